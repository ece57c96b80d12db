// The lines of a tower: rims, springs and ropes, a line on the shell, and the outline of what was
// at rest.

import type { Vertices } from "./buffer.js";
import { mix, type Palette, type Rgb } from "./colours.js";
import { isLink, onShell, placed, sectionAt, type Section } from "./motion.js";
import type { Point, TowerScene } from "./scene.js";

const CORNERS = 32;

function segment(lines: Vertices, from: Point, to: Point, colour: Rgb): void {
  lines.push(from, colour);
  lines.push(to, colour);
}

function path(lines: Vertices, points: Point[], colour: Rgb): void {
  points.slice(1).forEach((point, i) => segment(lines, points[i]!, point, colour));
}

function rim(lines: Vertices, section: Section, colour: Rgb): void {
  const corners = Array.from({ length: CORNERS + 1 }, (_, k) => onShell(section, (2 * Math.PI * k) / CORNERS, 1.004));
  path(lines, corners, colour);
}

/** A zigzag between two points. */
function spring([from, to]: [Point, Point]): Point[] {
  const along: Point = [to[0] - from[0], to[1] - from[1], to[2] - from[2]];
  const length = Math.hypot(...along) || 1;
  const flat = Math.hypot(along[0], along[1]);
  const side: Point = flat > 1e-3 * length ? [-along[1] / flat, along[0] / flat, 0] : [1, 0, 0];
  const at = (share: number, reach: number): Point => [
    from[0] + share * along[0] + reach * side[0],
    from[1] + share * along[1] + reach * side[1],
    from[2] + share * along[2] + reach * side[2],
  ];
  const turns = Array.from({ length: 8 }, (_, k) => at(0.15 + (0.7 * (k + 0.5)) / 8, (k % 2 ? -0.12 : 0.12) * length));
  return [from, at(0.12, 0), ...turns, at(0.88, 0), to];
}

/** Writes all lines of a tower in a pose, as seen from a bearing. */
export function writeStrokes(
  lines: Vertices, scene: TowerScene, sections: Section[], atRest: Section[] | null, rims: number[], bearing: number, palette: Palette,
): void {
  lines.begin();
  rims.forEach((height) => rim(lines, sectionAt(sections, height), mix(palette.steel, palette.ink, 0.6)));
  scene.bodies.filter(isLink).forEach((body) => {
    const [from, to] = placed(body, sections);
    if (from === undefined || to === undefined) return;
    path(lines, body.form === "spring" ? spring([from, to]) : [from, to], palette.of.link);
  });
  if (atRest !== null) {
    seam(lines, sections, bearing, palette.accent);
    outline(lines, atRest, bearing, palette.muted);
  }
  lines.end();
}

/** Dashes on the shell that face the reader at rest and turn with the sections. */
function seam(lines: Vertices, sections: Section[], bearing: number, colour: Rgb): void {
  for (let i = 0; i + 1 < sections.length; i += 2) {
    segment(lines, onShell(sections[i]!, bearing, 1.02), onShell(sections[i + 1]!, bearing, 1.02), colour);
  }
}

function outline(lines: Vertices, atRest: Section[], bearing: number, colour: Rgb): void {
  [-0.5, 0.5].forEach((side) => path(lines, atRest.map((section) => onShell(section, bearing + side * Math.PI)), colour));
  [atRest[0], atRest[atRest.length - 1]].forEach((section) => section !== undefined && rim(lines, section, colour));
}
