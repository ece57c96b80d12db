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

const KEYS = ["event_ms", "frame_ms", "waited_ms", "solve_ms", "answer_ms"] as const;

/** The last times; the memory for them is there from the beginning. */
export class Timings {
  private count = 0;
  private values: Float64Array;

  constructor(private most = 10_000) {
    this.values = new Float64Array(most * KEYS.length);
  }

  add(timing: Timing): void {
    const at = (this.count++ % this.most) * KEYS.length;
    KEYS.forEach((key, index) => (this.values[at + index] = timing[key]));
  }

  /** All that are kept, the oldest first. */
  all(): Timing[] {
    const first = Math.max(0, this.count - this.most);
    return Array.from({ length: this.count - first }, (_, k) => this.at(first + k));
  }

  private at(place: number): Timing {
    const at = (place % this.most) * KEYS.length;
    return Object.fromEntries(KEYS.map((key, index) => [key, this.values[at + index] ?? NaN])) as unknown as Timing;
  }

  /** "solve 1.2 ms · event to picture 7 ms" of the last answer. */
  text(): string {
    if (this.count === 0) return "";
    const { solve_ms, event_ms } = this.at(this.count - 1);
    return `solve ${solve_ms.toFixed(1)} ms · event to picture ${event_ms.toFixed(0)} ms`;
  }
}
