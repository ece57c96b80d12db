// The bodies around a tower, gathered so that few things are drawn: all that moves with one section
// is one part.

import { Group, LineSegments, Matrix4, Mesh, type RawShaderMaterial } from "three";

import { Vertices } from "./buffer.js";
import type { Palette } from "./colours.js";
import { isLink, sectionAt, turned, type Section } from "./motion.js";
import type { Body, TowerScene } from "./scene.js";
import { Hulls, writeBall, writeSolid } from "./solids.js";

/** The materials of a tower and its bodies. */
export interface Materials {
  wall: RawShaderMaterial;
  surface: RawShaderMaterial;
  clear: RawShaderMaterial;
  xray: RawShaderMaterial;
  line: RawShaderMaterial;
}

/**
 * Bodies that move as one: of what is drawn the surfaces, the edges, and what is seen through
 * walls.
 */
class Part {
  readonly group = new Group();
  readonly surfaces = new Vertices(true);
  readonly clear = new Vertices(true);
  readonly hidden = new Vertices(true);
  readonly edges = new Vertices(false);

  constructor(readonly follows: number | null, materials: Materials) {
    this.group.matrixAutoUpdate = false;
    const add = (thing: Mesh | LineSegments, order: number): void => {
      thing.frustumCulled = false;
      thing.renderOrder = order;
      this.group.add(thing);
    };
    add(new Mesh(this.surfaces.geometry, materials.surface), 0);
    add(new LineSegments(this.edges.geometry, materials.line), 0);
    add(new Mesh(this.clear.geometry, materials.clear), 1);
    add(new Mesh(this.hidden.geometry, materials.xray), 2);
  }

  get all(): Vertices[] {
    return [this.surfaces, this.edges, this.clear, this.hidden];
  }

  /** Nothing is drawn of what has no vertices. */
  end(): void {
    this.all.forEach((vertices, i) => {
      vertices.end();
      this.group.children[i]!.visible = !vertices.isEmpty;
    });
  }

  /** Moves with its section, rigidly. */
  place(sections: Section[]): void {
    if (this.follows === null) return;
    const { middle, turn, height } = sectionAt(sections, this.follows);
    const [x, y, z] = [turned([1, 0, 0], turn), turned([0, 1, 0], turn), turned([0, 0, 1], turn)];
    const at = [0, 1, 2].map((i) => middle[i]! - z[i]! * height);
    this.group.matrix.copy(new Matrix4().set(
      x[0], y[0], z[0], at[0]!,
      x[1], y[1], z[1], at[1]!,
      x[2], y[2], z[2], at[2]!,
      0, 0, 0, 1,
    ));
    this.group.matrixWorldNeedsUpdate = true;
  }
}

/** All bodies of a tower but those that link it to what stands still. */
export class Parts {
  readonly group = new Group();
  private parts: Part[] = [];
  private readonly hulls = new Hulls();

  constructor(private readonly materials: Materials) {}

  show(scene: TowerScene, palette: Palette): void {
    const places = scene.bodies.filter((body) => !isLink(body)).map((body) => body.follows_m ?? null);
    this.regroup([...new Set(places)]);
    this.parts.forEach((part) => part.all.forEach((vertices) => vertices.begin()));
    scene.bodies.forEach((body, index) => {
      const part = this.parts.find((candidate) => candidate.follows === (body.follows_m ?? null));
      if (part !== undefined && !isLink(body)) this.write(body, index, part, palette);
    });
    this.parts.forEach((part) => part.end());
  }

  place(sections: Section[]): void {
    this.parts.forEach((part) => part.place(sections));
  }

  dispose(): void {
    this.parts.forEach((part) => part.all.forEach((vertices) => vertices.dispose()));
  }

  /** Parts are taken again for other heights; only their number makes new ones. */
  private regroup(places: (number | null)[]): void {
    const same = places.length === this.parts.length && places.every((place, i) => place === this.parts[i]!.follows);
    if (same) return;
    const old = this.parts;
    this.parts = places.map((place, i) => (old[i] === undefined ? new Part(place, this.materials) : again(old[i], place)));
    old.slice(places.length).forEach((part) => part.all.forEach((vertices) => vertices.dispose()));
    this.group.clear();
    this.parts.forEach((part) => this.group.add(part.group));
  }

  private write(body: Body, index: number, part: Part, palette: Palette): void {
    const colour = palette.of[body.of];
    if (body.form === "ball") {
      const target = body.of === "mass" ? part.hidden : part.surfaces;
      writeBall(body.points[0]!, body.radius_m ?? 0, colour, target);
      return;
    }
    const hull = this.hulls.of(index, body.points);
    if (hull === null) return;
    const isClear = body.of === "soil" || body.of === "water";
    writeSolid(body.points, hull, colour, isClear ? part.clear : part.surfaces, part.edges, palette.ink);
  }
}

function again(part: Part, follows: number | null): Part {
  part.group.matrix.identity();
  part.group.matrixWorldNeedsUpdate = true;
  return Object.assign(part, { follows });
}
