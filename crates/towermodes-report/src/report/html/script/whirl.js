// The turbine with its turning rotor, in its modes: the same controls as those of the tower, whose functions draw it.
(() => {

const turbine = JSON.parse(byId("whirl-data").textContent);
// A direction of its own for the view in space.
const looks = { ...VIEWS, space: { ...VIEWS.space } };
const [SHAFT, LEFT, UP] = turbine.shaft_axes;
const TURN = 2 * Math.PI;
const AROUND = Array.from({ length: 49 }, (_, k) => TURN * k / 48);
const BLADES = Array.from({ length: turbine.blades }, (_, k) => TURN * k / turbine.blades);
const height = turbine.height_m[turbine.height_m.length - 1] - turbine.height_m[0];
const stage = { percent: 10, phase: 0, speed: 4, playing: false, time: null, pictures: [] };

// Motion. A mode moves with cos(w t) while the rotor turns by W t: both by the same time.

const plus = (a, b, factor = 1) => a.map((value, i) => value + factor * b[i]);
const cross = ([a, b, c], [x, y, z]) => [b * z - c * y, c * x - a * z, a * y - b * x];
const turnedBy = (mode, phase) => (mode.frequency_hz > 0 ? phase * turbine.rotor_speed_rpm / 60 / mode.frequency_hz : 0);

// Real parts of amplitudes at a phase: those of one, two, ... components.
function realParts(amplitudes, phase) {
  const [cos, sin] = [Math.cos(phase), Math.sin(phase)];
  return Array.from({ length: amplitudes.length / 2 }, (_, i) => amplitudes[2 * i] * cos - amplitudes[2 * i + 1] * sin);
}

const towerAt = (mode, phase, scale) => turbine.height_m.map((z, i) => ({
  height: z,
  middle: plus([0, 0, z], realParts(mode.tower[i], phase), scale),
  turn: [0, 0, 0],
  radius: turbine.radius_m[i],
}));

function nacelleAt(mode, phase, scale) {
  const motion = realParts(mode.nacelle, phase);
  const [shift, rotation] = [motion.slice(0, 3), motion.slice(3)];
  return turbine.nacelle_m.map((corner) => {
    const arm = plus(corner, turbine.apex_m, -1);
    return plus(corner, plus(shift, cross(rotation, arm)), scale);
  });
}

// A section of a blade at an azimuth, at rest and moved.
function section(mode, index, azimuth, phase, scale) {
  const [sin, cos] = [Math.sin(azimuth), Math.cos(azimuth)];
  const axes = [SHAFT, LEFT.map((left, i) => cos * left + sin * UP[i]), UP.map((up, i) => cos * up - sin * LEFT[i])];
  const span = turbine.span_m[index];
  let point = plus(turbine.apex_m, axes[0], span * Math.sin(turbine.cone_rad));
  point = plus(point, axes[2], span * Math.cos(turbine.cone_rad));
  if (scale === 0) return point;
  mode.harmonics.forEach(({ waves, motion }) => {
    realParts(motion[index], phase - waves * azimuth).forEach((value, i) => { point = plus(point, axes[i], scale * value); });
  });
  return point;
}

const bladeAt = (mode, azimuth, phase, scale) => turbine.span_m.map((_, i) => ({
  middle: section(mode, i, azimuth, phase, scale),
  radius: turbine.half_width_m[i],
}));
const TIP = turbine.span_m.length - 1;
const ringAt = (mode, phase, scale) => AROUND.map((azimuth) => section(mode, TIP, azimuth, phase, scale));

// Pictures.

const shownWhirls = () => chosen("whirl-mode").map((index) => turbine.modes[Number(index)]);

// A view has the whole rotor and the largest amplitude.
function wholeFrame(name) {
  const view = looks[name], eye = camera(view), margin = height * MOST_PERCENT / 100;
  const base = turbine.height_m[0], top = turbine.height_m[turbine.height_m.length - 1];
  const still = turbine.modes[0];
  const points = [[0, 0, base], [0, 0, top], ...turbine.nacelle_m, ...ringAt(still, 0, 0)];
  const flat = [eye.across, eye.up].map((of) => points.map(of));
  // The base stays where it is.
  const low = flat.map((values, i) => Math.min(...values) - (i === 1 && name !== "top" ? 0 : margin));
  const high = flat.map((values) => Math.max(...values) + margin);
  return sheet(view, eye, low, high);
}

function whirlPicture(parent, mode, name, frame) {
  const view = looks[name], id = `whirl-${mode.number}-${name}`;
  const cell = drawn(parent, "div", { class: `view view-${name}` });
  const svg = document.createElementNS(SVG, "svg");
  const attributes = { id, viewBox: `0 0 ${WIDTH} ${view.height}`, role: "img", "aria-labelledby": `${id}-title ${id}-text`, "font-size": 11 };
  Object.entries(attributes).forEach(([key, value]) => svg.setAttribute(key, value));
  cell.appendChild(svg);
  drawn(svg, "title", { id: `${id}-title` }, `Mode ${mode.number} of the turbine, ${mode.label}, ${view.name}`);
  drawn(svg, "desc", { id: `${id}-text` }, "Tower, nacelle and turning rotor, undeformed and deflected in the mode.");
  if (view.axes) drawAxes(svg, frame, view.axes);
  const shown = { mode, name, frame, rest: [], blades: [] };
  const path = (kind) => drawn(svg, "path", { class: kind });
  drawn(svg, "path", { class: "undeformed", d: towerPath(name, frame, towerAt(mode, 0, 0)) });
  shown.rest = BLADES.map(() => path("undeformed"));
  const rotor = () => {
    shown.ring = path("ring");
    shown.blades = BLADES.map(() => path("blade"));
    shown.tip = drawn(svg, "circle", { class: "first-tip", r: 2.5 });
  };
  const isBehind = frame.eye.near(turbine.apex_m) < frame.eye.near([0, 0, turbine.apex_m[2]]);
  if (isBehind) rotor();
  shown.nacelle = path("body rna");
  shown.tower = path("deformed");
  if (!isBehind) rotor();
  if (name === "space") drawDirections(svg, frame);
  drawn(cell, "p", { class: "view-name", "aria-hidden": "true" }, view.name);
  return shown;
}

function movePicture({ mode, name, frame, rest, blades, ring, tip, nacelle, tower: tube }) {
  const scale = height * stage.percent / 100, { phase } = stage;
  const turned = turnedBy(mode, phase);
  const line = (sections) => toPath(sections.map(({ middle }) => frame.place(middle)));
  rest.forEach((path, i) => path.setAttribute("d", line(bladeAt(mode, turned + BLADES[i], phase, 0))));
  blades.forEach((path, i) => path.setAttribute("d", outline(frame, bladeAt(mode, turned + BLADES[i], phase, scale))));
  ring.setAttribute("d", toPath(ringAt(mode, phase, scale).map(frame.place)));
  const [x, y] = frame.place(section(mode, TIP, turned, phase, scale));
  tip.setAttribute("cx", x.toFixed(1));
  tip.setAttribute("cy", y.toFixed(1));
  nacelle.setAttribute("d", solidPath(frame, nacelleAt(mode, phase, scale)));
  tube.setAttribute("d", towerPath(name, frame, towerAt(mode, phase, scale)));
}

function show() {
  stage.pictures.forEach(movePicture);
  const turns = stage.phase / TURN;
  const degrees = Math.round(360 * (turns - Math.round(turns)));
  if (stage.playing) byId("whirl-phase").value = degrees;
  byId("whirl-phase-text").textContent = `${degrees}\u00b0`.replace("-", "\u2212");
  byId("whirl-amplitude-text").textContent = `${stage.percent} %`;
}

// What stays as long as modes and views do.
function lay() {
  const modes = shownWhirls(), views = chosen("whirl-view");
  const pictures = byId("whirl-pictures");
  pictures.replaceChildren();
  pictures.style.setProperty("--views", Math.max(1, views.length));
  const frames = Object.fromEntries(views.map((name) => [name, wholeFrame(name)]));
  stage.pictures = modes.flatMap((mode) => {
    const group = drawn(pictures, "div", { class: "mode", role: "group", "aria-label": `Mode ${mode.number} of the turbine` });
    drawn(group, "p", { class: "mode-name" }, `Mode ${mode.number}: ${mode.label}, ${mode.frequency_hz} Hz`);
    const row = drawn(group, "div", { class: "views" });
    return views.map((name) => whirlPicture(row, mode, name, frames[name]));
  });
  boxes("whirl-mode").forEach((box) => { box.disabled = !box.checked && modes.length >= MOST_SHOWN; });
  const names = modes.map((mode) => `mode ${mode.number}, ${mode.label}`);
  byId("whirl-caption").textContent = names.length === 0 || views.length === 0
    ? "Choose a mode and a view."
    : `Shown: ${names.join("; ")}.${names.length >= MOST_SHOWN ? ` No more than ${MOST_SHOWN} at once.` : ""}`;
  show();
}

function showLook() {
  looks.space.azimuth = Number(byId("whirl-azimuth").value);
  byId("whirl-azimuth-text").textContent = `${looks.space.azimuth}\u00b0`.replace("-", "\u2212");
}

function showPace() {
  byId("whirl-speed").textContent = `${SPEEDS_HZ[stage.speed]} cycles per second on screen`;
  byId("whirl-slower").disabled = stage.speed === 0;
  byId("whirl-faster").disabled = stage.speed === SPEEDS_HZ.length - 1;
}

// Time. The phase goes on beyond a turn, so that the rotor turns steadily.

function step(now) {
  if (!stage.playing) return;
  if (stage.time !== null) stage.phase += TURN * SPEEDS_HZ[stage.speed] * Math.min(now - stage.time, 100) / 1000;
  stage.time = now;
  show();
  requestAnimationFrame(step);
}

function play(playing) {
  if (playing === stage.playing) return;
  stage.playing = playing;
  stage.time = null;
  byId("whirl-play").setAttribute("aria-pressed", String(playing));
  byId("whirl-phase").disabled = playing;
  if (playing) requestAnimationFrame(step);
}

function changePace(by) {
  stage.speed = Math.min(Math.max(stage.speed + by, 0), SPEEDS_HZ.length - 1);
  showPace();
}

byId("whirl-play").addEventListener("click", () => play(!stage.playing));
byId("whirl-slower").addEventListener("click", () => changePace(-1));
byId("whirl-faster").addEventListener("click", () => changePace(1));
byId("whirl-amplitude").addEventListener("input", (event) => {
  stage.percent = Number(event.target.value);
  show();
});
byId("whirl-phase").addEventListener("input", (event) => {
  stage.phase = Number(event.target.value) * DEGREE;
  show();
});
byId("whirl-azimuth").addEventListener("input", () => {
  showLook();
  lay();
});
["whirl-modes", "whirl-view-boxes"].forEach((id) => byId(id).addEventListener("change", lay));
byId("whirl").addEventListener("keydown", (event) => {
  const hasModifier = event.shiftKey || event.ctrlKey || event.altKey || event.metaKey;
  if (event.key !== " " || hasModifier || event.target.closest("button, summary, input[type=checkbox]")) return;
  event.preventDefault();
  if (!event.repeat) play(!stage.playing);
});
// Nothing moves unless asked for.
matchMedia("(prefers-reduced-motion: reduce)").addEventListener("change", () => play(false));
window.addEventListener("beforeprint", () => {
  play(false);
  stage.phase = 0;
  byId("whirl-phase").value = 0;
  lay();
});

byId("whirl-phase").disabled = false;
stage.percent = Number(byId("whirl-amplitude").value);
stage.phase = Number(byId("whirl-phase").value) * DEGREE;
showLook();
showPace();
lay();
})();
