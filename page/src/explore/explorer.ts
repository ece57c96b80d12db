// The page as a whole: what the user sets goes to the program, what it answers is shown.

import { byId, setText } from "./dom.js";
import { Influence } from "./influence.js";
import { listenToKeys } from "./keys.js";
import { recallPage, rememberPage, type Memory } from "./memory.js";
import { Follower } from "./modes/follow.js";
import type { Moving } from "./modes/player.js";
import { notice, say, withdraw } from "./notices.js";
import { fromAddress } from "./numbers/address.js";
import { AddressBar } from "./numbers/bar.js";
import { withFollowers } from "./numbers/followers.js";
import { History, isSame } from "./numbers/history.js";
import { BandPanel } from "./panels/band.js";
import { ComparePanel } from "./panels/compare.js";
import { Findings } from "./panels/findings.js";
import { MassTable, ModeTable } from "./panels/modes.js";
import { ParameterPanel } from "./panels/parameters.js";
import { ResonancePanel, seriesAt, type Checked } from "./panels/resonance.js";
import { stemOf } from "./panels/save.js";
import { Stage } from "./panels/stage.js";
import { sentences, showFreshness, showRefusal, showTools, spoken } from "./panels/status.js";
import { offerTable } from "./panels/tables.js";
import { TakeMenu } from "./panels/take.js";
import { TargetPanel } from "./panels/target.js";
import { verdictOf } from "./panels/turbine.js";
import { Latest } from "./program/latest.js";
import { band, ProgramEnded, solve, take } from "./program/program.js";
import { SolveQueue, type Result } from "./program/queue.js";
import { Timings } from "./program/timings.js";
import type { Answer, Band, Mode, Refusal, Sheet, State } from "./protocol.js";
import { Turning } from "./turning.js";
import { describeDrag, draggedBy, handlesOf, valuesOf, type Dragged } from "./handles.js";
import type { Drag } from "../view/scene.js";

/** A refusal that names no number is shown at those that changed, if they are not more. */
const MOST_CHANGED = 3;

/** A state that could be solved. */
interface Solved extends Moving {
  state: State;
}

/** While numbers slide, answers follow each other by less, and each draws the motion too. */
const AWAITED_MS = 80;

export class Explorer {
  readonly timings = new Timings();
  private queue: SolveQueue;
  private address = new AddressBar();
  private history: History;
  private follower: Follower;
  private shown: Solved | null = null;
  private variant: Solved | null = null;
  private refusal: Refusal["refused"] | null = null;
  /** Whether the last question for modes has no answer. */
  private isUnanswered = false;
  private chosen: number | null;
  /** The number or the column that the user has moved last. */
  private moved = "";
  private influence: Influence;
  private reveal = (name: string): void => this.numbers.reveal(name);
  /** When the last state was asked for, by performance.now(). */
  private askedAt = -Infinity;
  private stage: Stage;
  /** The numbers under the hand, from the start of a drag to the next one. */
  private dragged: Dragged[] = [];
  private numbers: ParameterPanel;
  private modes = new ModeTable((id) => this.choose(id));
  private masses = new MassTable();
  private findings = new Findings((name) => this.reveal(name));
  private comparison: ComparePanel;
  private resonance: ResonancePanel;
  /** The whole turbine, if the file has one. */
  private turning: Turning | null;
  private bands: Latest<State, Band | Refusal>;
  /** Frequencies in softer and stiffer soil, and their tower. */
  private soil: { state: State; band: Band } | null = null;
  private bandPanel = new BandPanel();
  private target: TargetPanel;
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
      failed: (error) => this.unanswered(error),
      idle: () => this.idle(),
    });
    this.numbers = new ParameterPanel(sheet, {
      input: (values, key) => this.input(values, key),
      settle: (key) => this.settle(key),
      opened: () => this.askElasticities(),
    });
    this.influence = new Influence(this.numbers, () => this.showAge(), (error) => this.failed(error));
    if (memory.open) this.numbers.unfold(memory.open);
    const failed = (error: unknown): void => this.failed(error);
    this.turning = sheet.has_turbine ? new Turning({
      changed: () => {
        this.show();
        this.askLast();
      },
      waits: () => this.showAge(),
      failed: (error) => {
        this.failed(error);
        this.askLast();
      },
    }) : null;
    this.bands = new Latest(band, { done: (result, state) => this.banded(state, result), failed }, 0);
    this.resonance = new ResonancePanel({
      chooseMode: (number) => this.chooseNumber(number),
      chooseWhirl: (name) => this.turning?.choose(name),
    });
    this.target = new TargetPanel({
      state: () => this.history.present,
      mode: () => this.mode,
      resonance: () => this.turning?.diagram?.resonance ?? this.shown?.answer.resonance ?? null,
      variables: () => this.numbers.marked(),
      conflict: () => this.numbers.conflict(),
      inWords: (text) => this.numbers.inWords(text),
      mark: (isOn) => this.numbers.mark(isOn),
      found: (state) => this.set(state),
      failed,
    });
    this.stage = new Stage({
      isAwaited: () => performance.now() - this.askedAt < AWAITED_MS,
      drag: (drag) => this.drag(drag),
      flatPicture: async () => (await take(this.history.present, { what: "tower-picture", format: "svg" })).content,
    });
    if (memory.amplitude && memory.speed) this.stage.controls = { amplitude: memory.amplitude, speed: memory.speed };
    this.comparison = new ComparePanel({ swap: () => this.swap(), drop: () => this.drop() });
    this.listen();
    this.numbers.show(this.wanted());
    this.ask(performance.now());
    const variant = memory.variant ?? (memory.steps || sheet.against === null ? null : { numbers: {}, is_of_other: true });
    if (variant) void this.recallVariant(variant);
  }

  private listen(): void {
    byId("undo").addEventListener("click", () => this.undo());
    byId("redo").addEventListener("click", () => this.redo());
    byId("reset").addEventListener("click", () => this.set({ numbers: {} }));
    byId("keep").addEventListener("click", () => this.keep());
    listenToKeys({
      undo: () => this.undo(),
      redo: () => this.redo(),
      choose: (number) => {
        if (this.turning?.chooseNumber(number) !== true) this.chooseNumber(number);
      },
      toggle: () => this.stage.toggle(),
      tap: () => this.stage.tapTop(),
    });
    // A reload, or another page in this tab: what is remembered is all that is left.
    addEventListener("pagehide", () => {
      this.address.write();
      this.remember();
    });
    addEventListener("hashchange", () => this.set(this.fromAddress()));
    new TakeMenu({
      state: () => this.history.present,
      name: () => `${stemOf(this.sheet.file)}-${stemOf((byId("readout-name").textContent ?? "").replaceAll(".", "-"))}`,
      png: () => this.stage.png(this.sheet.file),
      film: () => this.stage.film(this.sheet.file),
      failed: (error) => this.failed(error),
    }, () => (this.shown?.answer.resonance ?? null) !== null);
    this.offerTables();
  }

  private offerTables(): void {
    const name = (): string => stemOf(this.sheet.file);
    for (const host of document.querySelectorAll<HTMLElement>("[data-table]")) {
      const table = byId(host.dataset["table"] ?? "").closest("table, details, section");
      const found = table instanceof HTMLTableElement ? table : table?.querySelector("table");
      if (found) offerTable(host, found, name, host.dataset["what"] ?? "table");
    }
  }

  // What the user sets.

  private input(values: Record<string, number>, key: string): void {
    const at = performance.now();
    this.moved = key;
    this.history.preview(this.changed(withFollowers(this.sheet.parameters, values)));
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
    this.askElasticities();
  }

  /** A state that is a step of its own. */
  private set(state: State): void {
    const at = performance.now();
    this.moved = "";
    this.history.preview(state);
    this.history.settle();
    this.stepDone();
    this.ask(at);
  }

  private undo(): void {
    if (this.history.undo()) this.stepped("Undone");
  }

  private redo(): void {
    if (this.history.redo()) this.stepped("Redone");
  }

  private stepped(word: string): void {
    this.moved = "";
    say(word);
    this.stepDone();
    this.ask(performance.now());
  }

  private drag(drag: Drag): void {
    const isOver = drag.phase === "end" || drag.phase === "cancel";
    if (drag.phase === "start") this.dragged = draggedBy(this.sheet.parameters, this.wanted(), drag);
    this.stage.hold(isOver ? null : { text: describeDrag(this.dragged, drag), place: drag.place });
    if (drag.phase === "cancel") {
      this.history.cancel();
      this.ask(performance.now());
      return;
    }
    if (this.dragged.length > 0 && drag.phase !== "start") this.input(valuesOf(this.dragged, drag), this.dragged[0]?.name ?? "");
    if (drag.phase === "end") this.settle("");
  }

  private stepDone(): void {
    this.address.show(this.history.present);
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
    this.influence.cancel();
    this.queue.want(this.history.present, at);
    this.showState();
  }

  private done(state: State, result: Result, at: number, since: number): void {
    withdraw("program");
    this.isUnanswered = false;
    if (result.refused !== null) {
      this.refuse(result.refused);
      return;
    }
    this.accept(state, result);
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
    this.askLast();
    if (this.refusal === null && this.shown !== null) say(spoken(this.shown, this.place(), !this.isGoverned));
  }

  /** What comes after the modes and the diagram of a turbine. */
  private askLast(): void {
    this.askElasticities();
    this.askBand();
  }

  private accept(state: State, answer: Answer): void {
    this.refusal = null;
    this.numbers.refuse([], "");
    this.shown = { state, answer, followed: this.follower.follow(answer.modes, answer.scene) };
    this.chosen ??= this.shown.followed[0]?.id ?? null;
    this.turning?.ask(state, answer);
    this.show();
    if (this.history.isSettled) void this.stage.refreshFlat().catch((error: unknown) => this.failed(error));
  }

  /** The numbers that a refusal is about: those it names and the one that was moved last; if it
   * names none, the few that the last step changed. */
  private concerned(named: string[]): string[] {
    const before = this.shown?.state.numbers ?? {};
    const now = this.history.present.numbers;
    const names = [...new Set([...Object.keys(before), ...Object.keys(now)])];
    const changed = names.filter((name) => before[name] !== now[name]);
    const few = named.length > 0 || changed.length > MOST_CHANGED ? [] : changed;
    return [...new Set([...named, ...few, ...(this.moved === "" ? [] : [this.moved])])];
  }

  private refuse(refusal: Refusal["refused"]): void {
    this.refusal = refusal;
    this.numbers.refuse(this.concerned(refusal.parameters), sentences(refusal));
    this.numbers.show(this.wanted());
    this.showState();
    this.showTools();
  }

  /** The program gives no modes of the present tower: those of the one before stay. */
  private unanswered(error: unknown): void {
    this.isUnanswered = true;
    this.failed(error);
    this.showState();
  }

  private failed(error: unknown): void {
    if (error instanceof ProgramEnded) {
      notice("program", "The program does not answer: it has ended. Start it again with “", this.sheet.command,
        "”. The input values are in the address of this page after the #: append that part to the new address.");
    } else notice("program", error instanceof Error ? error.message : String(error));
  }

  // What is shown.

  /** The present values as the user wants them: numbers that follow others are those of the last
   * answer. */
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
    this.stage.turn(this.turning?.motion(answer.scene) ?? null);
    this.stage.show(shown, variant, handlesOf(this.sheet.parameters, answer.values));
    this.numbers.show(this.wanted());
    this.modes.show(answer.modes, followed, this.isTurning ? null : chosen, others, this.isGoverned);
    this.masses.show(answer.modes, followed);
    this.findings.show(answer, variant?.answer ?? null);
    this.comparison.show(this.sheet.parameters, answer.values, variant && this.valuesOf(variant), this.fileOf(variant));
    const other = this.fileOf(variant);
    setText(byId("beside"), `Left: this tower. Right, paler: A${other === null ? "" : `, ${other}`}.`);
    this.showResonance(shown);
    setText(byId("method"), `${answer.method} · ${answer.certificate}`);
    this.showReadout(shown);
    this.showState();
    this.showTools();
  }

  private showState(): void {
    showRefusal(this.refusal, this.reveal);
    const isOther = this.shown !== null && !isSame(this.shown.state, this.history.present);
    if (!isOther) showFreshness("present");
    else showFreshness(this.refusal !== null || this.isUnanswered ? "stale" : "late");
    this.showAge();
  }

  /** Marks what is of another tower than the present one beside its modes: elasticities,
   * frequencies in other soil, modes of the turbine. */
  private showAge(): void {
    const isOld = (state: State | null): boolean => state !== null && !isSame(state, this.history.present);
    const mark = (id: string, is: boolean): unknown => byId(id).classList.toggle("old", is);
    mark("parameters", isOld(this.influence.state));
    mark("band", isOld(this.soil?.state ?? null));
    const isWhirling = this.turning?.isWhirling ?? false;
    mark("turbine", isWhirling);
    mark("readout", isWhirling && this.isTurning);
  }

  /** Whether the verdicts are not those of the tower with a rigid rotor. */
  private get isGoverned(): boolean {
    return this.turning?.governs ?? false;
  }

  /** Whether a mode of the whole turbine is shown. */
  private get isTurning(): boolean {
    return this.turning?.chosen != null;
  }

  /** The tower mode that elasticities and searches are about: the one that is shown, or of a
   * turbine that with the same motion; null of a mode of the rotor. */
  private get mode(): Mode | null {
    const modes = this.shown?.answer.modes ?? [];
    if (this.turning === null || !this.isTurning) return modes[this.place()] ?? null;
    const like = this.turning.mode?.tower_mode ?? null;
    return modes.find(({ family, order }) => family === like?.family && order === like.order) ?? null;
  }

  private showResonance({ answer, followed }: Solved): void {
    const { turning, variant, chosen } = this;
    const own: Checked = { resonance: this.isGoverned ? null : answer.resonance, coupled: turning?.diagram ?? null, modes: answer.modes, followed };
    const other: Checked | null = variant && {
      resonance: this.isGoverned ? null : variant.answer.resonance,
      coupled: turning?.diagramOfOther ?? null, modes: variant.answer.modes, followed: variant.followed,
    };
    const isOfThis = this.soil !== null && this.shown !== null && isSame(this.soil.state, this.shown.state);
    const band = own.coupled === null && isOfThis ? this.soil?.band ?? null : null;
    this.resonance.show(own, other, band, { id: chosen, whirl: turning?.chosen ?? null }, turning?.isDrawing ?? false);
    turning?.show();
    const refused = turning?.refusal ? `The turbine cannot be solved: ${turning.refusal} The diagram shows the tower with a rigid rotor.` : "";
    const state = turning === null ? "" : turning.isDrawing ? "solving the turbine…" : refused;
    setText(byId("resonance-state"), state);
    byId("diagram").classList.toggle("waits", turning?.isDrawing ?? false);
    this.target.showMode();
  }

  private banded(state: State, result: Band | Refusal): void {
    const band = result.refused === null ? result : null;
    this.soil = band && { state, band };
    this.bandPanel.show(band, this.turning === null);
    if (this.shown !== null) this.showResonance(this.shown);
    this.showAge();
  }

  private askBand(): void {
    if (this.turning?.pending || this.queue.pending) return;
    if (this.sheet.has_soil && this.shown !== null && this.refusal === null) this.bands.want(this.shown.state);
  }

  private showReadout({ answer, followed }: Solved): void {
    const { turning } = this;
    const mode = turning?.mode ?? null;
    if (turning !== null && this.isTurning) {
      const resonance = turning.diagram?.resonance ?? null;
      const verdict = mode === null || resonance === null ? null : verdictOf(resonance.rows, mode.name);
      const label = mode?.name ?? `${turning.chosen ?? ""}: not at this rotor speed`;
      const series = resonance === null || mode === null ? 0 : seriesAt(resonance, mode.name, turning.rpm);
      this.stage.readout({ label, frequency: mode?.frequency ?? "–", verdict }, series);
      return;
    }
    const place = this.place();
    const own = answer.modes[place];
    this.stage.readout(own && (this.isGoverned ? { ...own, verdict: null } : own), followed[place]?.series ?? 0);
  }

  /** The index of the mode that is shown. */
  private place(): number {
    return Math.max(0, this.shown?.followed.findIndex(({ id }) => id === this.chosen) ?? 0);
  }

  private showTools(): void {
    showTools(this.history, this.variant !== null);
  }

  private choose(id: number): void {
    this.chosen = id;
    if (this.turning !== null) this.turning.chosen = null;
    this.stage.choose(id);
    this.show();
    this.askElasticities();
  }

  private chooseNumber(number: number): void {
    const { shown } = this;
    const identity = shown?.followed[number - 1];
    if (shown === null || identity === undefined) return;
    this.choose(identity.id);
    say(spoken(shown, number - 1, !this.isGoverned));
  }

  // The second tower.

  private take(variant: Solved | null): void {
    this.variant = variant;
    const hasTurbine = variant?.state.is_of_other ? this.sheet.against?.has_turbine : true;
    this.turning?.askOther(variant !== null && hasTurbine ? variant.state : null);
    this.show();
  }

  /** The values of A by the numbers of this tower; NaN of those that it does not have. */
  private valuesOf({ state, answer }: Solved): number[] {
    const { against, parameters } = this.sheet;
    if (!state.is_of_other || against === null) return answer.values;
    const values = new Map(against.names.map((name, index) => [name, answer.values[index] ?? NaN]));
    return parameters.map(({ name }) => values.get(name) ?? NaN);
  }

  /** The file of A, if it is another one. */
  private fileOf(variant: Solved | null): string | null {
    return (variant?.state.is_of_other && this.sheet.against?.file) || null;
  }

  private keep(): void {
    if (this.shown === null) return;
    this.take(this.shown);
    say("Kept as A");
  }

  private swap(): void {
    if (this.shown === null || this.variant === null) return;
    const { state } = this.variant;
    this.take(this.shown);
    this.set(state);
  }

  private drop(): void {
    this.take(null);
    byId("keep").focus();
  }

  /** A from before a reload. */
  private async recallVariant(state: State): Promise<void> {
    try {
      const answer = await solve(state);
      if (answer.refused !== null) return;
      // The present tower says which mode is which.
      while (this.shown === null && this.queue.pending) await new Promise(requestAnimationFrame);
      this.take({ state, answer, followed: this.follower.copy().follow(answer.modes, answer.scene) });
    } catch (error) {
      this.failed(error);
    }
  }

  /** Asks what moves the mode that is shown, between two steps. The turbine comes first. */
  private askElasticities(): void {
    const { shown, turning, mode } = this;
    if (shown === null || !this.history.isSettled || this.refusal !== null || this.queue.pending || turning?.pending) return;
    const isOfRigidRotor = turning !== null;
    if (mode !== null) this.influence.ask({ state: shown.state, number: mode.number, label: mode.label, isOfRigidRotor });
    else this.influence.none("No elasticities: they are computed for the tower with a rigid rotor, which has no such mode.");
  }

  /** What tests may read. */
  forTests(): Window["towermodes"] {
    const explorer = this;
    return {
      get state() { return explorer.history.present; },
      get answer() { return explorer.shown?.answer ?? null; },
      get timings() { return explorer.timings.all(); },
      get pending() {
        return explorer.queue.pending || explorer.influence.pending || (explorer.turning?.pending ?? false) || explorer.bands.pending;
      },
      get turbine() { return explorer.turning?.diagram ?? null; },
      get isCurrent() { return explorer.shown !== null && isSame(explorer.shown.state, explorer.history.present); },
    };
  }
}

function never(): never {
  throw new Error("a mode without an answer");
}
