// The wall of the tower, a smooth tube through its sections, and the members of a frame.

import type { Vertices } from "./buffer.js";
import type { Rgb } from "./colours.js";
import type { Limb } from "./frame.js";
import { turned, type Section } from "./motion.js";
import type { Point } from "./scene.js";

const AROUND = 32;
const circle = (corners: number): [number, number][] => Array.from({ length: corners }, (_, k) => {
  const angle = (2 * Math.PI * k) / corners;
  return [Math.cos(angle), Math.sin(angle)];
});
const CIRCLE = circle(AROUND);

/** Writes the wall between sections. */
export function writeTube(vertices: Vertices, sections: Section[], colour: Rgb): void {
  const faces = 6 * AROUND * Math.max(sections.length - 1, 0);
  if (vertices.index?.length !== faces) vertices.index = Uint32Array.from(ringFaces(0, sections.length, AROUND));
  vertices.begin();
  sections.forEach((section, row) => writeRing(vertices, section, slopeAt(sections, row), colour));
}

const AROUND_LIMB = 10;
const LIMB = circle(AROUND_LIMB);

/** Writes members of a frame, each as a tube across its axis. */
export function writeLimbs(vertices: Vertices, limbs: Limb[], colour: Rgb): void {
  const tubes = limbs.filter((limb) => limb[0]!.radius > 0);
  const rings = tubes.reduce((sum, limb) => sum + limb.length - 1, 0);
  if (vertices.index?.length !== 6 * AROUND_LIMB * rings) vertices.index = Uint32Array.from(limbFaces(tubes));
  vertices.begin();
  tubes.forEach((limb) => limb.forEach((section, k) => {
    const [before, after] = [limb[Math.max(k - 1, 0)]!.middle, limb[Math.min(k + 1, limb.length - 1)]!.middle];
    const [u, v] = acrossOf([after[0] - before[0], after[1] - before[1], after[2] - before[2]]);
    for (const [cos, sin] of LIMB) {
      const outwards: Point = [cos * u[0] + sin * v[0], cos * u[1] + sin * v[1], cos * u[2] + sin * v[2]];
      const { middle: [x, y, z], radius } = section;
      vertices.push([x + radius * outwards[0], y + radius * outwards[1], z + radius * outwards[2]], colour, outwards);
    }
  }));
}

/** Two unit vectors at right angles to a direction, which turn little with it. */
function acrossOf([x, y, z]: Point): [Point, Point] {
  const length = Math.hypot(x, y, z) || 1;
  const [a, b, c] = [x / length, y / length, z / length];
  const flat = Math.hypot(a, b);
  const u: Point = flat > 1e-6 ? [-b / flat, a / flat, 0] : [1, 0, 0];
  return [u, [b * u[2] - c * u[1], c * u[0] - a * u[2], a * u[1] - b * u[0]]];
}

function limbFaces(tubes: Limb[]): number[] {
  let first = 0;
  return tubes.flatMap((limb) => {
    const faces = ringFaces(first, limb.length, AROUND_LIMB);
    first += limb.length * AROUND_LIMB;
    return faces;
  });
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

/** The triangles between rings of corners, which begin at a vertex. */
function ringFaces(first: number, rows: number, corners: number): number[] {
  const faces: number[] = [];
  for (let row = 0; row + 1 < rows; row += 1) {
    for (let k = 0; k < corners; k += 1) {
      const a = first + row * corners + k;
      const b = first + row * corners + ((k + 1) % corners);
      faces.push(a, b, b + corners, a, b + corners, a + corners);
    }
  }
  return faces;
}
