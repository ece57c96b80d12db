// Questions of one kind whose answers take longer than a frame: a newer one ends the one before.

export interface LatestListener<Question, Answer> {
  done(answer: Answer, question: Question): void;
  failed(error: unknown): void;
}

export class Latest<Question, Answer> {
  private running: { key: string; stop: AbortController } | null = null;
  private answered = "";
  private timer: ReturnType<typeof setTimeout> | undefined;
  /** What comes after the one that runs. */
  private next: Question | null = null;

  /**
   * Waits so long for a newer question before it asks, ms; none waits, but lets the one that runs
   * end before it asks the newest: then answers come while someone slides.
   */
  constructor(
    private ask: (question: Question, signal: AbortSignal) => Promise<Answer>,
    private listener: LatestListener<Question, Answer>,
    private patience_ms: number | null = 0,
  ) {}

  /** Whether an answer is still to come. */
  get pending(): boolean {
    return this.running !== null;
  }

  /** Asks, unless that is what was asked last. */
  want(question: Question): void {
    const key = JSON.stringify(question);
    this.next = null;
    if (key === (this.running?.key ?? this.answered)) return;
    if (this.patience_ms === null && this.running !== null) {
      this.next = question;
      return;
    }
    this.cancel();
    const stop = new AbortController();
    this.running = { key, stop };
    if (this.patience_ms === null) void this.run(question, key, stop);
    else this.timer = setTimeout(() => void this.run(question, key, stop), this.patience_ms);
  }

  /** Wants no answer any more; the one that was given stays. */
  cancel(): void {
    clearTimeout(this.timer);
    this.running?.stop.abort();
    this.running = null;
    this.next = null;
  }

  private async run(question: Question, key: string, stop: AbortController): Promise<void> {
    try {
      const answer = await this.ask(question, stop.signal);
      if (stop.signal.aborted) return;
      this.running = null;
      this.answered = key;
      this.listener.done(answer, question);
    } catch (error) {
      if (stop.signal.aborted) return;
      this.running = null;
      this.listener.failed(error);
    }
    const { next } = this;
    this.next = null;
    if (next !== null && this.running === null) this.want(next);
  }
}
