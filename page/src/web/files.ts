// Which files the page shows: an example of the page, or files of the user, which survive a reload.

import { forgetPages, recall, remember } from "../explore/memory.js";
import type { NamedFile } from "./solver.js";

/** A tower that is part of the page. */
export interface Example {
  /** In the address: `?tower=monopile`. */
  key: string;
  title: string;
  name: string;
  text: string;
}

/** In the address, for the files of the user. */
const OWN = "files";
const MEMORY = "towermodes-files";

/** The examples of this page. */
export function examples(): Example[] {
  return JSON.parse(document.getElementById("examples")?.textContent ?? "[]") as Example[];
}

/** The example that the address names; null if it is the user's files. */
export function chosenExample(all: Example[]): Example | null {
  const key = new URLSearchParams(location.search).get("tower");
  if (key === OWN && recall(MEMORY) !== null) return null;
  return all.find((example) => example.key === key) ?? all[0] ?? null;
}

/** The file of an example. */
export function filesOf({ name, text }: Example): NamedFile[] {
  return [{ name, content: new TextEncoder().encode(text) }];
}

/** The files of the user from before a reload. */
export async function recallFiles(): Promise<NamedFile[]> {
  const packed = JSON.parse(recall(MEMORY) ?? "[]") as [string, string][];
  return Promise.all(packed.map(async ([name, content]) => ({ name, content: await unpacked(content) })));
}

/** Whether the tab could keep the files. */
export async function rememberFiles(files: NamedFile[]): Promise<boolean> {
  const text = JSON.stringify(await Promise.all(files.map(async ({ name, content }) => [name, await packed(content)])));
  // What was set on other files of the same names does not hold for these.
  forgetPages();
  remember(MEMORY, text);
  return recall(MEMORY) === text;
}

/** Shows an example, or the remembered files: the page begins anew. */
export function go(key: string | null): void {
  location.assign(`${location.pathname}?tower=${key ?? OWN}`);
}

/** Bytes of a compressed text in base64. */
export async function unpacked(text: string): Promise<Uint8Array<ArrayBuffer>> {
  const bytes = Uint8Array.from(atob(text), (character) => character.charCodeAt(0));
  return through(bytes, new DecompressionStream("gzip"));
}

async function packed(content: Uint8Array<ArrayBuffer>): Promise<string> {
  const bytes = await through(content, new CompressionStream("gzip"));
  const pieces: string[] = [];
  const most = 0x8000;
  for (let start = 0; start < bytes.length; start += most) {
    pieces.push(String.fromCharCode(...bytes.subarray(start, start + most)));
  }
  return btoa(pieces.join(""));
}

async function through(bytes: Uint8Array<ArrayBuffer>, stream: CompressionStream | DecompressionStream): Promise<Uint8Array<ArrayBuffer>> {
  const result = new Blob([bytes]).stream().pipeThrough(stream);
  return new Uint8Array(await new Response(result).arrayBuffer());
}
