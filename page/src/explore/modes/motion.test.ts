import assert from "node:assert/strict";
import { test } from "node:test";
import { largest, scaleOf, staticParts, superposed } from "./motion.js";
import { sample } from "./sample.js";

const near = (a: number | undefined, b: number): void => assert.ok(Math.abs((a ?? NaN) - b) <= 1e-12 * Math.max(1, Math.abs(b)), `${a} and ${b}`);

test("a mode reaches its amplitude, whatever the size of its shape", () => {
  for (const factor of [1, -0.01, 40]) {
    const { scene } = sample([{ family: "fore-aft", order: 1, frequency_hz: 0.3, factor }]);
    const [shape] = scene.modes;
    assert.ok(shape);
    near(largest(superposed(scene, [scaleOf(scene, shape, 0.05)], null)), 0.05 * 80);
  }
});

test("torsion is scaled by its rotation", () => {
  const { scene } = sample([{ family: "torsion", order: 1, frequency_hz: 1 }]);
  const [shape] = scene.modes;
  assert.ok(shape);
  near(scaleOf(scene, shape, 0.05), 0.4);
});

test("the static deflection has each mode by its flexibility at the force", () => {
  const { scene, modes } = sample([
    { family: "fore-aft", order: 1, frequency_hz: 1 }, { family: "fore-aft", order: 1, frequency_hz: 2 },
    { family: "side-side", order: 1, frequency_hz: 1 }, { family: "torsion", order: 1, frequency_hz: 1 },
  ]);
  const [first, second, across, twist] = staticParts(scene, modes, 80, [1, 0]);
  near(first, 1 / (2 * Math.PI) ** 2);
  near((first ?? 0) / (second ?? 1), 4);
  near(across, 0);
  near(twist, 0);
  // sin(π/4) at half the height, between two heights of the scene.
  const [half] = staticParts(scene, modes, 40, [0.6, 0.8]);
  near(half, (0.6 * Math.SQRT1_2) / (2 * Math.PI) ** 2);
});

test("a force beyond the ends pushes the end, a mode without mass has no part", () => {
  const { scene, modes } = sample([{ family: "fore-aft", order: 1, frequency_hz: 1 }]);
  near(staticParts(scene, modes, 200, [1, 0])[0], 1 / (2 * Math.PI) ** 2);
  near(staticParts(scene, modes, -5, [1, 0])[0], 0);
  const massless = modes.map((mode) => ({ ...mode, modal_mass: 0 }));
  assert.deepEqual(staticParts(scene, massless, 80, [1, 0]), [0]);
});

test("a pose is used again and holds the sum of the shapes", () => {
  const { scene } = sample([{ family: "fore-aft", order: 1, frequency_hz: 1 }, { family: "side-side", order: 1, frequency_hz: 1 }]);
  const pose = superposed(scene, [2, 3], null);
  near(pose.displacement.at(-1)?.[0], 2);
  near(pose.displacement.at(-1)?.[1], 3);
  assert.equal(superposed(scene, [0, 1], pose), pose);
  near(pose.displacement.at(-1)?.[0], 0);
});
