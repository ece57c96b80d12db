// How the tower and what is fixed to it move in a mode.

const tower = JSON.parse(document.getElementById("animation-data").textContent);
const base = tower.height_m[0];
const height = tower.height_m[tower.height_m.length - 1] - base || 1;

// A turn per percent of amplitude, where turning is what there is to see.
const RADIANS_PER_PERCENT = 3 * Math.PI / 180;
const MOST_PERCENT = 20;

const largest = (values) => values.reduce((most, value) => Math.max(most, Math.abs(value)), 0);

// What a shape is multiplied by at its largest: metres of deflection for each unit.
function reach(mode, percent) {
  const moved = Math.max(largest(mode.x), largest(mode.y), largest(mode.z));
  const turned = largest(mode.rotation_z);
  const until = (most, size) => (size > 0 ? most / size : Infinity);
  const scale = Math.min(until(0.01 * percent * height, moved), until(RADIANS_PER_PERCENT * percent, turned));
  return Number.isFinite(scale) ? scale : 0;
}

// The sections of the tower as a mode is at a multiple of its shape: where their middles are and how they are turned.
function sectionsAt(mode, scale) {
  return tower.height_m.map((z, i) => ({
    height: z,
    middle: [scale * mode.x[i], scale * mode.y[i], z + scale * mode.z[i]],
    turn: [scale * mode.rotation_x[i], scale * mode.rotation_y[i], scale * mode.rotation_z[i]],
    radius: tower.radius_m[i],
  }));
}

// The section at any height, between its neighbours.
function sectionAt(sections, z) {
  const above = sections.findIndex((section) => section.height >= z);
  if (above <= 0) return above === 0 ? sections[0] : sections[sections.length - 1];
  const [a, b] = [sections[above - 1], sections[above]];
  const share = (z - a.height) / (b.height - a.height);
  const between = (from, to) => from.map((value, i) => value + share * (to[i] - value));
  return { height: z, middle: between(a.middle, b.middle), turn: between(a.turn, b.turn), radius: a.radius };
}

// A vector turned about an axis by the length of that axis (Rodrigues): bodies stay rigid however far they turn.
function turned([x, y, z], [a, b, c]) {
  const angle = Math.hypot(a, b, c);
  if (angle === 0) return [x, y, z];
  const [u, v, w] = [a / angle, b / angle, c / angle];
  const sin = Math.sin(angle), cos = Math.cos(angle);
  const along = (u * x + v * y + w * z) * (1 - cos);
  return [
    x * cos + (v * z - w * y) * sin + u * along,
    y * cos + (w * x - u * z) * sin + v * along,
    z * cos + (u * y - v * x) * sin + w * along,
  ];
}

// A point that is fixed to a section, given as it is at rest.
function carried(section, [x, y, z]) {
  const [a, b, c] = turned([x, y, z - section.height], section.turn);
  return [section.middle[0] + a, section.middle[1] + b, section.middle[2] + c];
}

// The points of a body. Of what links the tower to what stands still only the first moves.
function placed(body, sections) {
  if (body.follows_m === undefined) return body.points;
  const section = sectionAt(sections, body.follows_m);
  const isLink = body.form === "line" || body.form === "spring";
  return body.points.map((point, i) => (isLink && i > 0 ? point : carried(section, point)));
}

// A point on the shell of a section, by its direction at rest.
const onShell = (section, direction) =>
  carried(section, [section.radius * Math.cos(direction), section.radius * Math.sin(direction), section.height]);
