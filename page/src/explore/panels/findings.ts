// What the program finds beside the modes: facts and warnings.

import { byId, make, setCount, setHidden, setText } from "../dom.js";
import type { Answer, Fact, Remark } from "../protocol.js";
import { signed } from "./modes.js";
import { showWithNames, type Reveal } from "./names.js";

interface FactRow {
  element: HTMLElement;
  name: HTMLElement;
  value: HTMLElement;
  other: HTMLElement;
}

export class Findings {
  private facts: FactRow[] = [];
  private warnings: HTMLElement[] = [];

  constructor(private reveal: Reveal) {}

  /** Shows an answer, and what A has instead. */
  show(answer: Answer, other: Answer | null): void {
    this.showFacts(answer.facts, other?.facts ?? null);
    this.showWarnings(answer.warnings);
  }

  private showFacts(facts: Fact[], others: Fact[] | null): void {
    const list = byId("facts");
    setCount(this.facts, facts.length, () => {
      const row = { name: make("dt"), value: make("dd"), other: make("dd", "of-a") };
      const element = make("div", "", row.name, row.value, row.other);
      list.append(element);
      return { element, ...row };
    }, (row) => row.element.remove());
    facts.forEach((fact, index) => {
      const row = this.facts[index];
      if (row === undefined) return;
      setText(row.name, fact.name.charAt(0).toUpperCase() + fact.name.slice(1));
      setText(row.value, fact.text);
      const other = others?.find(({ key }) => key === fact.key);
      setHidden(row.other, others === null);
      setText(row.other, other ? `A: ${other.text}${difference(fact, other)}` : "");
    });
  }

  private showWarnings(remarks: Remark[]): void {
    setCount(this.warnings, remarks.length, () => {
      const element = make("p", "warning");
      byId("warnings").append(element);
      return element;
    }, (element) => element.remove());
    remarks.forEach(({ text, parameters }, index) => {
      const element = this.warnings[index];
      if (element) showWithNames(element, `Warning: ${text}`, parameters, this.reveal);
    });
  }
}

function difference(fact: Fact, other: Fact): string {
  if (fact.value === null || !other.value) return "";
  return `, ${signed((100 * (fact.value - other.value)) / Math.abs(other.value), 2)} %`;
}
