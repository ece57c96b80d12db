// Numbers that move with the slider of another one: the two values of a boundary, the heights at a
// joint.

import type { Parameter } from "../protocol.js";

/** Values with those of the numbers that follow them, unless these have values of their own. */
export function withFollowers(parameters: Parameter[], values: Record<string, number>): Record<string, number> {
  const all = { ...values };
  for (const { name, follows } of parameters) {
    const leader = follows === null ? undefined : parameters[follows]?.name;
    const value = leader === undefined ? undefined : values[leader];
    if (value !== undefined) all[name] ??= value;
  }
  return all;
}

/** The indices of the numbers that the slider of a number moves, itself first. */
export function movedBy(parameters: Parameter[], index: number): number[] {
  return [index, ...parameters.flatMap(({ follows }, other) => (follows === index ? [other] : []))];
}
