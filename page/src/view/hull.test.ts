import assert from "node:assert/strict";
import { test } from "node:test";
import { hullOf, isHullOf, normalOf } from "./hull.js";
import type { Point } from "./scene.js";

const box = (a: number, b: number, c: number): Point[] =>
  [0, a].flatMap((x) => [0, b].flatMap((y) => [0, c].map((z): Point => [x, y, z])));

/** Six times the volume that a closed surface encloses, by the divergence theorem. */
function sixVolumes(points: Point[], triangles: [number, number, number][]): number {
  return triangles.reduce((sum, [i, j, k]) => {
    const [a, b, c] = [points[i]!, points[j]!, points[k]!];
    return sum + a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
  }, 0);
}

test("the hull of a box has its volume, twelve triangles and is closed", () => {
  const points = [...box(2, 3, 5), [1, 1, 1] as Point];
  const hull = hullOf(points);
  assert.ok(hull !== null);
  assert.equal(hull.triangles.length, 12);
  assert.equal(hull.edges.length, 18);
  assert.ok(Math.abs(sixVolumes(points, hull.triangles) - 180) < 1e-9);
});

test("the hull of a stretched body is that of the body, of a dented one it is not", () => {
  const hull = hullOf(box(2, 3, 5));
  assert.ok(hull !== null);
  assert.ok(isHullOf(hull, box(4, 3, 0.5)));
  const moved = box(2, 3, 5);
  moved[7] = [0.2, 0.2, 0.2];
  assert.ok(!isHullOf(hull, moved));
  assert.ok(!isHullOf(hull, box(2, 3, 5).slice(1)));
});

test("a flat body has two sides and the edges of its outline alone", () => {
  const square: Point[] = [[1, 0, 0], [1, 2, 0], [1, 2, 2], [1, 0, 2]];
  const hull = hullOf(square);
  assert.ok(hull !== null);
  assert.equal(hull.triangles.length, 4);
  assert.equal(hull.edges.length, 4);
  assert.deepEqual(hull.triangles.map((triangle) => normalOf(square, triangle)[0]).sort(), [-1, -1, 1, 1]);
});

test("points on a line have no surface", () => {
  assert.equal(hullOf([[0, 0, 0], [1, 1, 1], [2, 2, 2]]), null);
  assert.equal(hullOf([[1, 1, 1]]), null);
});
