import assert from "node:assert/strict";
import { test } from "node:test";
import { Latest } from "./latest.js";

/** A program that answers when told to, and counts what was given up. */
function program() {
  const asked: { question: number; signal: AbortSignal; answer: (value: number) => void }[] = [];
  const ask = (question: number, signal: AbortSignal): Promise<number> =>
    new Promise((answer, reject) => {
      asked.push({ question, signal, answer });
      signal.addEventListener("abort", () => reject(new Error("given up")));
    });
  return { asked, ask };
}

const turn = (): Promise<void> => new Promise((resolve) => setTimeout(resolve, 2));

test("a newer question ends the one before, and only its answer counts", async () => {
  const { asked, ask } = program();
  const [done, failed]: [number[], unknown[]] = [[], []];
  const latest = new Latest(ask, { done: (answer) => done.push(answer), failed: (error) => failed.push(error) });
  latest.want(1);
  await turn();
  latest.want(2);
  await turn();
  assert.deepEqual(asked.map(({ signal }) => signal.aborted), [true, false]);
  asked[1]!.answer(20);
  await turn();
  assert.deepEqual([done, failed, latest.pending], [[20], [], false]);
  // The same again is known.
  latest.want(2);
  await turn();
  assert.equal(asked.length, 2);
});

test("who slides asks once", async () => {
  const { asked, ask } = program();
  const latest = new Latest(ask, { done: () => undefined, failed: () => undefined }, 5);
  for (let k = 0; k < 10; k++) latest.want(k);
  await new Promise((resolve) => setTimeout(resolve, 20));
  assert.deepEqual(asked.map(({ question }) => question), [9]);
  latest.cancel();
  assert.ok(!latest.pending);
  // What was given up can be asked again.
  latest.want(9);
  await new Promise((resolve) => setTimeout(resolve, 20));
  assert.equal(asked.length, 2);
});

test("without patience the one that runs ends, then the newest is asked", async () => {
  const { asked, ask } = program();
  const done: number[] = [];
  const latest = new Latest(ask, { done: (answer) => done.push(answer), failed: () => undefined }, null);
  for (let k = 1; k <= 4; k++) latest.want(k);
  asked[0]!.answer(10);
  await turn();
  asked[1]!.answer(40);
  await turn();
  assert.deepEqual([asked.map(({ question }) => question), done, latest.pending], [[1, 4], [10, 40], false]);
});
