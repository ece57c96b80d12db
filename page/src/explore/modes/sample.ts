// Small towers with known shapes, for tests.

import type { Mode } from "../protocol.js";
import type { Shape, TowerScene } from "../../view/scene.js";

export interface Sample {
  family: "fore-aft" | "side-side" | "torsion";
  order: number;
  frequency_hz: number;
  /** Angle of the bending plane from x, degrees; by default that of the family. */
  plane?: number;
  factor?: number;
}

/** Bending as sin², sin(2·)… of the height, so that different orders are nearly orthogonal;
 * torsion as rotation. */
export function sample(modes: Sample[], heights = 31): { modes: Mode[]; scene: TowerScene } {
  const height_m = Array.from({ length: heights }, (_, k) => (80 * k) / (heights - 1));
  const shapes = modes.map((mode, index) => shapeOf(mode, index + 1, height_m));
  return {
    modes: modes.map((mode, index) => modeOf(mode, index + 1)),
    scene: { height_m, radius_m: height_m.map(() => 3), is_nominal: false, bodies: [], modes: shapes },
  };
}

function shapeOf({ family, order, frequency_hz, plane, factor = 1 }: Sample, number: number, height_m: number[]): Shape {
  const angle = ((plane ?? (family === "side-side" ? 90 : 0)) * Math.PI) / 180;
  const turns = (order - 0.5) * Math.PI;
  const bend = height_m.map((height) => (family === "torsion" ? 0 : factor * Math.sin((turns * height) / 80)));
  const slope = height_m.map((height) => (family === "torsion" ? 0 : (factor * turns * Math.cos((turns * height) / 80)) / 80));
  const twist = height_m.map((height) => (family === "torsion" ? factor * Math.sin((turns * height) / 80) : 0));
  const along = (values: number[], part: number): number[] => values.map((value) => value * part);
  return {
    number, label: labelOf(family, order), family, frequency_hz,
    x: along(bend, Math.cos(angle)), y: along(bend, Math.sin(angle)), z: along(bend, 0),
    rotation_x: along(slope, -Math.sin(angle)), rotation_y: along(slope, Math.cos(angle)), rotation_z: twist,
  };
}

function modeOf({ family, order, frequency_hz }: Sample, number: number): Mode {
  return {
    number, label: labelOf(family, order), shape: labelOf(family, order), family, order, frequency_hz,
    error_hz: 0, frequency: "", error: "", period_s: 1 / frequency_hz, effective_mass: [], modal_mass: 1, verdict: null,
  };
}

function labelOf(family: string, order: number): string {
  return `${order} ${family}`;
}
