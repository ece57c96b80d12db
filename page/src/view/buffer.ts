// Geometry that is written again and again in place: it only grows.

import { BufferAttribute, BufferGeometry, DynamicDrawUsage } from "three";

import type { Rgb } from "./colours.js";
import type { Point } from "./scene.js";

/** A list of vertices with colours, and normals if it is a surface. */
export class Vertices {
  readonly geometry = new BufferGeometry();
  private readonly names: readonly string[];
  private arrays: Float32Array[] = [];
  private count = 0;
  private capacity = 0;

  constructor(private readonly hasNormals: boolean) {
    this.names = hasNormals ? ["position", "color", "normal"] : ["position", "color"];
    this.grow(256);
  }

  /** Begins anew. */
  begin(): void {
    this.count = 0;
  }

  push(point: Point, colour: Rgb, normal: Point | null = null): void {
    if (this.count === this.capacity) this.grow(2 * this.capacity);
    const at = 3 * this.count;
    this.arrays[0]!.set(point, at);
    this.arrays[1]!.set(colour, at);
    if (this.hasNormals && normal !== null) this.arrays[2]!.set(normal, at);
    this.count += 1;
  }

  /** Hands what was written to the graphics. */
  end(): void {
    this.names.forEach((name) => {
      const attribute = this.geometry.getAttribute(name) as BufferAttribute;
      attribute.clearUpdateRanges();
      attribute.addUpdateRange(0, 3 * this.count);
      attribute.needsUpdate = true;
    });
    this.geometry.setDrawRange(0, this.count);
  }

  get isEmpty(): boolean {
    return this.count === 0;
  }

  dispose(): void {
    this.geometry.dispose();
  }

  private grow(capacity: number): void {
    // Buffers of graphics cannot grow: the old ones are freed.
    this.geometry.dispose();
    this.arrays = this.names.map((name, i) => {
      const array = new Float32Array(3 * capacity);
      if (this.arrays[i] !== undefined) array.set(this.arrays[i]);
      this.geometry.setAttribute(name, new BufferAttribute(array, 3).setUsage(DynamicDrawUsage));
      return array;
    });
    this.capacity = capacity;
  }
}
