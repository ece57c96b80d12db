import assert from "node:assert/strict";
import { test } from "node:test";
import type { State } from "../protocol.js";
import { SolveQueue, type Result } from "./queue.js";

const state = (mass: number): State => ({ numbers: { mass } });
const RESULT: Result = { refused: { message: "", hint: null, parameters: [] } };

/** A program that answers when told to. */
function program() {
  const asked: number[] = [];
  const answers: ((ok: boolean) => void)[] = [];
  const ask = (state: State): Promise<Result> => {
    asked.push(state.numbers["mass"] ?? NaN);
    return new Promise((resolve, reject) => answers.push((ok) => (ok ? resolve(RESULT) : reject(new Error("ended")))));
  };
  const answer = async (ok = true): Promise<void> => {
    answers.shift()?.(ok);
    for (let turn = 0; turn < 5; turn++) await Promise.resolve();
  };
  return { asked, ask, answer };
}

test("one request at a time, of those that wait the newest, the last never lost", async () => {
  const { asked, ask, answer } = program();
  const done: [number, number, number][] = [];
  const idle: boolean[] = [];
  const queue = new SolveQueue(ask, {
    done: (state, _, at, since) => done.push([state.numbers["mass"] ?? NaN, at, since]),
    failed: () => undefined,
    idle: () => idle.push(queue.pending),
  });
  for (let mass = 1; mass <= 5; mass++) queue.want(state(mass), 10 * mass);
  assert.deepEqual(asked, [1]);
  assert.ok(queue.pending);
  await answer();
  assert.deepEqual(asked, [1, 5]);
  await answer();
  assert.deepEqual(done, [[1, 10, 10], [5, 50, 20]]);
  assert.ok(!queue.pending);
  assert.deepEqual(idle, [false]);
});

test("after a failure the state that waits is asked for, and the next one too", async () => {
  const { asked, ask, answer } = program();
  let failures = 0;
  const queue = new SolveQueue(ask, { done: () => undefined, failed: () => failures++, idle: () => undefined });
  queue.want(state(1), 0);
  queue.want(state(2), 0);
  await answer(false);
  await answer(false);
  assert.equal(failures, 2);
  assert.ok(!queue.pending);
  queue.want(state(3), 0);
  assert.deepEqual(asked, [1, 2, 3]);
  await answer();
  assert.ok(!queue.pending);
});
