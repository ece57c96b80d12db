// The whole turbine of a page: its diagram, and its modes at a rotor speed, both newest first.

import { lastRpm } from "./diagram/content.js";
import type { Turning as Motion } from "./modes/player.js";
import { sceneOf } from "./modes/whirl.js";
import { TurbinePanel } from "./panels/turbine.js";
import { sentences } from "./panels/status.js";
import { coupled, whirl } from "./program/program.js";
import { Latest } from "./program/latest.js";
import type { Answer, Coupled, Refusal, Resonance, State, Whirl, WhirlMode, WhirlQuestion } from "./protocol.js";
import type { TowerScene } from "../view/scene.js";

export interface TurningEvents {
  /** Something has arrived, or another mode is chosen. */
  changed(): void;
  /** The modes at a rotor speed are awaited. */
  waits(): void;
  failed(error: unknown): void;
}

/** The diagram waits until nobody slides, ms. */
const PATIENCE_MS = 60;

/** The mode that is shown first: the first fore-aft mode of the tower, below which a floating platform
 * has six; without it the lowest. */
const firstOf = (modes: WhirlMode[]): string | null =>
  (modes.find(({ name }) => name === "1st tower fore-aft") ?? modes[0])?.name ?? null;

export class Turning {
  diagram: Coupled | null = null;
  /** Of the tower that is compared with. */
  diagramOfOther: Coupled | null = null;
  /** The chosen mode, by its name; null if the tower alone is shown. */
  chosen: string | null = null;
  /** Why there is no diagram. */
  refusal = "";
  private whirl: Whirl | null = null;
  private state: State | null = null;
  private panel: TurbinePanel;
  private isReady = false;
  /** Whether the first answer has chosen a mode. */
  private hasChosen = false;
  private diagrams: Latest<State, Coupled | Refusal>;
  private diagramsOfOther: Latest<State, Coupled | Refusal>;
  private whirls: Latest<WhirlQuestion, Whirl | Refusal>;

  constructor(private events: TurningEvents) {
    this.panel = new TurbinePanel({ speed: () => this.askWhirl(), choose: (name) => this.choose(name) });
    const failed = (error: unknown): void => events.failed(error);
    this.diagrams = new Latest(coupled, { done: (result) => this.drawn(result), failed }, PATIENCE_MS);
    this.diagramsOfOther = new Latest(coupled, { done: (result) => this.drawnOfOther(result), failed }, PATIENCE_MS);
    this.whirls = new Latest(whirl, { done: (result) => this.moved(result), failed }, null);
  }

  /** The rotor speed of the slider, rpm. */
  get rpm(): number {
    return this.panel.rpm;
  }

  /** Whether the diagram is that of another state. */
  get pending(): boolean {
    return this.diagrams.pending || this.whirls.pending;
  }

  /** Whether the modes are those of another state or rotor speed. */
  get isWhirling(): boolean {
    return this.whirls.pending;
  }

  get isDrawing(): boolean {
    return this.diagrams.pending;
  }

  /** Whether verdicts are those of the turbine, now or when it is solved; if it cannot be solved,
   * they are computed for the tower with a rigid rotor. */
  get governs(): boolean {
    return this.refusal === "" || this.isDrawing;
  }

  /** Asks for the turbine of a solved state. */
  ask(state: State, answer: Answer): void {
    this.state = state;
    if (!this.isReady && answer.resonance?.operation_rpm) this.ready(answer.resonance);
    this.diagrams.want(state);
    this.askWhirl();
  }

  askOther(state: State | null): void {
    if (state !== null) this.diagramsOfOther.want(state);
    else {
      this.diagramsOfOther.cancel();
      this.diagramOfOther = null;
    }
  }

  /** The first diagram says how far the slider goes. */
  private ready(resonance: Resonance): void {
    const last = lastRpm(resonance);
    const first = resonance.operation_rpm?.[1] ?? Number((0.5 * last).toPrecision(2));
    this.panel.range(last, this.isReady ? null : first);
    this.isReady = true;
  }

  private askWhirl(): void {
    if (this.state === null || !this.isReady) return;
    this.whirls.want({ ...this.state, rpm: this.panel.rpm });
    this.events.waits();
  }

  private drawn(result: Coupled | Refusal): void {
    this.refusal = result.refused === null ? "" : sentences(result.refused);
    this.diagram = result.refused === null ? result : null;
    if (!this.isReady && result.refused === null) {
      this.ready(result.resonance);
      this.askWhirl();
    }
    this.events.changed();
  }

  private drawnOfOther(result: Coupled | Refusal): void {
    this.diagramOfOther = result.refused === null ? result : null;
    this.events.changed();
  }

  private moved(result: Whirl | Refusal): void {
    this.whirl = result.refused === null ? result : null;
    if (!this.hasChosen && this.whirl !== null) {
      this.hasChosen = true;
      this.chosen ??= firstOf(this.whirl.modes);
    }
    this.events.changed();
  }

  choose(name: string | null): void {
    this.chosen = name;
    this.events.changed();
  }

  /** Chooses by the place in the table; false without such a mode. */
  chooseNumber(number: number): boolean {
    const mode = this.whirl?.modes[number - 1];
    if (mode === undefined) return false;
    this.choose(mode.name);
    return true;
  }

  show(): void {
    this.panel.show(this.whirl, this.diagram?.resonance ?? null, this.chosen);
  }

  /** The chosen mode at the speed of the slider; none if no mode has its name there. */
  get mode(): WhirlMode | null {
    const { whirl, chosen } = this;
    return whirl?.modes.find(({ name }) => name === chosen) ?? null;
  }

  /** The chosen mode in motion; null shows the tower. */
  motion(tower: TowerScene): Motion | null {
    const { whirl, chosen } = this;
    if (whirl === null || chosen === null) return null;
    const index = whirl.modes.findIndex(({ name }) => name === chosen);
    const mode = whirl.scene.modes[index];
    return mode ? { turbine: whirl.scene, scene: sceneOf(whirl.scene, tower), mode } : null;
  }
}
