// One number under the hand: a slider, a field for the exact value, its elasticity, and the way
// back to the file.

import { button, make, setAttribute, setClass, setHidden, setText } from "../dom.js";
import { readNumber, tidy, writeFull, writeNumber, writeShort, type Entry } from "../numbers/entry.js";
import { roundRange, type Range } from "../numbers/range.js";
import type { NoElasticity } from "../protocol.js";

export interface RowText {
  /** Begins the ids of its elements. */
  id: string;
  /** Its name in the tower file, where rows count from 0. */
  name: string;
  label: string;
  meaning: string;
  unit: string;
}

export interface RowRange {
  low: number;
  high: number;
  /** The value to which the row goes back. */
  home: number;
}

export interface RowEvents {
  /** The user asks for a value, in a slide or by a complete number. */
  input(value: number): void;
  /** The slide or the typing is at its end. */
  settle(): void;
}

/** Who pauses for this time has typed the whole number, ms. */
const PAUSE_MS = 700;
/** Elasticities below this have two digits, others three decimals. */
const SMALL = 0.01;
/** Elasticities below this are rounding errors. */
const ROUNDING = 1e-9;

export class Row {
  readonly element: HTMLElement;
  /** What the row is, in the words of the page. */
  readonly heading: string;
  private slider = make("input");
  private field = make("input", "field");
  private back: HTMLButtonElement;
  private message = make("p", "message");
  /** Whether a search may change it. */
  private mark = make("input", "pick");
  private bar = make("span", "bar");
  private elasticityText = make("span", "elasticity-text");
  private elasticityCell = make("span", "elasticity", this.elasticityText, make("span", "scale", this.bar));
  private range: Range;
  private value: number;
  /** What is wrong with what is typed; it is no number. */
  private typing: string | null = null;
  private refusal: string | null = null;
  /** The user is in the middle of typing. */
  private isEditing = false;
  /** The value before the user has begun to type. */
  private before: number;
  /** What was typed and is not used. */
  private note: string | null = null;
  private pause: ReturnType<typeof setTimeout> | undefined;

  constructor(private text: RowText, private given: RowRange, private events: RowEvents) {
    this.value = given.home;
    this.before = given.home;
    this.heading = headingOf(this.text).heading;
    this.range = this.firstRange();
    this.back = button("↺", () => this.goBack(), "back");
    this.element = this.build();
    this.showRange();
    this.showValue();
  }

  private build(): HTMLElement {
    const { id, label, unit } = this.text;
    const { heading, more } = headingOf(this.text);
    const name = make("span", "name", make("b", "", heading));
    if (more) name.append(` ${more}`);
    name.id = `${id}-name`;
    name.title = [name.textContent, this.text.name].filter(Boolean).join("\n");
    const spoken = [heading, more, unit && `in ${unit}`].filter(Boolean).join(", ");
    this.slider.type = "range";
    this.field.type = "text";
    this.field.inputMode = "decimal";
    this.field.autocomplete = "off";
    this.field.spellcheck = false;
    this.message.id = `${id}-message`;
    this.message.hidden = true;
    for (const input of [this.slider, this.field]) {
      input.setAttribute("aria-label", spoken);
      input.setAttribute("aria-describedby", this.message.id);
    }
    this.back.setAttribute("aria-label", `Put ${label} back to the value of the file`);
    this.listen();
    this.mark.type = "checkbox";
    this.mark.setAttribute("aria-label", `A search may change ${spoken}`);
    const element = make("div", "row", make("div", "top", this.mark, name, this.elasticityCell), this.slider, this.field, make("span", "unit", unit), this.back, this.message);
    element.id = id;
    return element;
  }

  private listen(): void {
    const { slider, field, events } = this;
    slider.addEventListener("input", () => this.ask(tidy(Number(slider.value))));
    slider.addEventListener("change", () => events.settle());
    field.addEventListener("input", () => this.edit());
    field.addEventListener("change", () => this.typed());
    field.addEventListener("focus", () => {
      this.before = this.value;
      this.showText();
    });
    field.addEventListener("blur", () => this.leave());
    field.addEventListener("keydown", (event) => {
      if (event.key !== "ArrowUp" && event.key !== "ArrowDown") return;
      event.preventDefault();
      const steps = (event.key === "ArrowUp" ? 1 : -1) * (event.shiftKey ? 10 : 1);
      this.ask(tidy(this.value + steps * this.range.step));
      this.isEditing = false;
      this.showText();
      events.settle();
    });
  }

  /** What is in the field; only what is rigid in the file can be so again. */
  private read(): Entry {
    const isRigid = this.given.home === Infinity && this.field.value.trim() === writeNumber(Infinity);
    return isRigid ? { value: Infinity } : readNumber(this.field.value, this.text.unit);
  }

  /** A part of a number is not solved: "4" of "400000". */
  private edit(): void {
    this.isEditing = true;
    this.note = null;
    clearTimeout(this.pause);
    this.pause = setTimeout(() => {
      const entry = this.read();
      if (this.isEditing && "value" in entry && entry.value !== this.value) this.ask(entry.value);
    }, PAUSE_MS);
  }

  /** What is no number is not used: the value is again that from before. */
  private leave(): void {
    if (this.isEditing) this.typed();
    if (this.typing !== null) {
      const note = `“${this.field.value.trim()}” is not used. ${this.typing}`;
      this.typing = null;
      if (this.value !== this.before) {
        this.ask(this.before);
        this.events.settle();
      }
      this.note = note;
    }
    this.showText();
    this.showProblem();
  }

  /** What is typed is complete. */
  private typed(): void {
    clearTimeout(this.pause);
    this.isEditing = false;
    const entry = this.read();
    this.typing = "problem" in entry ? entry.problem : null;
    this.showProblem();
    if ("problem" in entry) return;
    if (entry.value !== this.value) this.ask(entry.value);
    this.before = entry.value;
    this.widen();
    this.events.settle();
  }

  /** Brings the field into sight, ready to be typed over. */
  focus(): void {
    this.field.focus();
    this.field.select();
  }

  private ask(value: number): void {
    this.typing = null;
    this.note = null;
    this.value = value;
    this.events.input(value);
  }

  private goBack(): void {
    this.ask(this.given.home);
    this.events.settle();
    this.slider.focus();
  }

  /** Whether a search may change it. */
  get isMarked(): boolean {
    return this.mark.checked && !this.slider.disabled;
  }

  set isMarked(isOn: boolean) {
    this.mark.checked = isOn;
  }

  /** The ends of the slider. */
  get ends(): { low: number; high: number } {
    return { low: this.range.low, high: this.range.high };
  }

  /** Nothing can be set where a factor would change no number. */
  enable(isOn: boolean): void {
    if (this.field.disabled === isOn) this.field.disabled = !isOn;
  }

  /** Shows the present value, unless the user is typing it. */
  show(value: number): void {
    const isOther = value !== this.value;
    this.value = value;
    if (isOther) {
      this.typing = null;
      this.note = null;
      this.isEditing = false;
      this.before = value;
    }
    this.widen();
    this.showValue();
    this.showProblem();
  }

  private showValue(): void {
    const { field, slider, value } = this;
    this.showText();
    // What is rigid has no place on a slider; its field takes a number.
    const isOff = field.disabled || !Number.isFinite(value);
    if (slider.disabled !== isOff) slider.disabled = isOff;
    if (Number(slider.value) !== value) slider.value = String(Number.isFinite(value) ? value : this.range.high);
    setAttribute(slider, "aria-valuetext", `${writeShort(value)} ${this.text.unit}`.trim());
    const isChanged = value !== this.given.home;
    this.element.classList.toggle("changed", isChanged);
    if (this.back.disabled === isChanged) this.back.disabled = !isChanged;
    const title = isChanged ? `Back to ${writeFull(this.given.home)} ${this.text.unit}`.trim() : "As in the file";
    if (this.back.title !== title) this.back.title = title;
  }

  /** Shows the value in the field: all digits while the field has the focus. What is typed stays. */
  private showText(): void {
    const { field, value } = this;
    if (this.isEditing || this.typing !== null) return;
    const hasFocus = document.activeElement === field;
    const typed = this.read();
    if (hasFocus && "value" in typed && typed.value === value) return;
    const text = hasFocus ? writeFull(value) : writeShort(value);
    if (field.value === text) return;
    // A key that leads to a field selects its text, to be typed over.
    const isSelected = hasFocus && field.selectionStart === 0 && field.selectionEnd === field.value.length;
    field.value = text;
    if (isSelected) field.select();
  }

  /** The range grows with the value, and is the first one again at the value of the file. */
  private widen(): void {
    if (this.isEditing) return;
    const { home } = this.given;
    const isFirst = this.value === home && (document.activeElement !== this.slider || !Number.isFinite(home));
    if (this.value >= this.range.low && this.value <= this.range.high && !isFirst) return;
    this.range = isFirst ? this.firstRange() : this.widened();
    this.showRange();
  }

  private firstRange(): Range {
    const { low, high, home } = this.given;
    return roundRange(low, high, ...[home].filter(Number.isFinite));
  }

  /** In the place of what is rigid a number has a range of its own. */
  private widened(): Range {
    const { range, value, given } = this;
    return Number.isFinite(given.home) ? roundRange(range.low, range.high, value) : roundRange(0, 2 * value);
  }

  private showRange(): void {
    const { slider, range } = this;
    const [min, max, step] = [range.low, range.high, range.step].map(String) as [string, string, string];
    if (slider.min !== min) slider.min = min;
    if (slider.max !== max) slider.max = max;
    if (slider.step !== step) slider.step = step;
  }

  /** The program refuses the tower because of this number; null if not. */
  refuse(message: string | null): void {
    if (message === this.refusal) return;
    this.refusal = message;
    this.showProblem();
  }

  private showProblem(): void {
    const problem = this.typing ?? this.refusal;
    const message = problem ?? this.note;
    setText(this.message, message ?? "");
    setHidden(this.message, message === null);
    for (const input of [this.slider, this.field]) setAttribute(input, "aria-invalid", problem === null ? null : "true");
  }

  /** Shows the elasticity of a frequency, with a bar in the scale of the largest one; null if
   * there is none, with the reason. */
  elasticity(value: number | null, largest: number, reason: NoElasticity | null): void {
    setText(this.elasticityText, value === null ? reason === null ? "" : reason.short || "–" : writeElasticity(value));
    const { elasticityCell } = this;
    const title = reason?.text ?? "";
    if (elasticityCell.title !== title) elasticityCell.title = title;
    elasticityCell.classList.toggle("without", value === null && title !== "");
    const part = value === null || !(largest > 0) ? 0 : value / largest;
    this.bar.style.setProperty("--part", String(Math.abs(part)));
    setClass(this.bar, part < 0 ? "bar negative" : "bar");
  }
}

/** The name of a row, and its meaning where the name does not say it: "1: diameter" with "outer
 * diameter" is "1: outer diameter"; a place in a table of the file is no name. */
export function headingOf({ label, meaning }: { label: string; meaning: string }): { heading: string; more: string } {
  const key = label.slice(label.lastIndexOf(" ") + 1);
  const isPlace = key.endsWith("[]");
  const isNamed = isPlace || meaning.split(" ").includes(key);
  return {
    heading: isNamed ? label.slice(0, -key.length) + meaning : label,
    more: isNamed || label.endsWith(meaning) ? "" : meaning,
  };
}

/** With three decimals; a small one with two significant digits. */
export function writeElasticity(value: number): string {
  const size = Math.abs(value);
  if (size < ROUNDING) return "0";
  const small = (): string => (size < 1e-4 ? size.toExponential(1) : size.toPrecision(2));
  return `${value < 0 ? "−" : "+"}${size < SMALL ? small() : size.toFixed(3)}`;
}
