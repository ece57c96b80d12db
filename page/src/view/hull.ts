// The smallest convex body around points, as triangles that look outwards; flat bodies have two
// sides.

import type { Point } from "./scene.js";

/** Which corners form the surface of a convex body. */
export interface Hull {
  /** How many points it is of. */
  count: number;
  /** Three points a triangle, counterclockwise as seen from outside. */
  triangles: [number, number, number][];
  /** The triangles at each point. */
  around: number[][];
  /** Two points and the two triangles that meet between them. */
  edges: [number, number, number, number][];
}

/**
 * Points nearer to a face than this, relative to the size of the body, are on it: they have five
 * digits.
 */
const TOLERANCE = 1e-4;

const minus = (a: Point, b: Point): Point => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const dot = (a: Point, b: Point): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a: Point, b: Point): Point => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

/** The unit normal of a triangle; zero if its corners are on a line. */
export function normalOf(points: Point[], [a, b, c]: [number, number, number]): Point {
  const normal = cross(minus(points[b]!, points[a]!), minus(points[c]!, points[a]!));
  const length = Math.hypot(...normal);
  return length > 0 ? [normal[0] / length, normal[1] / length, normal[2] / length] : [0, 0, 0];
}

function sizeOf(points: Point[]): number {
  const extent = [0, 1, 2].map((axis) => {
    const values = points.map((point) => point[axis]!);
    return Math.max(...values) - Math.min(...values);
  });
  return Math.max(...extent);
}

const farthest = (points: Point[], distance: (point: Point) => number): number =>
  points.reduce((best, point, i) => (distance(point) > distance(points[best]!) ? i : best), 0);

/** The hull of points; none of points on a line. */
export function hullOf(points: Point[]): Hull | null {
  const small = TOLERANCE * sizeOf(points);
  if (!(small > 0)) return null;
  const a = 0;
  const b = farthest(points, (point) => Math.hypot(...minus(point, points[a]!)));
  const along = minus(points[b]!, points[a]!);
  const length = Math.hypot(...along);
  const c = farthest(points, (point) => Math.hypot(...cross(along, minus(point, points[a]!))));
  if (Math.hypot(...cross(along, minus(points[c]!, points[a]!))) < small * length) return null;
  const normal = normalOf(points, [a, b, c]);
  const above = (point: Point): number => dot(normal, minus(point, points[a]!));
  const d = farthest(points, (point) => Math.abs(above(point)));
  if (Math.abs(above(points[d]!)) < small) return flatHull(points.length, polygonOf(points, along, normal));
  const first: [number, number, number] = above(points[d]!) < 0 ? [a, b, c] : [a, c, b];
  return withTopology(points.length, solid(points, first, d, small));
}

/** Adds point after point to a tetrahedron: what a point sees is replaced by a cone to it. */
function solid(points: Point[], [a, b, c]: [number, number, number], d: number, small: number): Hull["triangles"] {
  let faces: Hull["triangles"] = [[a, b, c], [a, d, b], [b, d, c], [c, d, a]];
  points.forEach((point, index) => {
    const sees = (face: [number, number, number]): boolean =>
      dot(normalOf(points, face), minus(point, points[face[0]]!)) > small;
    const seen = faces.filter(sees);
    if (seen.length === 0) return;
    const edges = new Map<string, [number, number]>();
    seen.forEach(([i, j, k]) => ([[i, j], [j, k], [k, i]] as [number, number][]).forEach((edge) => {
      if (!edges.delete(`${edge[1]} ${edge[0]}`)) edges.set(`${edge[0]} ${edge[1]}`, edge);
    }));
    const kept = faces.filter((face) => !seen.includes(face));
    faces = kept.concat([...edges.values()].map(([i, j]) => [i, j, index]));
  });
  return faces;
}

/** The polygon around points of a plane (monotone chain). */
function polygonOf(points: Point[], along: Point, normal: Point): number[] {
  const across = cross(normal, along);
  const at = points.map((point): [number, number] => [dot(point, along), dot(point, across)]);
  const order = at.map((_, i) => i).sort((i, j) => at[i]![0] - at[j]![0] || at[i]![1] - at[j]![1]);
  const half = (indices: number[]): number[] => {
    const chain: number[] = [];
    indices.forEach((index) => {
      while (chain.length > 1 && !turnsLeft(at[chain[chain.length - 2]!]!, at[chain[chain.length - 1]!]!, at[index]!)) chain.pop();
      chain.push(index);
    });
    return chain.slice(0, -1);
  };
  return half(order).concat(half(order.slice().reverse()));
}

/** A polygon from both sides; its edges are between the first triangle of each. */
function flatHull(count: number, polygon: number[]): Hull {
  const fan = polygon.slice(2).map((point, i): [number, number, number] => [polygon[0]!, polygon[i + 1]!, point]);
  const triangles = fan.concat(fan.map(([i, j, k]) => [i, k, j]));
  const around: number[][] = Array.from({ length: count }, () => []);
  triangles.forEach((triangle, face) => triangle.forEach((point) => around[point]!.push(face)));
  const edges = polygon.map((point, i): Hull["edges"][number] => [point, polygon[(i + 1) % polygon.length]!, 0, fan.length]);
  return { count, triangles, around, edges };
}

const turnsLeft = (a: [number, number], b: [number, number], c: [number, number]): boolean =>
  (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) > 0;

function withTopology(count: number, triangles: Hull["triangles"]): Hull {
  const around: number[][] = Array.from({ length: count }, () => []);
  const sides = new Map<string, number>();
  triangles.forEach((triangle, face) => triangle.forEach((point, i) => {
    around[point]!.push(face);
    sides.set(`${point} ${triangle[(i + 1) % 3]!}`, face);
  }));
  const edges: Hull["edges"] = [];
  triangles.forEach((triangle, face) => triangle.forEach((point, i) => {
    const next = triangle[(i + 1) % 3]!;
    const other = sides.get(`${next} ${point}`);
    if (point < next && other !== undefined) edges.push([point, next, face, other]);
  }));
  return { count, triangles, around, edges };
}

/** Whether a hull of as many points is that of these too: most changes only stretch a body. */
export function isHullOf(hull: Hull, points: Point[]): boolean {
  if (hull.count !== points.length) return false;
  const small = 2 * TOLERANCE * sizeOf(points);
  return small > 0 && hull.triangles.every((face) => {
    const normal = normalOf(points, face);
    if (normal[0] === 0 && normal[1] === 0 && normal[2] === 0) return false;
    const offset = dot(normal, points[face[0]]!) + small;
    return points.every((point) => dot(normal, point) <= offset);
  });
}
