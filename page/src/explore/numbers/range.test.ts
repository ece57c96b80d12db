import assert from "node:assert/strict";
import { test } from "node:test";
import { roundRange } from "./range.js";

test("ranges contain what they are asked to contain, with round steps", () => {
  assert.deepEqual(roundRange(0.04, 0.08), { low: 0.04, high: 0.08, step: 0.0001 });
  assert.deepEqual(roundRange(175e3, 525e3), { low: 175e3, high: 525e3, step: 1e3 });
  assert.deepEqual(roundRange(-1, 1), { low: -1, high: 1, step: 0.005 });
});

test("a value beyond the range widens it", () => {
  const range = roundRange(0.04, 0.08, 0.5);
  assert.ok(range.low <= 0.04 && range.high >= 0.5);
  const below = roundRange(1, 2, -7.3);
  assert.ok(below.low <= -7.3 && below.high >= 2);
});

test("a range of one point, negative and tiny ranges have a step", () => {
  for (const [low, high] of [[0, 0], [5, 5], [-3, -3], [-2e-9, -1e-9], [1e11, 3e11]] as const) {
    const range = roundRange(low, high);
    assert.ok(range.step > 0 && range.low <= low && range.high >= high, JSON.stringify(range));
  }
});
