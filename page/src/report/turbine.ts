// The turbine with its turning rotor in its modes, as drawings of the page. A mode moves with
// cos(w t) while the rotor turns by W t: both by the same time.

import { extentOf, union, type Eye } from "../view/eye.js";
import type { Point } from "../view/scene.js";
import { Moment, TURN, type Turbine, type WhirlMode } from "../view/turbine.js";
import { linePath, solidPath, towerPath, tubePath } from "./paths.js";
import { animate, MOST_PERCENT, type Move } from "./player.js";
import { add } from "./views.js";

export function animateTurbine(turbine: Turbine): void {
  const height = turbine.height_m[turbine.height_m.length - 1]! - turbine.height_m[0]!;
  const margin = (height * MOST_PERCENT) / 100;
  animate<WhirlMode>({
    id: "whirl",
    of: " of the turbine",
    words: "Tower, nacelle and rotating rotor, undeformed and deflected in the mode.",
    modes: turbine.modes,
    level: turbine.height_m[0]! + 0.5 * height,
    // The whole rotor and the largest amplitude; the base stays where it is.
    extent: (eye, view, [first]) => {
      const atRest = new Moment(turbine, first!, 0, 0);
      const rotor = [...turbine.nacelle_m, ...atRest.ring].map((middle) => ({ height: 0, middle, turn: [0, 0, 0] as Point, radius: 0 }));
      const { low, high } = union(extentOf(eye, atRest.tower.map((section) => ({ ...section, radius: 0 })), []), extentOf(eye, rotor, []));
      const below = view === "top" ? margin : 0;
      return { low: [low[0] - margin, low[1] - below], high: [high[0] + margin, high[1] + margin] };
    },
    paint: (field, mode, _, eye) => paint(field, turbine, mode, eye, height),
  });
}

function paint(field: Element, turbine: Turbine, mode: WhirlMode, eye: Eye, height: number): Move {
  const azimuths = Array.from({ length: turbine.blades }, (_, k) => (TURN * k) / turbine.blades);
  const path = (of: string): Element => add(field, "path", { class: of });
  path("undeformed").setAttribute("d", towerPath(eye, new Moment(turbine, mode, 0, 0).tower));
  const rest = azimuths.map(() => path("undeformed"));
  const rotor = (): [Element, Element[], Element] =>
    [path("ring"), azimuths.map(() => path("blade")), add(field, "circle", { class: "first-tip", r: 2.5 })];
  const isBehind = eye.near(turbine.apex_m) < eye.near([0, 0, turbine.apex_m[2]]);
  const behind = isBehind ? rotor() : null;
  const [nacelle, tower] = [path("body rna"), path("deformed")];
  const [ring, blades, tip] = behind ?? rotor();
  return (phase, percent) => {
    const now = new Moment(turbine, mode, phase, (height * percent) / 100);
    const atRest = new Moment(turbine, mode, phase, 0);
    azimuths.forEach((azimuth, i) => {
      rest[i]!.setAttribute("d", linePath(eye, atRest.blade(now.turned + azimuth).map(({ middle }) => middle)));
      blades[i]!.setAttribute("d", tubePath(eye, now.blade(now.turned + azimuth)));
    });
    ring.setAttribute("d", linePath(eye, now.ring));
    const [x, y] = eye.place(now.tip);
    tip.setAttribute("cx", x.toFixed(1));
    tip.setAttribute("cy", y.toFixed(1));
    nacelle.setAttribute("d", solidPath(eye, now.nacelle));
    tower.setAttribute("d", towerPath(eye, now.tower));
  };
}
