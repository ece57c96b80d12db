// Answers the questions of the page in the page itself.

import type { Program, Reply } from "../explore/program/program.js";
import { Failed, Kind, parts, Solver, type Answer, type NamedFile } from "./solver.js";

/** The status of answers that are not ok. */
const CONFLICT = 409;

/** The program that has the tower of files. */
export async function programOf(module: WebAssembly.Module, files: NamedFile[]): Promise<Program> {
  let solver = await Solver.open(module, files);
  return async (question, body) => {
    try {
      return replyOf(solver.ask(question, body));
    } catch (error) {
      if (!(error instanceof Failed)) throw error;
      // The instance is broken, the module is not.
      solver = await Solver.open(module, files);
      throw new Error(`The solver failed with these values, which is a bug: ${error.message}`);
    }
  };
}

/** The answer as a server gives it; its JSON is there without waiting for a task of the browser. */
function replyOf({ kind, content }: Answer): Reply {
  const isFile = kind === Kind.File;
  const { name, mediaType, content: body } = isFile ? parts(content) : { name: "", mediaType: "", content };
  const text = (): string => new TextDecoder().decode(body);
  return {
    ok: kind === Kind.Json || isFile,
    status: CONFLICT,
    headers: { get: () => (isFile ? `attachment; filename="${name}"` : null) },
    json: async () => JSON.parse(text()) as unknown,
    text: async () => text(),
    blob: async () => new Blob([body], { type: mediaType }),
  };
}
