// How the tower and what is fixed to it move: the only place where it is written down. Reports use
// it too.

import type { Body, Point, Pose, Shape, TowerScene } from "./scene.js";

/** A section of the tower: where its middle is and how it is turned. */
export interface Section {
  /** Its height at rest, m. */
  height: number;
  middle: Point;
  /** Rotation vector, rad. */
  turn: Point;
  radius: number;
}

/** A turn per percent of amplitude, where turning is what there is to see. */
const RADIANS_PER_PERCENT = (3 * Math.PI) / 180;

const largest = (values: number[]): number => values.reduce((most, value) => Math.max(most, Math.abs(value)), 0);

/** The largest translation of a frame in a shape or a pose. */
export function largestOfFrame(frame: number[] = []): number {
  let most = 0;
  for (let i = 0; i + 2 < frame.length; i += 3) most = Math.max(most, Math.hypot(frame[i]!, frame[i + 1]!, frame[i + 2]!));
  return most;
}

/**
 * What a shape is multiplied by so that its largest deflection is so many percent of the height,
 * or its largest rotation three degrees a percent where that is less.
 */
export function reach(scene: TowerScene, mode: Shape, percent: number): number {
  const height = scene.height_m[scene.height_m.length - 1]! - scene.height_m[0]! || 1;
  const moved = Math.max(largest(mode.x), largest(mode.y), largest(mode.z), largestOfFrame(mode.frame));
  const until = (most: number, size: number): number => (size > 0 ? most / size : Infinity);
  const scale = Math.min(
    until(0.01 * percent * height, moved),
    until(RADIANS_PER_PERCENT * percent, largest(mode.rotation_z)),
  );
  return Number.isFinite(scale) ? scale : 0;
}

/** The pose of a multiple of a mode's shape. */
export function poseOf(mode: Shape, scale: number): Pose {
  return {
    displacement: mode.x.map((x, i) => [scale * x, scale * mode.y[i]!, scale * mode.z[i]!]),
    rotation: mode.rotation_x.map((x, i) => [scale * x, scale * mode.rotation_y[i]!, scale * mode.rotation_z[i]!]),
    frame: mode.frame?.map((value) => scale * value) ?? [],
  };
}

/** The sections of a tower in a pose; null is at rest. */
export function sectionsOf(scene: TowerScene, pose: Pose | null): Section[] {
  return scene.height_m.map((z, i) => {
    const [x, y, up] = pose?.displacement[i] ?? [0, 0, 0];
    const turn = pose?.rotation[i] ?? [0, 0, 0];
    return { height: z, middle: [x, y, z + up], turn, radius: scene.radius_m[i]! };
  });
}

/** The sections of a tower at a multiple of a mode's shape. */
export const sectionsAt = (scene: TowerScene, mode: Shape, scale: number): Section[] =>
  sectionsOf(scene, poseOf(mode, scale));

/** The section at any height, between its neighbours. */
export function sectionAt(sections: Section[], z: number): Section {
  const above = sections.findIndex((section) => section.height >= z);
  if (above <= 0) return above === 0 ? sections[0]! : sections[sections.length - 1]!;
  const a = sections[above - 1]!;
  const b = sections[above]!;
  const share = (z - a.height) / (b.height - a.height);
  const between = (from: Point, to: Point): Point => [
    from[0] + share * (to[0] - from[0]),
    from[1] + share * (to[1] - from[1]),
    from[2] + share * (to[2] - from[2]),
  ];
  return {
    height: z,
    middle: between(a.middle, b.middle),
    turn: between(a.turn, b.turn),
    radius: a.radius + share * (b.radius - a.radius),
  };
}

/**
 * A vector turned about an axis by the length of that axis (Rodrigues): bodies stay rigid however
 * far they turn.
 */
export function turned([x, y, z]: Point, [a, b, c]: Point): Point {
  const angle = Math.hypot(a, b, c);
  if (angle === 0) return [x, y, z];
  const u = a / angle;
  const v = b / angle;
  const w = c / angle;
  const sin = Math.sin(angle);
  const cos = Math.cos(angle);
  const along = (u * x + v * y + w * z) * (1 - cos);
  return [
    x * cos + (v * z - w * y) * sin + u * along,
    y * cos + (w * x - u * z) * sin + v * along,
    z * cos + (u * y - v * x) * sin + w * along,
  ];
}

/** A point that is fixed to a section, given as it is at rest. */
export function carried(section: Section, [x, y, z]: Point): Point {
  const [a, b, c] = turned([x, y, z - section.height], section.turn);
  return [section.middle[0] + a, section.middle[1] + b, section.middle[2] + c];
}

/** Whether a body links the tower to what stands still. */
export const isLink = (body: Body): boolean => body.form === "line" || body.form === "spring";

/**
 * The points of a body. Of what links the tower to what stands still the first moves, the last does
 * not.
 */
export function placed(body: Body, sections: Section[]): Point[] {
  if (body.follows_m === undefined) return body.points;
  const section = sectionAt(sections, body.follows_m);
  if (!isLink(body)) return body.points.map((point) => carried(section, point));
  const first = body.points[0]!;
  const moved = carried(section, first);
  const steps = body.points.length - 1;
  return body.points.map(([x, y, z], i) => {
    const share = 1 - i / steps;
    return [x + share * (moved[0] - first[0]), y + share * (moved[1] - first[1]), z + share * (moved[2] - first[2])];
  });
}

/** A rope with its weight: where it ends is far away. */
export const isRope = (body: Body): boolean => isLink(body) && body.points.length > 2;

/** A point on the shell of a section, by its direction at rest, at a multiple of its radius. */
export const onShell = (section: Section, direction: number, share = 1): Point => {
  const r = share * section.radius;
  return carried(section, [r * Math.cos(direction), r * Math.sin(direction), section.height]);
};
