// The range of a slider: steps of round numbers that contain the present value.

export interface Range {
  low: number;
  high: number;
  step: number;
}

const STEPS = 400;

/** A range from about `low` to about `high` with round steps, wide enough for these values. */
export function roundRange(low: number, high: number, ...values: number[]): Range {
  const least = Math.min(low, high, ...values);
  const most = Math.max(low, high, ...values);
  const step = roundStep((most - least) / STEPS || Math.abs(most) / STEPS || 1);
  return { low: multiple(Math.floor(least / step + 1e-9), step), high: multiple(Math.ceil(most / step - 1e-9), step), step };
}

/** The next larger of 1, 2 and 5 times a power of ten. */
function roundStep(width: number): number {
  const power = 10 ** Math.floor(Math.log10(width));
  const digit = [1, 2, 5, 10].find((digit) => digit * power >= width * (1 - 1e-9)) ?? 10;
  return Number((digit * power).toPrecision(1));
}

/** So many steps, without rounding error. */
function multiple(count: number, step: number): number {
  return Number((count * step).toPrecision(12));
}
