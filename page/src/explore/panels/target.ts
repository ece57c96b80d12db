// A frequency that the user asks for: the numbers that are marked move to a light tower with it.

import { byId, setHidden, setText } from "../dom.js";
import { readNumber } from "../numbers/entry.js";
import { target } from "../program/program.js";
import type { Found, Mode, Refusal, Resonance, State, TargetVariable } from "../protocol.js";
import { sentences } from "./status.js";

export interface TargetSource {
  state(): State;
  mode(): Mode | null;
  resonance(): Resonance | null;
  /** The numbers and columns that are marked. */
  variables(): TargetVariable[];
  /** Why they cannot be changed together. */
  conflict(): string | null;
  /** A sentence of the program in the words of the page. */
  inWords(text: string): string;
  /** Whether the marks are shown beside the sliders. */
  mark(isOn: boolean): void;
  found(state: State): void;
  failed(error: unknown): void;
}

/** More than the required margin: a frequency at the end of the band is no borderline case. */
const MORE = 0.01;

/** The band between 1P and the blade passing frequency with a little more than the margin to both,
 * Hz; null if there is none. */
export function windowHz(resonance: Resonance | null): [number, number] | null {
  if (resonance === null || resonance.operation_rpm === null || resonance.blades < 2) return null;
  const [low_rpm, high_rpm] = resonance.operation_rpm;
  const margin = resonance.margin + MORE;
  const low = high_rpm / 60 / (1 - margin);
  const high = (resonance.blades * low_rpm) / 60 / (1 + margin);
  return low < high ? [low, high] : null;
}

export class TargetPanel {
  private details = byId<HTMLDetailsElement>("target");
  private low = byId<HTMLInputElement>("target-low");
  private high = byId<HTMLInputElement>("target-high");
  private stop: AbortController | null = null;

  constructor(private source: TargetSource) {
    this.details.addEventListener("toggle", () => this.toggled());
    byId("target-find").addEventListener("click", () => void this.find());
    byId("target-cancel").addEventListener("click", () => this.stop?.abort());
  }

  /** The mode that is searched is the one that is chosen. */
  showMode(): void {
    const mode = this.source.mode();
    setText(byId("target-mode"), mode?.label ?? "");
  }

  private toggled(): void {
    this.source.mark(this.details.open);
    if (!this.details.open || this.low.value + this.high.value !== "") return;
    const window = windowHz(this.source.resonance());
    if (window === null) return;
    [this.low, this.high].forEach((field, end) => (field.value = String(Number(window[end]!.toPrecision(4)))));
  }

  private limit(field: HTMLInputElement): number | null | undefined {
    if (field.value.trim() === "") return null;
    const entry = readNumber(field.value, "Hz");
    if ("value" in entry) return entry.value;
    setText(byId("target-text"), entry.problem);
    field.focus();
    return undefined;
  }

  private async find(): Promise<void> {
    const { source } = this;
    const mode = source.mode();
    const [min_hz, max_hz] = [this.limit(this.low), this.limit(this.high)];
    if (mode === null) setText(byId("target-text"), "Choose a mode of the tower: the rotor is not changed.");
    if (mode === null || min_hz === undefined || max_hz === undefined || this.stop !== null) return;
    const variables = source.variables();
    if (variables.length === 0) {
      setText(byId("target-text"), "Mark the input values that may change: the boxes are beside their names.");
      return;
    }
    const conflict = source.conflict();
    if (conflict !== null) {
      setText(byId("target-text"), conflict);
      return;
    }
    const question = { ...source.state(), mode: `${mode.family} ${mode.order}`, min_hz, max_hz, variables };
    this.begin();
    try {
      const stop = this.stop as AbortController | null;
      this.show(await target(question, stop?.signal ?? new AbortController().signal));
    } catch (error) {
      if ((this.stop as AbortController | null)?.signal.aborted) setText(byId("target-text"), "Cancelled: nothing is changed.");
      else source.failed(error);
    } finally {
      this.end();
    }
  }

  private begin(): void {
    this.stop = new AbortController();
    setText(byId("target-text"), "Searching\u2026");
    setHidden(byId("target-cancel"), false);
    byId<HTMLButtonElement>("target-find").disabled = true;
  }

  private end(): void {
    this.stop = null;
    setHidden(byId("target-cancel"), true);
    byId<HTMLButtonElement>("target-find").disabled = false;
  }

  private show(result: Found | Refusal): void {
    if (result.refused !== null) {
      const text = this.source.inWords(sentences(result.refused));
      setText(byId("target-text"), text.replace(/^./, (letter) => letter.toUpperCase()));
      return;
    }
    setText(byId("target-text"), `${result.sentences.join("; ")}; ${result.solves} towers solved. Undo restores the original tower.`);
    this.source.found({ numbers: result.numbers });
  }
}
