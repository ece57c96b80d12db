// The table of modes: frequencies with errors, verdicts, differences from A; a choice of the mode
// that is shown.

import { speedText } from "../diagram/content.js";
import { byId, make, setClass, setCount, setHidden, setText, swatch } from "../dom.js";
import type { Followed } from "../modes/follow.js";
import type { Mode } from "../protocol.js";

export class ModeTable {
  private rows: ModeRow[] = [];
  private table = byId<HTMLTableElement>("modes");
  private body = this.table.tBodies[0] ?? this.table.createTBody();

  constructor(private choose: (id: number) => void) {
    const cell = (text: string): HTMLElement => {
      const head = make("th", "number of-a", text);
      head.scope = "col";
      return head;
    };
    const head = this.table.tHead?.rows[0];
    const differs = cell("Diff. Hz");
    differs.classList.add("diff-hz");
    const ofA = cell("A Hz");
    ofA.classList.add("a-hz");
    head?.querySelector(".judged")?.after(cell("Diff. %"), differs, ofA);
  }

  /** Shows the modes; `others` are the modes of A by identity, null without A. */
  show(modes: Mode[], followed: Followed[], chosen: number | null, others: Map<number, Mode> | null, isJudgedElsewhere = false): void {
    this.table.classList.toggle("has-a", others !== null);
    this.table.classList.toggle("no-damping", modes.every(({ damping }) => !damping));
    this.table.classList.toggle("no-rotor", isJudgedElsewhere || modes.every(({ verdict }) => verdict === null));
    setCount(this.rows, modes.length, (index) => this.row(index), (row) => row.element.remove());
    const decimals = Math.max(0, ...modes.map(({ frequency }) => decimalsOf(frequency)));
    modes.forEach((mode, index) => {
      const identity = followed[index];
      if (identity) this.rows[index]?.show(mode, identity, identity.id === chosen, others?.get(identity.id) ?? null, decimals, isJudgedElsewhere);
    });
  }

  private row(index: number): ModeRow {
    const row = new ModeRow(index, this.choose);
    this.body.append(row.element);
    return row;
  }
}

class ModeRow {
  readonly element = make("tr");
  private radio = make("input");
  private swatch = make("span", "swatch");
  private name = make("span", "mode-name");
  private remark = make("span", "mode-remark");
  private frequency = make("td", "number frequency");
  private error = make("td", "number error");
  private ofA = ["", " diff-hz", " a-hz"].map((more) => make("td", `number of-a${more}`));
  private verdict = make("span", "verdict");
  private damping = make("td", "number damping");
  private period = make("td", "number period");
  private id = -1;

  constructor(index: number, choose: (id: number) => void) {
    this.radio.type = "radio";
    this.radio.name = "mode";
    this.radio.value = String(index + 1);
    this.radio.addEventListener("change", () => choose(this.id));
    const names = make("span", "names", this.name, this.remark);
    const label = make("label", "", this.radio, make("span", "place", String(index + 1)), this.swatch, names);
    const head = make("th", "", label);
    head.scope = "row";
    this.element.append(head, this.frequency, this.error, make("td", "judged", this.verdict), ...this.ofA, this.damping, this.period);
  }

  show(mode: Mode, identity: Followed, isChosen: boolean, other: Mode | null, decimals: number, isJudgedElsewhere: boolean): void {
    this.id = identity.id;
    if (this.radio.checked !== isChosen) this.radio.checked = isChosen;
    this.element.classList.toggle("chosen", isChosen);
    setClass(this.swatch, swatch(identity.series));
    setText(this.name, mode.label);
    const remark = remarkOn(mode, identity, isJudgedElsewhere);
    setText(this.remark, remark);
    if (this.remark.title !== remark) this.remark.title = remark;
    setText(this.frequency, aligned(mode.frequency, decimals));
    setText(this.error, aligned(mode.error, decimals));
    showDamping(this.damping, mode);
    this.frequency.dataset["full"] = String(mode.frequency_hz);
    this.error.dataset["full"] = String(mode.error_hz);
    this.period.dataset["full"] = String(mode.period_s ?? "");
    setText(this.period, mode.period_s === null ? "" : mode.period_s.toPrecision(4));
    setText(this.verdict, mode.verdict?.word.toUpperCase() ?? "");
    setClass(this.verdict, `verdict ${mode.verdict?.word ?? ""}`);
    this.compare(mode, other, decimals);
  }

  private compare(mode: Mode, other: Mode | null, decimals: number): void {
    const difference = other && mode.frequency_hz - other.frequency_hz;
    const percent = difference === null || !(other && other.frequency_hz > 0) ? null : (100 * difference) / other.frequency_hz;
    const digits = Math.min(decimals, 6);
    const texts = [
      percent === null ? "–" : signed(percent, 2),
      difference === null ? "–" : signed(difference, digits),
      other === null ? "–" : aligned(other.frequency, decimals),
    ];
    this.ofA.forEach((cell, index) => setText(cell, texts[index] ?? ""));
  }
}

/** The damping ratio of the structure, and that of the running rotor beside it. */
function showDamping(cell: HTMLElement, { damping }: Mode): void {
  const percent = (ratio: number): string => (100 * ratio).toPrecision(3);
  const running = damping?.running.map(([rpm, ratio]) => `${percent(ratio)} at ${speedText(rpm)} rpm`) ?? [];
  const ratio = damping?.ratio ?? null;
  setText(cell, [ratio === null ? "" : percent(ratio), ...running].filter(Boolean).join("; "));
  cell.dataset["full"] = ratio === null ? "" : String(100 * ratio);
}

/** The shares of a coupled mode, the name that its shape had at first, and the verdict. */
function remarkOn(mode: Mode, identity: Followed, isJudgedElsewhere: boolean): string {
  const shares = mode.shape.slice(mode.label.length).replace(/^,? /, "");
  const before = mode.label === identity.name ? "" : `was ${identity.name}`;
  const verdict = isJudgedElsewhere ? "" : (mode.verdict?.text ?? "").replace(" -", " \u2212");
  return [shares, before, verdict].filter((text) => text !== "").join(" · ");
}

export function signed(value: number, decimals: number): string {
  const text = Math.abs(value).toFixed(decimals);
  return Number(text) === 0 ? text : `${value < 0 ? "−" : "+"}${text}`;
}

function decimalsOf(text: string): number {
  const point = text.indexOf(".");
  return point < 0 || /e/i.test(text) ? 0 : text.length - point - 1;
}

/** With figure spaces in the place of decimals that it does not have, so that points stand below
 * each other. */
function aligned(text: string, decimals: number): string {
  const missing = decimals - decimalsOf(text);
  return missing > 0 && text.includes(".") ? text + "\u2007".repeat(missing) : text;
}

/** The effective masses of the modes, as percentages; only while they are open. */
export class MassTable {
  private details = byId<HTMLDetailsElement>("masses");
  private body = this.details.querySelector("tbody") as HTMLTableSectionElement;
  private rows: { element: HTMLElement; name: HTMLElement; swatch: HTMLElement; cells: HTMLElement[] }[] = [];
  private last: [Mode[], Followed[]] = [[], []];

  constructor() {
    this.details.addEventListener("toggle", () => this.show(...this.last));
  }

  show(modes: Mode[], followed: Followed[]): void {
    this.last = [modes, followed];
    setHidden(this.details, modes.length === 0);
    if (!this.details.open) return;
    setCount(this.rows, modes.length, () => this.row(), (row) => row.element.remove());
    modes.forEach((mode, index) => {
      const row = this.rows[index];
      if (row === undefined) return;
      setText(row.name, mode.label);
      setClass(row.swatch, swatch(followed[index]?.series ?? 0));
      row.cells.forEach((cell, axis) => {
        const share = mode.effective_mass[axis];
        setText(cell, share === null || share === undefined ? "–" : (100 * share).toFixed(1));
      });
    });
  }

  private row(): MassTable["rows"][number] {
    const [name, swatch] = [make("span"), make("span", "swatch")];
    const head = make("th", "", swatch, name);
    head.scope = "row";
    const cells = Array.from({ length: 6 }, () => make("td", "number"));
    const element = make("tr", "", head, ...cells);
    this.body.append(element);
    return { element, name, swatch, cells };
  }
}
