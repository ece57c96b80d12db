// Saves a text of the page as a file. Nothing is fetched.

/** Hands a text to the reader as a file. */
export function saveText(text: string, type: string, name: string): void {
  const href = URL.createObjectURL(new Blob([text], { type: `${type};charset=utf-8` }));
  Object.assign(document.createElement("a"), { href, download: name }).click();
  URL.revokeObjectURL(href);
}

/** Marks what the browser does not let the page copy: the reader can. */
export function mark(element: Element): void {
  const selection = getSelection();
  selection?.removeAllRanges();
  selection?.selectAllChildren(element);
}

/** Copies a text, or marks an element where the browser does not allow it; says which. */
export async function copyText(text: string, element: Element): Promise<string> {
  try {
    await navigator.clipboard.writeText(text);
    return "Copied.";
  } catch {
    // Pages from disk may not be allowed to write to the clipboard.
    mark(element);
    return "Selected: copy it with the keyboard.";
  }
}
