// A turbine with a turning rotor in one of its modes: where its sections are at a phase.

import type { Section } from "./motion.js";
import type { Point } from "./scene.js";

/** A mode: amplitudes as real and imaginary parts by turns, the largest translation is 1. */
export interface WhirlMode {
  number: number;
  label: string;
  frequency_hz: number;
  tower: number[][];
  nacelle: number[];
  harmonics: { waves: number; motion: number[][] }[];
}

/** A turbine and its modes at a rotor speed, as the program writes them. */
export interface Turbine {
  rotor_speed_rpm: number;
  blades: number;
  cone_rad: number;
  shaft_axes: [Point, Point, Point];
  apex_m: Point;
  nacelle_m: Point[];
  height_m: number[];
  radius_m: number[];
  span_m: number[];
  half_width_m: number[];
  modes: WhirlMode[];
}

export const TURN = 2 * Math.PI;
const AROUND = Array.from({ length: 49 }, (_, k) => (TURN * k) / 48);

const plus = (a: Point, b: Point | number[], factor = 1): Point => [a[0] + factor * b[0]!, a[1] + factor * b[1]!, a[2] + factor * b[2]!];
const cross = ([a, b, c]: number[], [x, y, z]: Point): Point => [b! * z - c! * y, c! * x - a! * z, a! * y - b! * x];

/** Real parts of amplitudes at a phase. */
function realParts(amplitudes: number[], phase: number): number[] {
  const [cos, sin] = [Math.cos(phase), Math.sin(phase)];
  return Array.from({ length: amplitudes.length / 2 }, (_, i) => amplitudes[2 * i]! * cos - amplitudes[2 * i + 1]! * sin);
}

/** A turbine in one of its modes at a phase, with the largest deflection `scale`, m. */
export class Moment {
  constructor(private readonly turbine: Turbine, private readonly mode: WhirlMode, private readonly phase: number, private readonly scale: number) {}

  get tower(): Section[] {
    const { height_m, radius_m } = this.turbine;
    return height_m.map((height, i) => ({
      height, middle: plus([0, 0, height], realParts(this.mode.tower[i]!, this.phase), this.scale), turn: [0, 0, 0], radius: radius_m[i]!,
    }));
  }

  get nacelle(): Point[] {
    const { nacelle_m, apex_m } = this.turbine;
    const motion = realParts(this.mode.nacelle, this.phase);
    return nacelle_m.map((corner) => {
      const turned = cross(motion.slice(3), plus(corner, apex_m, -1));
      return plus(plus(corner, motion, this.scale), turned, this.scale);
    });
  }

  /** The rotation of the nacelle, rad. */
  get nacelleTurn(): Point {
    const [x, y, z] = realParts(this.mode.nacelle.slice(6), this.phase).map((value) => this.scale * value);
    return [x ?? 0, y ?? 0, z ?? 0];
  }

  /** The apex of the rotor. */
  get apex(): Point {
    const [x, y, z] = realParts(this.mode.nacelle.slice(0, 6), this.phase);
    return plus(this.turbine.apex_m, [x ?? 0, y ?? 0, z ?? 0], this.scale);
  }

  /** By how much the rotor has turned, rad. */
  get turned(): number {
    const { frequency_hz } = this.mode;
    return frequency_hz > 0 ? (this.phase * this.turbine.rotor_speed_rpm) / 60 / frequency_hz : 0;
  }

  /** A section of a blade at an azimuth. */
  section(index: number, azimuth: number): Point {
    const { shaft_axes: [shaft, left, up], apex_m, cone_rad, span_m } = this.turbine;
    const [sin, cos] = [Math.sin(azimuth), Math.cos(azimuth)];
    const along = (a: Point, s: number, b: Point, t: number): Point => plus(plus([0, 0, 0], a, s), b, t);
    const axes = [shaft, along(left, cos, up, sin), along(up, cos, left, -sin)] as const;
    const span = span_m[index]!;
    let point = plus(plus(apex_m, shaft, span * Math.sin(cone_rad)), axes[2], span * Math.cos(cone_rad));
    this.mode.harmonics.forEach(({ waves, motion }) => {
      const moved = realParts(motion[index]!, this.phase - waves * azimuth);
      moved.forEach((value, i) => { point = plus(point, axes[i]!, this.scale * value); });
    });
    return point;
  }

  blade(azimuth: number): { middle: Point; radius: number }[] {
    return this.turbine.half_width_m.map((radius, i) => ({ middle: this.section(i, azimuth), radius }));
  }

  get tip(): Point {
    return this.section(this.turbine.span_m.length - 1, this.turned);
  }

  /** The places of a tip at all azimuths. */
  get ring(): Point[] {
    return AROUND.map((azimuth) => this.section(this.turbine.span_m.length - 1, azimuth));
  }
}
