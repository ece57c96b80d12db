// What of the tower is at a pixel.

import type { Eye } from "./eye.js";
import type { Section } from "./motion.js";

/** How far beside a thin tower a tap is one on it, pixels. */
const BESIDE = 8;

/** The height at rest of the tower at a pixel; none beside it. */
export function heightAt([x, y]: [number, number], eye: Eye, sections: Section[]): number | null {
  let found: number | null = null;
  let least = Infinity;
  for (let i = 0; i + 1 < sections.length; i += 1) {
    const [low, high] = [sections[i]!, sections[i + 1]!];
    const [a, b] = [eye.place(low.middle), eye.place(high.middle)];
    const [u, v] = [b[0] - a[0], b[1] - a[1]];
    const along = ((x - a[0]) * u + (y - a[1]) * v) / (u * u + v * v || 1);
    const share = Math.min(Math.max(along, 0), 1);
    const distance = Math.hypot(a[0] + share * u - x, a[1] + share * v - y);
    if (distance >= least || distance > Math.max(low.radius, high.radius) / eye.scale + BESIDE) continue;
    least = distance;
    found = low.height + share * (high.height - low.height);
  }
  return found;
}
