// Frequencies and verdicts in softer and stiffer soil.

import { byId, make, setClass, setHidden, setText } from "../dom.js";
import type { Band } from "../protocol.js";

export class BandPanel {
  private details = byId<HTMLDetailsElement>("band");

  /** Without verdicts where another model governs; hidden without a band. */
  show(band: Band | null, isJudged: boolean): void {
    const { details } = this;
    setHidden(details, band === null);
    if (band === null) return;
    const head = make("tr", "", heading("Mode"), ...band.factors.map((factor) => heading(`soil \u00d7 ${factor}`, "number")));
    const rows = band.modes.map(({ label, at }) => {
      const name = make("th", "", label);
      name.scope = "row";
      return make("tr", "", name, ...at.map((value) => cell(value, isJudged)));
    });
    details.querySelector("thead")?.replaceChildren(head);
    details.querySelector("tbody")?.replaceChildren(...rows);
    const failed = band.failed.map(({ factor, reason }) => `Soil \u00d7 ${factor}: ${reason}.`);
    const shared = band.shared.map(({ factor, modes }) => `Soil \u00d7 ${factor}: ${modes}.`);
    setText(byId("band-text"), [...failed, ...shared].join(" "));
  }
}

function heading(text: string, of = ""): HTMLElement {
  const element = make("th", of, text);
  element.scope = "col";
  return element;
}

function cell(value: Band["modes"][number]["at"][number], isJudged: boolean): HTMLElement {
  if (value === null) return make("td", "number", "\u2013");
  const word = isJudged ? value.verdict : null;
  const verdict = make("span", "verdict", word === null ? "" : word.toUpperCase());
  setClass(verdict, `verdict ${word ?? ""}`);
  const element = make("td", "number", `${Number(value.frequency_hz.toPrecision(5))} `, verdict);
  element.dataset["full"] = String(value.frequency_hz);
  return element;
}
