import assert from "node:assert/strict";
import { test } from "node:test";
import { carried, placed, poseOf, reach, sectionAt, sectionsAt, sectionsOf, turned } from "./motion.js";
import type { Body, Point, Shape, TowerScene } from "./scene.js";

const shape: Shape = {
  number: 1, label: "1st fore-aft bending", family: "fore-aft", frequency_hz: 0.3,
  x: [0, 0.4, 1], y: [0, 0, 0.1], z: [0, 0, -0.01],
  rotation_x: [0, 0, 0.002], rotation_y: [0, 0.01, 0.02], rotation_z: [0, 0.003, 0.005],
};
const nacelle: Body = { follows_m: 80, of: "rna", form: "solid", points: [[-3, -2, 80], [5, -2, 80], [5, 2, 84], [-3, 2, 84]] };
const scene: TowerScene = { height_m: [0, 30, 80], radius_m: [3, 2.5, 1.5], is_nominal: false, bodies: [nacelle], modes: [shape] };

const distance = (a: Point, b: Point): number => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
const near = (a: number, b: number): void => assert.ok(Math.abs(a - b) < 1e-9, `${a} is not ${b}`);

test("a rigid body keeps all distances however far it turns", () => {
  for (const scale of [-60, 5, 200]) {
    const points = placed(nacelle, sectionsAt(scene, shape, scale));
    nacelle.points.forEach((a, i) => nacelle.points.forEach((b, j) => near(distance(points[i]!, points[j]!), distance(a, b))));
  }
});

test("the pose at rest is the identity", () => {
  for (const sections of [sectionsOf(scene, null), sectionsAt(scene, shape, 0)]) {
    assert.deepEqual(placed(nacelle, sections), nacelle.points);
    assert.deepEqual(sections.map(({ middle }) => middle), [[0, 0, 0], [0, 0, 30], [0, 0, 80]]);
  }
});

test("a section at a station is that of the station, and halfway the mean of its neighbours", () => {
  const sections = sectionsAt(scene, shape, 10);
  assert.deepEqual(sectionAt(sections, 30), sections[1]!);
  assert.deepEqual(sectionAt(sections, -5), sections[0]!);
  assert.deepEqual(sectionAt(sections, 99), sections[2]!);
  const between = sectionAt(sections, 55);
  near(between.radius, 2);
  near(between.middle[0], 7);
  near(between.turn[1], 0.15);
});

test("a quarter of a turn about z takes x to y", () => {
  const point = turned([1, 0, 0], [0, 0, Math.PI / 2]);
  [0, 1, 0].forEach((value, i) => near(point[i]!, value));
});

test("the middle of a section goes where its displacement says", () => {
  const [, , top] = sectionsOf(scene, poseOf(shape, 2));
  assert.deepEqual(carried(top!, [0, 0, 80]), [2, 0.2, 79.98]);
});

test("of a rope only the end on the tower moves", () => {
  const rope: Body = { follows_m: 80, of: "link", form: "line", points: [[0, 0, 80], [50, 0, 0]] };
  const [upper, lower] = placed(rope, sectionsAt(scene, shape, 3));
  near(upper![0], 3);
  assert.deepEqual(lower!, [50, 0, 0]);
});

test("the amplitude is in percent of the height, of a torsion in turns", () => {
  near(reach(scene, shape, 10), 8);
  const torsion: Shape = { ...shape, x: [0, 0, 0], y: [0, 0, 0], z: [0, 0, 0], rotation_z: [0, 0.5, 1] };
  near(reach(scene, torsion, 10), (30 * Math.PI) / 180);
  near(reach(scene, { ...torsion, rotation_z: [0, 0, 0] }, 10), 0);
});
