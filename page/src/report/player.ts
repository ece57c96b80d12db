// An animation of the page: which modes move, how they are looked at, how far and how fast they go.

import type { Eye, Extent } from "../view/eye.js";
import { Hand } from "../view/hand.js";
import { add, drawDirections, field, sheet, viewsOf, type View, type ViewName } from "./views.js";

const DEGREE = Math.PI / 180;
const SPEEDS_HZ = [0.05, 0.1, 0.2, 0.35, 0.5, 0.75, 1, 1.5, 2];
/** More modes than these are too small to be seen beside each other. */
const MOST_SHOWN = 6;
export const MOST_PERCENT = 20;

/** A mode as the page names it. */
interface Named {
  number: number;
  label: string;
  frequency_hz: number;
}

/** Moves a picture to a phase (rad), with an amplitude in percent. */
export type Move = (phase: number, percent: number) => void;

/** What is animated. */
export interface Subject<Mode extends Named> {
  /** What the ids of its elements begin with. */
  id: string;
  /** What its modes are of: " of the turbine". */
  of: string;
  /** What a picture shows, in words. */
  words: string;
  modes: Mode[];
  /** The height about which the view in space is turned, m. */
  level: number;
  /** What a view has to have room for: then modes can be compared. */
  extent(eye: Eye, view: ViewName, modes: Mode[]): Extent;
  /** Draws what stays; what it returns moves the rest. */
  paint(field: Element, mode: Mode, view: ViewName, eye: Eye): Move;
}

interface Picture<Mode> {
  svg: SVGSVGElement;
  mode: Mode;
  name: ViewName;
  move: Move;
}

class Player<Mode extends Named> {
  private readonly views = viewsOf();
  private pictures: Picture<Mode>[] = [];
  private hands: Hand[] = [];
  private phase = 0;
  private percent = 10;
  private speed = 4;
  private time: number | null = null;
  private isPlaying = false;
  /** Whether the reader has zoomed or moved the view in space: then it is not framed again. */
  private isOwn = false;
  private frame = 0;

  constructor(private readonly subject: Subject<Mode>) {
    this.listen();
    // A browser may have kept what was chosen before the page was loaded anew, and what was disabled.
    this.input("phase").disabled = false;
    this.percent = Number(this.input("amplitude").value);
    this.phase = Number(this.input("phase").value) * DEGREE;
    this.followSlider();
    this.setSpeed(this.speed);
    this.build();
  }

  private element(name: string): HTMLElement {
    return document.getElementById(`${this.subject.id}-${name}`)!;
  }

  private input(name: string): HTMLInputElement {
    return this.element(name) as HTMLInputElement;
  }

  private boxes(name: string): HTMLInputElement[] {
    return [...document.querySelectorAll<HTMLInputElement>(`input[name=${this.subject.id}-${name}]`)];
  }

  private chosen(name: string): string[] {
    return this.boxes(name).filter((box) => box.checked).map((box) => box.value);
  }

  private get modes(): Mode[] {
    return this.chosen("mode").map((index) => this.subject.modes[Number(index)]!);
  }

  /** Makes the pictures of all chosen modes and views. */
  private build(): void {
    const { subject, modes } = this;
    const names = this.chosen("view") as ViewName[];
    const stage = this.element("pictures");
    stage.replaceChildren();
    stage.style.setProperty("--views", String(Math.max(1, names.length)));
    this.hands.forEach((hand) => hand.dispose());
    this.hands = [];
    this.pictures = modes.flatMap((mode) => {
      const group = add(stage, "div", { class: "mode", role: "group", "aria-label": `Mode ${mode.number}${subject.of}` });
      add(group, "p", { class: "mode-name" }, `Mode ${mode.number}: ${mode.label}, ${mode.frequency_hz} Hz`);
      const row = add(group, "div", { class: "views" });
      return names.map((name) => this.picture(row, mode, name));
    });
    names.forEach((name) => this.fit(name));
    this.fill();
    this.say(modes, names.length);
  }

  private picture(row: Element, mode: Mode, name: ViewName): Picture<Mode> {
    const view = this.views[name];
    const cell = add(row, "div", { class: `view view-${name}` });
    const svg = sheet(cell, `${this.subject.id}-${mode.number}-${name}`, view);
    add(cell, "p", { class: "view-name", "aria-hidden": "true" }, view.name);
    if (name === "space") this.hands.push(this.handOn(svg, view));
    return { svg, mode, name, move: () => undefined };
  }

  /** Lets a view in space be turned, moved and zoomed; all of them go together. */
  private handOn(svg: SVGSVGElement, { eye }: View): Hand {
    svg.setAttribute("tabindex", "0");
    svg.setAttribute("aria-description", "Arrow keys turn the view, plus and minus zoom, 0 resets it.");
    return new Hand(svg, eye, {
      grab: () => false,
      pull: () => undefined,
      letGo: () => undefined,
      tap: () => undefined,
      hover: () => undefined,
      moved: (isTurn) => {
        this.isOwn ||= !isTurn;
        this.soon();
      },
      reset: () => {
        this.isOwn = false;
        const first = viewsOf().space.eye;
        eye.look(first.azimuth, first.elevation);
        this.soon();
      },
    });
  }

  /** Shows the view in space from another eye; pointers may move more often than the screen shows. */
  private soon(): void {
    this.frame ||= requestAnimationFrame(() => {
      this.frame = 0;
      this.look();
    });
  }

  private look(): void {
    this.writeDirection();
    this.fit("space");
    this.fill("space");
  }

  private fit(name: ViewName): void {
    const { eye } = this.views[name];
    if (this.modes.length === 0 || (this.isOwn && name === "space")) return;
    eye.level = this.subject.level;
    eye.frame(this.subject.extent(eye, name, this.modes));
  }

  /** Draws the pictures anew, or those of one view. */
  private fill(only?: ViewName): void {
    const { subject } = this;
    this.pictures.filter(({ name }) => only === undefined || name === only).forEach((picture) => {
      const { svg, mode, name } = picture;
      const view = this.views[name];
      svg.replaceChildren();
      add(svg, "title", { id: `${svg.id}-title` }, `Mode ${mode.number}${subject.of}, ${mode.label}, ${view.name}`);
      add(svg, "desc", { id: `${svg.id}-text` }, subject.words);
      picture.move = subject.paint(field(svg, view), mode, name, view.eye);
      drawDirections(svg, view);
    });
    this.draw();
  }

  /** At most so many modes at once; which, is said to those who listen. */
  private say(modes: Mode[], views: number): void {
    this.boxes("mode").forEach((box) => { box.disabled = !box.checked && modes.length >= MOST_SHOWN; });
    const names = modes.map((mode) => `mode ${mode.number}, ${mode.label}`);
    const isEmpty = names.length === 0 || views === 0;
    const most = names.length >= MOST_SHOWN ? ` No more than ${MOST_SHOWN} at once.` : "";
    this.element("caption").textContent = isEmpty ? "Choose a mode and a view." : `Shown: ${names.join("; ")}.${most}`;
  }

  private draw(): void {
    this.pictures.forEach(({ move }) => move(this.phase, this.percent));
    const turns = this.phase / (2 * Math.PI);
    const degrees = Math.round(360 * (turns - Math.round(turns)));
    if (this.isPlaying) this.input("phase").value = String(degrees);
    this.write("phase", `${degrees}\u00b0`);
    this.write("amplitude", `${this.percent} %`);
  }

  private write(name: string, text: string): void {
    this.element(`${name}-text`).textContent = text.replace("-", "\u2212");
  }

  /** The eye goes where the slider is: its angle is counted from the downwind side. */
  private followSlider(): void {
    const { eye } = this.views.space;
    eye.look(Number(this.input("azimuth").value) - 180, eye.elevation);
    this.writeDirection();
  }

  private writeDirection(): void {
    const { azimuth } = this.views.space.eye;
    const fromDownwind = azimuth >= 0 ? azimuth - 180 : azimuth + 180;
    this.input("azimuth").value = String(fromDownwind);
    this.write("azimuth", `${Math.round(fromDownwind)}\u00b0`);
  }

  private setSpeed(speed: number): void {
    this.speed = Math.min(Math.max(speed, 0), SPEEDS_HZ.length - 1);
    this.element("speed").textContent = `${SPEEDS_HZ[this.speed]} cycles per second on screen`;
    this.input("slower").disabled = this.speed === 0;
    this.input("faster").disabled = this.speed === SPEEDS_HZ.length - 1;
  }

  private play(isPlaying: boolean): void {
    if (isPlaying === this.isPlaying) return;
    this.isPlaying = isPlaying;
    this.time = null;
    this.element("play").textContent = isPlaying ? "Pause" : "Play";
    this.input("phase").disabled = isPlaying;
    if (isPlaying) requestAnimationFrame((now) => this.step(now));
  }

  /** The phase goes on beyond a turn, so that a rotor turns steadily. */
  private step(now: number): void {
    if (!this.isPlaying) return;
    // A page that was hidden goes on where it was.
    const seconds = this.time === null ? 0 : Math.min(now - this.time, 100) / 1000;
    this.phase += 2 * Math.PI * SPEEDS_HZ[this.speed]! * seconds;
    this.time = now;
    this.draw();
    requestAnimationFrame((next) => this.step(next));
  }

  private listen(): void {
    const on = (name: string, event: string, act: () => void): void => this.element(name).addEventListener(event, act);
    on("play", "click", () => this.play(!this.isPlaying));
    on("slower", "click", () => this.setSpeed(this.speed - 1));
    on("faster", "click", () => this.setSpeed(this.speed + 1));
    on("amplitude", "input", () => {
      this.percent = Number(this.input("amplitude").value);
      this.draw();
    });
    on("phase", "input", () => {
      this.phase = Number(this.input("phase").value) * DEGREE;
      this.draw();
    });
    on("azimuth", "input", () => {
      this.followSlider();
      this.look();
    });
    on("modes", "change", () => this.build());
    on("view-boxes", "change", () => this.build());
    document.getElementById(this.subject.id)!.addEventListener("keydown", (event) => this.key(event));
    // Who asks for less motion never sees any that was not asked for.
    matchMedia("(prefers-reduced-motion: reduce)").addEventListener("change", () => this.play(false));
    // Paper has the largest deflection, from where the view is looked at.
    window.addEventListener("beforeprint", () => {
      this.play(false);
      this.phase = 0;
      this.input("phase").value = "0";
      this.draw();
    });
  }

  /**
   * Buttons and boxes have the space bar to themselves; everywhere else in the section it plays and
   * pauses, once a press.
   */
  private key(event: KeyboardEvent): void {
    const hasModifier = event.shiftKey || event.ctrlKey || event.altKey || event.metaKey;
    const isOfControl = (event.target as Element).closest("button, summary, input[type=checkbox]") !== null;
    if (event.key !== " " || hasModifier || isOfControl) return;
    event.preventDefault();
    if (!event.repeat) this.play(!this.isPlaying);
  }
}

/** Animates a subject, by the controls of its section. */
export function animate<Mode extends Named>(subject: Subject<Mode>): void {
  new Player(subject);
}
