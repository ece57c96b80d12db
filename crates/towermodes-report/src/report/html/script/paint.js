// The pictures of the stage: one for each mode and view, made when these change, moved by changing paths.

// The figures above are of it.
const SVG = document.querySelector("figure svg").namespaceURI;
// Drawn after the tower, so that it is seen through them.
const THROUGH = ["soil", "water"];

function drawn(parent, name, attributes, text) {
  const element = document.createElementNS(parent.namespaceURI, name);
  Object.entries(attributes).forEach(([key, value]) => element.setAttribute(key, value));
  if (text !== undefined) element.textContent = text;
  parent.appendChild(element);
  return element;
}

// What stands behind the tower, before it, and around it; each with its path.
function layers(name, frame) {
  const depth = (points) => points.reduce((sum, point) => sum + frame.eye.near(point), 0) / points.length;
  const onAxis = (points) => points.map((point) => [0, 0, point[2]]);
  const isBefore = (body) => body.of === "mass" || depth(body.points) > depth(onAxis(body.points));
  const rest = bodiesOf(name).filter((body) => !THROUGH.includes(body.of));
  const moving = rest.filter((body) => ["rna", "rotor", "mass"].includes(body.of));
  const farthestFirst = (a, b) => depth(a.points) - depth(b.points);
  return {
    behind: rest.filter((body) => !moving.includes(body)).concat(moving.filter((body) => !isBefore(body)).sort(farthestFirst)),
    before: moving.filter(isBefore).sort(farthestFirst),
    around: bodiesOf(name).filter((body) => THROUGH.includes(body.of)),
  };
}

// A picture of a mode in a view.
function picture(parent, mode, name, frame) {
  const view = VIEWS[name], id = `view-${mode.number}-${name}`;
  const cell = drawn(parent, "div", { class: `view view-${name}` });
  const svg = document.createElementNS(SVG, "svg");
  const attributes = { id, viewBox: `0 0 ${WIDTH} ${view.height}`, role: "img", "aria-labelledby": `${id}-title ${id}-text`, "font-size": 11 };
  Object.entries(attributes).forEach(([key, value]) => svg.setAttribute(key, value));
  cell.appendChild(svg);
  drawn(svg, "title", { id: `${id}-title` }, `Mode ${mode.number}, ${mode.label}, ${view.name}`);
  drawn(svg, "desc", { id: `${id}-text` }, "The tower undeformed and deflected in the mode, with rotor-nacelle assembly, foundation and surroundings.");
  if (view.axes) drawAxes(svg, frame, view.axes);
  const parts = layers(name, frame);
  const paths = (bodies) => bodies.map((body) => ({ body, path: drawn(svg, "path", { class: `body ${body.of}` }) }));
  const moved = paths(parts.behind);
  drawn(svg, "path", { class: "undeformed", d: towerPath(name, frame, sectionsAt(mode, 0)) });
  const deformed = drawn(svg, "path", { class: "deformed" });
  const rims = name === "space" ? drawn(svg, "path", { class: "rims" }) : null;
  const seam = drawn(svg, "path", { class: "seam" });
  moved.push(...paths(parts.before), ...paths(parts.around));
  if (name === "space") drawDirections(svg, frame);
  drawn(cell, "p", { class: "view-name", "aria-hidden": "true" }, view.name);
  return { mode, name, cell, frame, moved, deformed, rims, seam };
}

// A picture as its mode is at a multiple of its shape.
function move({ name, frame, moved, deformed, rims, seam }, sections) {
  moved.forEach(({ body, path }) => path.setAttribute("d", bodyPath(frame, body, placed(body, sections))));
  deformed.setAttribute("d", towerPath(name, frame, sections));
  seam.setAttribute("d", seamPath(name, frame, sections));
  rims?.setAttribute("d", some(sections, [0, 0.25, 0.5, 0.75, 1]).map((section) => rim(frame, section)).join(""));
}

function drawAxes(svg, frame, names) {
  const group = drawn(svg, "g", { class: "axes" });
  const [left, bottom] = frame.flat(frame.u[0], frame.v[0]);
  const [right, top] = frame.flat(frame.u[1], frame.v[1]);
  const vertical = ticks(frame.v, 6), horizontal = ticks(frame.u, 4);
  vertical.values.forEach((value) => {
    const [, y] = frame.flat(0, value);
    drawn(group, "line", { class: "grid", x1: left, x2: right, y1: y, y2: y });
    drawn(group, "text", { x: left - 5, y: y + 4, "text-anchor": "end" }, written(value, vertical.decimals));
  });
  horizontal.values.forEach((value) => {
    const [x] = frame.flat(value, frame.v[0]);
    drawn(group, "line", { class: "grid", x1: x, x2: x, y1: top, y2: bottom });
    drawn(group, "text", { x, y: bottom + 14, "text-anchor": "middle" }, written(value, horizontal.decimals));
  });
  drawn(group, "line", { class: "axis", x1: left, x2: right, y1: bottom, y2: bottom });
  drawn(group, "line", { class: "axis", x1: left, x2: left, y1: top, y2: bottom });
  drawn(group, "text", { x: 0.5 * (left + right), y: bottom + 32, "text-anchor": "middle" }, names[0]);
  const middle = 0.5 * (top + bottom);
  drawn(group, "text", { x: 11, y: middle, "text-anchor": "middle", transform: `rotate(-90 11 ${middle})` }, names[1]);
}

// Where x, y and z point in the view in space, in its lower left corner.
function drawDirections(svg, { eye }) {
  const [x, y] = [42, VIEWS.space.height - 34];
  [["x", [1, 0, 0]], ["y", [0, 1, 0]], ["z", [0, 0, 1]]].forEach(([name, axis]) => {
    const [dx, dy] = [26 * eye.across(axis), -26 * eye.up(axis)];
    drawn(svg, "line", { class: "axis", x1: x, y1: y, x2: x + dx, y2: y + dy });
    drawn(svg, "text", { x: x + 1.35 * dx, y: y + 1.35 * dy + 4, "text-anchor": "middle" }, name);
  });
}
