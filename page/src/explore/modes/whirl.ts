// A turbine in a mode with its rotor turning, as the scene and the pose of a tower: its blades are
// members of a frame that go around.

import { Moment, TURN, type Turbine, type WhirlMode } from "../../view/turbine.js";
import type { Body, Frame, Point, Pose, TowerScene } from "../../view/scene.js";

/** The turbine at rest, with what surrounds the tower; nacelle and rotor are its own. */
export function sceneOf(turbine: Turbine, tower: TowerScene): TowerScene {
  const { height_m, radius_m, nacelle_m, apex_m } = turbine;
  const top = height_m.at(-1) ?? 0;
  const machine: Body[] = [
    { follows_m: top, of: "rna", form: "solid", points: nacelle_m },
    { follows_m: top, of: "rna", form: "ball", points: [apex_m], radius_m: 2 * Math.max(...turbine.half_width_m.slice(0, 2)) },
  ];
  return {
    height_m, radius_m, is_nominal: tower.is_nominal, modes: [],
    bodies: [...tower.bodies.filter((body) => body.of !== "rna" && body.of !== "rotor"), ...machine],
    frame: withBlades(turbine, tower.frame),
  };
}

/** A mode at rest: for the places of the undeformed turbine. */
const STILL: WhirlMode = { number: 0, label: "", frequency_hz: 0, tower: [], nacelle: [], harmonics: [] };

const azimuths = ({ blades }: Turbine): number[] => Array.from({ length: blades }, (_, k) => (TURN * k) / blades);

/** The sections of all blades, one after the other, each blade after the apex. */
function bladePoints(turbine: Turbine, moment: Moment, turned: number, apex: Point): Point[] {
  return azimuths(turbine).flatMap((azimuth) => [apex, ...moment.blade(azimuth + turned).map(({ middle }) => middle)]);
}

function withBlades(turbine: Turbine, frame: Frame | undefined): Frame {
  const atRest = bladePoints(turbine, new Moment(turbine, STILL, 0, 0), 0, turbine.apex_m);
  const first = frame?.joints.length ?? 0;
  const { half_width_m } = turbine;
  const count = half_width_m.length + 1;
  const members = azimuths(turbine).flatMap((_, blade) => half_width_m.map((radius, k) => {
    const from = first + blade * count + k;
    return { joints: [from, from + 1] as [number, number], radius_m: [half_width_m[Math.max(0, k - 1)] ?? radius, radius] as [number, number] };
  }));
  return { joints: [...(frame?.joints ?? []), ...atRest], members: [...(frame?.members ?? []), ...members] };
}

/** The turbine in a mode at a phase (rad), with the largest deflection `scale`, m. */
export function poseOf(turbine: Turbine, mode: WhirlMode, scene: TowerScene, phase: number, scale: number): Pose {
  const moment = new Moment(turbine, mode, phase, scale);
  const heights = scene.height_m;
  const displacement = moment.tower.map(({ middle: [x, y, z] }, k): Point => [x, y, z - (heights[k] ?? 0)]);
  const rotation = heights.map((): Point => [0, 0, 0]);
  rotation[heights.length - 1] = moment.nacelleTurn;
  return { displacement, rotation, frame: frameMotion(turbine, moment, scene) };
}

/** The translations of the joints and of three points of each member; what stands below does not
 * move. */
function frameMotion(turbine: Turbine, moment: Moment, { frame }: TowerScene): number[] {
  if (frame === undefined) return [];
  const now = bladePoints(turbine, moment, moment.turned, moment.apex);
  const first = frame.joints.length - now.length;
  const moved = frame.joints.map((rest, index): Point => {
    const [x, y, z] = now[index - first] ?? rest;
    return [x - rest[0], y - rest[1], z - rest[2]];
  });
  const between = frame.members.flatMap(({ joints: [a, b] }) => [0.25, 0.5, 0.75].flatMap((s) =>
    [0, 1, 2].map((axis) => (1 - s) * moved[a]![axis]! + s * moved[b]![axis]!)));
  return [...moved.flat(), ...between];
}
