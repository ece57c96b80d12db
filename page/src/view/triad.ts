// The directions of a view: x with the wind, y to the side, z up, in a corner of it.

import type { Eye } from "./eye.js";
import type { Point } from "./scene.js";

const LENGTH = 26;
const CORNER = 44;
const HEAD = 5;
/** For the name of the wind. */
const ROOM = 44;

/** A direction in the view, in pixels from its corner. */
export interface Arm {
  name: string;
  /** How far the arm reaches to the right and downwards. */
  to: [number, number];
}

const AXES: [string, Point][] = [["x, wind", [1, 0, 0]], ["y", [0, 1, 0]], ["z", [0, 0, 1]]];

/** The arms as an eye sees them; one that points at the reader has hardly any length. */
export function armsOf(eye: Eye): Arm[] {
  return AXES.map(([name, axis]) => ({ name, to: [LENGTH * eye.across(axis), -LENGTH * eye.up(axis)] }));
}

/** Where the arms begin in a view of a width. */
export const cornerOf = (width: number, height: number): [number, number] => [width - ROOM - CORNER, height - CORNER];

/** An arrow with its head, and the place of its name. */
export function arrowOf({ to: [x, y] }: Arm): { line: [number, number][]; name: [number, number] } {
  const length = Math.hypot(x, y);
  if (length < 4) return { line: [[0, 0], [x, y]], name: [x + 5, y - 5] };
  const [u, v] = [x / length, y / length];
  const side = (sign: number): [number, number] => [x - HEAD * (u + 0.5 * sign * -v), y - HEAD * (v + 0.5 * sign * u)];
  return { line: [[0, 0], [x, y], side(1), [x, y], side(-1)], name: [x + 9 * u, y + 9 * v + 4] };
}

const SVG = "http://www.w3.org/2000/svg";

/** The arrows over a view, which follow its eye. */
export class Triad {
  readonly element = document.createElementNS(SVG, "svg");
  private arms = AXES.map(() => ({ line: document.createElementNS(SVG, "path"), name: document.createElementNS(SVG, "text") }));
  private last = "";

  constructor() {
    this.element.setAttribute("class", "triad");
    this.element.setAttribute("aria-hidden", "true");
    this.element.append(...this.arms.flatMap(({ line, name }) => [line, name]));
  }

  show(eye: Eye): void {
    const key = `${eye.azimuth} ${eye.elevation} ${eye.width} ${eye.height}`;
    if (key === this.last) return;
    this.last = key;
    const [left, top] = cornerOf(eye.width, eye.height);
    armsOf(eye).forEach((arm, index) => {
      const { line, name } = arrowOf(arm);
      const at = this.arms[index]!;
      at.line.setAttribute("d", "M" + line.map(([x, y]) => `${(left + x).toFixed(1)} ${(top + y).toFixed(1)}`).join("L"));
      at.name.setAttribute("x", (left + name[0]).toFixed(1));
      at.name.setAttribute("y", (top + name[1]).toFixed(1));
      at.name.setAttribute("text-anchor", anchorOf(arm));
      at.name.textContent = arm.name;
    });
  }
}

const anchorOf = ({ to: [x] }: Arm): "start" | "middle" | "end" => (x > 4 ? "start" : x < -4 ? "end" : "middle");

/** The same arrows on a canvas. */
export function drawTriad(on: CanvasRenderingContext2D, eye: Eye, ink: string, font: string): void {
  const [left, top] = cornerOf(eye.width, eye.height);
  Object.assign(on, { strokeStyle: ink, fillStyle: ink, lineWidth: 1.2, font: `12px ${font}` });
  for (const arm of armsOf(eye)) {
    const { line, name } = arrowOf(arm);
    on.beginPath();
    line.forEach(([x, y], k) => (k === 0 ? on.moveTo(left + x, top + y) : on.lineTo(left + x, top + y)));
    on.stroke();
    on.textAlign = ({ start: "left", middle: "center", end: "right" } as const)[anchorOf(arm)];
    on.fillText(arm.name, left + name[0], top + name[1]);
  }
  on.textAlign = "left";
}
