import assert from "node:assert/strict";
import { test } from "node:test";
import { baseOf, multiplied } from "./column.js";

test("numbers that are a multiple of the file's are multiplied from the file", () => {
  const ofFile = [0.06, 0.027, 0, 0.019];
  const present = multiplied({ values: ofFile, factor: 1 }, 1.07);
  assert.deepEqual(present, [0.0642, 0.02889, 0, 0.02033]);
  assert.deepEqual(baseOf(ofFile, present), { values: ofFile, factor: 1.07 });
  assert.deepEqual(multiplied(baseOf(ofFile, present), 1), ofFile);
});

test("other numbers are multiplied from where they are", () => {
  const present = [0.06, 0.05];
  assert.deepEqual(baseOf([0.06, 0.027], present), { values: present, factor: 1 });
  assert.deepEqual(baseOf([0, 0], [0, 1]), { values: [0, 1], factor: 1 });
});
