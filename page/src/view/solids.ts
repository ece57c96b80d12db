// Convex bodies and balls as triangles and edges.

import type { Vertices } from "./buffer.js";
import { mix, type Rgb } from "./colours.js";
import { hullOf, isHullOf, normalOf, type Hull } from "./hull.js";
import type { Point } from "./scene.js";

/** The cosine of the largest angle between faces of what is drawn as one curved surface. */
const SMOOTH = Math.cos((35 * Math.PI) / 180);

const dot = (a: Point, b: Point): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

/** The hulls of the bodies of a tower, by their place in the list: most stay as they were. */
export class Hulls {
  private known: (Hull | null)[] = [];

  of(index: number, points: Point[]): Hull | null {
    const known = this.known[index];
    const hull = known && isHullOf(known, points) ? known : hullOf(points);
    this.known[index] = hull;
    return hull;
  }
}

/** Writes the surface of a convex body, and its edges as lines if they are asked for. */
export function writeSolid(points: Point[], hull: Hull, colour: Rgb, faces: Vertices, edges: Vertices, ink: Rgb): void {
  const normals = hull.triangles.map((triangle) => normalOf(points, triangle));
  hull.triangles.forEach((triangle, face) => triangle.forEach((corner) => {
    faces.push(points[corner]!, colour, cornerNormal(normals, face, hull.around[corner]!));
  }));
  const shade = mix(colour, ink, 0.45);
  hull.edges.forEach(([a, b, one, other]) => {
    if (dot(normals[one]!, normals[other]!) > SMOOTH) return;
    edges.push(points[a]!, shade);
    edges.push(points[b]!, shade);
  });
}

/** The mean normal of the faces at a corner that continue a face. */
function cornerNormal(normals: Point[], face: number, around: number[]): Point {
  const own = normals[face]!;
  const sum: Point = [0, 0, 0];
  around.forEach((other) => {
    const normal = normals[other]!;
    if (dot(normal, own) < SMOOTH) return;
    sum[0] += normal[0];
    sum[1] += normal[1];
    sum[2] += normal[2];
  });
  const length = Math.hypot(...sum);
  return length > 0 ? [sum[0] / length, sum[1] / length, sum[2] / length] : own;
}

const ROWS = 8;
const COLUMNS = 14;
const at = (row: number, column: number): Point => {
  const polar = (Math.PI * row) / ROWS;
  const angle = (2 * Math.PI * column) / COLUMNS;
  return [Math.sin(polar) * Math.cos(angle), Math.sin(polar) * Math.sin(angle), Math.cos(polar)];
};
/** The corners of the triangles of a ball of radius 1, which are its normals too. */
const BALL: Point[] = Array.from({ length: ROWS * COLUMNS }, (_, k): Point[] => {
  const [row, column] = [Math.floor(k / COLUMNS), k % COLUMNS];
  const [a, b, c, d] = [at(row, column), at(row + 1, column), at(row + 1, column + 1), at(row, column + 1)];
  return row === 0 ? [a, b, c] : row === ROWS - 1 ? [a, b, d] : [a, b, c, a, c, d];
}).flat();

export function writeBall([x, y, z]: Point, radius: number, colour: Rgb, faces: Vertices): void {
  BALL.forEach((normal) => {
    faces.push([x + radius * normal[0], y + radius * normal[1], z + radius * normal[2]], colour, normal);
  });
}
