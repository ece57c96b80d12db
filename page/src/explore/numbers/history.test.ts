import assert from "node:assert/strict";
import { test } from "node:test";
import type { State } from "../protocol.js";
import { History } from "./history.js";

const state = (mass: number): State => ({ numbers: { mass } });

test("a slide of many states is one step", () => {
  const history = new History(state(0));
  for (let mass = 1; mass <= 50; mass++) history.preview(state(mass));
  history.settle("mass", 0);
  assert.ok(history.undo());
  assert.deepEqual(history.present, state(0));
  assert.ok(!history.undo());
  assert.ok(history.redo());
  assert.deepEqual(history.present, state(50));
});

test("undo during a slide goes back to its beginning, and redo to where it was", () => {
  const history = new History(state(0));
  history.preview(state(7));
  assert.ok(history.canUndo);
  history.undo();
  assert.deepEqual(history.present, state(0));
  history.redo();
  assert.deepEqual(history.present, state(7));
});

test("a new step ends what could be redone, a step without change does not count", () => {
  const history = new History(state(0));
  history.preview(state(1));
  history.settle();
  history.undo();
  history.settle();
  assert.ok(history.canRedo);
  history.preview(state(2));
  history.settle();
  assert.ok(!history.canRedo);
});

test("a key held down is one step, a pause begins the next", () => {
  const history = new History(state(0));
  [100, 200, 300, 2000].forEach((at, index) => {
    history.preview(state(index + 1));
    history.settle("mass", at);
  });
  history.undo();
  assert.deepEqual(history.present, state(3));
  history.undo();
  assert.deepEqual(history.present, state(0));
});

test("steps survive a reload only with the state that they end in", () => {
  const before = new History(state(0));
  before.preview(state(1));
  before.settle();
  const record = JSON.parse(JSON.stringify(before.record()));
  const after = new History(state(1));
  after.resume(record);
  assert.ok(after.undo());
  const other = new History(state(9));
  other.resume(record);
  assert.ok(!other.undo());
});
