// From space to the sheet: directions of view, scales that all modes share, paths.

const DEGREE = Math.PI / 180;
const WIDTH = 300;
// Room for numbers and names of the axes.
const MARGIN = { left: 44, right: 8, top: 10, bottom: 42 };
// Which parts of the scene a view from above has: the others would hide the sections.
const FROM_ABOVE = ["rna"];

// A view in parallel projection from a direction: azimuth from x towards y, elevation above the ground.
const VIEWS = {
  space: { name: "in 3-D", azimuth: -145, elevation: 20, height: 400 },
  side: { name: "from the side", azimuth: -90, elevation: 0, height: 400, axes: ["x, fore-aft (m)", "height z (m)"] },
  front: { name: "from downwind", azimuth: 0, elevation: 0, height: 400, axes: ["y, side-side (m)", "height z (m)"] },
  top: { name: "from above", azimuth: -90, elevation: 90, height: 300, axes: ["x, fore-aft (m)", "y, side-side (m)"] },
};

// Where a point is in a view, in metres to the right and upwards, and how near to the reader.
function camera({ azimuth, elevation }) {
  const exact = (value) => (Math.abs(value) < 1e-12 ? 0 : value);
  const [sinA, cosA] = [exact(Math.sin(azimuth * DEGREE)), exact(Math.cos(azimuth * DEGREE))];
  const [sinE, cosE] = [exact(Math.sin(elevation * DEGREE)), exact(Math.cos(elevation * DEGREE))];
  const towards = ([x, y]) => x * cosA + y * sinA;
  return {
    across: ([x, y]) => y * cosA - x * sinA,
    up: (point) => point[2] * cosE - towards(point) * sinE,
    near: (point) => towards(point) * cosE + point[2] * sinE,
    direction: azimuth * DEGREE,
  };
}

const bodiesOf = (name) => (name === "top" ? tower.bodies.filter((body) => FROM_ABOVE.includes(body.of)) : tower.bodies);

// The scale of a view: that of the largest amplitude of all modes shown, so that they can be compared.
function frameOf(name, modes) {
  const view = VIEWS[name], eye = camera(view);
  const low = [Infinity, Infinity], high = [-Infinity, -Infinity];
  const include = (point, margin) => [eye.across(point), eye.up(point)].forEach((value, i) => {
    low[i] = Math.min(low[i], value - margin);
    high[i] = Math.max(high[i], value + margin);
  });
  modes.forEach((mode) => [-1, 0, 1].forEach((share) => {
    const sections = sectionsAt(mode, share * reach(mode, MOST_PERCENT));
    sections.forEach((section) => include(section.middle, section.radius));
    bodiesOf(name).forEach((body) => placed(body, sections).forEach((point) => include(point, body.radius_m ?? 0)));
  }));
  return sheet(view, eye, low, high);
}

// Places on the sheet for a rectangle of metres: one scale for both directions, the rectangle in the middle.
function sheet(view, eye, low, high) {
  const margin = view.axes ? MARGIN : { left: 4, right: 4, top: 4, bottom: 4 };
  const plot = { width: WIDTH - margin.left - margin.right, height: view.height - margin.top - margin.bottom };
  const scale = 0.97 * Math.min(plot.width / (high[0] - low[0]), plot.height / (high[1] - low[1]));
  const middle = [0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1])];
  const half = [0.5 * plot.width / scale, 0.5 * plot.height / scale];
  const flat = (u, v) => [
    margin.left + 0.5 * plot.width + scale * (u - middle[0]),
    margin.top + 0.5 * plot.height - scale * (v - middle[1]),
  ];
  const range = (i) => [middle[i] - half[i], middle[i] + half[i]];
  return { eye, scale, flat, place: (point) => flat(eye.across(point), eye.up(point)), u: range(0), v: range(1) };
}

// Paths.

const toPath = (points) => "M" + points.map(([x, y]) => `${x.toFixed(1)} ${y.toFixed(1)}`).join("L");

// The smallest convex polygon around points (Andrew's monotone chain).
function hull(points) {
  const sorted = points.slice().sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  const half = (list) => {
    const chain = [];
    list.forEach((p) => {
      while (chain.length > 1) {
        const [[ax, ay], [bx, by]] = chain.slice(-2);
        if ((bx - ax) * (p[1] - ay) - (by - ay) * (p[0] - ax) > 0) break;
        chain.pop();
      }
      chain.push(p);
    });
    return chain.slice(0, -1);
  };
  const around = half(sorted).concat(half(sorted.reverse()));
  return around.length > 0 ? around : points.slice(0, 1);
}

// The surface of a convex body; of a block its upper edge too, which shows from where it is seen.
function solidPath(frame, points) {
  const path = toPath(hull(points.map(frame.place))) + "Z";
  if (points.length !== 8) return path;
  const highest = Math.max(...points.map((point) => point[2]));
  const lid = points.filter((point) => point[2] > highest - 1e-6);
  return path + toPath(hull(lid.map(frame.place))) + "Z";
}

function ballPath(frame, [center], radius) {
  const [x, y] = frame.place(center).map((value) => value.toFixed(1));
  const r = (frame.scale * radius).toFixed(1);
  return `M${x} ${y}m-${r} 0a${r} ${r} 0 1 0 ${2 * r} 0a${r} ${r} 0 1 0 ${-2 * r} 0Z`;
}

function springPath([from, to]) {
  const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
  const length = Math.hypot(dx, dy);
  if (length < 4) return toPath([from, to]);
  const at = (share, side) => [from[0] + share * dx - 3 * side * dy / length, from[1] + share * dy + 3 * side * dx / length];
  const turns = Math.max(3, Math.min(9, Math.round(length / 4)));
  const middle = Array.from({ length: turns }, (_, k) => at(0.15 + 0.7 * (k + 0.5) / turns, k % 2 ? -1 : 1));
  return toPath([from, at(0.12, 0), ...middle, at(0.88, 0), to]);
}

function bodyPath(frame, body, points) {
  switch (body.form) {
    case "ball": return ballPath(frame, points, body.radius_m);
    case "line": return toPath(points.map(frame.place));
    case "spring": return springPath(points.map(frame.place));
    default: return solidPath(frame, points);
  }
}

// The outline of the tower: its axis thickened at right angles, which is what a tube looks like from anywhere.
function outline(frame, sections) {
  const axis = sections.map((section) => frame.place(section.middle));
  const left = [], right = [];
  axis.forEach(([x, y], i) => {
    const before = axis[Math.max(i - 1, 0)], after = axis[Math.min(i + 1, axis.length - 1)];
    const [dx, dy] = [after[0] - before[0], after[1] - before[1]];
    const length = Math.hypot(dx, dy) || 1;
    const r = frame.scale * sections[i].radius / length;
    left.push([x + r * dy, y - r * dx]);
    right.push([x - r * dy, y + r * dx]);
  });
  return toPath(left.concat(right.reverse())) + "Z";
}

const CORNERS = Array.from({ length: 48 }, (_, k) => k * Math.PI / 24);
const rim = (frame, section) => toPath(CORNERS.map((angle) => frame.place(onShell(section, angle)))) + "Z";
const some = (sections, shares) => shares.map((share) => sections[Math.round(share * (sections.length - 1))]);

// The tower in a view: from above sections at a few heights.
function towerPath(name, frame, sections) {
  if (name !== "top") return outline(frame, sections);
  return some(sections, [0, 0.25, 0.5, 0.75, 1]).map((section) => rim(frame, section)).join("");
}

// A line on the shell that faces the reader at rest and turns with the sections; from above the radii that point along x at rest.
function seamPath(name, frame, sections) {
  if (name !== "top") return toPath(sections.map((section) => frame.place(onShell(section, frame.eye.direction))));
  return some(sections, [0, 0.5, 1]).map((section) => toPath([section.middle, onShell(section, 0)].map(frame.place))).join("");
}

// Axes.

function ticks([low, high], count) {
  const rough = (high - low) / count;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((digit) => digit * power).find((size) => size >= rough);
  const values = [];
  for (let k = Math.ceil(low / step); k * step <= high; k += 1) values.push(k * step);
  return { values, decimals: Math.max(0, -Math.floor(Math.log10(step) + 1e-9)) };
}

const written = (value, decimals) => value.toFixed(decimals).replace(/^-(?=.*[1-9])/, "\u2212").replace(/^-/, "");
