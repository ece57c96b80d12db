// Starts the page.

import { byId, make, setText } from "./dom.js";
import { Explorer } from "./explorer.js";
import { notice } from "./notices.js";
import { sheet } from "./program/program.js";
import type { Timing } from "./program/timings.js";
import type { Answer, Coupled, Sheet, State } from "./protocol.js";
import { offerThemes } from "./theme.js";

declare global {
  interface Window {
    /** For tests, read only: the numbers that are set, the answer that is shown, measured times,
     * whether an answer is to come. */
    towermodes: {
      readonly state: State;
      readonly answer: Answer | null;
      readonly timings: readonly Timing[];
      readonly pending: boolean;
      readonly isCurrent: boolean;
      /** The coupled diagram of a turbine. */
      readonly turbine: Coupled | null;
    };
  }
}

export async function start(): Promise<void> {
  offerThemes();
  skipWithoutAddress();
  try {
    const given = await sheet();
    describe(given);
    window.towermodes = new Explorer(given).forTests();
  } catch (error) {
    notice("program", error instanceof Error && error.message ? error.message : "The program does not answer. Start it again.");
  }
}

function describe({ name, file, format, version, command, notes }: Sheet): void {
  const title = name === file ? file.split(/[\\/]/).at(-1) ?? file : name;
  document.title = `${title} – towermodes`;
  setText(byId("file"), name);
  byId("file").title = file;
  setText(byId("program"), `towermodes ${version} · ${format} · ${command}`);
  byId("notes").hidden = notes.length === 0;
  byId("notes").querySelector("ul")?.append(...notes.map((note) => make("li", "", note)));
}

/** Links to parts of the page; the address is that of the numbers. */
function skipWithoutAddress(): void {
  for (const link of document.querySelectorAll<HTMLElement>("[data-skip]")) {
    link.addEventListener("click", (event) => {
      event.preventDefault();
      byId(link.dataset["skip"] ?? "").focus();
    });
  }
}
