// The resonance check: the diagram that stays in sight, its conclusion, and the table of distances.

import { byId, make, setClass, setCount, setHidden, setText } from "../dom.js";
import { contentOf, type Line, type LineLook, type Source } from "../diagram/content.js";
import { Diagram } from "../diagram/diagram.js";
import type { Followed } from "../modes/follow.js";
import type { Band, Coupled, DiagramLine, DiagramRow, Mode, Resonance } from "../protocol.js";

/** What a tower has for the diagram. */
export interface Checked {
  resonance: Resonance | null;
  /** The coupled diagram in place of that of the rigid rotor. */
  coupled: Coupled | null;
  modes: Mode[];
  followed: Followed[];
}

export interface ResonanceEvents {
  /** A tower mode, by its number. */
  chooseMode(number: number): void;
  /** A mode of the turbine, by its name. */
  chooseWhirl(name: string): void;
}

/** What is chosen: a tower mode by its identity, or a mode of the turbine by its name. */
export interface Choice {
  id: number | null;
  whirl: string | null;
}

const COLOURS = 14;

export class ResonancePanel {
  private diagram: Diagram;
  private isWhole = false;
  private last: Parameters<ResonancePanel["show"]> | null = null;
  private sentences: HTMLElement[] = [];
  private rows: HTMLElement[][] = [];
  private bodies: HTMLElement[] = [];
  private body = byId("pairs").querySelector("tbody") as HTMLTableSectionElement;

  constructor(events: ResonanceEvents) {
    this.diagram = new Diagram({ choose: (line) => this.choose(line, events) });
    const button = byId("enlarge");
    button.addEventListener("click", () => {
      this.isWhole = !this.isWhole;
      button.setAttribute("aria-pressed", String(this.isWhole));
      if (this.last) this.show(...this.last);
    });
    byId("pairs").addEventListener("toggle", () => {
      if (this.last) this.show(...this.last);
    });
  }

  private choose({ label, mode }: Line, events: ResonanceEvents): void {
    if (mode === null) events.chooseWhirl(label);
    else events.chooseMode(mode);
  }

  /** Shows a tower and, if there is one, that which it is compared with. While the model that
   * governs is awaited there is no verdict. */
  show(own: Checked, other: Checked | null, band: Band | null, choice: Choice, isAwaited: boolean): void {
    this.last = [own, other, band, choice, isAwaited];
    const resonance = checkOf(own);
    setHidden(byId("resonance"), resonance === null && !isAwaited);
    setHidden(byId("check"), resonance === null);
    document.body.classList.toggle("unjudged", isAwaited);
    if (resonance === null) setText(byId("resonance-word"), "");
    if (resonance === null) return;
    const source = sourceOf(own, choice);
    const beside = other === null ? null : sourceOf(other, { id: null, whirl: null });
    if (source !== null) this.diagram.show(contentOf(source, beside, band, this.isWhole), resonance.conclusion.join(" "));
    const word = isAwaited || resonance.word === "undecided" ? "" : resonance.word.toUpperCase();
    setText(byId("resonance-word"), word);
    setClass(byId("resonance-word"), `verdict ${resonance.word}`);
    this.showSentences(own, resonance);
    this.showRows(resonance.rows);
  }

  private showSentences({ coupled }: Checked, { conclusion, word }: Resonance): void {
    const sentences = coupled === null ? conclusion : [...conclusion, coupled.proof];
    setCount(this.sentences, sentences.length, () => {
      const element = make("p");
      byId("conclusion").append(element);
      return element;
    }, (element) => element.remove());
    sentences.forEach((text, index) => {
      const element = this.sentences[index];
      if (element) setText(element, text);
    });
    setClass(byId("conclusion"), word);
  }

  /** The rows that the command lists; only while they are open. */
  private showRows(all: DiagramRow[]): void {
    const details = byId<HTMLDetailsElement>("pairs");
    const rows = all.filter(({ is_near }) => is_near);
    setHidden(details, rows.length === 0);
    if (!details.open) return;
    setCount(this.bodies, rows.length, () => this.row(), (element) => {
      this.rows.pop();
      element.remove();
    });
    rows.forEach((row, index) => {
      const texts = [
        row.label, row.frequency, `${row.multiple}P`, String(Number(row.nearest_rpm.toPrecision(4))), row.excitation_hz.toFixed(4),
        row.distance_text.replace("-", "\u2212"), row.verdict.toUpperCase(),
      ];
      this.rows[index]?.forEach((cell, place) => setText(cell, texts[place] ?? ""));
      const last = this.rows[index]?.at(-1);
      if (last) setClass(last, `verdict ${row.verdict}`);
    });
  }

  private row(): HTMLElement {
    const head = make("th");
    head.scope = "row";
    // The excitation follows from its multiple and the speed.
    const cells = [head, ...[1, 2, 3, 4, 5].map((place) => make("td", place === 3 ? "number speed" : place === 4 ? "number known" : "number")), make("td")];
    this.rows.push(cells);
    const element = make("tr", "", ...cells);
    this.body.append(element);
    return element;
  }
}

const checkOf = ({ coupled, resonance }: Checked): Resonance | null => coupled?.resonance ?? resonance;

function sourceOf(of: Checked, { id, whirl }: Choice): Source | null {
  const resonance = checkOf(of);
  if (resonance === null) return null;
  const look = (line: DiagramLine): LineLook => {
    if (line.curve !== null) return { series: seriesOf(line.curve), isChosen: line.label === whirl };
    const index = of.modes.findIndex(({ number }) => number === line.mode);
    const followed = of.followed[index];
    return { series: followed?.series ?? 0, isChosen: whirl === null && followed !== undefined && followed.id === id };
  };
  return { resonance, look };
}

const seriesOf = (curve: number): number => curve % COLOURS;

/** The colour of a mode of the turbine at a speed: that of its curve there. */
export function seriesAt({ lines }: Resonance, name: string, rpm: number): number {
  const own = lines.filter(({ label, curve }) => label === name && curve !== null);
  const holds = (line: DiagramLine): boolean => (line.points[0]?.[0] ?? 0) <= rpm && rpm <= (line.points.at(-1)?.[0] ?? 0);
  return seriesOf((own.find(holds) ?? own[0])?.curve ?? 0);
}
