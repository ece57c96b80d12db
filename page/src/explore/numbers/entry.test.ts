import assert from "node:assert/strict";
import { test } from "node:test";
import { readNumber, tidy, writeFull, writeNumber, writeShort } from "./entry.js";

test("numbers with a decimal point and an exponent are read exactly", () => {
  const cases: [string, number][] = [
    ["3.6e5", 360000], [" 0.03 ", 0.03], ["-12", -12], ["+4.", 4], [".5", 0.5], ["1E-3", 0.001], ["−7", -7],
  ];
  for (const [text, value] of cases) assert.deepEqual(readNumber(text), { value });
});

test("what is no number is answered with a sentence that names it", () => {
  for (const text of ["", "abc", "3 5", "0x10", "Infinity", "NaN", "1e", "1.2.3", "1,000,000", "1e999"]) {
    assert.ok("problem" in readNumber(text), text);
  }
  assert.deepEqual(readNumber("3,5"), { problem: "Write 3.5 with a point." });
  assert.deepEqual(readNumber("400,000"), { problem: "Write 400000 without commas, or 400.000 with a point." });
  assert.deepEqual(readNumber("60 mm"), { problem: "Write 60 without a unit; the unit is that beside the field." });
});

test("written numbers read back as the same", () => {
  for (const value of [0, 350000, 2.1e11, -0.41, 0.1 + 0.2, 5e-324, 1.7976931348623157e308, 1e7, 9999999, -1e-5]) {
    assert.deepEqual(readNumber(writeNumber(value)), { value });
  }
  assert.equal(writeNumber(2.1e11), "2.1e11");
  assert.equal(writeNumber(350000), "350000");
});

test("a field shows seven digits with the whole exponent, and all digits to who types", () => {
  const cases: [number, string, string][] = [
    [1.7940356851508e11, "1.794036e11", "1.7940356851508e11"],
    [3.2500000000000004, "3.25", "3.25"],
    [6.499999999999999, "6.5", "6.5"],
    [0.00803119703, "0.008031197", "0.00803119703"],
    [-12345678.9, "-1.234568e7", "-1.23456789e7"],
    [350000, "350000", "350000"],
    [0, "0", "0"],
    [Infinity, "rigid", "rigid"],
  ];
  for (const [value, short, full] of cases) assert.deepEqual([writeShort(value), writeFull(value)], [short, full]);
});

test("a product loses the digits of its rounding error", () => {
  assert.equal(tidy(0.06 * 1.07), 0.0642);
  assert.equal(tidy(-0.1 * 3), -0.3);
});
