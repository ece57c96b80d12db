// A tower with what surrounds it, as vertices.

import { Vertices } from "./buffer.js";
import type { Palette } from "./colours.js";
import { extentOf, type Eye, type Extent } from "./eye.js";
import { limbsOf } from "./frame.js";
import type { Item } from "./graphics.js";
import { isRope, sectionsOf, type Section } from "./motion.js";
import { AT_REST, Parts } from "./parts.js";
import type { Point, Pose, TowerScene } from "./scene.js";
import { strokesOf } from "./strokes.js";
import { writeLimbs, writeTube } from "./tube.js";

const SOME = [0, 0.25, 0.5, 0.75, 1];

/** A tower that can be shown and moved again and again. */
export class TowerModel {
  /** How far it stands from its place, m. */
  away: Point = [0, 0, 0];
  /** The sections as they are drawn. */
  sections: Section[] = [];
  /** Heights of its rims; a few if not given. */
  rims: number[] | null = null;
  scene: TowerScene | null = null;

  private readonly tube = new Vertices();
  private readonly parts = new Parts();
  private readonly lines = new Vertices();
  private readonly limbs = new Vertices();
  /** Members without a section. */
  private strings: Point[][] = [];
  /** The sections at rest. */
  atRest: Section[] = [];
  private pose: Pose | null = null;
  private palette: Palette | null = null;

  constructor(private readonly fade = 0) {}

  show(scene: TowerScene, palette: Palette): void {
    this.scene = scene;
    this.palette = palette;
    this.parts.show(scene, palette);
    this.move(this.pose);
  }

  /** Moves from rest; a pose of another tower is none. */
  move(pose: Pose | null): void {
    if (this.scene === null || this.palette === null) return;
    const fits = pose !== null && pose.displacement.length === this.scene.height_m.length;
    this.pose = fits ? pose : null;
    this.sections = sectionsOf(this.scene, this.pose);
    this.atRest = this.pose === null ? this.sections : sectionsOf(this.scene, null);
    writeTube(this.tube, this.sections, this.palette.steel);
    this.parts.move(this.sections);
    const limbs = limbsOf(this.scene, this.pose?.frame ?? null);
    writeLimbs(this.limbs, limbs, this.palette.steel);
    this.strings = limbs.filter((limb) => limb[0]!.radius === 0).map((limb) => limb.map(({ middle }) => middle));
  }

  /** What is drawn; of the lines some face the reader. */
  items(eye: Eye): Item[] {
    const { scene, palette, fade } = this;
    if (scene === null || palette === null) return [];
    const rims = this.rims ?? SOME.map((share) => scene.height_m[Math.round(share * (this.sections.length - 1))]!);
    this.lines.begin();
    const strings = this.strings.map((points) => ({ points, colour: palette.of.link }));
    const strokes = strokesOf(scene, this.sections, this.pose === null ? null : this.atRest, rims, eye.bearing, palette);
    strokes.concat(strings).forEach(({ points, colour }) =>
      points.slice(1).forEach((point, i) => [points[i]!, point].forEach((end) => this.lines.push(end, colour))));
    const own: Item[] = [
      { look: "wall", vertices: this.tube, place: AT_REST, fade },
      { look: "wall", vertices: this.limbs, place: AT_REST, fade },
      { look: "line", vertices: this.lines, place: AT_REST, fade },
    ];
    return own.concat(this.parts.items(fade)).map((item) => ({ ...item, place: item.place.map((value, i) => value + (this.away[i - 12] ?? 0)) }));
  }

  /** The rectangle around everything at these sections, as seen by an eye. */
  extent(eye: Eye, sections: Section[]): Extent {
    return extentOf(eye, sections, this.scene?.bodies ?? [], this.scene?.frame);
  }

  /** A length that nothing of it exceeds much, m. */
  get span(): number {
    const heights = this.scene?.height_m ?? [0];
    const below = this.scene?.frame?.joints.map((joint) => joint[2]) ?? [];
    const ropes = this.scene?.bodies.filter(isRope).flatMap(({ points }) => points.map(([x, y]) => Math.hypot(x, y))) ?? [];
    const lowest = below.reduce((low, z) => Math.min(low, z), heights[0]!);
    return Math.max(heights[heights.length - 1]! - lowest + 2 * this.reach, ...ropes);
  }

  /** The largest horizontal distance from the axis of anything. */
  get reach(): number {
    const scene = this.scene;
    if (scene === null) return 0;
    const bodies = scene.bodies.filter((body) => !isRope(body)).flatMap((body) => body.points.map(([x, y]) => Math.hypot(x, y) + (body.radius_m ?? 0)));
    return Math.max(...scene.radius_m, ...bodies);
  }
}
