// Sentences at the top of the page: each stays until it is dismissed or no longer holds.

import { button, byId, make } from "./dom.js";

const shown = new Map<string, HTMLElement>();

/** Shows a sentence under a key, in the place of one before. */
export function notice(key: string, ...content: (Node | string)[]): void {
  const text = content.map((part) => (typeof part === "string" ? part : part.textContent ?? "")).join("");
  if (shown.get(key)?.dataset["text"] === text) return;
  withdraw(key);
  const element = make("p", "notice", make("span", "", ...content), button("Dismiss", () => withdraw(key)));
  element.dataset["text"] = text;
  shown.set(key, element);
  byId("notices").append(element);
}

export function withdraw(key: string): void {
  shown.get(key)?.remove();
  shown.delete(key);
}

/** Says a sentence to screen readers, without showing it. */
export function say(text: string): void {
  byId("announcer").textContent = text;
}
