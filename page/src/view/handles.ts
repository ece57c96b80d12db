// The dots at stations that can be dragged: where they are, which is under the pointer, what a drag
// asks for.

import { Vertices } from "./buffer.js";
import type { Palette } from "./colours.js";
import type { Eye } from "./eye.js";
import { carried, sectionAt, type Section } from "./motion.js";
import type { Item } from "./graphics.js";
import { AT_REST } from "./parts.js";
import type { Drag, Handle, Point } from "./scene.js";

/** Diameter of a dot, and how near to its middle a pointer has to be, in pixels of the page. */
export const SIZE = 11;
const NEAR = { mouse: 9, touch: 22 };

/** The handles of a tower. */
export class Handles {
  private readonly vertices = new Vertices();
  private stations: Handle[] = [];
  /** The handle under the pointer or in the hand. */
  active: number | null = null;

  set(stations: Handle[]): void {
    this.stations = stations;
  }

  get heights(): number[] | null {
    return this.stations.length > 0 ? this.stations.map((station) => station.height_m) : null;
  }

  station(index: number): Handle | undefined {
    return this.stations.find((handle) => handle.station === index);
  }

  item(eye: Eye, sections: Section[], palette: Palette): Item {
    this.vertices.begin();
    this.stations.forEach((handle) => placesOf(handle, eye, sections).forEach((point) => {
      this.vertices.push(point, handle.station === this.active ? palette.accent : palette.handle);
    }));
    return { look: "dot", vertices: this.vertices, place: AT_REST, fade: 0 };
  }

  /** The handle at a pixel. */
  at([x, y]: [number, number], eye: Eye, sections: Section[], isTouch: boolean): Handle | null {
    let nearest: Handle | null = null;
    let least = isTouch ? NEAR.touch : NEAR.mouse;
    this.stations.forEach((handle) => placesOf(handle, eye, sections).forEach((point) => {
      const [u, v] = eye.place(point);
      const distance = Math.hypot(u - x, v - y);
      if (distance <= least) [nearest, least] = [handle, distance];
    }));
    return nearest;
  }
}

/** Left and right on the rim. */
function placesOf(handle: Handle, eye: Eye, sections: Section[]): Point[] {
  if (sections.length === 0) return [];
  const section = { ...sectionAt(sections, handle.height_m), height: handle.height_m };
  const [x, y] = eye.right;
  return [-1, 1].map((side) =>
    carried(section, [side * handle.radius_m * x, side * handle.radius_m * y, handle.height_m]));
}

/** The pixels after which it is known what a drag changes. */
const DECIDED = 4;
/** Seen from higher up heights cannot be dragged: a pixel would be too many metres. */
const LEAST_RISE = 0.25;

/** A handle in the hand. */
export class Pull {
  private quantity: Drag["quantity"] | null = null;
  private readonly side: number;

  constructor(private readonly handle: Handle, private readonly from: [number, number], private readonly eye: Eye) {
    this.side = from[0] < eye.place([0, 0, handle.height_m])[0] ? -1 : 1;
  }

  /** Whether it is a drag by now. */
  get isDecided(): boolean {
    return this.quantity !== null;
  }

  /**
   * What the pointer asks for; nothing before it has moved far enough. The first answer starts the
   * drag.
   */
  move(to: [number, number]): Drag | null {
    const isFirst = this.quantity === null;
    this.quantity ??= this.decide(to);
    return this.quantity === null ? null : this.drag(isFirst ? "start" : "move", to);
  }

  end(to: [number, number], phase: "end" | "cancel"): Drag | null {
    return this.quantity === null ? null : this.drag(phase, phase === "cancel" ? this.from : to);
  }

  private decide(to: [number, number]): Drag["quantity"] | null {
    const [right, down] = [Math.abs(to[0] - this.from[0]), Math.abs(to[1] - this.from[1])];
    if (Math.max(right, down) < DECIDED) return null;
    const canRise = this.handle.hasHeight && this.eye.rise > LEAST_RISE;
    if (!canRise && !this.handle.hasDiameter) return null;
    const isDiameter = this.handle.hasDiameter && (right >= down || !canRise);
    return isDiameter ? "diameter" : "height";
  }

  private drag(phase: Drag["phase"], to: [number, number]): Drag {
    const { station, radius_m, height_m } = this.handle;
    const wider = this.side * (to[0] - this.from[0]) * this.eye.scale;
    const higher = (-(to[1] - this.from[1]) * this.eye.scale) / this.eye.rise;
    const value_m = this.quantity === "diameter" ? 2 * Math.max(radius_m + wider, 0.02 * radius_m) : height_m + higher;
    return { station, phase, quantity: this.quantity ?? "diameter", value_m, place: to };
  }
}
