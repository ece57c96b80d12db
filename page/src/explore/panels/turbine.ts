// The modes of the whole turbine at a rotor speed that a slider sets.

import { byId, make, setClass, setCount, setHidden, setText, swatch } from "../dom.js";
import type { DiagramRow, Resonance, Whirl, WhirlMode, Word } from "../protocol.js";
import { seriesAt } from "./resonance.js";

export interface TurbineEvents {
  /** Another rotor speed, rpm. */
  speed(rpm: number): void;
  choose(name: string): void;
}

interface WhirlRow {
  element: HTMLElement;
  radio: HTMLInputElement;
  swatch: HTMLElement;
  name: HTMLElement;
  remark: HTMLElement;
  frequency: HTMLElement;
  verdict: HTMLElement;
}

const RANK: Word[] = ["pass", "warn", "fail"];
const STEPS = 120;

/** The worst verdict on the mode with a name; null without one. */
export function verdictOf(rows: DiagramRow[], name: string): { word: Word; text: string } | null {
  const own = rows.filter(({ label, verdict }) => label === name && verdict !== "undecided");
  const order = (row: DiagramRow): number => RANK.indexOf(row.verdict) - 1e-3 * Math.min(1, Math.abs(row.distance));
  const worst = own.reduce<DiagramRow | null>((most, row) => (most === null || order(row) > order(most) ? row : most), null);
  return worst && { word: worst.verdict, text: `${worst.multiple}P: ${worst.distance_text.replace("-", "\u2212")}` };
}

export class TurbinePanel {
  private slider = byId<HTMLInputElement>("rotor-speed");
  private body = byId("whirls").querySelector("tbody") as HTMLTableSectionElement;
  private rows: WhirlRow[] = [];

  constructor(private events: TurbineEvents) {
    for (const id of ["rotor", "rigid-title"]) setHidden(byId(id), false);
    this.slider.addEventListener("input", () => {
      this.showSpeed();
      events.speed(this.rpm);
    });
  }

  get rpm(): number {
    return Number(this.slider.value);
  }

  /** The range of the slider, and where it begins. */
  range(last_rpm: number, first_rpm: number | null): void {
    this.slider.max = String(Number(last_rpm.toPrecision(4)));
    // A power of ten: the slider can stand at a speed of few digits, such as the highest in operation.
    this.slider.step = String(10 ** Math.floor(Math.log10(last_rpm / STEPS)));
    if (first_rpm !== null) this.slider.value = String(first_rpm);
    this.showSpeed();
  }

  private showSpeed(): void {
    setText(byId("rotor-speed-text"), `${this.rpm} rpm`);
    this.slider.setAttribute("aria-valuetext", `${this.rpm} rpm`);
  }

  /** Shows the modes, with the verdicts and colours of a diagram if it is there; none if they
   * cannot be solved. */
  show(whirl: Whirl | null, resonance: Resonance | null, chosen: string | null): void {
    setHidden(byId("turbine"), whirl === null);
    if (whirl === null) return;
    const { modes, scene } = whirl;
    setText(byId("turbine-title"), `Turbine at ${Number(scene.rotor_speed_rpm.toPrecision(4))} rpm`);
    byId("whirls").classList.toggle("no-rotor", !(resonance?.is_checked ?? false));
    setCount(this.rows, modes.length, (index) => this.row(index), ({ element }) => element.remove());
    modes.forEach((mode, index) => {
      const row = this.rows[index];
      if (row) showRow(row, mode, resonance, scene.rotor_speed_rpm, mode.name === chosen);
    });
  }

  private row(index: number): WhirlRow {
    const radio = make("input");
    radio.type = "radio";
    radio.name = "whirl";
    radio.addEventListener("change", () => this.events.choose(radio.value));
    const [name, remark, mark] = [make("span", "mode-name"), make("span", "mode-remark"), make("span", "swatch")];
    const label = make("label", "", radio, make("span", "place", String(index + 1)), mark, make("span", "names", name, remark));
    const head = make("th", "", label);
    head.scope = "row";
    const [frequency, verdict] = [make("td", "number frequency"), make("span", "verdict")];
    const element = make("tr", "", head, frequency, make("td", "judged", verdict));
    this.body.append(element);
    return { element, radio, swatch: mark, name, remark, frequency, verdict };
  }
}

function showRow(row: WhirlRow, mode: WhirlMode, resonance: Resonance | null, rpm: number, isChosen: boolean): void {
  const verdict = verdictOf(resonance?.rows ?? [], mode.name);
  row.radio.value = mode.name;
  if (row.radio.checked !== isChosen) row.radio.checked = isChosen;
  row.element.classList.toggle("chosen", isChosen);
  setClass(row.swatch, resonance === null ? "swatch" : swatch(seriesAt(resonance, mode.name, rpm)));
  setText(row.name, mode.name);
  setText(row.remark, [mode.remark, verdict?.text ?? ""].filter(Boolean).join(" · "));
  setText(row.frequency, mode.frequency);
  row.frequency.dataset["full"] = String(mode.frequency_hz);
  setText(row.verdict, verdict?.word.toUpperCase() ?? "");
  setClass(row.verdict, `verdict ${verdict?.word ?? ""}`);
}
