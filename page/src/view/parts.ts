// The bodies around a tower, gathered so that few things are drawn: all that moves with one section
// is one part.

import { Vertices } from "./buffer.js";
import type { Palette } from "./colours.js";
import type { Item, Look, Matrix } from "./graphics.js";
import { isLink, sectionAt, turned, type Section } from "./motion.js";
import type { Body, TowerScene } from "./scene.js";
import { Hulls, writeBall, writeSolid } from "./solids.js";

export const AT_REST: Matrix = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

/** Bodies that move as one. */
class Part {
  follows: number | null = null;
  place = AT_REST;
  readonly of = {
    surface: new Vertices(), line: new Vertices(), clear: new Vertices(), hidden: new Vertices(),
  };

  /** Moves with its section, rigidly. */
  move(sections: Section[]): void {
    if (this.follows === null) return;
    const { middle, turn, height } = sectionAt(sections, this.follows);
    const [x, y, z] = [turned([1, 0, 0], turn), turned([0, 1, 0], turn), turned([0, 0, 1], turn)];
    this.place = [...x, 0, ...y, 0, ...z, 0, ...middle.map((at, i) => at - z[i]! * height), 1];
  }
}

/** All bodies of a tower but those that link it to what stands still. */
export class Parts {
  private parts: Part[] = [];
  private readonly hulls = new Hulls();

  show(scene: TowerScene, palette: Palette): void {
    const follows = (body: Body): number | null => body.follows_m ?? null;
    const heights = new Set(scene.bodies.filter((body) => !isLink(body)).map(follows));
    this.parts = [...heights].map((height, i) => Object.assign(this.parts[i] ?? new Part(), { follows: height, place: AT_REST }));
    this.parts.forEach((part) => Object.values(part.of).forEach((vertices) => vertices.begin()));
    scene.bodies.forEach((body, index) => {
      const part = this.parts.find((candidate) => candidate.follows === follows(body));
      if (part !== undefined && !isLink(body)) this.write(body, index, part, palette);
    });
  }

  move(sections: Section[]): void {
    this.parts.forEach((part) => part.move(sections));
  }

  items(fade: number): Item[] {
    return this.parts.flatMap(({ of, place }) =>
      Object.entries(of).map(([look, vertices]) => ({ look: look as Look, vertices, place, fade })));
  }

  private write(body: Body, index: number, { of }: Part, palette: Palette): void {
    const colour = palette.of[body.of];
    if (body.form === "ball") {
      writeBall(body.points[0]!, body.radius_m ?? 0, colour, body.of === "mass" ? of.hidden : of.surface);
      return;
    }
    const hull = this.hulls.of(index, body.points);
    if (hull === null) return;
    const isClear = body.of === "soil" || body.of === "water";
    writeSolid(body.points, hull, colour, isClear ? of.clear : of.surface, of.line, palette.ink);
  }
}
