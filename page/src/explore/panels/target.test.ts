import assert from "node:assert/strict";
import { test } from "node:test";
import type { Resonance } from "../protocol.js";
import { windowHz } from "./target.js";

function rotor(operation_rpm: [number, number] | null): Resonance {
  return {
    word: "pass", conclusion: [], is_checked: true, operation_rpm, blades: 3, margin: 0.05, multiples: [1, 3], lines: [], rows: [],
  };
}

test("the proposed band is one percent farther from the excitations than the margin", () => {
  const [low, high] = windowHz(rotor([6.9, 12.1])) ?? [NaN, NaN];
  // Distances are those of the excitation from the natural frequency.
  assert.ok(Math.abs(12.1 / 60 / low - 1 + 0.06) < 1e-12);
  assert.ok(Math.abs((3 * 6.9) / 60 / high - 1 - 0.06) < 1e-12);
});

test("there is no band without operating speeds, or where it is empty", () => {
  assert.equal(windowHz(rotor(null)), null);
  assert.equal(windowHz(rotor([4, 12.1])), null);
});
