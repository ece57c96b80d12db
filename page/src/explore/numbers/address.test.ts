import assert from "node:assert/strict";
import { test } from "node:test";
import type { Parameter } from "../protocol.js";
import { fromAddress, toAddress } from "./address.js";

function parameter(name: string, value: number): Parameter {
  return { name, group: 0, column: null, also_in: null, follows: null, label: name, meaning: "", unit: "", value, low: 0, high: 1, drag: null };
}

const PARAMETERS = [parameter("rna.mass", 350000), parameter("stations[0].wall", 0.06), parameter("a&b=c #1", 2)];

test("a state is the same after a way through the address", () => {
  const state = { numbers: { "rna.mass": 360000, "stations[0].wall": 0.1 + 0.2, "a&b=c #1": -1e-30 } };
  assert.deepEqual(fromAddress(`#${toAddress(state)}`, PARAMETERS), { state, problems: [] });
});

test("names and numbers stay readable", () => {
  assert.equal(toAddress({ numbers: { "rna.mass": 360000, "stations[0].wall": 0.03 } }), "rna.mass=360000&stations[0].wall=0.03");
});

test("unknown names and wrong numbers are named, the rest is used", () => {
  const { state, problems } = fromAddress("#rna.mas=1&rna.mass=4e5&stations[0].wall=thick&%zz&=", PARAMETERS);
  assert.deepEqual(state, { numbers: { "rna.mass": 400000 } });
  assert.equal(problems.length, 4);
  assert.match(problems[0] ?? "", /rna\.mas”/);
  assert.match(problems[1] ?? "", /thick/);
});

test("a number that equals the file's is no change", () => {
  assert.deepEqual(fromAddress("#rna.mass=3.5e5", PARAMETERS), { state: { numbers: {} }, problems: [] });
  assert.deepEqual(fromAddress("", PARAMETERS), { state: { numbers: {} }, problems: [] });
});
