// Round numbers along an axis.

/** At most about so many round numbers from 0 to the end. */
export function ticks(end: number, most: number): number[] {
  if (!(end > 0) || !(most >= 1)) return [0];
  const raw = end / most;
  const power = 10 ** Math.floor(Math.log10(raw));
  const step = power * ([1, 2, 5, 10].find((digit) => digit * power >= raw * (1 - 1e-9)) ?? 10);
  return Array.from({ length: Math.floor(end / step + 1e-9) + 1 }, (_, k) => Number((k * step).toPrecision(12)));
}

/** Labels of lines at one edge, moved apart: the places of their middles, in the order given. */
export function apart(wanted: number[], gap: number, [low, high]: [number, number]): number[] {
  const order = wanted.map((_, index) => index).sort((a, b) => wanted[a]! - wanted[b]!);
  const places = order.map((index) => Math.min(high, Math.max(low, wanted[index]!)));
  for (let k = 1; k < places.length; k++) places[k] = Math.max(places[k]!, places[k - 1]! + gap);
  const last = places.length - 1;
  if (last >= 0 && places[last]! > high) {
    places[last] = high;
    for (let k = last - 1; k >= 0; k--) places[k] = Math.min(places[k]!, places[k + 1]! - gap);
  }
  const result: number[] = new Array<number>(wanted.length).fill(0);
  order.forEach((index, k) => (result[index] = places[k]!));
  return result;
}
