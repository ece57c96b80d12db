import assert from "node:assert/strict";
import { test } from "node:test";
import type { Drag } from "../view/scene.js";
import { describeDrag, draggedBy, valuesOf } from "./handles.js";
import type { Parameter } from "./protocol.js";

/** Heights and diameters of stations, m: a step of the wall at 40 m, one of the diameter at 60 m. */
const STATIONS: [number, number][] = [[0, 6], [40, 5], [40.001, 5], [60, 5], [60, 4], [100, 4]];
const VALUES = STATIONS.flat();
const PARAMETERS = STATIONS.flatMap((_, station) => (["height", "diameter"] as const).map((quantity): Parameter => ({
  name: `stations[${station}].${quantity}`, group: 0, column: null, also_in: null, follows: null, label: "", meaning: "", unit: "m",
  value: 0, low: 0, high: 1, drag: { station, quantity },
})));

function drag(station: number, quantity: Drag["quantity"], value_m = 0): Drag {
  return { station, quantity, value_m, phase: "move", place: [0, 0] };
}

function stations(station: number, quantity: Drag["quantity"]): number[] {
  return draggedBy(PARAMETERS, VALUES, drag(station, quantity)).map((of) => of.station);
}

test("both stations of a step move in height, and in diameter where they have the same", () => {
  assert.deepEqual(stations(1, "height"), [1, 2]);
  assert.deepEqual(stations(2, "diameter"), [1, 2]);
  assert.deepEqual(stations(3, "height"), [3, 4]);
  assert.deepEqual(stations(3, "diameter"), [3]);
  assert.deepEqual(stations(4, "diameter"), [4]);
  assert.deepEqual(stations(0, "height"), [0]);
  assert.deepEqual(stations(9, "height"), []);
});

test("stations that are nearly at one height keep their distance", () => {
  const dragged = draggedBy(PARAMETERS, VALUES, drag(1, "height"));
  assert.deepEqual(valuesOf(dragged, drag(1, "height", 41.23456)), { "stations[1].height": 41.235, "stations[2].height": 41.236 });
});

test("what is dragged is described with its value", () => {
  const one = draggedBy(PARAMETERS, VALUES, drag(0, "diameter"));
  assert.equal(describeDrag(one, drag(0, "diameter", 6.2)), "Station 1: diameter 6.2 m");
  const step = draggedBy(PARAMETERS, VALUES, drag(3, "height"));
  assert.equal(describeDrag(step, drag(3, "height", 58.00049)), "Stations 4 and 5: height 58 m");
});
