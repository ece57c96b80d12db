// Moves the tower in time: one mode that oscillates, or all of them after a release from the push
// of a tap.

import type { Answer, Mode } from "../protocol.js";
import type { Pose, Tap, TowerScene } from "../../view/scene.js";
import type { Followed } from "./follow.js";
import { heightOf, largest, scaleOf, staticParts, superposed } from "./motion.js";
import { poseOf } from "./whirl.js";
import type { Turbine, WhirlMode } from "../../view/turbine.js";

/** A solved tower with the identities of its modes. */
export interface Moving {
  answer: Answer;
  followed: Followed[];
}

/** A turbine in one of its modes, in place of the tower. */
export interface Turning {
  turbine: Turbine;
  scene: TowerScene;
  mode: WhirlMode;
}

/** What the user has set. */
export interface Setting {
  /** The identity of the mode that is shown. */
  chosen: number | null;
  /** The largest deflection as a fraction of the height. */
  amplitude: number;
  /** The frequency on the screen of the mode that is shown, or of the lowest that a tap has
   * excited, Hz. */
  screen_hz: number;
  /** The tap that has released the tower; null shows one mode. */
  tap: Tap | null;
  /** The turbine that is shown; null shows the tower. */
  turning: Turning | null;
}

/** A mode with less than this part of the largest is not excited. */
const EXCITED = 1e-3;
/** Longer pauses between two pictures do not advance the motion by more, s. */
const LONGEST_STEP_S = 0.1;

export class Player {
  setting: Setting = { chosen: null, amplitude: 0.05, screen_hz: 0.5, tap: null, turning: null };
  /** Of the turbine; it goes on beyond a turn, so that the rotor turns steadily. */
  private whirled = 0;
  private phases = new Map<number, number>();
  private phasesOfA = new Map<number, number>();
  private present: Moving | null = null;
  private other: Moving | null = null;
  private parts: number[] = [];
  private partsOfA: number[] = [];
  private pose: Pose | null = null;
  private poseOfA: Pose | null = null;
  private last: number | null = null;

  /** While `isHeld`, another picture is about to come, and frames are not drawn for the motion
   * alone. */
  constructor(
    private draw: (pose: Pose | null, beside: Pose | null) => void,
    private isHeld: () => boolean = () => false,
  ) {}

  get isPlaying(): boolean {
    return this.last !== null;
  }

  /** Goes on with other towers; phases stay. */
  show(present: Moving, other: Moving | null): void {
    this.present = present;
    this.other = other;
    this.refresh();
  }

  /** Takes up a changed setting. */
  refresh(): void {
    this.parts = this.factors(this.present);
    this.partsOfA = this.factors(this.other);
    if (!this.isPlaying) this.paint();
  }

  /** Begins again at the largest deflection. */
  restart(): void {
    this.phases.clear();
    this.phasesOfA.clear();
    this.refresh();
  }

  play(): void {
    if (this.isPlaying) return;
    this.last = performance.now();
    requestAnimationFrame((now) => this.frame(now));
  }

  pause(): void {
    this.last = null;
  }

  /** Draws where the motion is now. */
  paint(): void {
    const { turning } = this.setting;
    if (turning !== null) {
      const { turbine, mode, scene } = turning;
      this.draw(poseOf(turbine, mode, scene, this.whirled, this.setting.amplitude * heightOf(scene)), null);
      return;
    }
    this.pose = this.poseOf(this.present, this.parts, this.phases, this.pose);
    this.poseOfA = this.poseOf(this.other, this.partsOfA, this.phasesOfA, this.poseOfA);
    this.draw(this.pose, this.poseOfA);
  }

  /** How long a period takes on the screen, of a turbine a turn of its rotor if that is longer, s. */
  period_s(): number {
    const period = 1 / this.setting.screen_hz;
    const rpm = this.setting.turning?.turbine.rotor_speed_rpm ?? 0;
    return rpm > 0 ? Math.max(period, 60 / rpm / this.timeFactor()) : period;
  }

  /** Draws so many seconds after the largest deflection. */
  paintAt(seconds: number): void {
    this.phases.clear();
    this.phasesOfA.clear();
    this.whirled = 0;
    this.advance(seconds * this.timeFactor());
    this.paint();
  }

  private frame(now: number): void {
    if (this.last === null) return;
    const step_s = Math.min(LONGEST_STEP_S, Math.max(0, (now - this.last) / 1000));
    this.last = now;
    this.advance(step_s * this.timeFactor());
    if (!this.isHeld()) this.paint();
    requestAnimationFrame((next) => this.frame(next));
  }

  private advance(time_s: number): void {
    this.whirled += 2 * Math.PI * (this.setting.turning?.mode.frequency_hz ?? 0) * time_s;
    step(this.phases, this.present, time_s);
    if (this.setting.tap !== null) step(this.phasesOfA, this.other, time_s);
    else this.phasesOfA = this.phases;
  }

  /** How many times faster than real the motion is; below 1 it is slower. */
  timeFactor(): number {
    const frequency_hz = this.reference()?.frequency_hz ?? 0;
    return frequency_hz > 0 ? this.setting.screen_hz / frequency_hz : 1;
  }

  /** The mode whose frequency on the screen is set. */
  private reference(): Pick<Mode, "frequency_hz"> | undefined {
    const { present, setting, parts } = this;
    if (setting.turning !== null) return setting.turning.mode;
    if (setting.tap === null) return present?.answer.modes[indexOf(present.followed, setting.chosen)];
    const most = Math.max(...parts.map(Math.abs));
    return present?.answer.modes.find(({ frequency_hz }, index) => frequency_hz > 0 && Math.abs(parts[index] ?? 0) > EXCITED * most);
  }

  /** The factor of each shape at the largest deflection. */
  private factors(of: Moving | null): number[] {
    if (of === null) return [];
    const { answer: { scene, modes }, followed } = of;
    const { tap, chosen, amplitude } = this.setting;
    if (tap === null) {
      const index = indexOf(followed, chosen);
      const sign = followed[index]?.sign ?? 1;
      return scene.modes.map((shape, at) => (at === index ? sign * scaleOf(scene, shape, amplitude) : 0));
    }
    const parts = staticParts(scene, modes, tap.height_m, tap.direction);
    const deflection = largest(superposed(scene, parts, null));
    const scale = deflection > 0 ? (amplitude * heightOf(scene)) / deflection : 0;
    return parts.map((part) => part * scale);
  }

  private poseOf(of: Moving | null, parts: number[], phases: Map<number, number>, into: Pose | null): Pose | null {
    if (of === null) return null;
    const now = parts.map((part, index) => part * Math.cos(phases.get(of.followed[index]?.id ?? -1) ?? 0));
    return superposed(of.answer.scene, now, into);
  }
}

/** Lets every mode go on by a time. Modes that have left keep their phase no longer. */
function step(phases: Map<number, number>, of: Moving | null, time_s: number): void {
  const ids = of?.followed.map(({ id }) => id) ?? [];
  for (const id of phases.keys()) if (!ids.includes(id)) phases.delete(id);
  ids.forEach((id, index) => {
    const turn = 2 * Math.PI * (of?.answer.modes[index]?.frequency_hz ?? 0) * time_s;
    phases.set(id, ((phases.get(id) ?? 0) + turn) % (2 * Math.PI));
  });
}

/** The index of an identity; of one that has left the list, the first. */
function indexOf(followed: Followed[], id: number | null): number {
  return Math.max(0, followed.findIndex((one) => one.id === id));
}
