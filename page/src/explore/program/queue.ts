// Solves one state after the other: one request at a time, of the states that wait only the newest.

import type { Answer, Refusal, State } from "../protocol.js";

/** A state and the events that asked for it, by performance.now(). */
interface Wish {
  state: State;
  /** The last event, whose state this is. */
  at: number;
  /** The first event that no answer has followed. */
  since: number;
}

export type Result = Answer | Refusal;

export interface Listener {
  done(state: State, result: Result, at: number, since: number): void;
  failed(error: unknown): void;
  /** Nothing more is to come. */
  idle(): void;
}

export class SolveQueue {
  private waiting: Wish | null = null;
  private running: Wish | null = null;

  constructor(private ask: (state: State) => Promise<Result>, private listener: Listener) {}

  /** Whether an answer is still to come. */
  get pending(): boolean {
    return this.running !== null || this.waiting !== null;
  }

  /** Asks for a state; it replaces the one that waits. */
  want(state: State, at: number): void {
    this.waiting = { state, at, since: this.waiting?.since ?? at };
    if (this.running === null) void this.run();
  }

  private async run(): Promise<void> {
    for (let wish = this.take(); wish !== null; wish = this.take()) {
      try {
        const result = await this.ask(wish.state);
        this.listener.done(wish.state, result, wish.at, wish.since);
      } catch (error) {
        this.listener.failed(error);
      }
    }
    this.listener.idle();
  }

  private take(): Wish | null {
    this.running = this.waiting;
    this.waiting = null;
    return this.running;
  }
}
