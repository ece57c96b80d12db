// The page without a server: the solver is part of it.

import { byId } from "../explore/dom.js";
import { start } from "../explore/main.js";
import { notice } from "../explore/notices.js";
import { answerBy } from "../explore/program/program.js";
import { chosenExample, examples, filesOf, recallFiles, unpacked } from "./files.js";
import { Picker } from "./picker.js";
import { programOf } from "./program.js";

async function open(): Promise<void> {
  const module = await WebAssembly.compile(await unpacked(byId("solver").textContent ?? ""));
  const all = examples();
  const example = chosenExample(all);
  new Picker(module, all, example);
  answerBy(await programOf(module, example === null ? await recallFiles() : filesOf(example)));
  await start();
}

open().catch((error: unknown) => {
  notice("program", `The page cannot start: ${error instanceof Error ? error.message : String(error)}`);
});
