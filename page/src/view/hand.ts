// The pointer, the wheel and the keys over a view.

import type { Eye } from "./eye.js";

/** What is done with a view by hand. Places are pixels from the upper left corner. */
export interface Grip {
  /** Takes hold of what is at a place; false if there is only the view to be turned. */
  grab(place: [number, number], isTouch: boolean): boolean;
  pull(place: [number, number]): void;
  letGo(place: [number, number], isCancelled: boolean): void;
  tap(place: [number, number]): void;
  /** A pointer without a button; null once it has left. */
  hover(place: [number, number] | null): void;
  /** The eye has moved: it was turned, or the picture was moved or zoomed. */
  moved(isTurn: boolean): void;
  reset(): void;
}

const STILL = 4;
const TURN = 0.4;
const STEP = 5;
const ZOOM = 1.15;
const ARROWS: Record<string, [number, number]> = {
  ArrowLeft: [-STEP, 0],
  ArrowRight: [STEP, 0],
  ArrowUp: [0, STEP],
  ArrowDown: [0, -STEP],
};

/** Lets a view be turned, zoomed and taken hold of. */
export class Hand {
  private readonly held = new Map<number, [number, number]>();
  private from: [number, number] | null = null;
  private isTurning = false;
  private isGrabbing = false;
  private readonly stop = new AbortController();

  constructor(private readonly canvas: HTMLElement | SVGSVGElement, private readonly eye: Eye, private readonly grip: Grip) {
    const on = <K extends keyof HTMLElementEventMap>(name: K, listener: (event: HTMLElementEventMap[K]) => void, passive = true): void =>
      (canvas as Element).addEventListener(name, listener as EventListener, { signal: this.stop.signal, passive });
    on("pointerdown", (event) => this.down(event));
    on("pointermove", (event) => this.move(event));
    on("pointerup", (event) => this.up(event, false));
    on("pointercancel", (event) => this.up(event, true));
    on("lostpointercapture", (event) => this.up(event, true));
    on("pointerleave", () => this.grip.hover(null));
    on("dblclick", () => this.grip.reset());
    on("wheel", (event) => this.wheel(event), false);
    on("keydown", (event) => this.key(event), false);
    // What is in the hand does not scroll the page.
    on("touchstart", (event) => this.isGrabbing && event.cancelable && event.preventDefault(), false);
  }

  dispose(): void {
    this.stop.abort();
  }

  private place(event: MouseEvent): [number, number] {
    const box = this.canvas.getBoundingClientRect();
    return [
      ((event.clientX - box.left) * this.eye.width) / (box.width || 1),
      ((event.clientY - box.top) * this.eye.height) / (box.height || 1),
    ];
  }

  private down(event: PointerEvent): void {
    if (event.pointerType === "mouse" && event.button !== 0) return;
    const place = this.place(event);
    this.held.set(event.pointerId, place);
    this.canvas.setPointerCapture(event.pointerId);
    if (this.held.size > 1) {
      this.letGo(place, true);
      return;
    }
    this.from = place;
    this.isTurning = false;
    this.isGrabbing = this.grip.grab(place, event.pointerType === "touch");
  }

  private move(event: PointerEvent): void {
    const place = this.place(event);
    const before = this.held.get(event.pointerId);
    if (before === undefined) {
      this.grip.hover(place);
      return;
    }
    if (this.held.size > 1) this.pinch(event.pointerId, place);
    else if (this.isGrabbing) this.grip.pull(place);
    else this.turn(before, place, event.shiftKey);
    if (this.held.size > 1 || this.isGrabbing || this.isTurning) this.held.set(event.pointerId, place);
  }

  private turn(before: [number, number], [x, y]: [number, number], isPan: boolean): void {
    this.isTurning ||= this.from === null || Math.hypot(x - this.from[0], y - this.from[1]) >= STILL;
    if (!this.isTurning) return;
    const [right, down] = [x - before[0], y - before[1]];
    if (isPan) this.eye.pan(right, -down);
    else this.eye.look(this.eye.azimuth - TURN * right, this.eye.elevation + TURN * down);
    this.grip.moved(!isPan);
  }

  private pinch(id: number, place: [number, number]): void {
    const before = this.held.get(id)!;
    const other = [...this.held].find(([key]) => key !== id)?.[1];
    if (other === undefined) return;
    const distance = (to: [number, number]): number => Math.hypot(to[0] - other[0], to[1] - other[1]) || 1;
    this.eye.zoom(distance(place) / distance(before), other);
    this.grip.moved(false);
  }

  private up(event: PointerEvent, isCancelled: boolean): void {
    if (!this.held.delete(event.pointerId)) return;
    const place = this.place(event);
    const isTap = this.held.size === 0 && this.from !== null && !this.isTurning && !isCancelled;
    const isStill = this.from !== null && Math.hypot(place[0] - this.from[0], place[1] - this.from[1]) < STILL;
    this.letGo(place, isCancelled);
    if (isTap && isStill) this.grip.tap(place);
    this.from = null;
  }

  private letGo(place: [number, number], isCancelled: boolean): void {
    if (this.isGrabbing) this.grip.letGo(place, isCancelled);
    this.isGrabbing = false;
    if (this.held.size > 1) this.from = null;
  }

  private wheel(event: WheelEvent): void {
    // Without the focus the wheel scrolls the page.
    if (!event.ctrlKey && document.activeElement !== this.canvas) return;
    event.preventDefault();
    const pixels = event.deltaY * (event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 16 : 1);
    this.eye.zoom(Math.exp(-0.0015 * Math.max(-400, Math.min(pixels, 400))), this.place(event));
    this.grip.moved(false);
  }

  private key(event: KeyboardEvent): void {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    if (event.key === "Escape" && this.isGrabbing) this.drop();
    else if (!this.act(event.key)) return;
    event.preventDefault();
  }

  /** Lets go of what was held; the pointer that still is down does nothing more. */
  private drop(): void {
    this.letGo([0, 0], true);
    this.held.clear();
    this.from = null;
  }

  private act(key: string): boolean {
    const turn = ARROWS[key];
    if (turn !== undefined) this.eye.look(this.eye.azimuth + turn[0], this.eye.elevation + turn[1]);
    else if (key === "+" || key === "=") this.eye.zoom(ZOOM);
    else if (key === "-" || key === "\u2212") this.eye.zoom(1 / ZOOM);
    else if (key === "0" || key === "Home") this.grip.reset();
    else return false;
    if (key !== "0" && key !== "Home") this.grip.moved(turn !== undefined);
    return true;
  }
}
