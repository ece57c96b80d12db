// The wall of the tower: a smooth tube through its sections.

import type { Vertices } from "./buffer.js";
import type { Rgb } from "./colours.js";
import { turned, type Section } from "./motion.js";
import type { Point } from "./scene.js";

const AROUND = 32;
const CIRCLE = Array.from({ length: AROUND }, (_, k): [number, number] => {
  const angle = (2 * Math.PI * k) / AROUND;
  return [Math.cos(angle), Math.sin(angle)];
});

/** Writes the wall between sections. */
export function writeTube(vertices: Vertices, sections: Section[], colour: Rgb): void {
  const faces = 6 * AROUND * Math.max(sections.length - 1, 0);
  if (vertices.index?.length !== faces) vertices.index = facesOf(sections.length);
  vertices.begin();
  sections.forEach((section, row) => writeRing(vertices, section, slopeAt(sections, row), colour));
}

/** A ring is a combination of two turned axes, its normals lean by the slope along the third. */
function writeRing(vertices: Vertices, { middle, turn, radius }: Section, slope: number, colour: Rgb): void {
  const [x, y, z] = [turned([1, 0, 0], turn), turned([0, 1, 0], turn), turned([0, 0, 1], turn)];
  const long = 1 / Math.hypot(1, slope);
  for (const [cos, sin] of CIRCLE) {
    const outwards: Point = [cos * x[0] + sin * y[0], cos * x[1] + sin * y[1], cos * x[2] + sin * y[2]];
    const point: Point = [middle[0] + radius * outwards[0], middle[1] + radius * outwards[1], middle[2] + radius * outwards[2]];
    const normal: Point = [long * (outwards[0] - slope * z[0]), long * (outwards[1] - slope * z[1]), long * (outwards[2] - slope * z[2])];
    vertices.push(point, colour, normal);
  }
}

/** How fast the radius grows with the height at a section. */
function slopeAt(sections: Section[], row: number): number {
  const below = sections[Math.max(row - 1, 0)]!;
  const above = sections[Math.min(row + 1, sections.length - 1)]!;
  const height = above.height - below.height;
  return height > 0 ? (above.radius - below.radius) / height : 0;
}

function facesOf(rows: number): Uint32Array {
  const faces: number[] = [];
  for (let row = 0; row + 1 < rows; row += 1) {
    for (let k = 0; k < AROUND; k += 1) {
      const a = row * AROUND + k;
      const b = row * AROUND + ((k + 1) % AROUND);
      faces.push(a, b, b + AROUND, a, b + AROUND, a + AROUND);
    }
  }
  return Uint32Array.from(faces);
}
