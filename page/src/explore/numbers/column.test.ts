import assert from "node:assert/strict";
import { test } from "node:test";
import { baseAmong, baseOf, isMultiplied, multiplied } from "./column.js";

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

test("the factor on numbers of which one was changed before stays visible", () => {
  const ofFile = [0.06, 0.027];
  const before = [0.05, 0.027];
  const present = multiplied({ values: before, factor: 1 }, 1.1);
  assert.deepEqual(baseAmong([ofFile], present), { values: present, factor: 1 });
  assert.deepEqual(baseAmong([ofFile, before], present), { values: before, factor: 1.1 });
  assert.deepEqual(baseAmong([ofFile, before], multiplied({ values: ofFile, factor: 1 }, 1.2)), { values: ofFile, factor: 1.2 });
});

test("a factor that the program refuses stays the factor, and another one multiplies the file's numbers", () => {
  const ofFile = [0.06, 0, 0.019];
  for (const refused of [0, -2]) {
    const base = baseOf(ofFile, multiplied({ values: ofFile, factor: 1 }, refused));
    assert.deepEqual(base, { values: ofFile, factor: refused });
    assert.ok(base.values.some(isMultiplied));
    assert.deepEqual(multiplied(base, 1), ofFile);
  }
});

test("what is rigid stays rigid, whatever the factor", () => {
  const ofFile = [Infinity, 2e11, 0];
  const present = multiplied({ values: ofFile, factor: 1 }, 1.2);
  assert.deepEqual(present, [Infinity, 2.4e11, 0]);
  assert.deepEqual(baseOf(ofFile, present), { values: ofFile, factor: 1.2 });
  assert.deepEqual(multiplied({ values: [Infinity], factor: 1 }, 0), [Infinity]);
  // A number typed in the place of one that was rigid is multiplied from where it is.
  assert.deepEqual(baseOf(ofFile, [1e12, 2e11, 0]), { values: [1e12, 2e11, 0], factor: 1 });
  assert.ok(![0, Infinity, NaN].some(isMultiplied));
});
