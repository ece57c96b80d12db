// Draws towers on a canvas.

import { Color, ColorManagement, OrthographicCamera, Scene, WebGLRenderer } from "three";

import type { Palette, Rgb } from "./colours.js";
import { Eye } from "./eye.js";
import { support } from "./support.js";

// Colours are those of the page, and are mixed as the page mixes them.
ColorManagement.enabled = false;

/** More pixels than that cost more than they show. */
const FINEST = 2;

/** A canvas with an eye in front of it. */
export class Stage {
  readonly canvas: HTMLCanvasElement;
  readonly eye = new Eye();
  readonly scene = new Scene();
  private readonly camera = new OrthographicCamera();
  private readonly renderer: WebGLRenderer;
  private readonly paper = new Color();

  constructor() {
    const { isSoftware } = support();
    this.renderer = new WebGLRenderer({ antialias: !isSoftware, alpha: false, stencil: false });
    this.renderer.setPixelRatio(isSoftware ? 1 : Math.min(devicePixelRatio, FINEST));
    this.canvas = this.renderer.domElement;
    this.scene.matrixAutoUpdate = false;
  }

  /** Pixels of the canvas for each of the page. */
  get pixelRatio(): number {
    return this.renderer.getPixelRatio();
  }

  /** The size in pixels of the page. What was as high as the picture stays so. */
  resize(width: number, height: number): void {
    const { eye } = this;
    if (width === eye.width && height === eye.height) return;
    eye.scale *= eye.height / height;
    eye.width = width;
    eye.height = height;
    this.renderer.setSize(width, height, false);
  }

  colour({ paper }: Palette): void {
    this.setPaper(paper);
  }

  /** Draws; everything is within a distance of the level of the eye. */
  draw(distance: number): void {
    if (this.renderer.getContext().isContextLost()) return;
    this.eye.aim(this.camera, distance);
    this.renderer.render(this.scene, this.camera);
  }

  dispose(): void {
    this.renderer.dispose();
    this.renderer.forceContextLoss();
    this.canvas.remove();
  }

  private setPaper(paper: Rgb): void {
    this.renderer.setClearColor(this.paper.setRGB(...paper), 1);
  }
}
