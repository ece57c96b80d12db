// Copies and saves the input files that the page repeats. Nothing is fetched; without this script the texts can be read and marked.
(() => {
"use strict";

const textOf = (button) => document.getElementById(button.dataset.file);

// As the file has it: with the ends of lines that it had.
function original(pre) {
  return pre.dataset.lineEnd === "crlf" ? pre.textContent.replace(/\n/g, "\r\n") : pre.textContent;
}

function say(button, text) {
  button.closest(".file").querySelector("[role=status]").textContent = text;
}

// Pages from disk may not be allowed to write to the clipboard; what is marked can always be copied by the reader.
function mark(pre) {
  pre.closest("details").open = true;
  const selection = getSelection();
  selection.removeAllRanges();
  selection.selectAllChildren(pre);
}

async function copy(button) {
  const pre = textOf(button);
  try {
    await navigator.clipboard.writeText(original(pre));
    say(button, "Copied.");
  } catch {
    mark(pre);
    say(button, "Selected: copy it with the keyboard.");
  }
}

function save(button) {
  const pre = textOf(button);
  const address = URL.createObjectURL(new Blob([original(pre)], { type: "text/plain;charset=utf-8" }));
  const link = document.createElement("a");
  link.href = address;
  link.download = pre.dataset.name;
  link.click();
  URL.revokeObjectURL(address);
  say(button, `Saved as ${pre.dataset.name}.`);
}

document.querySelectorAll(".copy-file").forEach((button) => button.addEventListener("click", () => copy(button)));
document.querySelectorAll(".save-file").forEach((button) => button.addEventListener("click", () => save(button)));
})();
