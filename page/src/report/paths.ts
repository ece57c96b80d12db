// What bodies and tubes look like from an eye, as paths of a drawing.

import type { Eye } from "../view/eye.js";
import type { Limb } from "../view/frame.js";
import { onShell, type Section } from "../view/motion.js";
import type { Body, Point } from "../view/scene.js";
import { linkOf, rim } from "../view/strokes.js";

type Place = [number, number];

const toPath = (places: Place[]): string => `M${places.map(([x, y]) => `${x.toFixed(1)} ${y.toFixed(1)}`).join("L")}`;
const placesOf = (eye: Eye, points: Point[]): Place[] => points.map((point) => eye.place(point));

/** A line through points. */
export const linePath = (eye: Eye, points: Point[]): string => toPath(placesOf(eye, points));

/** The smallest convex polygon around places (Andrew's monotone chain). */
function hull(places: Place[]): Place[] {
  const sorted = places.slice().sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  const half = (list: Place[]): Place[] => {
    const chain: Place[] = [];
    list.forEach((p) => {
      while (chain.length > 1) {
        const [[ax, ay], [bx, by]] = chain.slice(-2) as [Place, Place];
        if ((bx - ax) * (p[1] - ay) - (by - ay) * (p[0] - ax) > 0) break;
        chain.pop();
      }
      chain.push(p);
    });
    return chain.slice(0, -1);
  };
  const around = half(sorted).concat(half(sorted.reverse()));
  return around.length > 0 ? around : places.slice(0, 1);
}

/**
 * The surface of a convex body; of a block its upper edge too, which shows from where it is seen.
 */
export function solidPath(eye: Eye, points: Point[]): string {
  const outlineOf = (some: Point[]): string => `${toPath(hull(placesOf(eye, some)))}Z`;
  const path = outlineOf(points);
  if (points.length !== 8) return path;
  const highest = Math.max(...points.map((point) => point[2]));
  return path + outlineOf(points.filter((point) => point[2] > highest - 1e-6));
}

function ballPath(eye: Eye, center: Point, radius: number): string {
  const [x, y] = eye.place(center).map((value) => value.toFixed(1));
  const r = (radius / eye.scale).toFixed(1);
  return `M${x} ${y}m-${r} 0a${r} ${r} 0 1 0 ${2 * Number(r)} 0a${r} ${r} 0 1 0 ${-2 * Number(r)} 0Z`;
}

/** A body whose points are where it has moved to. */
export function bodyPath(eye: Eye, body: Body, points: Point[]): string {
  if (body.form === "ball") return ballPath(eye, points[0]!, body.radius_m ?? 0);
  return body.form === "solid" ? solidPath(eye, points) : linePath(eye, linkOf(body.form, points));
}

/**
 * The outline of a tube: its axis thickened at right angles, which is what it looks like from
 * anywhere.
 */
export function tubePath(eye: Eye, sections: { middle: Point; radius: number }[]): string {
  const axis = placesOf(eye, sections.map(({ middle }) => middle));
  const [left, right]: [Place[], Place[]] = [[], []];
  axis.forEach(([x, y], i) => {
    const [before, after] = [axis[Math.max(i - 1, 0)]!, axis[Math.min(i + 1, axis.length - 1)]!];
    const [dx, dy] = [after[0] - before[0], after[1] - before[1]];
    const r = sections[i]!.radius / eye.scale / (Math.hypot(dx, dy) || 1);
    left.push([x + r * dy, y - r * dx]);
    right.push([x - r * dy, y + r * dx]);
  });
  return `${toPath(left.concat(right.reverse()))}Z`;
}

/** A member of a frame. */
export const limbPath = (eye: Eye, limb: Limb): string =>
  limb[0]!.radius > 0 ? tubePath(eye, limb) : linePath(eye, limb.map(({ middle }) => middle));

const some = (sections: Section[], shares: number[]): Section[] =>
  shares.map((share) => sections[Math.round(share * (sections.length - 1))]!);

/** The circles of sections at a few heights. */
export const rimsPath = (eye: Eye, sections: Section[]): string =>
  some(sections, [0, 0.25, 0.5, 0.75, 1]).map((section) => `${linePath(eye, rim(section))}Z`).join("");

/** A tower; from above its circles. */
export const towerPath = (eye: Eye, sections: Section[]): string =>
  eye.elevation === 90 ? rimsPath(eye, sections) : tubePath(eye, sections);

/**
 * A line on the shell that faces the reader at rest and turns with the sections; from above the
 * radii that point along x at rest.
 */
export function seamPath(eye: Eye, sections: Section[]): string {
  if (eye.elevation !== 90) return linePath(eye, sections.map((section) => onShell(section, eye.bearing)));
  return some(sections, [0, 0.5, 1]).map((section) => linePath(eye, [section.middle, onShell(section, 0)])).join("");
}
