import assert from "node:assert/strict";
import { test } from "node:test";
import type { Band, DiagramLine, Resonance } from "../protocol.js";
import { contentOf, hzAt, lastRpm, speedText, type Source } from "./content.js";
import { apart, ticks } from "./ticks.js";

const line = (label: string, mode: number, hz: number): DiagramLine =>
  ({ label, mode, curve: null, class: "tower", points: [[0, hz], [14.52, hz]] });

const RESONANCE: Resonance = {
  word: "pass", conclusion: [], is_checked: true, operation_rpm: [6.9, 12.1], blades: 3, margin: 0.05, multiples: [1, 3, 6, 9],
  lines: [line("1st fore-aft bending", 1, 0.3), line("1st side-side bending", 2, 0.31), line("2nd fore-aft bending", 3, 2.5)],
  rows: [],
};

const source = (resonance = RESONANCE): Source => ({ resonance, look: ({ mode }) => ({ series: (mode ?? 1) - 1, isChosen: mode === 1 }) });

test("speeds of files in rad/s are as short as others", () => {
  assert.deepEqual([5.000011692174984, 7.559987120819503, 6.9, 12.1, 0].map(speedText), ["5", "7.56", "6.9", "12.1", "0"]);
});

test("the near part ends above the first modes and the blade passing frequency", () => {
  const near = contentOf(source(), null, null, false);
  assert.equal(near.last_rpm, 14.52);
  // 3 × 14.52/60 Hz × 1.03 is more than 1.3 × 0.31 Hz.
  assert.ok(Math.abs(near.last_hz - 1.03 * 3 * 14.52 / 60) < 1e-12);
  assert.deepEqual(near.lines.map(({ label }) => label), ["1st fore-aft bending", "1st side-side bending"]);
  assert.equal(near.above, 1);
  const whole = contentOf(source(), null, null, true);
  assert.equal(whole.lines.length, 3);
  assert.equal(whole.above, 0);
});

test("the near part of a floating tower reaches the first modes of the tower", () => {
  // Up to 3.63 rpm, where 3P is at 0.18 Hz.
  const at = (label: string, mode: number, hz: number, of: string): DiagramLine =>
    ({ ...line(label, mode, hz), class: of, points: [[0, hz], [3.63, hz]] });
  const rigid = [at("1st platform surge", 1, 0.007, "platform"), at("1st platform sway", 2, 0.008, "platform")];
  const bending = [at("1st tower fore-aft", 3, 0.516, "tower"), at("1st tower side-side", 4, 0.529, "tower")];
  const { last_hz } = contentOf(source({ ...RESONANCE, operation_rpm: [2, 3], lines: [...rigid, ...bending] }), null, null, false);
  assert.ok(Math.abs(last_hz - 1.3 * 0.529) < 1e-12, `${last_hz}`);
});

test("a ribbon has the margin to both sides of its ray", () => {
  const { ribbons } = contentOf(source(), null, null, false);
  // Twice the margin first, so that the margin is on top; 1P and 3P each.
  assert.deepEqual(ribbons.map(({ isMargin }) => isMargin), [false, false, true, true]);
  for (const [rpm, hz] of ribbons[2]!.points) {
    const distance = rpm / 60 / hz - 1;
    assert.ok(Math.abs(Math.abs(distance) - 0.05) < 1e-12, `${distance}`);
  }
  const unknown = contentOf(source({ ...RESONANCE, is_checked: false, operation_rpm: null }), null, null, false);
  assert.deepEqual(unknown.ribbons, []);
});

test("another tower is below, softer and stiffer soil beside its mode", () => {
  const other = source({ ...RESONANCE, lines: [line("1st fore-aft bending", 1, 0.27)] });
  const at = (frequency_hz: number) => ({ frequency_hz, error_hz: 0, verdict: null });
  const band: Band = {
    refused: null, factors: [0.5, 1, 2], failed: [], shared: [],
    modes: [{ label: "1st side-side bending", family: "side-side", order: 1, at: [at(0.28), at(0.31), at(0.32)] }],
  };
  const content = contentOf(source(), other, band, false);
  assert.deepEqual(content.lines.map(({ isOther }) => isOther), [true, false, false]);
  assert.deepEqual(content.spans, [{ label: "1st side-side bending", low_hz: 0.28, high_hz: 0.32, series: 1 }]);
});

test("a frequency between two speeds is on the line", () => {
  const curve = { points: [[0, 1], [10, 2], [20, 2]] as [number, number][] };
  assert.deepEqual([0, 5, 15, 25].map((rpm) => hzAt(curve, rpm)), [1, 1.5, 2, null]);
  assert.equal(lastRpm({ ...RESONANCE, lines: [] }), 1.2 * 12.1);
});

test("axes have round numbers, labels do not overlap", () => {
  assert.deepEqual(ticks(14.52, 8), [0, 2, 4, 6, 8, 10, 12, 14]);
  assert.deepEqual(ticks(0.75, 4), [0, 0.2, 0.4, 0.6]);
  const places = apart([50, 51, 10, 52], 14, [0, 60]);
  const sorted = [...places].sort((a, b) => a - b);
  assert.ok(sorted.every((place, k) => k === 0 || place - sorted[k - 1]! >= 14 - 1e-9), `${places}`);
  assert.ok(places[2]! <= 10 && Math.max(...places) <= 60);
});
