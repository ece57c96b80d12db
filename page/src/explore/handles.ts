// The stations that can be dragged in the view, and the numbers that a drag changes.

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

/** The number that a drag changes. */
export function nameOfDrag(parameters: Parameter[], { station, quantity }: Drag): string | null {
  const found = parameters.find(({ drag }) => drag !== null && drag.station === station && drag.quantity === quantity);
  return found?.name ?? null;
}
