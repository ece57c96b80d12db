// The tower in its modes, as drawings of the page.

import { extentOf, union, type Eye } from "../view/eye.js";
import { limbsOf } from "../view/frame.js";
import { placed, reach, sectionsAt } from "../view/motion.js";
import type { Body, Point, Shape, TowerScene } from "../view/scene.js";
import { bodyPath, limbPath, rimsPath, seamPath, towerPath } from "./paths.js";
import { animate, MOST_PERCENT, type Move } from "./player.js";
import { add, type ViewName } from "./views.js";

/** Drawn after the tower, so that it is seen through them. */
const isThrough = ({ of }: Body): boolean => of === "soil" || of === "water";
const isOnTower = ({ of }: Body): boolean => of === "rna" || of === "rotor" || of === "mass";

/** What stands behind the tower, before it, and around it. */
function layers(bodies: Body[], eye: Eye): Record<"behind" | "before" | "around", Body[]> {
  const depth = (points: Point[]): number => points.reduce((sum, point) => sum + eye.near(point), 0) / points.length;
  const onAxis = (points: Point[]): Point[] => points.map((point) => [0, 0, point[2]]);
  const isBefore = (body: Body): boolean => body.of === "mass" || depth(body.points) > depth(onAxis(body.points));
  const moving = bodies.filter(isOnTower).sort((a, b) => depth(a.points) - depth(b.points));
  const still = bodies.filter((body) => !isThrough(body) && !isOnTower(body));
  return {
    behind: still.concat(moving.filter((body) => !isBefore(body))),
    before: moving.filter(isBefore),
    around: bodies.filter(isThrough),
  };
}

export function animateTower(scene: TowerScene): void {
  // From above other parts would hide the sections.
  const bodiesOf = (view: ViewName): Body[] => (view === "top" ? scene.bodies.filter(({ of }) => of === "rna") : scene.bodies);
  animate<Shape>({
    id: "animation",
    of: "",
    words: "The tower undeformed and deflected in the mode, with rotor-nacelle assembly, foundation and surroundings.",
    modes: scene.modes,
    level: 0.5 * (scene.height_m[0]! + scene.height_m[scene.height_m.length - 1]!),
    extent: (eye, view, modes) => modes.flatMap((mode) => [-1, 0, 1].map((share) =>
      extentOf(eye, sectionsAt(scene, mode, share * reach(scene, mode, MOST_PERCENT)), bodiesOf(view), scene.frame))).reduce(union),
    paint: (field, mode, view, eye) => paint(field, scene, mode, layers(bodiesOf(view), eye), view === "space", eye),
  });
}

function paint(
  field: Element, scene: TowerScene, mode: Shape, { behind, before, around }: ReturnType<typeof layers>, hasRims: boolean, eye: Eye,
): Move {
  const path = (of: string): Element => add(field, "path", { class: of });
  const frameAt = (factor: number): string =>
    limbsOf(scene, mode.frame?.map((value) => factor * value) ?? null).map((limb) => limbPath(eye, limb)).join("");
  const paths = (bodies: Body[]): [Body, Element][] => bodies.map((body) => [body, path(`body ${body.of}`)]);
  const moved = paths(behind);
  path("undeformed").setAttribute("d", towerPath(eye, sectionsAt(scene, mode, 0)) + frameAt(0));
  const frame = scene.frame === undefined ? null : path("deformed limbs");
  const deformed = path("deformed");
  const rims = hasRims ? path("rims") : null;
  const seam = path("seam");
  moved.push(...paths(before), ...paths(around));
  return (phase, percent) => {
    const factor = Math.cos(phase) * reach(scene, mode, percent);
    const sections = sectionsAt(scene, mode, factor);
    frame?.setAttribute("d", frameAt(factor));
    moved.forEach(([body, element]) => element.setAttribute("d", bodyPath(eye, body, placed(body, sections))));
    deformed.setAttribute("d", towerPath(eye, sections));
    seam.setAttribute("d", seamPath(eye, sections));
    rims?.setAttribute("d", rimsPath(eye, sections));
  };
}
