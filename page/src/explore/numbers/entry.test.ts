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
});

test("a number with a unit is answered with the number in the unit of the field", () => {
  const cases: [string, string, string][] = [
    ["310 t", "kg", "Write 310000: the field is in kg."],
    ["45 mm", "m", "Write 0.045: the field is in m."],
    ["270cm", "m", "Write 2.7: the field is in m."],
    ["6 m", "m", "Write 6: the field is in m."],
    ["210 GPa", "Pa", "Write 2.1e11: the field is in Pa."],
    ["80 MPa", "Pa", "Write 8e7: the field is in Pa."],
    ["12 kN/m", "N/m", "Write 12000: the field is in N/m."],
    ["3 MN m", "N m", "Write 3000000: the field is in N m."],
    ["8.5 t/m³", "kg/m3", "Write 8500: the field is in kg/m3."],
    ["4e4 t m2", "kg m2", "Write 4e7: the field is in kg m2."],
    ["12 ft", "m", "Write the number in m, without a unit."],
    ["60 mm", "kg", "Write the number in kg, without a unit."],
    ["1.1 x", "", "Write 1.1 without a unit."],
  ];
  for (const [text, unit, problem] of cases) assert.deepEqual(readNumber(text, unit), { problem }, text);
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
