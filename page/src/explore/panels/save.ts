// Files that the page makes itself.

import { make } from "../dom.js";

/** Lets the browser save a file. */
export function save(name: string, content: Blob): void {
  const link = make("a");
  link.href = URL.createObjectURL(content);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}

/** The name of a file without folder and ending, in characters that every system allows. */
export function stemOf(file: string): string {
  const name = file.split(/[\\/]/).at(-1) ?? "";
  const stem = name.includes(".") ? name.slice(0, name.lastIndexOf(".")) : name;
  return stem.replaceAll(/[^\w-]/g, "-").replaceAll(/^-+|-+$/g, "") || "tower";
}
