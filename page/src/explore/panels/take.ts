// What the user takes away: files of the program, the picture of the view, lines that reproduce the
// state.

import { button, byId, make, setText } from "../dom.js";
import { notice, withdraw } from "../notices.js";
import { reproduce, take } from "../program/program.js";
import type { State, Take } from "../protocol.js";
import { filmFormat } from "./picture.js";
import { save } from "./save.js";

export interface TakeSource {
  /** The state that is shown. */
  state(): State;
  /** What the names of files begin with: that of the tower and the mode. */
  name(): string;
  /** The picture of the view. */
  png(): Promise<Blob>;
  /** The mode in motion. */
  film(): Promise<Blob>;
  failed(error: unknown): void;
}

const FILES: [string, Take][] = [
  ["Tower file", { what: "tower" }],
  ["Report", { what: "report" }],
];
const PICTURES: [string, Take["what"]][] = [
  ["Tower", "tower-picture"],
  ["Mode shapes", "shapes-picture"],
  ["Resonance diagram", "resonance-picture"],
];

export class TakeMenu {
  private menu = byId<HTMLDetailsElement>("take");

  constructor(private source: TakeSource, hasRotor: () => boolean) {
    const list = byId("take-list");
    for (const [text, what] of FILES) list.append(button(text, () => this.load(what)));
    const pictures = PICTURES.map(([text, what]) => {
      const formats = (["svg", "png"] as const).map((format) => {
        const element = button(format.toUpperCase(), () => this.load({ what, format }));
        element.setAttribute("aria-label", `${text} as ${format.toUpperCase()}`);
        return element;
      });
      return make("div", "pictures", make("span", "", text), ...formats);
    });
    const view = button("PNG", () => this.run(this.source.png().then((made) => save(`${this.source.name()}.png`, made))));
    view.setAttribute("aria-label", "View as PNG");
    list.append(...pictures, make("div", "pictures", make("span", "", "View"), ...this.film(), view));
    list.append(button("Shell and Python lines…", () => this.run(this.showLines())));
    this.menu.addEventListener("toggle", () => {
      const last = pictures.at(-1);
      if (last) last.hidden = !hasRotor();
    });
    this.closeByItself();
    this.offerCopies();
  }

  /** The button of the film, where the browser makes one. */
  private film(): HTMLButtonElement[] {
    const format = filmFormat();
    if (format === null) return [];
    const ending = format.includes("webm") ? "webm" : "mp4";
    const film = button("Film", () => {
      notice("film", "The film is being recorded: one period of the mode.");
      this.run(this.source.film().then((made) => save(`${this.source.name()}.${ending}`, made)).finally(() => withdraw("film")));
    });
    film.setAttribute("aria-label", "Mode in motion as a film");
    return [film];
  }

  /** A menu closes by Escape, by a click elsewhere, and when the focus leaves it. */
  private closeByItself(): void {
    const { menu } = this;
    menu.addEventListener("keydown", (event) => {
      if (event.key !== "Escape" || !menu.open) return;
      menu.open = false;
      menu.querySelector("summary")?.focus();
    });
    document.addEventListener("pointerdown", (event) => {
      if (!menu.contains(event.target as Node)) menu.open = false;
    });
    menu.addEventListener("focusout", (event) => {
      if (event.relatedTarget !== null && !menu.contains(event.relatedTarget as Node)) menu.open = false;
    });
  }

  private load(what: Take): void {
    this.run(this.saved(what));
  }

  private async saved(what: Take): Promise<void> {
    const state = this.source.state();
    const { name, content } = await take(state, what);
    save(name, content);
    if (what.what !== "tower") return;
    const { left_out } = await reproduce(state);
    if (left_out.length > 0) notice("taken", `${name} does not contain all data of the old file. ${left_out.join(" ")}`);
    else withdraw("taken");
  }

  private run(work: Promise<void>): void {
    this.menu.open = false;
    work.catch((error: unknown) => this.source.failed(error));
  }

  private async showLines(): Promise<void> {
    const { shell, python } = await reproduce(this.source.state());
    setText(byId("shell"), shell);
    setText(byId("python"), python);
    setText(byId("copied"), "");
    byId<HTMLDialogElement>("reproduction").showModal();
  }

  private offerCopies(): void {
    for (const element of document.querySelectorAll<HTMLElement>("[data-copy]")) {
      element.addEventListener("click", () => void copy(byId(element.dataset["copy"] ?? "")));
    }
  }
}

/** Copies a text, or selects it if the browser does not allow that. */
async function copy(source: HTMLElement): Promise<void> {
  try {
    await navigator.clipboard.writeText(source.textContent ?? "");
    setText(byId("copied"), "Copied.");
  } catch {
    getSelection()?.selectAllChildren(source);
    setText(byId("copied"), "The browser does not allow copying. The lines are selected: copy them by Ctrl-C.");
  }
}
