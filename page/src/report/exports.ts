// Buttons beside pictures and tables: a picture is saved as SVG, a table copied or saved as CSV.

import { plain, toCsv, toTabs } from "./plain.js";
import { copyText, saveText } from "./save.js";

/** What a button does; it returns what is said of it. */
type Act = () => string | Promise<string>;

/** A row of buttons with a place for what they say. */
function tools(acts: [string, string, Act][]): HTMLElement {
  const row = Object.assign(document.createElement("div"), { className: "tools" });
  const status = document.createElement("span");
  status.setAttribute("role", "status");
  row.append(...acts.map(([name, label, act]) => {
    const button = Object.assign(document.createElement("button"), { type: "button", textContent: name });
    button.setAttribute("aria-label", label);
    button.addEventListener("click", () => void Promise.resolve(act()).then((said) => { status.textContent = said; }));
    return button;
  }), status);
  return row;
}

/** "Table 5. Natural frequencies." is saved as "table-5". */
const fileName = (caption: string): string =>
  (/^(Table|Data of figure) \d+/.exec(caption)?.[0] ?? "table").toLowerCase().replace(/ /g, "-");

/** The rows of a table, its head first; of a table that is shown in brief all rows. */
function rowsOf(box: Element): string[][] {
  const whole = box.nextElementSibling?.nextElementSibling?.matches("details.all") === true;
  const table = (whole ? box.nextElementSibling!.nextElementSibling! : box).querySelector("table")!;
  return [...table.rows].map((row) => [...row.cells].map((cell) => plain(cell.textContent)));
}

function offerTable(box: HTMLElement): void {
  const caption = box.querySelector("caption")!.textContent;
  const [name] = /^[^.]*/.exec(caption)!;
  const file = `${fileName(caption)}.csv`;
  box.before(tools([
    ["Copy", `Copy ${name}`, () => copyText(toTabs(rowsOf(box)), box.querySelector("table")!)],
    ["CSV", `Save ${name} as CSV`, () => {
      saveText(toCsv(rowsOf(box)), "text/csv", file);
      return `Saved as ${file}.`;
    }],
  ]));
}

/** The rules of the page for pictures, with the colours of light paper in place of variables. */
function rulesOfPictures(): string {
  const root = document.documentElement;
  const theme = root.dataset.theme;
  root.dataset.theme = "light";
  const colours = getComputedStyle(root);
  const rules = [...document.styleSheets].flatMap((sheet) => [...sheet.cssRules])
    .filter((rule): rule is CSSStyleRule => rule instanceof CSSStyleRule && rule.selectorText.startsWith("svg ."))
    .map(({ cssText }) => cssText.replace(/^svg /, "").replace(/var\((--tm-[\w-]+)\)/g, (_, name: string) => colours.getPropertyValue(name).trim()));
  root.dataset.theme = theme;
  return rules.join("");
}

/** A picture as a file of its own, on light paper. */
export function standalone(svg: SVGSVGElement): string {
  const copy = svg.cloneNode(true) as SVGSVGElement;
  const { width, height } = svg.viewBox.baseVal;
  copy.setAttribute("width", String(width));
  copy.setAttribute("height", String(height));
  const add = (name: string): Element => {
    const element = document.createElementNS(svg.namespaceURI, name);
    copy.querySelector("desc")!.after(element);
    return element;
  };
  const paper = add("rect");
  Object.entries({ class: "f-paper", width, height }).forEach(([key, value]) => paper.setAttribute(key, String(value)));
  add("style").textContent = rulesOfPictures();
  return `${new XMLSerializer().serializeToString(copy)}\n`;
}

function offerPicture(figure: HTMLElement): void {
  const svg = figure.querySelector<SVGSVGElement>("svg[role=img]")!;
  const name = /^Figure \d+/.exec(figure.querySelector("figcaption")!.textContent.trim())![0];
  const file = `${svg.getAttribute("aria-labelledby")!.replace(/-title .*/, "")}.svg`;
  figure.querySelector("figcaption")!.before(tools([["SVG", `Save ${name} as SVG`, () => {
    saveText(standalone(svg), "image/svg+xml", file);
    return `Saved as ${file}.`;
  }]]));
}

export function offerExports(): void {
  document.querySelectorAll<HTMLElement>("figure:has(svg[role=img])").forEach(offerPicture);
  document.querySelectorAll<HTMLElement>(".scroll:has(> table)").forEach((box) => {
    // What is folded away is part of the table above it.
    if (box.closest("details.all") === null) offerTable(box);
  });
}
