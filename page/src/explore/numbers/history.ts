// The numbers that the user has set, with undo and redo. A whole slide is one step.

import type { State } from "../protocol.js";

/** Steps that can be undone. */
const MOST_STEPS = 200;
/** Changes of the same number within this time are one step: a key that is held down, ms. */
const ONE_STEP_MS = 700;

export interface Steps {
  past: State[];
  present: State;
  future: State[];
}

export class History {
  private past: State[] = [];
  private future: State[] = [];
  /** The state at the end of the last step; `present` differs from it during a slide. */
  private settled: State;
  private last = { key: "", at: -Infinity };
  present: State;

  constructor(present: State) {
    this.present = present;
    this.settled = present;
  }

  get canUndo(): boolean {
    return this.past.length > 0 || !this.isSettled;
  }

  /** Whether no slide is on its way. */
  get isSettled(): boolean {
    return isSame(this.present, this.settled);
  }

  get canRedo(): boolean {
    return this.future.length > 0;
  }

  /** Shows a state that is not yet a step. */
  preview(state: State): void {
    this.present = state;
  }

  /** Back to the end of the last step. */
  cancel(): void {
    this.present = this.settled;
  }

  /** Makes the present state a step. Steps with the same key in quick succession are one. */
  settle(key = "", now = 0): void {
    if (isSame(this.present, this.settled)) return;
    const goesOn = key !== "" && key === this.last.key && now - this.last.at < ONE_STEP_MS && this.past.length > 0;
    if (!goesOn) this.past.push(this.settled);
    if (this.past.length > MOST_STEPS) this.past.shift();
    this.future = [];
    this.settled = this.present;
    this.last = { key, at: now };
  }

  /** The step before; false if there is none. */
  undo(): boolean {
    this.settle();
    return this.move(this.past, this.future);
  }

  redo(): boolean {
    this.settle();
    return this.move(this.future, this.past);
  }

  private move(from: State[], to: State[]): boolean {
    const state = from.pop();
    if (state === undefined) return false;
    to.push(this.settled);
    this.present = state;
    this.settled = state;
    this.last = { key: "", at: -Infinity };
    return true;
  }

  /** For a memory that survives a reload. */
  record(): Steps {
    return { past: this.past, present: this.settled, future: this.future };
  }

  /** Continues with the steps of a record if it ends in the present state. */
  resume(record: Steps): void {
    if (!isSame(record.present, this.settled)) return;
    this.past = record.past;
    this.future = record.future;
  }
}

export function isSame(a: State, b: State): boolean {
  const names = Object.keys(a.numbers);
  return names.length === Object.keys(b.numbers).length && names.every((name) => a.numbers[name] === b.numbers[name]);
}
