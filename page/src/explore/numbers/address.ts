// A state in the address of the page: `rna.mass=360000&stations[0].wall=0.03` after the #.

import type { Parameter, State } from "../protocol.js";
import { readNumber } from "./entry.js";

/** The part of an address after the #, without it. Names stay readable; what addresses cannot
 * have is encoded. */
export function toAddress(state: State): string {
  const entries = Object.entries(state.numbers);
  return entries.map(([name, value]) => `${encodeName(name)}=${value}`).join("&");
}

function encodeName(name: string): string {
  return encodeURIComponent(name).replaceAll("%5B", "[").replaceAll("%5D", "]");
}

/** A state from an address, and a sentence for each part that is not used. */
export function fromAddress(hash: string, parameters: Parameter[]): { state: State; problems: string[] } {
  const known = new Map(parameters.map((parameter) => [parameter.name, parameter]));
  const state: State = { numbers: {} };
  const problems: string[] = [];
  for (const part of hash.replace(/^#/, "").split("&")) {
    if (part === "") continue;
    const [name, text] = nameAndText(part);
    const parameter = known.get(name);
    const entry = readNumber(text);
    if (parameter === undefined) problems.push(`The address names “${name}”, which is not an input value of this page. It is not used.`);
    else if ("problem" in entry) problems.push(`The address has “${text}” for ${name}, which is not a number. It is not used.`);
    else if (entry.value !== parameter.value) state.numbers[name] = entry.value;
  }
  return { state, problems };
}

function nameAndText(part: string): [string, string] {
  const at = part.lastIndexOf("=");
  return at < 0 ? [decode(part), ""] : [decode(part.slice(0, at)), decode(part.slice(at + 1))];
}

function decode(text: string): string {
  try {
    return decodeURIComponent(text);
  } catch {
    return text;
  }
}
