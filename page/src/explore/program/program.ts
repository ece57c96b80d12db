// The program that serves the page, as functions.

import type { Answer, Elasticities, Reproduction, Refusal, Sheet, State, Take } from "../protocol.js";

/** The program does not answer: it has ended. */
export class ProgramEnded extends Error {}

/** The program answers with an error status and a text. */
export class Refused extends Error {}

export function sheet(): Promise<Sheet> {
  return ask("sheet", null).then((response) => response.json() as Promise<Sheet>);
}

export function solve(state: State): Promise<Answer | Refusal> {
  return ask("solve", state).then((response) => response.json() as Promise<Answer | Refusal>);
}

export function elasticities(state: State, mode: number): Promise<Elasticities | Refusal> {
  return ask("elasticities", { ...state, mode }).then((response) => response.json() as Promise<Elasticities | Refusal>);
}

export function reproduce(state: State): Promise<Reproduction> {
  return ask("reproduce", state).then((response) => response.json() as Promise<Reproduction>);
}

/** A file with the name that the program gives it. */
export async function take(state: State, what: Take): Promise<{ name: string; content: Blob }> {
  const response = await ask("take", { ...state, ...what });
  if (response.headers.get("Content-Type") === "application/json") {
    throw new Refused(((await response.json()) as Refusal).refused.message);
  }
  const disposition = response.headers.get("Content-Disposition") ?? "";
  const name = /filename="([^"]+)"/.exec(disposition)?.[1] ?? `towermodes.${what.format ?? "txt"}`;
  return { name, content: await response.blob() };
}

async function ask(address: string, body: object | null): Promise<Response> {
  const response = await fetch(address, body === null ? {} : {
    method: "POST", body: JSON.stringify(body), headers: { "Content-Type": "application/json" },
  }).catch(() => {
    throw new ProgramEnded();
  });
  if (!response.ok) throw new Refused((await response.text()).trim() || `The program answers with status ${response.status}.`);
  return response;
}
