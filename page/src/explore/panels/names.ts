// Names of numbers in a sentence, as buttons that lead to their fields.

import { button, make } from "../dom.js";

/** More names than these say no more than the sentence. */
const MOST = 4;

export type Reveal = (name: string) => void;

/** Fills an element with a sentence and the names that it is about; only if they differ from
 * what it has. */
export function showWithNames(element: HTMLElement, text: string, names: string[], reveal: Reveal): void {
  const key = [text, ...names].join("\n");
  if (element.dataset["key"] === key) return;
  element.dataset["key"] = key;
  const shown = names.slice(0, MOST).map((name) => {
    const link = button(name, () => reveal(name), "to-number");
    link.setAttribute("aria-label", `Go to ${name}`);
    return link;
  });
  element.replaceChildren(make("span", "", text), ...shown.flatMap((link) => [" ", link]));
}
