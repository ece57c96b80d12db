// All numbers of a column of a list, multiplied at once.

import { tidy } from "./entry.js";

/** What a factor multiplies: the numbers, and the factor at which they are now. */
export interface Base {
  values: number[];
  factor: number;
}

/** The file's numbers if the present ones are a common multiple of them, else the present ones
 * at factor 1. */
export function baseOf(ofFile: number[], present: number[]): Base {
  const at = ofFile.findIndex((value) => value !== 0);
  const factor = at < 0 ? 1 : (present[at] ?? 0) / (ofFile[at] ?? 1);
  const isMultiple = ofFile.every((value, index) => isClose(value * factor, present[index] ?? NaN));
  return isMultiple && factor > 0 ? { values: ofFile, factor: tidy(factor) } : { values: present, factor: 1 };
}

export function multiplied(base: Base, factor: number): number[] {
  return base.values.map((value) => tidy(value * factor));
}

function isClose(a: number, b: number): boolean {
  return Math.abs(a - b) <= 1e-9 * Math.max(Math.abs(a), Math.abs(b));
}
