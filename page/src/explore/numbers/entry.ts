// Numbers as people type them, and as fields show them.

/** A number, or the sentence that says why the text is none. */
export type Entry = { value: number } | { problem: string };

/** A number with a unit after it: `60 mm`, `12 kN/m`, `4e7 kg m2`. */
const WITH_UNIT = /^([+-]?\d+\.?\d*(?:e[+-]?\d+)?)\s*([a-z°%][a-z²³\d/ ]*)$/i;

/** Prefixes before the unit of a field. */
const PREFIXES: Record<string, number> = { k: 1e3, M: 1e6, G: 1e9 };

const NUMBER = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i;

/** Reads a number with a decimal point: `0.03`, `-12`, `3.6e5`. The unit of its field is used in the
 * sentence about a number with a unit. */
export function readNumber(typed: string, unit = ""): Entry {
  const text = typed.trim().replace("−", "-");
  if (text === "") return { problem: "Type a number, for example 3.6e5." };
  if (NUMBER.test(text)) {
    const value = Number(text);
    return Number.isFinite(value) ? { value } : { problem: `${text} is too large.` };
  }
  const pointed = text.replace(",", ".");
  const whole = text.replaceAll(",", "");
  if (/^[+-]?\d{1,3}(,\d{3})+$/.test(text)) {
    const decimal = NUMBER.test(pointed) ? `, or ${pointed} with a point` : "";
    return { problem: `Write ${whole} without commas${decimal}.` };
  }
  if (NUMBER.test(pointed)) return { problem: `Write ${pointed} with a point.` };
  const [, number, given] = WITH_UNIT.exec(text) ?? [];
  if (number !== undefined && given !== undefined) return { problem: withoutUnit(Number(number), given, unit) };
  return { problem: `“${text}” is not a number. Type digits with a decimal point, for example 3.6e5.` };
}

/** What to write in place of a number with a unit, in the unit of the field. */
function withoutUnit(value: number, given: string, unit: string): string {
  if (unit === "") return `Write ${writeNumber(value)} without a unit.`;
  const factor = factorOf(given.replace("²", "2").replace("³", "3"), unit);
  return factor === null ? `Write the number in ${unit}, without a unit.` : `Write ${writeNumber(tidy(value * factor))}: the field is in ${unit}.`;
}

/** How many of a unit are one of a given unit; null if unknown. */
function factorOf(given: string, unit: string): number | null {
  if (given === unit) return 1;
  if (unit === "m" && (given === "mm" || given === "cm")) return given === "mm" ? 1e-3 : 1e-2;
  if (unit.startsWith("kg") && given === `t${unit.slice(2)}`) return 1e3;
  return given.slice(1) === unit ? PREFIXES[given.charAt(0)] ?? null : null;
}

/** The shortest text that reads back as the same number; an infinite stiffness is no number. */
export function writeNumber(value: number): string {
  if (value === Infinity) return "rigid";
  const size = Math.abs(value);
  if (size !== 0 && (size >= 1e7 || size < 1e-4)) return value.toExponential().replace("e+", "e");
  return String(value);
}

/** What a field shows while nobody types in it: seven digits, and the whole exponent. */
export function writeShort(value: number): string {
  return writeNumber(Number(value.toPrecision(7)));
}

/** All digits of a number but the noise of its last bits, for who types: 3.25, not 3.2500000000000004. */
export function writeFull(value: number): string {
  return writeNumber(Number(value.toPrecision(15)));
}

/** Without the digits beyond twelve that a product of two short numbers gets. */
export function tidy(value: number): number {
  return Number(value.toPrecision(12));
}
