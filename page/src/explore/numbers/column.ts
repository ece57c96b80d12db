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
  const at = ofFile.findIndex(isMultiplied);
  const factor = at < 0 ? 1 : (present[at] ?? 0) / (ofFile[at] ?? 1);
  const isMultiple = ofFile.every((value, index) =>
    isMultiplied(value) ? isClose(value * factor, present[index] ?? NaN) : value === present[index]);
  return isMultiple ? { values: ofFile, factor: tidy(factor) } : { values: present, factor: 1 };
}

/** The first of several earlier lists of which the present numbers are a common multiple, else the
 * present ones at factor 1. */
export function baseAmong(earlier: number[][], present: number[]): Base {
  const found = earlier.map((values) => baseOf(values, present)).find(({ values }) => earlier.includes(values));
  return found ?? { values: present, factor: 1 };
}

export function multiplied(base: Base, factor: number): number[] {
  return base.values.map((value) => (isMultiplied(value) ? tidy(value * factor) : value));
}

/** Whether a factor changes it: zero and what is rigid have no multiple. */
export function isMultiplied(value: number): boolean {
  return value !== 0 && Number.isFinite(value);
}

function isClose(a: number, b: number): boolean {
  return Math.abs(a - b) <= 1e-9 * Math.max(Math.abs(a), Math.abs(b));
}
