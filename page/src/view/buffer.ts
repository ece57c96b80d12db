// Vertices that are written again and again in place: their list only grows.

import type { Rgb } from "./colours.js";
import type { Point } from "./scene.js";

/** Numbers of a vertex: position, colour, normal. */
export const NUMBERS = 9;

const NONE: Point = [0, 0, 0];

/** A list of vertices with colours, and normals if it is a surface. */
export class Vertices {
  data = new Float32Array(256 * NUMBERS);
  count = 0;
  /** Three vertices for each triangle; null takes the vertices in their order. */
  index: Uint32Array | null = null;
  /** Grows with every change. */
  version = 0;

  /** Begins anew. */
  begin(): void {
    this.count = 0;
    this.version += 1;
  }

  push(point: Point, colour: Rgb, normal: Point = NONE): void {
    const at = NUMBERS * this.count;
    if (at === this.data.length) {
      const longer = new Float32Array(2 * at);
      longer.set(this.data);
      this.data = longer;
    }
    this.data.set(point, at);
    this.data.set(colour, at + 3);
    this.data.set(normal, at + 6);
    this.count += 1;
  }
}
