// Tables to take along: copied for a spreadsheet, or saved as CSV, with all digits.

import { button, make } from "../dom.js";
import { say } from "../notices.js";
import { save } from "./save.js";

/** The rows of a table as it is shown; numbers have all their digits. */
export function rowsOf(table: HTMLTableElement): string[][] {
  const rows = [...table.rows].map((row) => [...row.cells].filter((cell) => cell.offsetParent !== null).map(textOf));
  return rows.filter((row) => row.length > 0);
}

function textOf(cell: HTMLTableCellElement): string {
  if (cell.dataset["full"] !== undefined) return cell.dataset["full"];
  const name = cell.querySelector(".mode-name");
  return plain((name ?? cell).textContent ?? "");
}

/** A minus sign is one of programs too, and spaces that align are none. */
export function plain(text: string): string {
  return text.replaceAll("\u2212", "-").replaceAll("\u2007", "").trim();
}

/** Lines with commas; a cell with a comma, a quote or a line end is quoted. */
export function csv(rows: string[][]): string {
  const cell = (text: string): string => (/[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);
  return rows.map((row) => row.map(cell).join(",")).join("\n") + "\n";
}

/** What a spreadsheet takes from the clipboard. */
export function tabbed(rows: string[][]): string {
  return rows.map((row) => row.map((text) => text.replaceAll(/[\t\n]/g, " ")).join("\t")).join("\n");
}

/** Puts the two buttons of a table beside its title. */
export function offerTable(host: HTMLElement, table: HTMLTableElement, name: () => string, what: string): void {
  const copy = button("Copy", () => void copied(tabbed(rowsOf(table)), copy), "small");
  const file = button("CSV", () => save(`${name()}-${what}.csv`, new Blob([csv(rowsOf(table))], { type: "text/csv" })), "small");
  copy.setAttribute("aria-label", `Copy the table of ${what}`);
  file.setAttribute("aria-label", `Save the table of ${what} as CSV`);
  host.append(make("span", "buttons", copy, file));
}

async function copied(text: string, from: HTMLButtonElement): Promise<void> {
  try {
    await navigator.clipboard.writeText(text);
    from.textContent = "Copied";
    say("Copied");
  } catch {
    from.textContent = "Not allowed";
    say("The browser does not allow copying");
  }
  setTimeout(() => (from.textContent = "Copy"), 1500);
}
