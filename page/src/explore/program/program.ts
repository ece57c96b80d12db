// The program that answers the page, as functions.

import type {
  Answer, Band, Coupled, ElasticityQuestion, Elasticities, Found, Reproduction, Refusal, Sheet, State, Take, TargetQuestion, Whirl, WhirlQuestion,
} from "../protocol.js";

/** The program does not answer: it has ended. */
export class ProgramEnded extends Error {}

/** The program answers with an error status and a text. */
export class Refused extends Error {}

/** Answers a question with a status and a body, as the server of the page does. */
export type Program = (question: string, body: object | null, signal?: AbortSignal) => Promise<Reply>;

/** What the page reads of an answer. */
export type Reply = Pick<Response, "ok" | "status" | "json" | "text" | "blob"> & {
  headers: Pick<Headers, "get">;
};

let program: Program = served;

/** From now on another program answers. */
export function answerBy(other: Program): void {
  program = other;
}

export async function sheet(): Promise<Sheet> {
  const given = (await (await ask("sheet", null)).json()) as Sheet;
  given.parameters.forEach((parameter) => (parameter.value = orInfinite(parameter.value)));
  return given;
}

export async function solve(state: State): Promise<Answer | Refusal> {
  const result = (await (await ask("solve", state)).json()) as Answer | Refusal;
  if (result.refused === null) result.values = result.values.map(orInfinite);
  return result;
}

export const coupled = (state: State, signal: AbortSignal): Promise<Coupled | Refusal> => answered("coupled", state, signal);
export const whirl = (of: WhirlQuestion, signal: AbortSignal): Promise<Whirl | Refusal> => answered("whirl", of, signal);
export const band = (state: State, signal: AbortSignal): Promise<Band | Refusal> => answered("band", state, signal);
export const elasticities = (of: ElasticityQuestion, signal: AbortSignal): Promise<Elasticities | Refusal> => answered("elasticities", of, signal);
export const target = (of: TargetQuestion, signal: AbortSignal): Promise<Found | Refusal> => answered("target", of, signal);

async function answered<T>(question: string, body: object, signal: AbortSignal): Promise<T> {
  return (await (await ask(question, body, signal)).json()) as T;
}

/** JSON has no infinity: the program writes null for the stiffness of what is rigid. */
function orInfinite(value: number | null): number {
  return value ?? Infinity;
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

async function ask(question: string, body: object | null, signal?: AbortSignal): Promise<Reply> {
  const response = await program(question, body, signal);
  if (!response.ok) throw new Refused((await response.text()).trim() || `The program answers with status ${response.status}.`);
  return response;
}

/** The program that serves this page. */
function served(question: string, body: object | null, signal?: AbortSignal): Promise<Response> {
  return fetch(question, body === null ? {} : {
    method: "POST", body: JSON.stringify(body), headers: { "Content-Type": "application/json" }, signal: signal ?? null,
  }).catch((error: unknown) => {
    if (signal?.aborted) throw error;
    throw new ProgramEnded();
  });
}
