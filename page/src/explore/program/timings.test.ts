import assert from "node:assert/strict";
import { test } from "node:test";
import { Timings } from "./timings.js";

const timing = (event_ms: number) => ({ event_ms, frame_ms: 2, waited_ms: 3, solve_ms: 1.25, answer_ms: 5 });

test("the last times are kept, the oldest first", () => {
  const timings = new Timings(3);
  assert.deepEqual(timings.all(), []);
  assert.equal(timings.text(), "");
  for (let event = 10; event < 15; event++) timings.add(timing(event));
  assert.deepEqual(timings.all(), [timing(12), timing(13), timing(14)]);
  assert.equal(timings.text(), "solve 1.3 ms · event to picture 14 ms");
});
