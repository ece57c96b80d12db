import assert from "node:assert/strict";
import { test } from "node:test";
import type { Parameter } from "../protocol.js";
import { movedBy, withFollowers } from "./followers.js";

function parameter(name: string, follows: number | null): Parameter {
  return { name, group: 0, column: null, also_in: null, follows, label: name, meaning: "", unit: "m", value: 0, low: 0, high: 1, drag: null };
}

const PARAMETERS = [
  parameter("stations[1].height", null), parameter("stations[2].height", 0), parameter("point_mass[0].height", 0), parameter("ground.surface", null),
];

test("what follows a number has its value", () => {
  assert.deepEqual(withFollowers(PARAMETERS, { "stations[1].height": 12 }), {
    "stations[1].height": 12, "stations[2].height": 12, "point_mass[0].height": 12,
  });
  assert.deepEqual(withFollowers(PARAMETERS, { "ground.surface": -20 }), { "ground.surface": -20 });
});

test("a follower that is set itself keeps its value", () => {
  const dragged = { "stations[1].height": 12, "stations[2].height": 12.001 };
  assert.deepEqual(withFollowers(PARAMETERS, dragged), { ...dragged, "point_mass[0].height": 12 });
});

test("a slider moves its number and those that follow it", () => {
  assert.deepEqual(movedBy(PARAMETERS, 0), [0, 1, 2]);
  assert.deepEqual(movedBy(PARAMETERS, 3), [3]);
});
