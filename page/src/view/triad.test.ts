import assert from "node:assert/strict";
import { test } from "node:test";
import { Eye } from "./eye.js";
import { armsOf, arrowOf } from "./triad.js";

test("arrows point where the eye sees the axes", () => {
  const eye = new Eye();
  // From the side, on the level: the wind goes to the right, up is up, y points away or at the reader.
  eye.look(90, 0);
  const [x, y, z] = armsOf(eye).map(({ to }) => to.map((value) => Math.round(value) + 0));
  assert.deepEqual([Math.abs(x![0]!), x![1]], [26, 0]);
  assert.deepEqual(y!.map(Math.abs), [0, 0]);
  assert.deepEqual(z, [0, -26]);
  // As any point, an arm is to the right where the eye has it to the right.
  eye.look(20, 35);
  const [wind] = armsOf(eye);
  const [from, to] = [eye.place([0, 0, 0]), eye.place([26 * eye.scale, 0, 0])];
  assert.ok(Math.hypot(to[0] - from[0] - wind!.to[0], to[1] - from[1] - wind!.to[1]) < 1e-9);
  assert.equal(arrowOf(wind!).line.length, 5);
});
