// The elasticities of the mode that is shown: asked for when nothing else is to be answered.

import { byId, setText } from "./dom.js";
import type { ParameterPanel } from "./panels/parameters.js";
import { elasticities } from "./program/program.js";
import type { Elasticities, State } from "./protocol.js";

/** After this time only numbers in open groups are asked for, ms in the program. */
const PATIENCE_MS = 1500;

/** A mode of a tower. */
export interface Subject {
  state: State;
  /** Its number in the list of the answer to the state, from 1. */
  number: number;
  label: string;
  /** Whether it stands for the mode of a turbine with the same motion. */
  isOfRigidRotor: boolean;
}

/** Shows the influence of each number on a mode, beside its slider. */
export class Influence {
  /** The question whose answers are shown or on their way. */
  private asked = "";
  private label = "";
  /** The tower of the last answer that is shown; null if none is. */
  state: State | null = null;
  private running: AbortController | null = null;
  /** Numbers and columns that have been answered. */
  private known = new Set<string>();
  private spent_ms = 0;
  private isFirst = true;

  constructor(private panel: ParameterPanel, private changed: () => void, private failed: (error: unknown) => void) {}

  get pending(): boolean {
    return this.running !== null;
  }

  /** Asks for what is not yet known of a mode. */
  ask(subject: Subject): void {
    const question = JSON.stringify([subject.state, subject.number, subject.label]);
    if (question !== this.asked) this.begin(question, subject);
    if (this.running === null && this.left().length > 0) void this.run(subject);
  }

  /** Something else has been asked: what is known stays. */
  cancel(): void {
    this.running?.abort();
    this.running = null;
  }

  /** Shows that there are none, and why. */
  none(reason: string): void {
    this.cancel();
    this.asked = "";
    this.label = "";
    this.state = null;
    this.panel.clearElasticities();
    setText(byId("elasticity-text"), reason);
  }

  private begin(question: string, { label, isOfRigidRotor }: Subject): void {
    this.cancel();
    this.asked = question;
    this.known.clear();
    this.spent_ms = 0;
    if (label !== this.label) this.panel.clearElasticities();
    this.label = label;
    const model = isOfRigidRotor ? " of the tower with a rigid rotor" : "";
    setText(byId("elasticity-text"), `Elasticity of ${label}${model}, % per %`);
  }

  /** What is still to be asked, open groups first. */
  private left(): string[] {
    const { shown, hidden } = this.panel.names();
    const names = this.spent_ms < PATIENCE_MS ? [...shown, ...hidden] : shown;
    return names.filter((name) => !this.known.has(name));
  }

  private async run({ state, number, label }: Subject): Promise<void> {
    const stop = new AbortController();
    this.running = stop;
    try {
      for (let names = this.left(); names.length > 0; names = this.left()) {
        const result = await elasticities({ ...state, mode: number, label, names }, stop.signal);
        if (stop.signal.aborted) return;
        this.take(names, result.refused === null ? result : null);
        this.state = state;
        this.changed();
      }
    } catch (error) {
      if (stop.signal.aborted) return;
      // It is not asked again until another mode or tower is shown.
      this.take(this.left(), null);
      this.failed(error);
    }
    this.running = null;
    this.unfold();
  }

  /** Nothing is known of what is refused. */
  private take(names: string[], result: Elasticities | null): void {
    const left = new Set(result?.left ?? []);
    for (const name of names) if (!left.has(name)) this.known.add(name);
    if (result === null) return;
    this.spent_ms += result.answer_ms;
    this.panel.addElasticities(result);
  }

  /** Opens the group with the largest elasticity, once, if none is open. */
  private unfold(): void {
    const group = this.panel.mostInfluential();
    if (this.isFirst && group !== null && this.panel.open().length === 0) this.panel.unfold([group]);
    this.isFirst = false;
  }
}
