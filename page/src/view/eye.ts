// From where the view is looked at, in parallel projection: what is as long is drawn as long.

import type { OrthographicCamera } from "three";

import type { Point } from "./scene.js";

const DEGREE = Math.PI / 180;
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

  /** Metres to the right. */
  across([x, y]: Point): number {
    return y * Math.cos(this.bearing) - x * Math.sin(this.bearing);
  }

  /** The horizontal direction to the right. */
  get right(): Point {
    return [-Math.sin(this.bearing), Math.cos(this.bearing), 0];
  }

  /** Metres upwards in the picture. */
  up([x, y, z]: Point): number {
    const towards = x * Math.cos(this.bearing) + y * Math.sin(this.bearing);
    return z * Math.cos(this.elevation * DEGREE) - towards * Math.sin(this.elevation * DEGREE);
  }

  /** How many metres upwards in the picture a metre of height is. */
  get rise(): number {
    return Math.cos(this.elevation * DEGREE);
  }

  /** Pixels from the upper left corner. */
  place(point: Point): [number, number] {
    return [
      0.5 * this.width + (this.across(point) - this.middle[0]) / this.scale,
      0.5 * this.height - (this.up(point) - this.middle[1]) / this.scale,
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

  /** Sets a camera of three.js; everything within a distance of the level is in front of it. */
  aim(camera: OrthographicCamera, distance: number): void {
    const [c, s] = [Math.cos(this.bearing), Math.sin(this.bearing)];
    const [ce, se] = [Math.cos(this.elevation * DEGREE), Math.sin(this.elevation * DEGREE)];
    camera.position.set(c * ce * distance, s * ce * distance, this.level + se * distance);
    camera.up.set(-c * se, -s * se, ce);
    camera.lookAt(0, 0, this.level);
    const half = [0.5 * this.width * this.scale, 0.5 * this.height * this.scale];
    const [u, v] = [this.middle[0], this.middle[1] - this.up([0, 0, this.level])];
    Object.assign(camera, { left: u - half[0]!, right: u + half[0]!, bottom: v - half[1]!, top: v + half[1]! });
    Object.assign(camera, { near: 0, far: 2 * distance });
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
  }
}
