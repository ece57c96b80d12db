import assert from "node:assert/strict";
import { test } from "node:test";
import { csv, plain, tabbed } from "./tables.js";

test("cells are those of spreadsheets", () => {
  const rows = [["Mode", "Hz"], ['1st, "bending"', "0.2765"]];
  assert.equal(csv(rows), 'Mode,Hz\n"1st, ""bending""",0.2765\n');
  assert.equal(tabbed(rows), 'Mode\tHz\n1st, "bending"\t0.2765');
  assert.equal(plain("\u22120.12\u2007\u2007"), "-0.12");
});
