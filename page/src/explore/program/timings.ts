// How long it takes from an event to the picture, measured by the page itself.

export interface Timing {
  /** From the event to the end of the task that has drawn the result, ms. */
  event_ms: number;
  /** From the event to the next frame of the screen. */
  frame_ms: number;
  /** The same from the first event that this result answers; later events replaced its state. */
  waited_ms: number;
  /** Of that in the program: the solve, and the whole answer. */
  solve_ms: number;
  answer_ms: number;
}

const MOST = 10_000;

export class Timings {
  readonly all: Timing[] = [];

  add(timing: Timing): void {
    if (this.all.length >= MOST) this.all.shift();
    this.all.push(timing);
  }

  /** "solve 1.2 ms, event to picture 7 ms" of the last answer. */
  text(): string {
    const last = this.all.at(-1);
    return last ? `solve ${last.solve_ms.toFixed(1)} ms · event to picture ${last.event_ms.toFixed(0)} ms` : "";
  }
}
