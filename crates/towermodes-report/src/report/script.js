// Moves the tower in its modes. Nothing is fetched; without this script the report is complete but still.
(() => {
"use strict";

const byId = (id) => document.getElementById(id);
const dataElement = byId("animation-data");
if (!dataElement) return;
const tower = JSON.parse(dataElement.textContent);
if (!tower.modes.length) return;

const WIDTH = 240, HEIGHT = 400;
// Room for numbers and names of the axes.
const MARGIN = { left: 44, right: 8, top: 10, bottom: 42 };
// A turn per percent of amplitude, where turning is what there is to see.
const RADIANS_PER_PERCENT = 3 * Math.PI / 180;
const MOST_PERCENT = 20;
const SPEEDS_HZ = [0.05, 0.1, 0.2, 0.35, 0.5, 0.75, 1, 1.5, 2];

const state = { mode: 0, percent: 10, phase: 0, speed: 4, playing: false, time: null };
const base = tower.height_m[0];
const height = tower.height_m[tower.height_m.length - 1] - base || 1;
const widest = Math.max(...tower.radius_m);

const largest = (values) => values.reduce((most, value) => Math.max(most, Math.abs(value)), 0);
const currentMode = () => tower.modes[state.mode];

// What a shape is multiplied by at its largest: metres of deflection for each unit.
function reach(mode, percent) {
  const moved = Math.max(largest(mode.x), largest(mode.y), largest(mode.z));
  const turned = largest(mode.rotation_z);
  const until = (most, size) => (size > 0 ? most / size : Infinity);
  const scale = Math.min(until(0.01 * percent * height, moved), until(RADIANS_PER_PERCENT * percent, turned));
  return Number.isFinite(scale) ? scale : 0;
}

// Where the axis and the sections are as the mode is at a share of its largest deflection.
function placed(share) {
  const mode = currentMode();
  const scale = share * reach(mode, state.percent);
  return tower.height_m.map((z, i) => ({
    x: scale * mode.x[i], y: scale * mode.y[i], z: z + scale * mode.z[i],
    turn: scale * mode.rotation_z[i], radius: tower.radius_m[i],
  }));
}

// One scale for height and width: pixels per metre, and where the middle of the base is.
function uprightFrame() {
  const mode = currentMode();
  const stretch = reach(mode, MOST_PERCENT);
  const across = widest + stretch * Math.max(largest(mode.x), largest(mode.y));
  const up = stretch * largest(mode.z);
  const plot = { width: WIDTH - MARGIN.left - MARGIN.right, height: HEIGHT - MARGIN.top - MARGIN.bottom };
  const scale = Math.min(plot.width / (2.1 * across), plot.height / (height + 2 * up));
  const low = base - up, high = low + plot.height / scale;
  const half = plot.width / (2 * scale);
  const place = (u, v) => [MARGIN.left + plot.width / 2 + scale * u, HEIGHT - MARGIN.bottom - scale * (v - low)];
  return { place, u: [-half, half], v: [low, Math.min(high, base + height + 2 * up + 0.12 * height)] };
}

function topFrame() {
  const mode = currentMode();
  const stretch = reach(mode, MOST_PERCENT) * Math.max(largest(mode.x), largest(mode.y));
  const half = 1.1 * (widest + stretch);
  const side = WIDTH - MARGIN.left - MARGIN.right;
  const scale = side / (2 * half);
  const place = (u, v) => [MARGIN.left + side / 2 + scale * u, MARGIN.top + side / 2 - scale * v];
  return { place, u: [-half, half], v: [-half, half] };
}

// Paths.

const toPath = (points) => "M" + points.map(([x, y]) => `${x.toFixed(1)} ${y.toFixed(1)}`).join("L");

// The outline of the tower in a plane: its axis thickened at right angles.
function outline(frame, points, along) {
  const left = [], right = [];
  points.forEach((point, i) => {
    const before = points[Math.max(i - 1, 0)], after = points[Math.min(i + 1, points.length - 1)];
    const du = after[along] - before[along], dv = after.z - before.z;
    const length = Math.hypot(du, dv) || 1;
    const [nu, nv] = [dv / length * point.radius, -du / length * point.radius];
    left.push(frame.place(point[along] - nu, point.z - nv));
    right.push(frame.place(point[along] + nu, point.z + nv));
  });
  return toPath(left.concat(right.reverse())) + "Z";
}

// A line on the shell that faces the reader at rest and turns with the sections.
const seam = (frame, points, along) => toPath(points.map((p) => frame.place(p[along] + p.radius * Math.sin(p.turn), p.z)));

// Sections from above at a few heights, each with the radius that points along x at rest.
function sections(frame, points) {
  const last = points.length - 1;
  const shown = [0, 0.25, 0.5, 0.75, 1].map((share) => points[Math.round(share * last)]);
  return shown.map((point) => circle(frame, point)).join("");
}

function circle(frame, { x, y, turn, radius }) {
  const rim = [];
  for (let k = 0; k < 48; k += 1) {
    const angle = turn + k * Math.PI / 24;
    rim.push(frame.place(x + radius * Math.cos(angle), y + radius * Math.sin(angle)));
  }
  return toPath(rim) + "Z";
}

function spokes(frame, points) {
  const last = points.length - 1;
  const shown = [0, 0.5, 1].map((share) => points[Math.round(share * last)]);
  return shown.map(({ x, y, turn, radius }) => toPath([
    frame.place(x, y),
    frame.place(x + radius * Math.cos(turn), y + radius * Math.sin(turn)),
  ])).join("");
}

// Axes.

function drawn(parent, name, attributes, text) {
  const element = document.createElementNS(parent.namespaceURI, name);
  Object.entries(attributes).forEach(([key, value]) => element.setAttribute(key, value));
  if (text !== undefined) element.textContent = text;
  parent.appendChild(element);
}

function ticks([low, high], count) {
  const rough = (high - low) / count;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((digit) => digit * power).find((size) => size >= rough);
  const values = [];
  for (let k = Math.ceil(low / step); k * step <= high; k += 1) values.push(k * step);
  return { values, decimals: Math.max(0, -Math.floor(Math.log10(step) + 1e-9)) };
}

const written = (value, decimals) => value.toFixed(decimals).replace(/^-(?=.*[1-9])/, "\u2212").replace(/^-/, "");

function drawAxes(svg, frame, names) {
  const group = svg.querySelector(".axes");
  group.replaceChildren();
  const [left, bottom] = frame.place(frame.u[0], frame.v[0]);
  const [right, top] = frame.place(frame.u[1], frame.v[1]);
  const vertical = ticks(frame.v, 6), horizontal = ticks(frame.u, 4);
  vertical.values.forEach((value) => {
    const [, y] = frame.place(0, value);
    drawn(group, "line", { class: "grid", x1: left, x2: right, y1: y, y2: y });
    drawn(group, "text", { x: left - 5, y: y + 4, "text-anchor": "end" }, written(value, vertical.decimals));
  });
  horizontal.values.forEach((value) => {
    const [x] = frame.place(value, frame.v[0]);
    drawn(group, "line", { class: "grid", x1: x, x2: x, y1: top, y2: bottom });
    drawn(group, "text", { x, y: bottom + 14, "text-anchor": "middle" }, written(value, horizontal.decimals));
  });
  drawn(group, "line", { class: "axis", x1: left, x2: right, y1: bottom, y2: bottom });
  drawn(group, "line", { class: "axis", x1: left, x2: left, y1: top, y2: bottom });
  drawn(group, "text", { x: 0.5 * (left + right), y: bottom + 32, "text-anchor": "middle" }, names[0]);
  const middle = 0.5 * (top + bottom);
  drawn(group, "text", { x: 11, y: middle, "text-anchor": "middle", transform: `rotate(-90 11 ${middle})` }, names[1]);
}

// Views.

const upright = (along) => ({
  frame: uprightFrame,
  body: (frame, points) => outline(frame, points, along),
  mark: (frame, points) => seam(frame, points, along),
});
const views = [
  { svg: byId("view-side"), names: ["x, fore-aft (m)", "height z (m)"], ...upright("x") },
  { svg: byId("view-front"), names: ["y, side-side (m)", "height z (m)"], ...upright("y") },
  { svg: byId("view-top"), names: ["x, fore-aft (m)", "y, side-side (m)"], frame: topFrame, body: sections, mark: spokes },
];
views.forEach((view) => {
  drawn(view.svg, "path", { class: "seam" });
  view.marks = view.svg.querySelector(".seam");
});

// What stays as long as mode and amplitude do.
function drawStill() {
  views.forEach((view) => {
    view.current = view.frame();
    drawAxes(view.svg, view.current, view.names);
    view.svg.querySelector(".undeformed").setAttribute("d", view.body(view.current, placed(0)));
  });
  const mode = currentMode();
  byId("animation-caption").textContent = `Mode ${mode.number}: ${mode.label}, ${mode.frequency_hz} Hz`;
  byId("animation-amplitude-text").textContent = `${state.percent} %`;
  drawMoving();
}

function drawMoving() {
  const points = placed(Math.cos(state.phase));
  views.forEach((view) => {
    view.svg.querySelector(".deformed").setAttribute("d", view.body(view.current, points));
    view.marks.setAttribute("d", view.mark(view.current, points));
  });
  const turns = state.phase / (2 * Math.PI);
  const degrees = Math.round(360 * (turns - Math.round(turns)));
  if (state.playing) byId("animation-phase").value = degrees;
  byId("animation-phase-text").textContent = `${degrees}\u00b0`.replace("-", "\u2212");
}

function showSpeed() {
  byId("animation-speed").textContent = `${SPEEDS_HZ[state.speed]} cycles per second here`;
  byId("animation-slower").disabled = state.speed === 0;
  byId("animation-faster").disabled = state.speed === SPEEDS_HZ.length - 1;
}

// Time.

function tick(now) {
  if (!state.playing) return;
  if (state.time !== null) {
    // A page that was hidden goes on where it was.
    const seconds = Math.min(now - state.time, 100) / 1000;
    state.phase = (state.phase + 2 * Math.PI * SPEEDS_HZ[state.speed] * seconds) % (2 * Math.PI);
  }
  state.time = now;
  drawMoving();
  requestAnimationFrame(tick);
}

function setPlaying(playing) {
  if (playing === state.playing) return;
  state.playing = playing;
  state.time = null;
  byId("animation-play").setAttribute("aria-pressed", String(playing));
  byId("animation-phase").disabled = playing;
  if (playing) requestAnimationFrame(tick);
}

function changeSpeed(by) {
  state.speed = Math.min(Math.max(state.speed + by, 0), SPEEDS_HZ.length - 1);
  showSpeed();
}

// Controls.

byId("animation-play").addEventListener("click", () => setPlaying(!state.playing));
byId("animation-slower").addEventListener("click", () => changeSpeed(-1));
byId("animation-faster").addEventListener("click", () => changeSpeed(1));
byId("animation-amplitude").addEventListener("input", (event) => {
  state.percent = Number(event.target.value);
  drawStill();
});
byId("animation-phase").addEventListener("input", (event) => {
  state.phase = Number(event.target.value) * Math.PI / 180;
  drawMoving();
});
byId("animation-modes").addEventListener("change", (event) => {
  state.mode = Number(event.target.value);
  drawStill();
});
// Buttons have the space bar to themselves; everywhere else in the section it plays and pauses, once a press.
byId("animation").addEventListener("keydown", (event) => {
  const hasModifier = event.shiftKey || event.ctrlKey || event.altKey || event.metaKey;
  if (event.key !== " " || hasModifier || event.target.closest("button, summary")) return;
  event.preventDefault();
  if (event.repeat) return;
  setPlaying(!state.playing);
});
// Who asks for less motion never sees any that was not asked for.
matchMedia("(prefers-reduced-motion: reduce)").addEventListener("change", () => setPlaying(false));
window.addEventListener("beforeprint", () => {
  setPlaying(false);
  state.phase = 0;
  byId("animation-phase").value = 0;
  drawMoving();
});

// A browser may have kept what was chosen before the page was loaded anew, and what was disabled.
byId("animation-phase").disabled = false;
state.percent = Number(byId("animation-amplitude").value);
state.phase = Number(byId("animation-phase").value) * Math.PI / 180;
state.mode = Number(document.querySelector("input[name=animation-mode]:checked")?.value ?? 0);
showSpeed();
drawStill();
})();
