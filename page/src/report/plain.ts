// Cells as programs read them: numbers with digits of the keyboard, rows as CSV or for a clipboard.

const SUPERSCRIPTS = "\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079";

const digit = (raised: string): string => (raised === "\u207b" ? "-" : String(SUPERSCRIPTS.indexOf(raised)));

/** A cell as a program reads it: "−1.5·10⁻⁷" is "-1.5e-7"; a dash for no value is nothing. */
export function plain(text: string): string {
  if (text.trim() === "\u2013") return "";
  return text.trim()
    .replace(/\u00a0/g, " ")
    .replace(/(\d)\u00b710([\u207b\u2070\u00b9\u00b2\u00b3\u2074-\u2079]+)/g, (_, last: string, power: string) => `${last}e${[...power].map(digit).join("")}`)
    .replace(/\u2212(?=\d)/g, "-");
}

const quoted = (cell: string): string => (/[",\r\n]/.test(cell) ? `"${cell.replace(/"/g, '""')}"` : cell);

/** Rows as a file (RFC 4180). */
export const toCsv = (rows: string[][]): string => rows.map((row) => `${row.map(quoted).join(",")}\r\n`).join("");

/** Rows as spreadsheets take them from a clipboard. */
export const toTabs = (rows: string[][]): string =>
  rows.map((row) => row.map((cell) => cell.replace(/[\t\n]+/g, " ")).join("\t")).join("\n");
