import assert from "node:assert/strict";
import { test } from "node:test";
import { limbsOf } from "./frame.js";
import { extentOf, Eye } from "./eye.js";
import { placed } from "./motion.js";
import type { Body, TowerScene } from "./scene.js";

const scene: TowerScene = {
  height_m: [0, 10],
  radius_m: [1, 1],
  is_nominal: false,
  bodies: [],
  modes: [],
  frame: { joints: [[0, 0, -8], [4, 0, 0]], members: [{ joints: [0, 1], radius_m: [1, 0.5] }] },
};
const near = (a: number, b: number): void => assert.ok(Math.abs(a - b) < 1e-12, `${a} is not ${b}`);

test("a member at rest is straight", () => {
  const [limb] = limbsOf(scene, null);
  assert.deepEqual(limb!.map(({ middle }) => middle), [[0, 0, -8], [4, 0, 0]]);
  assert.deepEqual(limb!.map(({ radius }) => radius), [1, 0.5]);
});

test("a member bends through its samples, a quartic exactly", () => {
  const deflection = (s: number): number => s ** 2 * (1 - s) ** 2;
  const samples = [0, 1, 0.25, 0.5, 0.75].flatMap((s) => [0, deflection(s), 0]);
  const [limb] = limbsOf(scene, samples);
  assert.equal(limb!.length, 9);
  limb!.forEach(({ middle: [x, y, z] }, k) => {
    near(x, (4 * k) / 8);
    near(y, deflection(k / 8));
    near(z, -8 + k);
  });
});

test("a motion of another frame is none", () => {
  assert.equal(limbsOf(scene, [1, 2, 3])[0]!.length, 2);
});

const rope: Body = { follows_m: 0, of: "link", form: "line", points: [[1, 0, 0], [50, 0, -8], [100, 0, -8]] };

test("a rope follows at its beginning and stays at its end", () => {
  const section = { height: 0, middle: [2, 0, 0] as [number, number, number], turn: [0, 0, 0] as [number, number, number], radius: 1 };
  assert.deepEqual(placed(rope, [section]), [[3, 0, 0], [51, 0, -8], [100, 0, -8]]);
});

test("a picture has room for joints, but not for anchors", () => {
  const eye = Object.assign(new Eye(), { azimuth: 90, elevation: 0 });
  const sections = [0, 10].map((height) => ({ height, middle: [0, 0, height] as [number, number, number], turn: [0, 0, 0] as [number, number, number], radius: 1 }));
  const { low, high } = extentOf(eye, sections, [rope], scene.frame);
  near(Math.max(Math.abs(low[0]), Math.abs(high[0])), 4);
  near(low[1], -8);
});
