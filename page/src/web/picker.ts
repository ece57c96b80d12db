// Where the user chooses a tower: an example from a list, or files that are opened or dropped.

import { button, byId, make } from "../explore/dom.js";
import { notice } from "../explore/notices.js";
import { go, rememberFiles, type Example } from "./files.js";
import { Solver, type NamedFile } from "./solver.js";

const KEY = "files";

export class Picker {
  private input = make("input");

  /** `chosen` is the example that is shown; null for files of the user. */
  constructor(private module: WebAssembly.Module, examples: Example[], chosen: Example | null) {
    this.input.type = "file";
    this.input.multiple = true;
    this.input.hidden = true;
    this.input.addEventListener("change", () => void this.open([...(this.input.files ?? [])]));
    const open = button("Open files…", () => this.input.click());
    open.id = "open-files";
    open.title = "Files of one tower; they can also be dropped on the page. They stay on this computer.";
    const tools = make("div", "tools", listOf(examples, chosen), open, this.input);
    tools.id = "source";
    byId("method").after(tools);
    this.listenToDrops();
  }

  private listenToDrops(): void {
    const mark = (isOver: boolean): void => void document.body.classList.toggle("dropping", isOver);
    const hasFiles = ({ dataTransfer }: DragEvent): boolean => dataTransfer?.types.includes("Files") ?? false;
    document.addEventListener("dragover", (event) => {
      if (!hasFiles(event)) return;
      event.preventDefault();
      mark(true);
    });
    document.addEventListener("dragleave", (event) => {
      if (event.relatedTarget === null) mark(false);
    });
    document.addEventListener("drop", (event) => {
      mark(false);
      if (!hasFiles(event)) return;
      event.preventDefault();
      void this.open([...(event.dataTransfer?.files ?? [])]);
    });
  }

  /** Shows the tower of files; the one that is shown stays if there is none in them. */
  private async open(chosen: File[]): Promise<void> {
    // The same files can be chosen again after they have been changed.
    const files = await read(chosen);
    this.input.value = "";
    if (files === null || files.length === 0) return;
    try {
      await Solver.open(this.module, files);
    } catch (error) {
      notice(KEY, error instanceof Error ? error.message : String(error));
      return;
    }
    if (await rememberFiles(files)) go(null);
    else notice(KEY, "The browser does not keep files of this size. The program towermodes opens them: towermodes explore ", files[0]?.name ?? "");
  }
}

function listOf(examples: Example[], chosen: Example | null): HTMLSelectElement {
  const list = make("select");
  list.id = "example";
  list.setAttribute("aria-label", "Tower");
  const option = (text: string, value: string): HTMLOptionElement => {
    const element = make("option", "", text);
    element.value = value;
    return element;
  };
  if (chosen === null) list.append(option("Opened files", ""));
  list.append(...examples.map(({ key, title }) => option(`Example: ${title}`, key)));
  list.value = chosen?.key ?? "";
  list.addEventListener("change", () => {
    if (list.value !== "") go(list.value);
  });
  return list;
}

async function read(files: File[]): Promise<NamedFile[] | null> {
  try {
    return await Promise.all(files.map(async (file) => ({ name: file.name, content: new Uint8Array(await file.arrayBuffer()) })));
  } catch {
    notice(KEY, "The browser cannot read the selection. Choose files, not folders.");
    return null;
  }
}
