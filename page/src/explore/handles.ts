// The stations that can be dragged in the view, and the numbers that a drag changes.

import { tidy } from "./numbers/entry.js";
import type { Parameter } from "./protocol.js";
import type { Drag, Handle } from "../view/scene.js";

/** The handles at the present values, which are in the order of the parameters. */
export function handlesOf(parameters: Parameter[], values: number[]): Handle[] {
  const handles = new Map<number, Handle>();
  parameters.forEach(({ drag }, index) => {
    const value = values[index];
    if (drag === null || value === undefined) return;
    const handle = handles.get(drag.station)
      ?? { station: drag.station, height_m: NaN, radius_m: NaN, hasDiameter: false, hasHeight: false };
    if (drag.quantity === "height") Object.assign(handle, { height_m: value, hasHeight: true });
    else Object.assign(handle, { radius_m: value / 2, hasDiameter: true });
    handles.set(drag.station, handle);
  });
  return [...handles.values()].filter(({ height_m, radius_m }) => Number.isFinite(height_m) && Number.isFinite(radius_m));
}

/** A number that a drag changes, and how much more than that of the grabbed station it is. */
export interface Dragged {
  name: string;
  station: number;
  more_m: number;
}

/** Stations nearer to each other, as a part of the tower's height, have one place under the hand. */
const NEAR = 1e-4;

/**
 * The numbers that a drag changes, with the values before it: both stations of a step move in
 * height, and those of one diameter become wider together.
 */
export function draggedBy(parameters: Parameter[], values: number[], { station, quantity }: Drag): Dragged[] {
  const handles = handlesOf(parameters, values);
  const held = handles.find((handle) => handle.station === station);
  if (held === undefined) return [];
  const heights = handles.map(({ height_m }) => height_m);
  const near_m = NEAR * (Math.max(...heights) - Math.min(...heights));
  const isBeside = (handle: Handle): boolean => Math.abs(handle.height_m - held.height_m) <= near_m
    && (quantity === "height" || 2 * Math.abs(handle.radius_m - held.radius_m) <= near_m);
  const size = ({ height_m, radius_m }: Handle): number => (quantity === "height" ? height_m : 2 * radius_m);
  return handles.filter(isBeside).flatMap((handle) => {
    const found = parameters.find(({ drag }) => drag?.station === handle.station && drag.quantity === quantity);
    return found ? [{ name: found.name, station: handle.station, more_m: size(handle) - size(held) }] : [];
  });
}

/** The values that a drag asks for, by name, to the millimetre. */
export function valuesOf(dragged: Dragged[], { value_m }: Drag): Record<string, number> {
  return Object.fromEntries(dragged.map(({ name, more_m }) => [name, tidy(Number((value_m + more_m).toFixed(3)))]));
}

/** "Stations 2 and 3: height 38.4 m"; stations count from 1, as in messages. */
export function describeDrag(dragged: Dragged[], { quantity, value_m }: Drag): string {
  const numbers = dragged.map(({ station }) => String(station + 1));
  return `Station${numbers.length > 1 ? "s" : ""} ${numbers.join(" and ")}: ${quantity} ${Number(value_m.toFixed(3))} m`;
}
