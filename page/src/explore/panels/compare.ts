// The numbers in which the present tower and A differ, and what can be done with A.

import { button, byId, make, setCount, setHidden, setText } from "../dom.js";
import { writeNumber } from "../numbers/entry.js";
import type { Parameter } from "../protocol.js";

export interface CompareEvents {
  swap(): void;
  drop(): void;
}

interface Line {
  element: HTMLElement;
  cells: HTMLElement[];
}

export class ComparePanel {
  private lines: Line[] = [];
  private body = make("tbody");
  private none = make("p", "remark", "The present tower and A have the same input values.");
  private table: HTMLElement;
  private swap = button("Swap", () => undefined);
  private of = make("p", "remark");

  constructor(events: CompareEvents) {
    const title = make("h3", "", "Compared with A");
    title.id = "compare-title";
    const buttons = make("div", "buttons", this.swap, button("Drop A", events.drop));
    this.swap.addEventListener("click", () => events.swap());
    const heads = ["Number", "Now", "A", "File", "Unit"].map((text, index) => {
      const head = make("th", index > 0 && index < 4 ? "number" : "", text);
      head.scope = "col";
      return head;
    });
    this.table = make("div", "scroll", make("table", "", make("thead", "", make("tr", "", ...heads)), this.body));
    byId("compare").append(make("div", "head", title, buttons), this.of, this.none, this.table);
  }

  /** Shows the differences; `others` are the values of A in the order of the parameters, null
   * without A, and NaN where A has no such number. `file` is that of A, if it is another one. */
  show(parameters: Parameter[], values: number[], others: number[] | null, file: string | null): void {
    setHidden(byId("compare"), others === null);
    if (others === null) return;
    setHidden(this.swap, file !== null);
    setHidden(this.of, file === null);
    setText(this.of, `A is the tower of ${file ?? ""}.`);
    const changed = parameters.map((_, index) => index).filter((index) => values[index] !== others[index]);
    setHidden(this.none, changed.length > 0);
    setHidden(this.table, changed.length === 0);
    setCount(this.lines, changed.length, () => this.line(), (line) => line.element.remove());
    changed.forEach((index, place) => {
      const parameter = parameters[index];
      if (parameter === undefined) return;
      const numbers = [values[index], others[index], parameter.value].map((value) => (value === undefined || Number.isNaN(value) ? "\u2013" : writeNumber(value)));
      [parameter.name, ...numbers, parameter.unit].forEach((text, cell) => {
        const element = this.lines[place]?.cells[cell];
        if (element) setText(element, text);
      });
    });
  }

  private line(): Line {
    const head = make("th");
    head.scope = "row";
    const cells = [head, ...[1, 2, 3].map(() => make("td", "number")), make("td")];
    const element = make("tr", "", ...cells);
    this.body.append(element);
    return { element, cells };
  }
}
