import assert from "node:assert/strict";
import { test } from "node:test";
import { headingOf, writeElasticity } from "./row.js";

test("elasticities have three decimals, small ones two significant digits", () => {
  const cases: [number, string][] = [
    [0.43911, "+0.439"], [-1.4924, "−1.492"], [0.0034, "+0.0034"], [-0.000421, "−0.00042"], [3.21e-6, "+3.2e-6"], [0, "0"], [1e-15, "0"],
  ];
  for (const [value, text] of cases) assert.equal(writeElasticity(value), text);
});

test("a row has the words of its meaning, not its place in the file", () => {
  const of = (label: string, meaning: string): string[] => Object.values(headingOf({ label, meaning }));
  assert.deepEqual(of("1.1: foundation.mooring[][]", "stiffness of the moorings"), ["1.1: stiffness of the moorings", ""]);
  assert.deepEqual(of("1: diameter", "outer diameter"), ["1: outer diameter", ""]);
  assert.deepEqual(of("1: k", "spring constant"), ["1: k", "spring constant"]);
});
