import assert from "node:assert/strict";
import { test } from "node:test";
import { Eye, isOtherSize, type Extent } from "./eye.js";
import { Pull } from "./handles.js";
import { heightAt } from "./pick.js";
import type { Handle } from "./scene.js";

const near = (a: number, b: number): void => assert.ok(Math.abs(a - b) < 1e-9, `${a} is not ${b}`);

function eye(azimuth = 0, elevation = 0): Eye {
  const made = new Eye();
  Object.assign(made, { azimuth: 0, elevation: 0, width: 400, height: 400, scale: 0.5, middle: [0, 50], level: 50 });
  made.look(azimuth, elevation);
  return made;
}

test("from the upwind side y is to the left, z upwards", () => {
  const made = eye();
  near(made.across([0, 1, 0]), -1);
  near(made.across([1, 0, 0]), 0);
  const [x, y] = made.place([0, 0, 60]);
  near(x, 200);
  near(y, 180);
});

test("what it is turned about stays in its place", () => {
  const made = eye();
  const before = made.place([0, 0, 50]);
  made.look(77, 40);
  made.place([0, 0, 50]).forEach((value, i) => near(value, before[i]!));
});

test("what is under the pointer stays there as it is zoomed", () => {
  const made = eye(35, 20);
  const before = made.place([3, 4, 80]);
  made.zoom(1.7, before);
  made.place([3, 4, 80]).forEach((value, i) => near(value, before[i]!));
});

const handle: Handle = { station: 2, height_m: 60, radius_m: 3, hasDiameter: true, hasHeight: true };

test("a handle that is dragged sideways changes the diameter, upwards the height", () => {
  const wider = new Pull(handle, [206, 180], eye());
  assert.equal(wider.move([208, 181]), null);
  const first = wider.move([212, 181]);
  assert.deepEqual({ ...first }, { station: 2, phase: "start", quantity: "diameter", value_m: 12, place: [212, 181] });
  assert.equal(wider.move([206, 100])?.quantity, "diameter");
  const cancelled = wider.end([0, 0], "cancel");
  assert.deepEqual({ ...cancelled }, { station: 2, phase: "cancel", quantity: "diameter", value_m: 6, place: [206, 180] });
  const higher = new Pull(handle, [194, 180], eye());
  assert.deepEqual({ ...higher.move([195, 160]) }, { station: 2, phase: "start", quantity: "height", value_m: 70, place: [195, 160] });
});

test("on the left of the tower outwards is to the left", () => {
  near(new Pull(handle, [194, 180], eye()).move([184, 180])!.value_m, 16);
});

test("a handle without one of the two changes the other", () => {
  const only = new Pull({ ...handle, hasHeight: false }, [206, 180], eye());
  assert.equal(only.move([206, 100])?.quantity, "diameter");
  assert.equal(new Pull({ ...handle, hasHeight: false, hasDiameter: false }, [206, 180], eye()).move([0, 0]), null);
});

test("a tap is at the height of the tower under it, or beside it", () => {
  const sections = [0, 100].map((height) => ({ height, middle: [0, 0, height] as [number, number, number], turn: [0, 0, 0] as [number, number, number], radius: 3 }));
  near(heightAt([202, 180], eye(), sections)!, 60);
  assert.equal(heightAt([260, 180], eye(), sections), null);
});

test("a tower of another size needs another scale, a taller one does not", () => {
  const extent = (wide: number, tall: number): Extent => ({ low: [-wide / 2, 0], high: [wide / 2, tall] });
  assert.equal(isOtherSize(extent(40, 100), extent(40, 130)), false);
  // 600 typed in the place of 6.00 and back.
  assert.equal(isOtherSize(extent(40, 100), extent(600, 100)), true);
  assert.equal(isOtherSize(extent(600, 100), extent(40, 100)), true);
});
