// A tower with what surrounds it, as three.js draws it.

import { Group, LineSegments, Mesh } from "three";

import { Vertices } from "./buffer.js";
import type { Palette } from "./colours.js";
import type { Eye, Extent } from "./eye.js";
import { placed, sectionsOf, type Section } from "./motion.js";
import { Parts, type Materials } from "./parts.js";
import type { Pose, TowerScene } from "./scene.js";
import { line, surface, tint, wall, xray } from "./shading.js";
import { writeStrokes } from "./strokes.js";
import { Tube } from "./tube.js";

const SOME = [0, 0.25, 0.5, 0.75, 1];

/** A tower that can be shown and moved again and again. */
export class TowerModel {
  readonly group = new Group();
  /** The sections as they are drawn. */
  sections: Section[] = [];
  /** Heights of its rims; a few if not given. */
  rims: number[] | null = null;
  scene: TowerScene | null = null;

  private readonly materials: Materials = { wall: wall(), surface: surface(), clear: surface(0.4), xray: xray(), line: line() };
  private readonly tube = new Tube();
  private readonly parts = new Parts(this.materials);
  private readonly lines = new Vertices(false);
  /** The sections at rest. */
  atRest: Section[] = [];
  private pose: Pose | null = null;
  private palette: Palette | null = null;

  constructor(private readonly fade = 0) {
    const strokes = new LineSegments(this.lines.geometry, this.materials.line);
    const tower = new Mesh(this.tube.geometry, this.materials.wall);
    [tower, strokes].forEach((thing) => {
      thing.frustumCulled = false;
      this.group.add(thing);
    });
    this.group.add(this.parts.group);
  }

  show(scene: TowerScene, palette: Palette): void {
    this.scene = scene;
    this.parts.show(scene, palette);
    this.move(this.pose);
    if (this.palette !== palette) this.paint(palette);
  }

  /** Moves from rest; a pose of another tower is none. */
  move(pose: Pose | null): void {
    if (this.scene === null) return;
    const fits = pose !== null && pose.displacement.length === this.scene.height_m.length;
    this.pose = fits ? pose : null;
    this.sections = sectionsOf(this.scene, this.pose);
    this.atRest = this.pose === null ? this.sections : sectionsOf(this.scene, null);
    const isNew = this.tube.place(this.sections);
    if (isNew && this.palette !== null) this.tube.paint(this.palette.steel);
    this.parts.place(this.sections);
  }

  /** The lines, some of which face the reader. */
  draw(eye: Eye): void {
    if (this.scene === null || this.palette === null) return;
    const rims = this.rims ?? SOME.map((share) => this.scene!.height_m[Math.round(share * (this.sections.length - 1))]!);
    writeStrokes(this.lines, this.scene, this.sections, this.pose === null ? null : this.atRest, rims, eye.bearing, this.palette);
  }

  /** The rectangle around everything at these sections, as seen by an eye. */
  extent(eye: Eye, sections: Section[] = this.sections): Extent {
    const low: [number, number] = [Infinity, Infinity];
    const high: [number, number] = [-Infinity, -Infinity];
    const include = (point: [number, number, number], margin: number): void => {
      const at = [eye.across(point), eye.up(point)] as const;
      [0, 1].forEach((i) => {
        low[i] = Math.min(low[i]!, at[i]! - margin);
        high[i] = Math.max(high[i]!, at[i]! + margin);
      });
    };
    sections.forEach((section) => include(section.middle, section.radius));
    this.scene?.bodies.forEach((body) => placed(body, sections).forEach((point) => include(point, body.radius_m ?? 0)));
    return { low, high };
  }

  /** A length that nothing of it exceeds much, m. */
  get span(): number {
    const heights = this.scene?.height_m ?? [0];
    return heights[heights.length - 1]! - heights[0]! + 2 * this.reach;
  }

  /** The largest horizontal distance from the axis of anything. */
  get reach(): number {
    const scene = this.scene;
    if (scene === null) return 0;
    const bodies = scene.bodies.flatMap((body) => body.points.map(([x, y]) => Math.hypot(x, y) + (body.radius_m ?? 0)));
    return Math.max(...scene.radius_m, ...bodies);
  }

  dispose(): void {
    [this.tube, this.parts, this.lines, ...Object.values(this.materials)].forEach((thing) => thing.dispose());
  }

  private paint(palette: Palette): void {
    this.palette = palette;
    this.tube.paint(palette.steel);
    Object.values(this.materials).forEach((made) => tint(made, palette.paper, this.fade));
  }
}
