import assert from "node:assert/strict";
import { test } from "node:test";
import { Follower } from "./follow.js";
import { sample, type Sample } from "./sample.js";

const foreAft = (order: number, frequency_hz: number, more: Partial<Sample> = {}): Sample =>
  ({ family: "fore-aft", order, frequency_hz, ...more });
const sideSide = (order: number, frequency_hz: number, more: Partial<Sample> = {}): Sample =>
  ({ family: "side-side", order, frequency_hz, ...more });
const torsion = (order: number, frequency_hz: number, more: Partial<Sample> = {}): Sample =>
  ({ family: "torsion", order, frequency_hz, ...more });

function follow(follower: Follower, modes: Sample[], heights?: number) {
  const made = sample(modes, heights);
  return follower.follow(made.modes, made.scene);
}

const names = (followed: { name: string }[]): string[] => followed.map(({ name }) => name);

test("modes that exchange order keep name and colour", () => {
  const follower = new Follower();
  const before = follow(follower, [sideSide(1, 0.3), foreAft(1, 0.31), torsion(1, 1.1), foreAft(2, 1.2)]);
  const after = follow(follower, [foreAft(1, 0.31), sideSide(1, 0.33), foreAft(2, 1.15), torsion(1, 1.2)]);
  assert.deepEqual(names(after), ["1 fore-aft", "1 side-side", "2 fore-aft", "1 torsion"]);
  for (const one of after) assert.equal(one.series, before.find(({ id }) => id === one.id)?.series);
  assert.equal(new Set(after.map(({ series }) => series)).size, 4);
});

test("other numbers of heights, amplitudes and signs of the shapes do not matter", () => {
  const follower = new Follower();
  const before = follow(follower, [foreAft(1, 0.3), foreAft(2, 1.2)], 31);
  const after = follow(follower, [foreAft(2, 1.1, { factor: -3 }), foreAft(1, 1.2, { factor: 0.2 })], 58);
  assert.deepEqual(after.map(({ id }) => id), [before[1]?.id, before[0]?.id]);
});

test("a shape that the solver turns over is turned back, and stays so", () => {
  const follower = new Follower();
  assert.equal(follow(follower, [foreAft(1, 0.3)])[0]?.sign, 1);
  assert.equal(follow(follower, [foreAft(1, 0.3, { factor: -1 })])[0]?.sign, -1);
  assert.equal(follow(follower, [foreAft(1, 0.3, { factor: -1 })])[0]?.sign, -1);
  assert.equal(follow(follower, [foreAft(1, 0.3)])[0]?.sign, 1);
});

test("an equal pair in turned planes is told apart by family", () => {
  const follower = new Follower();
  const before = follow(follower, [foreAft(1, 0.3, { plane: 50 }), sideSide(1, 0.3, { plane: 140 }), foreAft(2, 1.5)]);
  const after = follow(follower, [sideSide(1, 0.3, { plane: 90 }), foreAft(1, 0.3, { plane: 0 }), foreAft(2, 1.5)]);
  assert.deepEqual(after.map(({ id }) => id), [before[1]?.id, before[0]?.id, before[2]?.id]);
});

test("planes that turn by small steps are followed through coupled shapes", () => {
  const follower = new Follower();
  const [first] = follow(follower, [foreAft(1, 0.3), sideSide(1, 0.32)]);
  let followed = [first];
  for (let plane = 5; plane <= 90; plane += 5) {
    const pair = plane < 45 ? [foreAft(1, 0.3, { plane }), sideSide(1, 0.32, { plane: plane + 90 })]
      : [sideSide(1, 0.3, { plane }), foreAft(1, 0.32, { plane: plane + 90 })];
    followed = follow(follower, pair);
    assert.equal(followed[0]?.id, first?.id, `plane ${plane}`);
  }
  assert.equal(followed[0]?.name, "1 fore-aft");
});

test("where shapes are unlike, family and order decide", () => {
  const follower = new Follower();
  const before = follow(follower, [foreAft(1, 0.3, { plane: 0 }), torsion(1, 1)]);
  const after = follow(follower, [torsion(1, 0.2), foreAft(1, 0.3, { plane: 80 })]);
  assert.deepEqual(after.map(({ id }) => id), [before[1]?.id, before[0]?.id]);
});

test("a mode that leaves the list and comes back is the same; a new one has a free colour", () => {
  const follower = new Follower();
  const before = follow(follower, [foreAft(1, 0.3), sideSide(3, 2), torsion(1, 2.1)]);
  const without = follow(follower, [foreAft(1, 0.3), torsion(1, 1.9), foreAft(3, 2)]);
  assert.equal(without[1]?.id, before[2]?.id);
  assert.ok(before.every(({ id }) => id !== without[2]?.id));
  assert.ok(without[2]?.series !== without[0]?.series && without[2]?.series !== without[1]?.series);
  const after = follow(follower, [foreAft(1, 0.3), sideSide(3, 1.8), torsion(1, 1.9)]);
  assert.deepEqual(after.map(({ id }) => id), before.map(({ id }) => id));
});

test("identities from before a reload are taken up, and new ones differ from them", () => {
  const old = new Follower();
  follow(old, [foreAft(1, 0.3), sideSide(1, 0.31)]);
  const before = follow(old, [sideSide(1, 0.3), foreAft(1, 0.31)]);
  const fresh = new Follower(before.map(({ id, name, series }) => ({ id, name, series })));
  const after = follow(fresh, [sideSide(1, 0.3), foreAft(1, 0.31)]);
  assert.deepEqual(after, before);
  const more = follow(fresh, [sideSide(1, 0.3), foreAft(1, 0.31), torsion(1, 1)]);
  assert.equal(new Set(more.map(({ id }) => id)).size, 3);
});
