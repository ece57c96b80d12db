// The turbine with its turning rotor in its modes, as drawings of the page. A mode moves with
// cos(w t) while the rotor turns by W t: both by the same time.

import { extentOf, union, type Eye } from "../view/eye.js";
import type { Section } from "../view/motion.js";
import type { Point } from "../view/scene.js";
import { linePath, solidPath, towerPath, tubePath } from "./paths.js";
import { animate, MOST_PERCENT, type Move } from "./player.js";
import { add } from "./views.js";

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

const TURN = 2 * Math.PI;
const AROUND = Array.from({ length: 49 }, (_, k) => (TURN * k) / 48);

const plus = (a: Point, b: Point | number[], factor = 1): Point => [a[0] + factor * b[0]!, a[1] + factor * b[1]!, a[2] + factor * b[2]!];
const cross = ([a, b, c]: number[], [x, y, z]: Point): Point => [b! * z - c! * y, c! * x - a! * z, a! * y - b! * x];

/** Real parts of amplitudes at a phase. */
function realParts(amplitudes: number[], phase: number): number[] {
  const [cos, sin] = [Math.cos(phase), Math.sin(phase)];
  return Array.from({ length: amplitudes.length / 2 }, (_, i) => amplitudes[2 * i]! * cos - amplitudes[2 * i + 1]! * sin);
}

/** A turbine in one of its modes at a phase, with the largest deflection `scale`, m. */
class Moment {
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

export function animateTurbine(turbine: Turbine): void {
  const height = turbine.height_m[turbine.height_m.length - 1]! - turbine.height_m[0]!;
  const margin = (height * MOST_PERCENT) / 100;
  animate<WhirlMode>({
    id: "whirl",
    of: " of the turbine",
    words: "Tower, nacelle and turning rotor, undeformed and deflected in the mode.",
    modes: turbine.modes,
    level: turbine.height_m[0]! + 0.5 * height,
    // The whole rotor and the largest amplitude; the base stays where it is.
    extent: (eye, view, [first]) => {
      const atRest = new Moment(turbine, first!, 0, 0);
      const rotor = [...turbine.nacelle_m, ...atRest.ring].map((middle) => ({ height: 0, middle, turn: [0, 0, 0] as Point, radius: 0 }));
      const { low, high } = union(extentOf(eye, atRest.tower.map((section) => ({ ...section, radius: 0 })), []), extentOf(eye, rotor, []));
      const below = view === "top" ? margin : 0;
      return { low: [low[0] - margin, low[1] - below], high: [high[0] + margin, high[1] + margin] };
    },
    paint: (field, mode, _, eye) => paint(field, turbine, mode, eye, height),
  });
}

function paint(field: Element, turbine: Turbine, mode: WhirlMode, eye: Eye, height: number): Move {
  const azimuths = Array.from({ length: turbine.blades }, (_, k) => (TURN * k) / turbine.blades);
  const path = (of: string): Element => add(field, "path", { class: of });
  path("undeformed").setAttribute("d", towerPath(eye, new Moment(turbine, mode, 0, 0).tower));
  const rest = azimuths.map(() => path("undeformed"));
  const rotor = (): [Element, Element[], Element] =>
    [path("ring"), azimuths.map(() => path("blade")), add(field, "circle", { class: "first-tip", r: 2.5 })];
  const isBehind = eye.near(turbine.apex_m) < eye.near([0, 0, turbine.apex_m[2]]);
  const behind = isBehind ? rotor() : null;
  const [nacelle, tower] = [path("body rna"), path("deformed")];
  const [ring, blades, tip] = behind ?? rotor();
  return (phase, percent) => {
    const now = new Moment(turbine, mode, phase, (height * percent) / 100);
    const atRest = new Moment(turbine, mode, phase, 0);
    azimuths.forEach((azimuth, i) => {
      rest[i]!.setAttribute("d", linePath(eye, atRest.blade(now.turned + azimuth).map(({ middle }) => middle)));
      blades[i]!.setAttribute("d", tubePath(eye, now.blade(now.turned + azimuth)));
    });
    ring.setAttribute("d", linePath(eye, now.ring));
    const [x, y] = eye.place(now.tip);
    tip.setAttribute("cx", x.toFixed(1));
    tip.setAttribute("cy", y.toFixed(1));
    nacelle.setAttribute("d", solidPath(eye, now.nacelle));
    tower.setAttribute("d", towerPath(eye, now.tower));
  };
}
