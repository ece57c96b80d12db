// The resonance diagram in the page: drawn in its size, with values at the pointer.

import { byId, setText } from "../dom.js";
import { showSvg } from "../panels/patch.js";
import { hzAt, type Content, type Line } from "./content.js";
import { drawing, scaleOf, type Frame } from "./draw.js";

/** A line is touched within so many pixels. */
const NEAR_PX = 14;

export interface DiagramEvents {
  /** A line is chosen by the pointer or the keyboard. */
  choose(line: Line): void;
}

export class Diagram {
  private host = byId("diagram");
  private text = byId("diagram-text");
  private cursor = document.createElement("div");
  private content: Content | null = null;
  private words = "";
  /** Where the cursor is: a speed and a line. */
  private at: { rpm: number; line: Line | null } | null = null;

  constructor(private events: DiagramEvents) {
    this.cursor.className = "cursor";
    this.cursor.hidden = true;
    new ResizeObserver(() => this.draw()).observe(this.host);
    this.host.addEventListener("pointermove", (event) => this.point(event));
    this.host.addEventListener("pointerleave", () => this.leave());
    this.host.addEventListener("blur", () => this.leave());
    this.host.addEventListener("click", (event) => {
      this.point(event);
      this.chooseTouched();
    });
    this.host.addEventListener("keydown", (event) => this.key(event));
  }

  /** Shows a diagram; `words` say what is in it. */
  show(content: Content, words: string): void {
    this.content = content;
    this.words = words;
    if (this.at !== null) this.at = { ...this.at, line: sameLine(content, this.at.line) };
    this.draw();
  }

  private get frame(): Frame {
    const text = parseFloat(getComputedStyle(this.host).fontSize);
    return { width: this.host.clientWidth, height: this.host.clientHeight, text };
  }

  private draw(): void {
    const { content, frame } = this;
    if (content === null || frame.width < 100 || frame.height < 80) return;
    showSvg(this.host, drawing(content, frame, this.words));
    this.host.append(this.cursor);
    if (this.at !== null) this.showCursor();
    else setText(this.text, this.rest());
  }

  /** What is said without a pointer. */
  private rest(): string {
    const above = this.content?.above ?? 0;
    return above > 0 ? `${above} ${above === 1 ? "line" : "lines"} above the axis.` : "";
  }

  private point(event: MouseEvent): void {
    const { content } = this;
    if (content === null) return;
    const box = this.host.getBoundingClientRect();
    const scale = scaleOf(content, this.frame);
    const [x, y] = [event.clientX - box.left, event.clientY - box.top];
    const rpm = Math.min(content.last_rpm, Math.max(0, scale.rpm(x)));
    const near = content.lines.flatMap((line) => {
      const hz = hzAt(line, rpm);
      const distance = hz === null ? Infinity : Math.abs(scale.y(hz) - y) + (line.isOther ? 1 : 0);
      return distance <= NEAR_PX ? [{ line, distance }] : [];
    });
    near.sort((a, b) => a.distance - b.distance);
    this.at = { rpm, line: near[0]?.line ?? null };
    this.showCursor();
  }

  private leave(): void {
    this.at = null;
    this.cursor.hidden = true;
    this.host.classList.remove("touches");
    setText(this.text, this.rest());
  }

  private chooseTouched(): void {
    const line = this.at?.line;
    if (line && !line.isOther) this.events.choose(line);
  }

  /** Left and right move along the speed, up and down from line to line. */
  private key(event: KeyboardEvent): void {
    const { content } = this;
    if (content === null) return;
    const now = this.at ?? { rpm: content.operation?.[1] ?? content.last_rpm, line: null };
    const sideways = event.key === "ArrowRight" ? 1 : event.key === "ArrowLeft" ? -1 : 0;
    const upwards = event.key === "ArrowUp" ? 1 : event.key === "ArrowDown" ? -1 : 0;
    if (sideways !== 0) {
      const rpm = now.rpm + (sideways * content.last_rpm) / 60;
      this.at = { ...now, rpm: Math.min(content.last_rpm, Math.max(0, rpm)) };
    } else if (upwards !== 0) this.at = { ...now, line: this.next(now, upwards) };
    else if (event.key === "Enter") this.chooseTouched();
    else return;
    event.preventDefault();
    if (event.key !== "Enter") this.showCursor();
  }

  private next({ rpm, line }: { rpm: number; line: Line | null }, by: number): Line | null {
    const there = (this.content?.lines ?? []).flatMap((one) => {
      const hz = hzAt(one, rpm);
      return hz === null ? [] : [{ one, hz }];
    });
    there.sort((a, b) => a.hz - b.hz);
    const place = there.findIndex(({ one }) => one.label === line?.label && one.isOther === line.isOther);
    const next = place < 0 ? (by > 0 ? 0 : there.length - 1) : Math.min(there.length - 1, Math.max(0, place + by));
    return there[next]?.one ?? null;
  }

  private showCursor(): void {
    const { content, at } = this;
    if (content === null || at === null) return;
    const scale = scaleOf(content, this.frame);
    this.cursor.hidden = false;
    this.cursor.style.transform = `translateX(${scale.x(at.rpm).toFixed(1)}px)`;
    this.cursor.style.top = `${scale.top}px`;
    this.cursor.style.height = `${scale.bottom - scale.top}px`;
    this.host.classList.toggle("touches", at.line !== null && !at.line.isOther);
    setText(this.text, describe(content, at));
  }
}

/** The line of the same mode in another diagram. */
function sameLine({ lines }: Content, before: Line | null): Line | null {
  return lines.find(({ label, isOther }) => label === before?.label && isOther === before.isOther) ?? null;
}

/** "9.1 rpm: 1st fore-aft bending 0.2765 Hz; 1P 0.1517, 3P 0.455 Hz". */
export function describe(content: Content, { rpm, line }: { rpm: number; line: Line | null }): string {
  const hz = line === null ? null : hzAt(line, rpm);
  const short = (value: number): string => String(Number(value.toPrecision(4)));
  const rays = content.rays.map(({ multiple }) => `${multiple}P ${short((multiple * rpm) / 60)}`);
  const mode = line === null || hz === null ? "" : `${line.isOther ? "A: " : ""}${line.label} ${short(hz)} Hz; `;
  return `${Number(rpm.toFixed(2))} rpm: ${mode}${rays.join(", ")} Hz`;
}
