// How far each mode is deflected at a time: one mode that oscillates, or all after a release from a
// deflection.

import { largestOfFrame } from "../../view/motion.js";
import type { Mode } from "../protocol.js";
import type { Point, Pose, Shape, TowerScene } from "../../view/scene.js";

/** A rotation of 1 rad counts as a translation of this part of the height. */
const HEIGHT_PER_RADIAN = 1 / 8;

/** The factor at which a shape reaches an amplitude, which is a fraction of the height. */
export function scaleOf(scene: TowerScene, shape: Shape, amplitude: number): number {
  const height = heightOf(scene);
  const largest = shape.x.reduce((most, x, k) => {
    const translation = Math.hypot(x, shape.y[k] ?? 0, shape.z[k] ?? 0);
    return Math.max(most, translation, Math.abs(shape.rotation_z[k] ?? 0) * height * HEIGHT_PER_RADIAN);
  }, largestOfFrame(shape.frame));
  return largest > 0 ? (amplitude * height) / largest : 0;
}

export function heightOf(scene: TowerScene): number {
  return (scene.height_m.at(-1) ?? 0) - (scene.height_m[0] ?? 0);
}

/** The part of each mode in the static deflection by a unit force at a height: (φ·d)(z)/(m ω²). */
export function staticParts(scene: TowerScene, modes: Mode[], height_m: number, direction: [number, number]): number[] {
  return scene.modes.map((shape, index) => {
    const mode = modes[index];
    if (mode === undefined || !(mode.modal_mass > 0) || !(mode.frequency_hz > 0)) return 0;
    const x = at(scene.height_m, shape.x, height_m);
    const y = at(scene.height_m, shape.y, height_m);
    return (x * direction[0] + y * direction[1]) / (mode.modal_mass * (2 * Math.PI * mode.frequency_hz) ** 2);
  });
}

/** A value at a height, linear between the heights; beyond them that of the end. */
function at(heights: number[], values: number[], height: number): number {
  const above = heights.findIndex((other) => other >= height);
  if (above < 0) return values.at(-1) ?? 0;
  if (above === 0) return values[0] ?? 0;
  const [low, high] = [heights[above - 1] ?? 0, heights[above] ?? 0];
  const part = high > low ? (height - low) / (high - low) : 1;
  return (1 - part) * (values[above - 1] ?? 0) + part * (values[above] ?? 0);
}

/** The sum of the shapes, each with its factor; written into a pose that is used again if it has
 * as many heights. */
export function superposed(scene: TowerScene, factors: number[], into: Pose | null): Pose {
  const ofFrame = scene.modes[0]?.frame?.length ?? 0;
  const fits = into?.displacement.length === scene.height_m.length && into.frame.length === ofFrame;
  const pose = fits ? into : emptyPose(scene.height_m.length, ofFrame);
  pose.frame.fill(0);
  factors.forEach((factor, index) => {
    if (factor !== 0) scene.modes[index]?.frame?.forEach((value, k) => { pose.frame[k]! += factor * value; });
  });
  for (let k = 0; k < scene.height_m.length; k++) {
    const displacement: Point = pose.displacement[k] ?? [0, 0, 0];
    const rotation: Point = pose.rotation[k] ?? [0, 0, 0];
    displacement.fill(0);
    rotation.fill(0);
    for (let index = 0; index < factors.length; index++) {
      const factor = factors[index] ?? 0;
      const shape = scene.modes[index];
      if (factor === 0 || shape === undefined) continue;
      displacement[0] += factor * (shape.x[k] ?? 0);
      displacement[1] += factor * (shape.y[k] ?? 0);
      displacement[2] += factor * (shape.z[k] ?? 0);
      rotation[0] += factor * (shape.rotation_x[k] ?? 0);
      rotation[1] += factor * (shape.rotation_y[k] ?? 0);
      rotation[2] += factor * (shape.rotation_z[k] ?? 0);
    }
  }
  return pose;
}

function emptyPose(count: number, ofFrame: number): Pose {
  const points = (): Point[] => Array.from({ length: count }, () => [0, 0, 0]);
  return { displacement: points(), rotation: points(), frame: new Array<number>(ofFrame).fill(0) };
}

/** The largest translation of a pose. */
export function largest(pose: Pose): number {
  return pose.displacement.reduce((most, point) => Math.max(most, Math.hypot(...point)), largestOfFrame(pose.frame));
}
