// What is enabled, what is refused, and the mode that is shown as a sentence.

import { byId, setHidden, setText } from "../dom.js";
import type { Moving } from "../modes/player.js";
import type { History } from "../numbers/history.js";
import type { Refusal } from "../protocol.js";
import { showWithNames, type Reveal } from "./names.js";

/** Enables the tools that have something to do. */
export function showTools(history: History, hasVariant: boolean): void {
  const enable = (id: string, isOn: boolean): void => {
    const element = byId<HTMLButtonElement>(id);
    if (element.disabled === isOn) element.disabled = !isOn;
  };
  enable("undo", history.canUndo);
  enable("redo", history.canRedo);
  enable("reset", Object.keys(history.present.numbers).length > 0);
  setText(byId("keep"), hasVariant ? "Keep as new A" : "Keep as A");
}

/** Shows why the tower is refused. */
export function showRefusal(refusal: Refusal["refused"] | null, reveal: Reveal): void {
  const text = refusal ? `Refused: ${sentences(refusal)}` : "";
  showWithNames(byId("refusal-text"), text, refusal?.parameters ?? [], reveal);
  setHidden(byId("refusal"), refusal === null);
}

/** What is shown is of the present tower, of one before whose successor is being solved, or of one
 * before while the present one has no answer. */
export type Freshness = "present" | "late" | "stale";

const WORDS: Record<Freshness, string> = { present: "", late: "solving…", stale: "last solved tower" };

/** Marks results of another tower than the present one; while it is solved, after a moment. */
export function showFreshness(freshness: Freshness): void {
  setText(byId("readout-state"), WORDS[freshness]);
  document.body.classList.toggle("stale", freshness === "stale");
  document.body.classList.toggle("late", freshness === "late");
}

/** Message and hint of the program as sentences. Names of numbers stay as they are. */
export function sentences({ message, hint }: Refusal["refused"]): string {
  const ended = (text: string): string => (/[.?!]$/.test(text) ? text : `${text}.`);
  if (hint === null) return ended(message);
  const begun = hint.replace(/^[a-z]+(?=[ ,])/, (word) => word.charAt(0).toUpperCase() + word.slice(1));
  return `${ended(message)} ${ended(begun)}`;
}

/** A mode with its frequency and, where this model governs, its verdict, for screen readers. */
export function spoken({ answer }: Moving, index: number, isJudged: boolean): string {
  const mode = answer.modes[index];
  if (mode === undefined) return "";
  const verdict = mode.verdict && isJudged ? `, ${mode.verdict.word}` : "";
  return `${mode.label}: ${mode.frequency} Hz${verdict}`;
}
