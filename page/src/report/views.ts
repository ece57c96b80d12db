// The views of an animated tower or turbine: where they look from, and their axes.

import { Eye } from "../view/eye.js";
import type { Point } from "../view/scene.js";

const WIDTH = 300;
/** Room for numbers and names of the axes. */
const MARGIN = { left: 44, right: 8, top: 10, bottom: 42 };
const NONE = { left: 0, right: 0, top: 0, bottom: 0 };

export type ViewName = "space" | "side" | "front" | "top";

/** A view: its name, its eye, and the names of its axes if it has numbers. */
export interface View {
  name: string;
  eye: Eye;
  height: number;
  axes: [string, string] | null;
}

/** The views of an animation; that in three dimensions can be turned. */
export const viewsOf = (): Record<ViewName, View> => ({
  space: view("in 3-D", 35, 20, 400),
  side: view("from the side", 90, 0, 400, ["x, fore-aft (m)", "height z (m)"]),
  front: view("from downwind", 180, 0, 400, ["y, side-side (m)", "height z (m)"]),
  top: view("from above", 90, 90, 300, ["x, fore-aft (m)", "y, side-side (m)"]),
});

function view(name: string, azimuth: number, elevation: number, height: number, axes: View["axes"] = null): View {
  const { left, right, top, bottom } = axes === null ? NONE : MARGIN;
  const eye = Object.assign(new Eye(), { azimuth, elevation, width: WIDTH - left - right, height: height - top - bottom });
  return { name, eye, height, axes };
}

/** Adds an element to another. */
export function add(parent: Element, name: string, attributes: Record<string, string | number>, text?: string): Element {
  const element = document.createElementNS(parent.namespaceURI, name);
  Object.entries(attributes).forEach(([key, value]) => element.setAttribute(key, String(value)));
  if (text !== undefined) element.textContent = text;
  parent.append(element);
  return element;
}

/** An empty drawing for a view. */
export function sheet(parent: Element, id: string, { height }: View): SVGSVGElement {
  // The page has figures: their namespace is that of drawings.
  const svg = document.createElementNS(document.querySelector("figure svg")!.namespaceURI, "svg") as SVGSVGElement;
  const attributes = { id, viewBox: `0 0 ${WIDTH} ${height}`, role: "img", "aria-labelledby": `${id}-title ${id}-text`, "font-size": "11" };
  Object.entries(attributes).forEach(([key, value]) => svg.setAttribute(key, value));
  parent.append(svg);
  return svg;
}

/** The place for what a view shows, with axes around it. */
export function field(svg: SVGSVGElement, { eye, axes, height }: View): Element {
  if (axes === null) return add(svg, "g", {});
  const group = add(svg, "g", { class: "axes" });
  const { left, top } = MARGIN;
  const [right, bottom] = [left + eye.width, top + eye.height];
  const half = [0.5 * eye.width * eye.scale, 0.5 * eye.height * eye.scale] as const;
  const vertical = ticks([eye.middle[1] - half[1], eye.middle[1] + half[1]], 6);
  const horizontal = ticks([eye.middle[0] - half[0], eye.middle[0] + half[0]], 4);
  vertical.values.forEach((value) => {
    const y = 0.5 * (top + bottom) - (value - eye.middle[1]) / eye.scale;
    add(group, "line", { class: "grid", x1: left, x2: right, y1: y, y2: y });
    add(group, "text", { x: left - 5, y: y + 4, "text-anchor": "end" }, written(value, vertical.decimals));
  });
  horizontal.values.forEach((value) => {
    const x = 0.5 * (left + right) + (value - eye.middle[0]) / eye.scale;
    add(group, "line", { class: "grid", x1: x, x2: x, y1: top, y2: bottom });
    add(group, "text", { x, y: bottom + 14, "text-anchor": "middle" }, written(value, horizontal.decimals));
  });
  add(group, "line", { class: "axis", x1: left, x2: right, y1: bottom, y2: bottom });
  add(group, "line", { class: "axis", x1: left, x2: left, y1: top, y2: bottom });
  add(group, "text", { x: 0.5 * (left + right), y: height - 10, "text-anchor": "middle" }, axes[0]);
  const middle = 0.5 * (top + bottom);
  add(group, "text", { x: 11, y: middle, "text-anchor": "middle", transform: `rotate(-90 11 ${middle})` }, axes[1]);
  return add(svg, "g", { transform: `translate(${left} ${top})` });
}

/** Where x, y and z point, in the lower left corner of a view without axes. */
export function drawDirections(svg: Element, { eye, height, axes }: View): void {
  if (axes !== null) return;
  const [x, y] = [42, height - 34];
  ([["x", [1, 0, 0]], ["y", [0, 1, 0]], ["z", [0, 0, 1]]] as [string, Point][]).forEach(([name, axis]) => {
    const [dx, dy] = [26 * eye.across(axis), -26 * eye.up(axis)];
    add(svg, "line", { class: "axis", x1: x, y1: y, x2: x + dx, y2: y + dy });
    add(svg, "text", { x: x + 1.35 * dx, y: y + 1.35 * dy + 4, "text-anchor": "middle" }, name);
  });
}

function ticks([low, high]: [number, number], count: number): { values: number[]; decimals: number } {
  const rough = (high - low) / count;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((digit) => digit * power).find((size) => size >= rough) ?? rough;
  const values: number[] = [];
  for (let k = Math.ceil(low / step); k * step <= high; k += 1) values.push(k * step);
  return { values, decimals: Math.max(0, -Math.floor(Math.log10(step) + 1e-9)) };
}

const written = (value: number, decimals: number): string =>
  value.toFixed(decimals).replace(/^-(?=.*[1-9])/, "\u2212").replace(/^-/, "");
