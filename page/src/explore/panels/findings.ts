// What the program finds beside the modes: facts, resonance, warnings.

import { byId, make, setClass, setCount, setHidden, setText } from "../dom.js";
import type { Answer, Fact, Remark, Resonance } from "../protocol.js";
import { signed } from "./modes.js";
import { showWithNames, type Reveal } from "./names.js";
import { showSvg } from "./patch.js";

interface FactRow {
  element: HTMLElement;
  name: HTMLElement;
  value: HTMLElement;
  other: HTMLElement;
}

export class Findings {
  private facts: FactRow[] = [];
  private sentences: HTMLElement[] = [];
  private warnings: HTMLElement[] = [];
  private diagram = byId("diagram");
  private drawn: string | null = null;

  constructor(private reveal: Reveal) {
    const button = byId("enlarge");
    button.addEventListener("click", () => button.setAttribute("aria-pressed", String(this.diagram.classList.toggle("large"))));
  }

  /** Shows an answer, and what A has instead. */
  show(answer: Answer, other: Answer | null): void {
    this.showFacts(answer.facts, other?.facts ?? null);
    this.showResonance(answer.resonance);
    this.showDiagram(answer.diagram);
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

  private showResonance(resonance: Resonance | null): void {
    setHidden(byId("resonance"), resonance === null);
    const sentences = resonance?.conclusion ?? [];
    setCount(this.sentences, sentences.length, () => {
      const element = make("p");
      byId("conclusion").append(element);
      return element;
    }, (element) => element.remove());
    sentences.forEach((text, index) => {
      const element = this.sentences[index];
      if (element) setText(element, text);
    });
    setClass(byId("conclusion"), resonance?.word ?? "");
  }

  private showDiagram(svg: string | null): void {
    if (svg === this.drawn) return;
    this.drawn = svg;
    if (svg === null) this.diagram.replaceChildren();
    else showSvg(this.diagram, svg);
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
