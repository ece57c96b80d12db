// From where the view is looked at, in parallel projection: what is as long is drawn as long.

import { isRope, placed, type Section } from "./motion.js";
import type { Body, Frame, Point } from "./scene.js";

const DEGREE = Math.PI / 180;
const dot = (a: Point, b: Point): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const LOWEST = -30;
const HIGHEST = 89;

/** A rectangle of the view, m. */
export interface Extent {
  low: [number, number];
  high: [number, number];
}

/** The rectangle around two. */
export const union = (a: Extent, b: Extent): Extent => ({
  low: [Math.min(a.low[0], b.low[0]), Math.min(a.low[1], b.low[1])],
  high: [Math.max(a.high[0], b.high[0]), Math.max(a.high[1], b.high[1])],
});

/**
 * The rectangle around the sections of a tower, bodies and a frame at rest, as seen by an eye. Of
 * ropes it has the beginning: anchors may be far away.
 */
export function extentOf(eye: Eye, sections: Section[], bodies: Body[], frame?: Frame): Extent {
  const extent = (point: Point, margin: number): Extent => {
    const at: [number, number] = [eye.across(point), eye.up(point)];
    return { low: [at[0] - margin, at[1] - margin], high: [at[0] + margin, at[1] + margin] };
  };
  const ofTower = sections.map(({ middle, radius }) => extent(middle, radius));
  const ofBodies = bodies.flatMap((body) => {
    const points = placed(body, sections);
    return (isRope(body) ? points.slice(0, 1) : points).map((point) => extent(point, body.radius_m ?? 0));
  });
  const ofFrame = frame?.joints.map((joint) => extent(joint, 0)) ?? [];
  return ofTower.concat(ofBodies, ofFrame).reduce(union);
}

/** Two sizes with a larger ratio than this are not seen in one picture. */
const OTHER_SIZE = 3;

/** Whether a rectangle is so much larger or smaller than one before that it needs another scale. */
export function isOtherSize(before: Extent, now: Extent): boolean {
  const size = ({ low, high }: Extent): number => Math.max(high[0] - low[0], high[1] - low[1]);
  const ratio = size(now) / size(before);
  return ratio > OTHER_SIZE || ratio < 1 / OTHER_SIZE;
}

/** Sine and cosine, which are zero at right angles. */
const circular = (angle: number): [number, number] =>
  [Math.sin(angle), Math.cos(angle)].map((value) => (Math.abs(value) < 1e-12 ? 0 : value)) as [number, number];

/** A direction of view, a middle and a scale. */
export class Eye {
  /** From the upwind side about the tower, degrees. */
  azimuth = 35;
  elevation = 20;
  /** Metres a pixel. */
  scale = 0.2;
  /** The middle of the picture, m to the right and upwards. */
  middle: [number, number] = [0, 0];
  /** The height about which it is turned, m. */
  level = 0;
  width = 1;
  height = 1;

  /** Turns to a direction about the level: it stays where it is in the picture. */
  look(azimuth: number, elevation: number): void {
    const before = this.up([0, 0, this.level]);
    this.azimuth = ((((azimuth + 180) % 360) + 360) % 360) - 180;
    this.elevation = Math.min(Math.max(elevation, LOWEST), HIGHEST);
    this.middle[1] += this.up([0, 0, this.level]) - before;
  }

  /** The angle from x towards y of the horizontal direction to the eye, rad. */
  get bearing(): number {
    return (this.azimuth + 180) * DEGREE;
  }

  /** The unit vectors to the right, upwards in the picture, and towards the reader. */
  get axes(): [Point, Point, Point] {
    const [s, c] = circular(this.bearing);
    const [se, ce] = circular(this.elevation * DEGREE);
    return [[-s, c, 0], [-c * se, -s * se, ce], [c * ce, s * ce, se]];
  }

  /** Metres to the right. */
  across(point: Point): number {
    return dot(this.axes[0], point);
  }

  /** The horizontal direction to the right. */
  get right(): Point {
    return this.axes[0];
  }

  /** Metres upwards in the picture. */
  up(point: Point): number {
    return dot(this.axes[1], point);
  }

  /** Metres towards the reader. */
  near(point: Point): number {
    return dot(this.axes[2], point);
  }

  /** How many metres upwards in the picture a metre of height is. */
  get rise(): number {
    return Math.cos(this.elevation * DEGREE);
  }

  /** Pixels from the upper left corner. */
  place(point: Point): [number, number] {
    const [right, up] = this.axes;
    return [
      0.5 * this.width + (dot(right, point) - this.middle[0]) / this.scale,
      0.5 * this.height - (dot(up, point) - this.middle[1]) / this.scale,
    ];
  }

  /** Zooms by a factor; what is at a pixel stays there. */
  zoom(factor: number, [x, y]: [number, number] = [0.5 * this.width, 0.5 * this.height]): void {
    const right = (x - 0.5 * this.width) * this.scale;
    const up = (0.5 * this.height - y) * this.scale;
    this.scale /= factor;
    this.middle[0] += right * (1 - 1 / factor);
    this.middle[1] += up * (1 - 1 / factor);
  }

  /** Moves the picture by pixels. */
  pan(right: number, down: number): void {
    this.middle[0] -= right * this.scale;
    this.middle[1] += down * this.scale;
  }

  /** Shows a rectangle with a margin around it. */
  frame({ low, high }: Extent): void {
    const margin = 1.08;
    const wide = Math.max(high[0] - low[0], 1e-3);
    const tall = Math.max(high[1] - low[1], 1e-3);
    this.scale = margin * Math.max(wide / this.width, tall / this.height);
    this.middle = [0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1])];
  }

  /** Whether a rectangle is within the picture. */
  shows({ low, high }: Extent): boolean {
    const half = [0.5 * this.width * this.scale, 0.5 * this.height * this.scale];
    return [0, 1].every((i) => low[i]! >= this.middle[i]! - half[i]! && high[i]! <= this.middle[i]! + half[i]!);
  }

  /**
   * The matrix from space to the cube of WebGL, by columns; everything within a distance of the
   * level is in front of the eye.
   */
  matrix(distance: number): number[] {
    const [right, up, near] = this.axes;
    const half = [0.5 * this.width * this.scale, 0.5 * this.height * this.scale, -distance] as const;
    const columns = [0, 1, 2].flatMap((i) => [right[i]! / half[0], up[i]! / half[1], near[i]! / half[2], 0]);
    const level = this.near([0, 0, this.level]);
    return [...columns, -this.middle[0] / half[0], -this.middle[1] / half[1], -level / half[2], 1];
  }
}
