// Draws towers on a canvas.

import type { Rgb } from "./colours.js";
import { Eye } from "./eye.js";
import { Graphics, type Item } from "./graphics.js";
import { support } from "./support.js";

/** More pixels than that cost more than they show. */
const FINEST = 2;

/** A canvas with an eye in front of it. */
export class Stage {
  readonly canvas = document.createElement("canvas");
  readonly eye = new Eye();
  paper: Rgb = [1, 1, 1];
  private readonly gl: WebGL2RenderingContext;
  private readonly pixelRatio: number;
  private graphics: Graphics;

  constructor() {
    const { isSoftware } = support();
    this.pixelRatio = isSoftware ? 1 : Math.min(devicePixelRatio, FINEST);
    const context = this.canvas.getContext("webgl2", { antialias: !isSoftware, alpha: false });
    if (context === null) throw new Error("the browser gives no context of WebGL");
    this.gl = context;
    this.graphics = new Graphics(context);
    // A context that was lost comes again, without anything that it had.
    this.canvas.addEventListener("webglcontextlost", (event) => event.preventDefault());
    this.canvas.addEventListener("webglcontextrestored", () => { this.graphics = new Graphics(context); });
  }

  /** The size in pixels of the page. What was as high as the picture stays so. */
  resize(width: number, height: number): void {
    const { eye, canvas, pixelRatio } = this;
    if (width === eye.width && height === eye.height) return;
    eye.scale *= eye.height / height;
    Object.assign(eye, { width, height });
    Object.assign(canvas, { width: Math.floor(width * pixelRatio), height: Math.floor(height * pixelRatio) });
  }

  /** Draws, with dots of a size; everything is within a distance of the level of the eye. */
  draw(items: Item[], distance: number, dotSize: number): void {
    if (this.gl.isContextLost()) return;
    this.graphics.draw(items, this.eye, distance, this.paper, dotSize * this.pixelRatio);
  }

  dispose(): void {
    this.gl.getExtension("WEBGL_lose_context")?.loseContext();
    this.canvas.remove();
  }
}
