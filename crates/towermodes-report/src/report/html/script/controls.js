// Which modes move, how they are looked at, how far and how fast they go.

const byId = (id) => document.getElementById(id);
const SPEEDS_HZ = [0.05, 0.1, 0.2, 0.35, 0.5, 0.75, 1, 1.5, 2];
// More modes than these are too small to be seen beside each other.
const MOST_SHOWN = 6;

const state = { percent: 10, phase: 0, speed: 4, playing: false, time: null, pictures: [] };
const boxes = (name) => [...document.querySelectorAll(`input[name=${name}]`)];
const chosen = (name) => boxes(name).filter((box) => box.checked).map((box) => box.value);
const shownModes = () => chosen("animation-mode").map((index) => tower.modes[Number(index)]);

// What stays as long as modes, views and amplitude do.
function build() {
  const modes = shownModes(), views = chosen("animation-view");
  const stage = byId("animation-pictures");
  stage.replaceChildren();
  stage.style.setProperty("--views", Math.max(1, views.length));
  const frames = Object.fromEntries(views.map((name) => [name, modes.length ? frameOf(name, modes) : null]));
  state.pictures = modes.flatMap((mode) => {
    const figure = drawn(stage, "div", { class: "mode", role: "group", "aria-label": `Mode ${mode.number}` });
    drawn(figure, "p", { class: "mode-name" }, `Mode ${mode.number}: ${mode.label}, ${mode.frequency_hz} Hz`);
    const row = drawn(figure, "div", { class: "views" });
    return views.map((name) => picture(row, mode, name, frames[name]));
  });
  fillSpace();
  limit(modes.length);
  draw(true);
}

// At most so many modes at once; which, is said to those who listen.
function limit(count) {
  boxes("animation-mode").forEach((box) => { box.disabled = !box.checked && count >= MOST_SHOWN; });
  const names = shownModes().map((mode) => `mode ${mode.number}, ${mode.label}`);
  const views = chosen("animation-view").length;
  const isEmpty = names.length === 0 || views === 0;
  byId("animation-caption").textContent = isEmpty
    ? "Choose a mode and a view."
    : `Shown: ${names.join("; ")}.${names.length >= MOST_SHOWN ? ` No more than ${MOST_SHOWN} at once.` : ""}`;
}

// Drawings that are on paper only are not moved unless asked for.
function draw(isForPaper = false) {
  const scales = new Map(shownModes().map((mode) => [mode, Math.cos(state.phase) * reach(mode, state.percent)]));
  const sections = new Map([...scales].map(([mode, scale]) => [mode, sectionsAt(mode, scale)]));
  state.pictures.forEach((shown) => {
    if (isForPaper || !shown.canvas) move(shown, sections.get(shown.mode));
    if (shown.canvas) pictures?.draw(shown.canvas, poseOf(shown.mode, scales.get(shown.mode)));
  });
  const turns = state.phase / (2 * Math.PI);
  const degrees = Math.round(360 * (turns - Math.round(turns)));
  if (state.playing) byId("animation-phase").value = degrees;
  byId("animation-phase-text").textContent = `${degrees}\u00b0`.replace("-", "\u2212");
  byId("animation-amplitude-text").textContent = `${state.percent} %`;
}

function showDirection() {
  VIEWS.space.azimuth = Number(byId("animation-azimuth").value);
  pictures?.turn(VIEWS.space.azimuth + HALF_TURN);
  writeDirection();
}

function writeDirection() {
  byId("animation-azimuth-text").textContent = `${Math.round(VIEWS.space.azimuth)}\u00b0`.replace("-", "\u2212");
}

function showSpeed() {
  byId("animation-speed").textContent = `${SPEEDS_HZ[state.speed]} cycles per second on screen`;
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
  draw();
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
  draw();
});
byId("animation-phase").addEventListener("input", (event) => {
  state.phase = Number(event.target.value) * DEGREE;
  draw();
});
byId("animation-azimuth").addEventListener("input", () => {
  showDirection();
  if (pictures === null) build();
  else draw();
});
["animation-modes", "animation-view-boxes"].forEach((id) => byId(id).addEventListener("change", build));
// Buttons and boxes have the space bar to themselves; everywhere else in the section it plays and pauses, once a press.
byId("animation").addEventListener("keydown", (event) => {
  const hasModifier = event.shiftKey || event.ctrlKey || event.altKey || event.metaKey;
  if (event.key !== " " || hasModifier || event.target.closest("button, summary, input[type=checkbox]")) return;
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
  build();
});

// A browser may have kept what was chosen before the page was loaded anew, and what was disabled.
byId("animation-phase").disabled = false;
state.percent = Number(byId("animation-amplitude").value);
state.phase = Number(byId("animation-phase").value) * DEGREE;
showDirection();
pictures = openSpace();
showSpeed();
build();
