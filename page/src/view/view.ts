import { paletteOf, type Palette } from "./colours.js";
import { isOtherSize, union, type Extent } from "./eye.js";
import { Hand, type Grip } from "./hand.js";
import { Handles, Pull, SIZE } from "./handles.js";
import { heightAt } from "./pick.js";
import type { Drag, Handle, Pose, TowerScene, ViewEvents } from "./scene.js";
import { Stage } from "./stage.js";
import { support } from "./support.js";
import { TowerModel } from "./tower.js";
import { Triad, drawTriad } from "./triad.js";

const FIRST = { azimuth: 35, elevation: 20 };
const PALER = 0.55;
/** Between two towers, as a part of what they need themselves. */
const GAP = 0.12;

/** Whether the browser draws in three dimensions (WebGL). */
export function isSupported(): boolean {
  return support().isThere;
}

/**
 * The tower in three dimensions in an element of a page. Colours are the variables `--tm-*` of the
 * page.
 */
export class TowerView {
  private readonly stage = new Stage();
  private readonly tower = new TowerModel();
  private readonly beside = new TowerModel(PALER);
  private isBeside = false;
  private readonly dots = new Handles();
  private readonly triad = new Triad();
  private readonly hand: Hand;
  private readonly stop = new AbortController();
  private readonly observers: { disconnect(): void }[] = [];
  private palette: Palette;
  private pull: Pull | null = null;
  /** Whether the user has zoomed or moved the picture: then it is not framed again. */
  private isOwn = false;
  /** What was framed last. */
  private framed: Extent | null = null;
  private isHovered = false;
  private isDirty = false;
  private isDisposed = false;
  /** Drawing that waits for the next frame. */
  private frame = 0;

  /** Fills an element, and follows its size and the theme. */
  constructor(private readonly host: HTMLElement, label: string, private readonly events: ViewEvents = {}) {
    this.palette = paletteOf(host);
    this.stage.paper = this.palette.paper;
    this.adopt(label);
    this.hand = new Hand(this.stage.canvas, this.stage.eye, this.grip());
    this.stage.eye.look(FIRST.azimuth, FIRST.elevation);
    this.follow();
  }

  /**
   * Shows a tower, and a second one beside it, paler, to compare with. The camera stays where the
   * user put it; the first call frames the tower, and so does one with a tower of another size.
   */
  show(tower: TowerScene, beside: TowerScene | null = null): void {
    const isFirst = this.tower.scene === null;
    const isOther = this.isBeside !== (beside !== null);
    this.tower.show(tower, this.palette);
    this.isBeside = beside !== null;
    if (beside !== null) this.beside.show(beside, this.palette);
    if (!isFirst && this.framed !== null && isOtherSize(this.framed, this.extent())) this.isOwn = false;
    if (isFirst || (!this.isOwn && (isOther || !this.isWell()))) this.fit();
    this.later();
  }

  /** Moves the towers from rest; null is at rest. Draws at once. */
  pose(tower: Pose | null, beside: Pose | null = null): void {
    this.tower.move(tower);
    if (this.isBeside) this.beside.move(beside);
    this.draw();
  }

  /**
   * The stations that can be dragged; drawn as handles while the pointer is over the view or the
   * view has the focus.
   */
  handles(stations: Handle[]): void {
    this.dots.set(stations);
    this.tower.rims = this.dots.heights;
    this.later();
  }

  /**
   * The direction of the eye: azimuth about the tower from the upwind side and elevation, degrees.
   */
  look(azimuth: number, elevation: number): void {
    this.stage.eye.look(azimuth, elevation);
    if (!this.isOwn && !this.isInSight()) this.fit();
    this.later();
  }

  /** The first camera again, on the present tower. */
  reset(): void {
    this.isOwn = false;
    this.stage.eye.look(FIRST.azimuth, FIRST.elevation);
    this.fit();
    this.later();
  }

  /** Reads the colours again. */
  recolour(): void {
    this.palette = paletteOf(this.host);
    this.stage.paper = this.palette.paper;
    [this.tower, this.beside].forEach((model) => model.scene !== null && model.show(model.scene, this.palette));
    this.later();
  }

  /** The canvas, drawn in this task: later its picture may be gone. */
  get picture(): HTMLCanvasElement {
    this.draw();
    return this.stage.canvas;
  }

  /** Draws the directions of the view on another canvas, in its colours. */
  drawAxes(on: CanvasRenderingContext2D, ink: string, font: string): void {
    drawTriad(on, this.stage.eye, ink, font);
  }

  /** Frees everything. */
  dispose(): void {
    if (this.isDisposed) return;
    this.isDisposed = true;
    cancelAnimationFrame(this.frame);
    this.stop.abort();
    this.observers.forEach((observer) => observer.disconnect());
    [this.hand, this.stage].forEach((part) => part.dispose());
  }

  private adopt(label: string): void {
    const { canvas } = this.stage;
    canvas.tabIndex = 0;
    canvas.setAttribute("role", "application");
    canvas.setAttribute("aria-roledescription", "3-D view");
    canvas.setAttribute("aria-label", label);
    canvas.setAttribute("aria-description", "Arrow keys turn the view, plus and minus zoom, 0 resets it.");
    Object.assign(canvas.style, { position: "absolute", inset: "0", width: "100%", height: "100%", touchAction: "pan-y" });
    if (getComputedStyle(this.host).position === "static") this.host.style.position = "relative";
    this.host.append(canvas, this.triad.element);
  }

  /** Follows the size of the element, the theme, the focus, and the loss of the graphics. */
  private follow(): void {
    const { signal } = this.stop;
    const { canvas } = this.stage;
    const size = new ResizeObserver(() => this.resize());
    size.observe(this.host);
    const theme = new MutationObserver(() => this.recolour());
    theme.observe(document.documentElement, { attributeFilter: ["class", "data-theme"] });
    this.observers.push(size, theme);
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.recolour(), { signal });
    ["focus", "blur", "webglcontextrestored"].forEach((name) => canvas.addEventListener(name, () => this.soon(), { signal }));
    this.resize();
  }

  private resize(): void {
    const { clientWidth, clientHeight } = this.host;
    if (clientWidth === 0 || clientHeight === 0) return;
    this.stage.resize(clientWidth, clientHeight);
    if (!this.isOwn) this.fit();
    this.draw();
  }

  /** Draws at the end of the task, unless it has been drawn by then. */
  private later(): void {
    if (this.isDirty) return;
    this.isDirty = true;
    queueMicrotask(() => this.isDirty && this.draw());
  }

  /** Draws with the next frame: pointers may move more often than that. */
  private soon(): void {
    if (this.frame !== 0 || this.isDisposed) return;
    this.frame = requestAnimationFrame(() => this.draw());
  }

  private draw(): void {
    this.isDirty = false;
    cancelAnimationFrame(this.frame);
    this.frame = 0;
    if (this.isDisposed || this.tower.scene === null) return;
    const { eye, canvas } = this.stage;
    const [x, y] = eye.right;
    this.beside.away = [this.distance() * x, this.distance() * y, 0];
    const items = this.tower.items(eye).concat(this.isBeside ? this.beside.items(eye) : []);
    const hasDots = this.isHovered || this.pull !== null || document.activeElement === canvas;
    if (hasDots) items.push(this.dots.item(eye, this.tower.sections, this.palette));
    this.triad.show(eye);
    this.stage.draw(items, 10 * (this.tower.span + this.beside.span + this.distance()), SIZE);
  }

  /** From one axis to the other. */
  private distance(): number {
    return this.isBeside ? (1 + GAP) * (this.tower.reach + this.beside.reach) : 0;
  }

  private extent(): ReturnType<TowerModel["extent"]> {
    const { eye } = this.stage;
    const own = this.tower.extent(eye, this.tower.atRest);
    if (!this.isBeside) return own;
    const { low, high } = this.beside.extent(eye, this.beside.atRest);
    const distance = this.distance();
    return union(own, { low: [low[0] + distance, low[1]], high: [high[0] + distance, high[1]] });
  }

  /** Whether the picture shows the tower, and no speck. */
  private isWell(): boolean {
    return this.isInSight() && !(this.framed !== null && isOtherSize(this.framed, this.extent()));
  }

  private isInSight(): boolean {
    return this.stage.eye.shows(this.extent());
  }

  private fit(): void {
    if (this.tower.scene === null) return;
    const heights = this.tower.scene.height_m;
    this.stage.eye.level = 0.5 * (heights[0]! + heights[heights.length - 1]!);
    this.framed = this.extent();
    this.stage.eye.frame(this.framed);
  }

  private grip(): Grip {
    const { eye } = this.stage;
    const tell = (drag: Drag | null): void => {
      if (drag !== null) this.events.drag?.(drag);
    };
    return {
      grab: (place, isTouch) => {
        const handle = this.dots.at(place, eye, this.tower.sections, isTouch);
        this.pull = handle === null ? null : new Pull(handle, place, eye);
        this.activate(handle);
        return handle !== null;
      },
      pull: (place) => tell(this.pull?.move(place) ?? null),
      letGo: (place, isCancelled) => {
        tell(this.pull?.end(place, isCancelled ? "cancel" : "end") ?? null);
        this.pull = null;
        this.soon();
      },
      tap: (place) => this.tap(place),
      hover: (place) => {
        this.isHovered = place !== null;
        this.activate(place === null ? null : this.dots.at(place, eye, this.tower.sections, false));
      },
      moved: (isTurn) => {
        this.isOwn ||= !isTurn;
        if (!this.isOwn && !this.isInSight()) this.fit();
        this.soon();
      },
      reset: () => this.reset(),
    };
  }

  private activate(handle: Handle | null): void {
    this.dots.active = handle?.station ?? null;
    this.stage.canvas.style.setProperty("cursor", handle === null ? "grab" : "move");
    this.soon();
  }

  private tap(place: [number, number]): void {
    const { eye } = this.stage;
    const height_m = heightAt(place, eye, this.tower.sections);
    if (height_m === null) return;
    this.events.tap?.({ height_m, direction: [-Math.cos(eye.bearing), -Math.sin(eye.bearing)] });
  }
}
