// Copies and saves the input files that the page repeats. Nothing is fetched; without this script
// the texts can be read and marked.

const textOf = (button: HTMLElement): HTMLElement => document.getElementById(button.dataset.file!)!;

/** As the file has it: with the ends of lines that it had. */
function original(pre: HTMLElement): string {
  const text = pre.textContent ?? "";
  return pre.dataset.lineEnd === "crlf" ? text.replace(/\n/g, "\r\n") : text;
}

function say(button: HTMLElement, text: string): void {
  button.closest(".file")!.querySelector("[role=status]")!.textContent = text;
}

/**
 * Pages from disk may not be allowed to write to the clipboard; what is marked can always be copied
 * by the reader.
 */
function mark(pre: HTMLElement): void {
  pre.closest("details")!.open = true;
  const selection = getSelection();
  selection?.removeAllRanges();
  selection?.selectAllChildren(pre);
}

async function copy(button: HTMLElement): Promise<void> {
  const pre = textOf(button);
  try {
    await navigator.clipboard.writeText(original(pre));
    say(button, "Copied.");
  } catch {
    mark(pre);
    say(button, "Selected: copy it with the keyboard.");
  }
}

function save(button: HTMLElement): void {
  const pre = textOf(button);
  const href = URL.createObjectURL(new Blob([original(pre)], { type: "text/plain;charset=utf-8" }));
  const link = Object.assign(document.createElement("a"), { href, download: pre.dataset.name! });
  link.click();
  URL.revokeObjectURL(href);
  say(button, `Saved as ${pre.dataset.name}.`);
}

export function offerFiles(): void {
  const on = (what: string, act: (button: HTMLElement) => void): void =>
    document.querySelectorAll<HTMLElement>(what).forEach((button) => button.addEventListener("click", () => act(button)));
  on(".copy-file", (button) => void copy(button));
  on(".save-file", save);
}
