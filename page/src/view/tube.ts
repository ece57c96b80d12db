// The wall of the tower: a smooth tube through its sections.

import { BufferAttribute, BufferGeometry, DynamicDrawUsage } from "three";

import type { Rgb } from "./colours.js";
import { turned, type Section } from "./motion.js";

const AROUND = 32;
const CIRCLE = Array.from({ length: AROUND }, (_, k): [number, number] => {
  const angle = (2 * Math.PI * k) / AROUND;
  return [Math.cos(angle), Math.sin(angle)];
});

/** A tube whose buffers stay as long as the number of its sections does. */
export class Tube {
  readonly geometry = new BufferGeometry();
  private rows = 0;
  private position = new Float32Array(0);
  private normal = new Float32Array();
  private colour = new Float32Array();

  paint([red, green, blue]: Rgb): void {
    for (let at = 0; at < this.colour.length; at += 3) {
      this.colour[at] = red;
      this.colour[at + 1] = green;
      this.colour[at + 2] = blue;
    }
    this.changed("color");
  }

  /** Puts the wall where its sections are. Whether all has to be painted is the answer. */
  place(sections: Section[]): boolean {
    const isNew = sections.length !== this.rows;
    if (isNew) this.allocate(sections.length);
    sections.forEach((section, row) => this.placeRow(section, row, slopeAt(sections, row)));
    this.changed("position");
    this.changed("normal");
    return isNew;
  }

  dispose(): void {
    this.geometry.dispose();
  }

  private placeRow(section: Section, row: number, slope: number): void {
    // A ring is a combination of two turned axes, its normals lean by the slope along a third.
    const [x, y, z] = turned([1, 0, 0], section.turn);
    const [u, v, w] = turned([0, 1, 0], section.turn);
    const [a, b, c] = turned([0, 0, 1], section.turn);
    const [mx, my, mz] = section.middle;
    const long = 1 / Math.hypot(1, slope);
    let at = 3 * row * AROUND;
    for (const [cos, sin] of CIRCLE) {
      const [dx, dy, dz] = [cos * x + sin * u, cos * y + sin * v, cos * z + sin * w];
      this.position[at] = mx + section.radius * dx;
      this.position[at + 1] = my + section.radius * dy;
      this.position[at + 2] = mz + section.radius * dz;
      this.normal[at] = long * (dx - slope * a);
      this.normal[at + 1] = long * (dy - slope * b);
      this.normal[at + 2] = long * (dz - slope * c);
      at += 3;
    }
  }

  private allocate(rows: number): void {
    this.geometry.dispose();
    this.rows = rows;
    const size = 3 * rows * AROUND;
    this.position = this.attribute("position", size);
    this.normal = this.attribute("normal", size);
    this.colour = this.attribute("color", size);
    this.geometry.setIndex(facesOf(rows));
  }

  private attribute(name: string, size: number): Float32Array<ArrayBuffer> {
    const array = new Float32Array(size);
    this.geometry.setAttribute(name, new BufferAttribute(array, 3).setUsage(DynamicDrawUsage));
    return array;
  }

  private changed(name: string): void {
    const attribute = this.geometry.getAttribute(name) as BufferAttribute | undefined;
    if (attribute !== undefined) attribute.needsUpdate = true;
  }
}

/** How fast the radius grows with the height at a section. */
function slopeAt(sections: Section[], row: number): number {
  const below = sections[Math.max(row - 1, 0)]!;
  const above = sections[Math.min(row + 1, sections.length - 1)]!;
  const height = above.height - below.height;
  return height > 0 ? (above.radius - below.radius) / height : 0;
}

function facesOf(rows: number): number[] {
  const faces: number[] = [];
  for (let row = 0; row + 1 < rows; row += 1) {
    for (let k = 0; k < AROUND; k += 1) {
      const a = row * AROUND + k;
      const b = row * AROUND + ((k + 1) % AROUND);
      faces.push(a, b, b + AROUND, a, b + AROUND, a + AROUND);
    }
  }
  return faces;
}
