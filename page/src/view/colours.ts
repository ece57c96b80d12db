// The colours of the page, as numbers from 0 to 1.

import type { Substance } from "./scene.js";

export type Rgb = [number, number, number];

/** What each thing of the view is coloured with. */
export interface Palette {
  paper: Rgb;
  ink: Rgb;
  muted: Rgb;
  steel: Rgb;
  /** A line on the shell, and a handle under the pointer. */
  accent: Rgb;
  handle: Rgb;
  of: Record<Substance, Rgb>;
}

export const mix = (a: Rgb, b: Rgb, share: number): Rgb => [
  a[0] + share * (b[0] - a[0]),
  a[1] + share * (b[1] - a[1]),
  a[2] + share * (b[2] - a[2]),
];

/** The palette of an element, from its variables `--tm-*`. */
export function paletteOf(element: Element): Palette {
  const style = getComputedStyle(element);
  const colour = (name: string, otherwise: string): Rgb =>
    rgb(style.getPropertyValue(`--tm-${name}`)) ?? rgb(otherwise) ?? [0, 0, 0];
  const paper = colour("paper", "#ffffff");
  const ink = colour("ink", "#1b1f24");
  const muted = colour("muted", "#57606a");
  const steel = colour("steel", "#8b98a7");
  const rna = colour("rna", "#5d6b7a");
  const of: Record<Substance, Rgb> = {
    rna,
    rotor: mix(rna, [1, 1, 1], 0.55),
    mass: ink,
    foundation: mix(steel, ink, 0.15),
    ground: mix(colour("band", "#e9edf2"), muted, 0.25),
    soil: colour("soil", "#d9c7a8"),
    water: mix(colour("water", "#cfe6f5"), colour("series0", "#0072b2"), 0.25),
    link: ink,
  };
  return { paper, ink, muted, steel, of, accent: colour("series1", "#c04e00"), handle: colour("series0", "#0072b2") };
}

/** `#rgb` and `#rrggbb`; none of anything else. */
export function rgb(text: string): Rgb | null {
  const digits = /^#([0-9a-f]{3}|[0-9a-f]{6})$/i.exec(text.trim())?.[1];
  if (digits === undefined) return null;
  const size = digits.length / 3;
  const part = (i: number): number => parseInt(digits.slice(i * size, (i + 1) * size).repeat(size === 1 ? 2 : 1), 16) / 255;
  return [part(0), part(1), part(2)];
}
