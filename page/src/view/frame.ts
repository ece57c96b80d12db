// A frame under the tower: its members as bent tubes, and what has no section as lines.

import type { Section } from "./motion.js";
import type { Point, TowerScene } from "./scene.js";

/** A member: points along its axis, with its radius there; a radius of 0 is a line. */
export type Limb = Pick<Section, "middle" | "radius">[];

/** Where a member is sampled, as fractions of its length. */
const SAMPLED = [0, 0.25, 0.5, 0.75, 1];
/** Where it is drawn, where it is bent and where it is straight. */
const BENT = [0, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1];

/** Of each sample, its part in the quartic through all of them. */
const weightsAt = (s: number): number[] => SAMPLED.map((own) =>
  SAMPLED.reduce((product, other) => (other === own ? product : (product * (s - other)) / (own - other)), 1));

const AT_REST = SAMPLED.slice(0, 1).concat(1).map(weightsAt);
const IN_MOTION = BENT.map(weightsAt);

/** The members of a frame, moved by so much; null is at rest. */
export function limbsOf({ frame }: TowerScene, motion: number[] | null): Limb[] {
  if (frame === undefined) return [];
  const moves = motion !== null && motion.length === 3 * (frame.joints.length + 3 * frame.members.length);
  const at = (index: number): Point => (moves ? [motion[3 * index]!, motion[3 * index + 1]!, motion[3 * index + 2]!] : [0, 0, 0]);
  return frame.members.map(({ joints: [from, to], radius_m }, member) => {
    const [a, b] = [frame.joints[from]!, frame.joints[to]!];
    const first = frame.joints.length + 3 * member;
    const moved = [at(from), at(first), at(first + 1), at(first + 2), at(to)];
    return (moves ? IN_MOTION : AT_REST).map((weights, k, all) => {
      const s = moves ? BENT[k]! : k / (all.length - 1);
      const place = (i: number): number => a[i]! + s * (b[i]! - a[i]!) + weights.reduce((sum, weight, j) => sum + weight * moved[j]![i]!, 0);
      return { middle: [place(0), place(1), place(2)], radius: radius_m[0] + s * (radius_m[1] - radius_m[0]) };
    });
  });
}
