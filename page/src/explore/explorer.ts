// The page as a whole: what the user sets goes to the program, what it answers is shown.

import { byId, setHidden, setText } from "./dom.js";
import { listenToKeys } from "./keys.js";
import { recallPage, rememberPage, type Memory } from "./memory.js";
import { Follower } from "./modes/follow.js";
import type { Moving } from "./modes/player.js";
import { notice, say, withdraw } from "./notices.js";
import { fromAddress, toAddress } from "./numbers/address.js";
import { tidy } from "./numbers/entry.js";
import { History, isSame } from "./numbers/history.js";
import { ComparePanel } from "./panels/compare.js";
import { Findings } from "./panels/findings.js";
import { MassTable, ModeTable } from "./panels/modes.js";
import { showWithNames } from "./panels/names.js";
import { ParameterPanel } from "./panels/parameters.js";
import { Stage } from "./panels/stage.js";
import { TakeMenu } from "./panels/take.js";
import { elasticities, ProgramEnded, solve, take } from "./program/program.js";
import { SolveQueue, type Result } from "./program/queue.js";
import { Timings } from "./program/timings.js";
import type { Answer, Refusal, Sheet, State } from "./protocol.js";
import { handlesOf, nameOfDrag } from "./handles.js";
import type { Drag } from "../view/scene.js";

/** A state that could be solved. */
interface Solved extends Moving {
  state: State;
}

/** An answer that takes longer does not hold the motion. */
const AWAITED_MS = 50;

export class Explorer {
  readonly timings = new Timings();
  private queue: SolveQueue;
  private history: History;
  private follower: Follower;
  private shown: Solved | null = null;
  private variant: Solved | null = null;
  private refusal: Refusal["refused"] | null = null;
  private chosen: number | null;
  /** The question whose elasticities are shown or on their way. */
  private asked = "";
  private isAsking = false;
  /** When the last state was asked for, by performance.now(). */
  private askedAt = -Infinity;
  private stage: Stage;
  private numbers: ParameterPanel;
  private modes = new ModeTable((id) => this.choose(id));
  private masses = new MassTable();
  private findings = new Findings((name) => this.numbers.reveal(name));
  private comparison: ComparePanel;
  private byName: Map<string, number>;

  constructor(private sheet: Sheet) {
    this.byName = new Map(sheet.parameters.map(({ name }, index) => [name, index]));
    const memory = recallPage(sheet.file);
    this.history = new History(this.fromAddress());
    if (memory.steps) this.history.resume(memory.steps);
    this.follower = new Follower(memory.identities);
    this.chosen = memory.chosen ?? null;
    this.queue = new SolveQueue(solve, {
      done: (state, result, at, since) => this.done(state, result, at, since),
      failed: (error) => this.failed(error),
      idle: () => this.idle(),
    });
    this.numbers = new ParameterPanel(sheet, {
      input: (values) => this.input(values),
      settle: (key) => this.settle(key),
    });
    if (memory.open) this.numbers.unfold(memory.open);
    this.stage = new Stage({
      isAwaited: () => this.queue.pending && performance.now() - this.askedAt < AWAITED_MS,
      drag: (drag) => this.drag(drag),
      flatPicture: async () => (await take(this.history.present, { what: "tower-picture", format: "svg" })).content,
    });
    if (memory.amplitude && memory.speed) this.stage.controls = { amplitude: memory.amplitude, speed: memory.speed };
    this.comparison = new ComparePanel({ swap: () => this.swap(), drop: () => this.drop() });
    this.listen();
    this.numbers.show(this.wanted());
    this.ask(performance.now());
    if (memory.variant) void this.recallVariant(memory.variant);
  }

  private listen(): void {
    byId("undo").addEventListener("click", () => this.undo());
    byId("redo").addEventListener("click", () => this.redo());
    byId("reset").addEventListener("click", () => this.set({ numbers: {} }));
    byId("keep").addEventListener("click", () => this.keep());
    listenToKeys({
      undo: () => this.undo(),
      redo: () => this.redo(),
      choose: (number) => this.chooseNumber(number),
      toggle: () => this.stage.toggle(),
      tap: () => this.stage.tapTop(),
    });
    // A reload, or another page in this tab: what is remembered is all that is left.
    addEventListener("pagehide", () => this.remember());
    addEventListener("hashchange", () => this.set(this.fromAddress()));
    new TakeMenu({
      state: () => this.history.present,
      png: () => this.stage.png(),
      failed: (error) => this.failed(error),
    }, () => (this.shown?.answer.resonance ?? null) !== null);
  }

  // What the user sets.

  private input(values: Record<string, number>): void {
    const at = performance.now();
    this.history.preview(this.changed(values));
    this.ask(at);
  }

  /** The present state with other values; those of the file are not in it. */
  private changed(values: Record<string, number>): State {
    const numbers = { ...this.history.present.numbers };
    for (const [name, value] of Object.entries(values)) {
      const ofFile = this.sheet.parameters[this.byName.get(name) ?? -1]?.value;
      if (value === ofFile) delete numbers[name];
      else numbers[name] = value;
    }
    return { numbers };
  }

  private settle(key: string): void {
    this.history.settle(key, performance.now());
    this.stepDone();
    if (!this.queue.pending) this.askElasticities();
  }

  /** A state that is a step of its own. */
  private set(state: State): void {
    const at = performance.now();
    this.history.preview(state);
    this.history.settle();
    this.stepDone();
    this.ask(at);
  }

  private undo(): void {
    if (this.history.undo()) this.moved("Undone");
  }

  private redo(): void {
    if (this.history.redo()) this.moved("Redone");
  }

  private moved(word: string): void {
    say(word);
    this.stepDone();
    this.ask(performance.now());
  }

  private drag(drag: Drag): void {
    if (drag.phase === "cancel") {
      this.history.cancel();
      this.ask(performance.now());
      return;
    }
    const name = nameOfDrag(this.sheet.parameters, drag);
    if (name !== null && drag.phase !== "start") this.input({ [name]: tidy(Number(drag.value_m.toFixed(3))) });
    if (drag.phase === "end") this.settle("");
  }

  private stepDone(): void {
    const address = toAddress(this.history.present);
    // Without the numbers of before, also when there are none.
    window.history.replaceState(null, "", address === "" ? location.pathname + location.search : `#${address}`);
    this.showTools();
  }

  private fromAddress(): State {
    const { state, problems } = fromAddress(location.hash, this.sheet.parameters);
    if (problems.length > 0) notice("address", problems.join(" "));
    else withdraw("address");
    return state;
  }

  private remember(): void {
    const memory: Memory = {
      steps: this.history.record(),
      variant: this.variant?.state ?? null,
      chosen: this.chosen,
      identities: this.shown?.followed.map(({ id, name, series }) => ({ id, name, series })) ?? [],
      ...this.stage.controls,
      open: this.numbers.open(),
    };
    rememberPage(this.sheet.file, memory);
  }

  // What the program answers.

  private ask(at: number): void {
    this.askedAt = at;
    this.queue.want(this.history.present, at);
  }

  private done(state: State, result: Result, at: number, since: number): void {
    withdraw("program");
    if (result.refused === null) this.accept(state, result);
    else this.refuse(result.refused);
    if (result.refused !== null) return;
    const { solve_ms, answer_ms } = result;
    const drawn = performance.now();
    requestAnimationFrame(() => {
      const now = performance.now();
      this.timings.add({ event_ms: drawn - at, frame_ms: now - at, waited_ms: drawn - since, solve_ms, answer_ms });
      setText(byId("timing"), this.timings.text());
    });
  }

  /** Nothing more is to come: what the last step has done. */
  private idle(): void {
    if (!this.history.isSettled) return;
    this.askElasticities();
    if (this.refusal === null) say(this.readoutText());
  }

  private accept(state: State, answer: Answer): void {
    this.refusal = null;
    this.numbers.refuse([], "");
    const isFirst = this.shown === null;
    this.shown = { state, answer, followed: this.follower.follow(answer.modes, answer.scene) };
    this.chosen ??= this.shown.followed[0]?.id ?? null;
    this.show();
    if (isFirst) this.begin();
    if (this.history.isSettled) void this.stage.refreshFlat().catch((error: unknown) => this.failed(error));
  }

  /** After the first answer: what moves, moves from here on. */
  private begin(): void {
    if (!matchMedia("(prefers-reduced-motion: reduce)").matches) this.stage.play();
  }

  private refuse(refusal: Refusal["refused"]): void {
    this.refusal = refusal;
    this.numbers.refuse(refusal.parameters, sentences(refusal));
    this.numbers.show(this.wanted());
    this.showRefusal();
    this.showTools();
  }

  private failed(error: unknown): void {
    if (error instanceof ProgramEnded) {
      notice("program", "The program does not answer: it has ended. Start it again with “", this.sheet.command,
        "”. The numbers stay in the address of this page after the #: put that part behind the new address.");
    } else notice("program", error instanceof Error ? error.message : String(error));
  }

  // What is shown.

  /** The present values as the user wants them: numbers that follow others are those of the last answer. */
  private wanted(): number[] {
    const { numbers } = this.history.present;
    return this.sheet.parameters.map(({ name, value }, index) => numbers[name] ?? this.shown?.answer.values[index] ?? value);
  }

  private show(): void {
    const { shown, variant, chosen } = this;
    if (shown === null) return;
    const { answer, followed } = shown;
    const others = variant && new Map(variant.followed.map(({ id }, index) => [id, variant.answer.modes[index] ?? never()]));
    this.stage.player.setting.chosen = chosen;
    this.stage.show(shown, variant, handlesOf(this.sheet.parameters, answer.values));
    this.numbers.show(this.wanted());
    this.modes.show(answer.modes, followed, chosen, others);
    this.masses.show(answer.modes, followed);
    this.findings.show(answer, variant?.answer ?? null);
    this.comparison.show(this.sheet.parameters, answer.values, variant?.answer.values ?? null);
    setText(byId("method"), `${answer.method} · ${answer.certificate}`);
    this.showReadout();
    this.showRefusal();
    this.showTools();
  }

  private showReadout(): void {
    const index = this.shown?.followed.findIndex(({ id }) => id === this.chosen) ?? -1;
    const identity = this.shown?.followed[Math.max(0, index)];
    this.stage.readout(this.shown?.answer.modes[Math.max(0, index)], identity?.name ?? "", identity?.series ?? 0);
  }

  /** The mode that is shown, for screen readers. */
  private readoutText(): string {
    const index = Math.max(0, this.shown?.followed.findIndex(({ id }) => id === this.chosen) ?? 0);
    const mode = this.shown?.answer.modes[index];
    return mode ? `${this.shown?.followed[index]?.name ?? mode.label}: ${mode.frequency} Hz${mode.verdict ? `, ${mode.verdict.word}` : ""}` : "";
  }

  private showRefusal(): void {
    const { refusal } = this;
    setHidden(byId("refusal"), refusal === null);
    const text = refusal ? `Refused: ${sentences(refusal)}` : "";
    showWithNames(byId("refusal-text"), text, refusal?.parameters ?? [], (name) => this.numbers.reveal(name));
    setText(byId("readout-state"), refusal ? "last solved tower" : "");
    document.body.classList.toggle("refused", refusal !== null);
  }

  private showTools(): void {
    const { history } = this;
    const enable = (id: string, isOn: boolean): void => {
      const element = byId<HTMLButtonElement>(id);
      if (element.disabled === isOn) element.disabled = !isOn;
    };
    enable("undo", history.canUndo);
    enable("redo", history.canRedo);
    enable("reset", Object.keys(history.present.numbers).length > 0);
    setText(byId("keep"), this.variant === null ? "Keep as A" : "Keep as new A");
  }

  private choose(id: number): void {
    this.chosen = id;
    this.stage.choose(id);
    this.show();
    this.askElasticities();
  }

  private chooseNumber(number: number): void {
    const identity = this.shown?.followed[number - 1];
    if (identity === undefined) return;
    this.choose(identity.id);
    say(this.readoutText());
  }

  // The second tower.

  private keep(): void {
    if (this.shown === null) return;
    this.variant = this.shown;
    say("Kept as A");
    this.show();
  }

  private swap(): void {
    if (this.shown === null || this.variant === null) return;
    const { state } = this.variant;
    this.variant = this.shown;
    this.set(state);
  }

  private drop(): void {
    this.variant = null;
    this.show();
    byId("keep").focus();
  }

  /** A from before a reload. */
  private async recallVariant(state: State): Promise<void> {
    try {
      const answer = await solve(state);
      if (answer.refused !== null) return;
      // The present tower says which mode is which.
      while (this.shown === null && this.queue.pending) await new Promise(requestAnimationFrame);
      this.variant = { state, answer, followed: this.follower.copy().follow(answer.modes, answer.scene) };
      this.show();
      } catch (error) {
      this.failed(error);
    }
  }

  // What moves the mode that is shown.

  private askElasticities(): void {
    const number = 1 + (this.shown?.followed.findIndex(({ id }) => id === this.chosen) ?? -1);
    if (this.shown === null || this.isAsking || !this.history.isSettled || this.refusal !== null) return;
    const question = JSON.stringify([this.shown.state, Math.max(1, number)]);
    if (question === this.asked) return;
    this.asked = question;
    this.isAsking = true;
    void this.fetchElasticities(this.shown, Math.max(1, number)).finally(() => {
      this.isAsking = false;
      if (!this.queue.pending) this.askElasticities();
    });
  }

  private async fetchElasticities(of: Solved, number: number): Promise<void> {
    try {
      const result = await elasticities(of.state, number);
      if (result.refused !== null) return;
      const isFirst = byId("elasticity-text").textContent === "";
      setText(byId("elasticity-text"), `Elasticity of ${result.mode}, % per %`);
      this.numbers.showElasticities(result.elasticities);
      const group = this.numbers.mostInfluential();
      if (isFirst && group !== null && this.numbers.open().length === 0) this.numbers.unfold([group]);
    } catch (error) {
      this.failed(error);
    }
  }

  /** What tests may read. */
  forTests(): Window["towermodes"] {
    const explorer = this;
    return {
      get state() { return explorer.history.present; },
      get answer() { return explorer.shown?.answer ?? null; },
      get timings() { return explorer.timings.all(); },
      get pending() { return explorer.queue.pending || explorer.isAsking; },
      get isCurrent() { return explorer.shown !== null && isSame(explorer.shown.state, explorer.history.present); },
    };
  }
}

/** Message and hint of the program as sentences. Names of numbers stay as they are. */
function sentences({ message, hint }: Refusal["refused"]): string {
  const ended = (text: string): string => (/[.?!]$/.test(text) ? text : `${text}.`);
  if (hint === null) return ended(message);
  return `${ended(message)} ${ended(hint.replace(/^[a-z]+(?=[ ,])/, (word) => word.charAt(0).toUpperCase() + word.slice(1)))}`;
}

function never(): never {
  throw new Error("a mode without an answer");
}
