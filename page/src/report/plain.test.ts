import assert from "node:assert/strict";
import { test } from "node:test";
import { plain, toCsv, toTabs } from "./plain.js";

test("numbers are those of programs", () => {
  const cells = [
    ["\u22121.5\u00b710\u207b\u2077", "-1.5e-7"],
    ["2.1\u00b710\u00b9\u00b9", "2.1e11"],
    ["\u22124.9", "-4.9"],
    ["+8.4", "+8.4"],
    [" 1st fore-aft bending\n", "1st fore-aft bending"],
    ["no mode from 11.9 rpm", "no mode from 11.9 rpm"],
    ["\u2013", ""],
    ["inertia (kg\u00a0m\u00b2)", "inertia (kg m\u00b2)"],
  ];
  cells.forEach(([shown, read]) => assert.equal(plain(shown!), read));
});

test("cells with commas and quotes are quoted", () => {
  assert.equal(toCsv([["a", 'say "b", c'], ["1", ""]]), 'a,"say ""b"", c"\r\n1,\r\n');
  assert.equal(toTabs([["a", "b\tc"], ["1", "2"]]), "a\tb c\n1\t2");
});
