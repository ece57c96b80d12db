// How similar two mode shapes are: the modal assurance criterion on translations and on rotations
// times the height.

import type { Shape, TowerScene } from "../../view/scene.js";

/** Places along the tower at which shapes are compared. */
const PLACES = 25;

/** A shape as a vector of length 1, independent of the heights at which it is given. */
export type Signature = Float64Array;

export function signatures(scene: TowerScene): Signature[] {
  const places = placesIn(scene.height_m);
  const height = (scene.height_m.at(-1) ?? 0) - (scene.height_m[0] ?? 0);
  return scene.modes.map((shape) => signature(shape, places, height));
}

/** Where in a list of heights the places are that divide the tower evenly: the index below, and
 * the part of the interval. */
function placesIn(heights: number[]): { below: number; part: number }[] {
  const base = heights[0] ?? 0;
  const top = heights.at(-1) ?? 0;
  let below = 0;
  return Array.from({ length: PLACES }, (_, k) => {
    const height = base + ((top - base) * k) / (PLACES - 1);
    while (below < heights.length - 2 && (heights[below + 1] ?? 0) < height) below++;
    const from = heights[below] ?? 0;
    const length = (heights[below + 1] ?? from) - from;
    return { below, part: length > 0 ? (height - from) / length : 0 };
  });
}

function signature(shape: Shape, places: { below: number; part: number }[], height: number): Signature {
  const parts: [number[], number][] = [
    [shape.x, 1], [shape.y, 1], [shape.z, 1],
    [shape.rotation_x, height], [shape.rotation_y, height], [shape.rotation_z, height],
  ];
  const vector = new Float64Array(parts.length * PLACES);
  parts.forEach(([values, scale], row) => {
    places.forEach(({ below, part }, k) => {
      const from = values[below] ?? 0;
      vector[row * PLACES + k] = scale * (from + part * ((values[below + 1] ?? from) - from));
    });
  });
  const length = Math.sqrt(product(vector, vector));
  return length > 0 ? vector.map((value) => value / length) : vector;
}

/** The cosine of the angle between two shapes; its square is the modal assurance criterion. */
export function product(a: Signature, b: Signature): number {
  let sum = 0;
  for (let k = 0; k < a.length; k++) sum += (a[k] ?? 0) * (b[k] ?? 0);
  return sum;
}
