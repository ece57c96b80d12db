// The lines of a tower: rims, springs and ropes, a line on the shell, and the outline of what was
// at rest.

import { mix, type Palette, type Rgb } from "./colours.js";
import { isLink, onShell, placed, sectionAt, type Section } from "./motion.js";
import type { Form, Point, TowerScene } from "./scene.js";

/** A line through points. */
export interface Stroke {
  points: Point[];
  colour: Rgb;
}

const CORNERS = 32;

/** The circle of a section. */
export const rim = (section: Section, share = 1): Point[] =>
  Array.from({ length: CORNERS + 1 }, (_, k) => onShell(section, (2 * Math.PI * k) / CORNERS, share));

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

/** All lines of a tower in a pose, as seen from a bearing. */
export function strokesOf(
  scene: TowerScene, sections: Section[], atRest: Section[] | null, rims: number[], bearing: number, palette: Palette,
): Stroke[] {
  const all = (lines: Point[][], colour: Rgb): Stroke[] => lines.map((points) => ({ points, colour }));
  const links = scene.bodies.filter(isLink).map((body) => linkOf(body.form, placed(body, sections)));
  const strokes = all(rims.map((height) => rim(sectionAt(sections, height), 1.004)), mix(palette.steel, palette.ink, 0.6));
  strokes.push(...all(links, palette.of.link));
  if (atRest === null) return strokes;
  return strokes.concat(all(seam(sections, bearing), palette.accent), all(outline(atRest, bearing), palette.muted));
}

/** A rope or a spring between its two ends. */
export const linkOf = (form: Form, points: Point[]): Point[] =>
  form === "spring" && points.length === 2 ? spring(points as [Point, Point]) : points;

/** Dashes on the shell that face the reader at rest and turn with the sections. */
function seam(sections: Section[], bearing: number): Point[][] {
  const dashes = sections.slice(1).map((section, i) => [onShell(sections[i]!, bearing, 1.02), onShell(section, bearing, 1.02)]);
  return dashes.filter((_, i) => i % 2 === 0);
}

function outline(atRest: Section[], bearing: number): Point[][] {
  const sides = [-0.5, 0.5].map((side) => atRest.map((section) => onShell(section, bearing + side * Math.PI)));
  return sides.concat([atRest[0]!, atRest[atRest.length - 1]!].map((section) => rim(section, 1.004)));
}
