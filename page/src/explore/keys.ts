// Keys of the whole page.

import { byId } from "./dom.js";

export interface KeyActions {
  undo(): void;
  redo(): void;
  choose(number: number): void;
  toggle(): void;
  tap(): void;
}

export function listenToKeys(actions: KeyActions): void {
  const dialog = byId<HTMLDialogElement>("keys");
  byId("help").addEventListener("click", () => dialog.showModal());
  document.addEventListener("keydown", (event) => {
    if (document.querySelector("dialog[open]") !== null || event.altKey) return;
    if (event.ctrlKey || event.metaKey) withControl(event, actions);
    else if (!isTyping(event.target)) alone(event, actions, dialog);
  });
}

/** Undo and redo, except in the search, which has its own. */
function withControl(event: KeyboardEvent, actions: KeyActions): void {
  if (event.target instanceof HTMLInputElement && event.target.type === "search") return;
  const key = event.key.toLowerCase();
  const isRedo = key === "y" || (key === "z" && event.shiftKey);
  if (!isRedo && key !== "z") return;
  event.preventDefault();
  if (isRedo) actions.redo();
  else actions.undo();
}

function alone(event: KeyboardEvent, actions: KeyActions, dialog: HTMLDialogElement): void {
  const isOnControl = event.target instanceof Element && event.target.closest("button, summary, a, input[type=radio]") !== null;
  if (/^[1-9]$/.test(event.key)) actions.choose(Number(event.key));
  else if (event.key === " " && !isOnControl) actions.toggle();
  else if (event.key === "t" || event.key === "T") actions.tap();
  else if (event.key === "/") byId("filter").focus();
  else if (event.key === "?") dialog.showModal();
  else return;
  event.preventDefault();
}

function isTyping(target: EventTarget | null): boolean {
  return target instanceof HTMLInputElement && (target.type === "text" || target.type === "search");
}
