// What survives a reload of the page, in the memory of its tab.

import type { Identity } from "./modes/follow.js";
import type { Steps } from "./numbers/history.js";
import type { State } from "./protocol.js";

export interface Memory {
  steps: Steps;
  variant: State | null;
  chosen: number | null;
  identities: Identity[];
  amplitude: string;
  speed: string;
  /** The names of the groups that are open. */
  open: string[] | null;
}

export function remember(key: string, text: string): void {
  try {
    sessionStorage.setItem(key, text);
  } catch {
    // A browser may refuse the memory, or it is full: only a reload will miss it.
  }
}

export function recall(key: string): string | null {
  try {
    return sessionStorage.getItem(key);
  } catch {
    return null;
  }
}

/** The memory of the page for a file; what is missing or broken is left out. */
export function recallPage(file: string): Partial<Memory> {
  try {
    return JSON.parse(recall(key(file)) ?? "{}") as Partial<Memory>;
  } catch {
    return {};
  }
}

export function rememberPage(file: string, memory: Memory): void {
  remember(key(file), JSON.stringify(memory));
}

/** Forgets what was set on any file. */
export function forgetPages(): void {
  try {
    const keys = Object.keys(sessionStorage).filter((name) => name.startsWith(PREFIX));
    for (const name of keys) sessionStorage.removeItem(name);
  } catch {
    // Nothing is remembered where the memory is refused.
  }
}

const PREFIX = "towermodes-explore ";

function key(file: string): string {
  return PREFIX + file;
}
