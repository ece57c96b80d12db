// One tower in several poses, each on a canvas of its own: one renderer draws them all, one after
// the other.

import { paletteOf, type Palette } from "./colours.js";
import { union } from "./eye.js";
import { Hand } from "./hand.js";
import { reach, sectionsAt } from "./motion.js";
import type { Pose, Shape, TowerScene } from "./scene.js";
import { Stage } from "./stage.js";
import { TowerModel } from "./tower.js";

/** What the page is told. */
export interface PictureEvents {
  /** All pictures have to be drawn again; they may have been turned by hand. */
  changed(): void;
  /** The browser draws no longer. */
  lost(): void;
}

/** Pictures of a tower in its modes, to one scale and from one direction. */
export class Pictures {
  private readonly stage = new Stage();
  private readonly tower = new TowerModel();
  private readonly first: [number, number];
  private canvases: HTMLCanvasElement[] = [];
  private hands: Hand[] = [];
  private modes: Shape[] = [];
  private palette: Palette;
  private isOwn = false;
  private frame = 0;
  private readonly size = new ResizeObserver(() => this.resize());

  /** `azimuth` and `elevation` are the first direction of the eye, as of `TowerView.look`. */
  constructor(
    private readonly host: HTMLElement, private readonly scene: TowerScene, private readonly percent: number,
    azimuth: number, elevation: number, private readonly events: PictureEvents,
  ) {
    this.first = [azimuth, elevation];
    this.palette = paletteOf(host);
    this.stage.scene.add(this.tower.group);
    this.stage.colour(this.palette);
    this.stage.eye.look(azimuth, elevation);
    this.tower.show(scene, this.palette);
    this.stage.canvas.addEventListener("webglcontextlost", () => events.lost());
    new MutationObserver(() => this.recolour()).observe(document.documentElement, { attributeFilter: ["class", "data-theme"] });
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.recolour());
  }

  get azimuth(): number {
    return this.stage.eye.azimuth;
  }

  get elevation(): number {
    return this.stage.eye.elevation;
  }

  /** Turns all pictures about the tower. They have to be drawn again. */
  turn(azimuth: number): void {
    this.stage.eye.look(azimuth, this.elevation);
    if (!this.isOwn) this.fit();
  }

  /** Takes the canvases of these modes, one each, instead of those before. */
  use(canvases: HTMLCanvasElement[], modes: Shape[]): void {
    this.release();
    this.canvases = canvases;
    this.modes = modes;
    this.hands = canvases.map((canvas) => new Hand(canvas, this.stage.eye, {
      grab: () => false,
      pull: () => undefined,
      letGo: () => undefined,
      tap: () => undefined,
      hover: () => undefined,
      moved: (isTurn) => this.moved(isTurn),
      reset: () => this.reset(),
    }));
    canvases.forEach((canvas) => this.size.observe(canvas));
    this.resize(false);
  }

  /** Draws a pose on one of the canvases. */
  draw(canvas: HTMLCanvasElement, pose: Pose | null): void {
    const context = canvas.getContext("2d", { alpha: false });
    if (context === null || canvas.width === 0 || canvas.height === 0) return;
    this.tower.move(pose);
    this.tower.draw(this.stage.eye);
    this.stage.draw(10 * this.tower.span);
    context.drawImage(this.stage.canvas, 0, 0);
  }

  private reset(): void {
    this.isOwn = false;
    this.stage.eye.look(...this.first);
    this.fit();
    this.soon();
  }

  private moved(isTurn: boolean): void {
    this.isOwn ||= !isTurn;
    if (!this.isOwn) this.fit();
    this.soon();
  }

  private release(): void {
    this.size.disconnect();
    this.hands.forEach((hand) => hand.dispose());
  }

  /** All canvases are as large as the first: they are beside each other. */
  private resize(isLater = true): void {
    const canvas = this.canvases[0];
    if (canvas === undefined || canvas.clientWidth === 0 || canvas.clientHeight === 0) return;
    this.stage.resize(canvas.clientWidth, canvas.clientHeight);
    const { width, height } = this.stage.canvas;
    this.canvases.filter((one) => one.width !== width || one.height !== height).forEach((one) => Object.assign(one, { width, height }));
    if (!this.isOwn) this.fit();
    if (isLater) this.soon();
  }

  /** Shows all modes at their largest amplitude. */
  private fit(): void {
    const { eye } = this.stage;
    const heights = this.scene.height_m;
    eye.level = 0.5 * (heights[0]! + heights[heights.length - 1]!);
    const extents = this.modes.flatMap((mode) => [-1, 0, 1].map((share) =>
      this.tower.extent(eye, sectionsAt(this.scene, mode, share * reach(this.scene, mode, this.percent)))));
    if (extents.length > 0) eye.frame(extents.reduce(union));
  }

  private recolour(): void {
    this.palette = paletteOf(this.host);
    this.stage.colour(this.palette);
    this.tower.show(this.scene, this.palette);
    this.soon();
  }

  /** Pointers may move more often than the screen shows. */
  private soon(): void {
    if (this.frame !== 0) return;
    this.frame = requestAnimationFrame(() => {
      this.frame = 0;
      this.events.changed();
    });
  }
}
