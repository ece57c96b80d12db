import assert from "node:assert/strict";
import { test } from "node:test";
import { writeElasticity } from "./row.js";

test("elasticities have three decimals, small ones two significant digits", () => {
  const cases: [number, string][] = [
    [0.43911, "+0.439"], [-1.4924, "−1.492"], [0.0034, "+0.0034"], [-0.000421, "−0.00042"], [3.21e-6, "+3.2e-6"], [0, "0"], [1e-15, "0"],
  ];
  for (const [value, text] of cases) assert.equal(writeElasticity(value), text);
});
