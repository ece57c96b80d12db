// Copies and saves the input files that the page repeats. Nothing is fetched; without this script
// the texts can be read and marked.

import { copyText, saveText } from "./save.js";

const textOf = (button: HTMLElement): HTMLElement => document.getElementById(button.dataset.file!)!;

/** As the file has it: with the ends of lines that it had. */
function original(pre: HTMLElement): string {
  const text = pre.textContent ?? "";
  return pre.dataset.lineEnd === "crlf" ? text.replace(/\n/g, "\r\n") : text;
}

function say(button: HTMLElement, text: string): void {
  button.closest(".file")!.querySelector("[role=status]")!.textContent = text;
}

async function copy(button: HTMLElement): Promise<void> {
  const pre = textOf(button);
  const said = await copyText(original(pre), pre);
  if (said !== "Copied.") pre.closest("details")!.open = true;
  say(button, said);
}

function save(button: HTMLElement): void {
  const pre = textOf(button);
  saveText(original(pre), "text/plain", pre.dataset.name!);
  say(button, `Saved as ${pre.dataset.name}.`);
}

export function offerFiles(): void {
  const on = (what: string, act: (button: HTMLElement) => void): void =>
    document.querySelectorAll<HTMLElement>(what).forEach((button) => button.addEventListener("click", () => act(button)));
  on(".copy-file", (button) => void copy(button));
  on(".save-file", save);
}
