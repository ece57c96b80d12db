// The colours of the page: as the system has them, or dark, or light; the same choice as in a
// report.

import { byId } from "./dom.js";
import { recall, remember } from "./memory.js";

const THEMES = ["auto", "dark", "light"];
const KEY = "towermodes-theme";

/** Takes up the choice from before a reload, and changes it by the button. */
export function offerThemes(): void {
  const set = (theme: string): void => {
    document.documentElement.dataset["theme"] = theme;
    byId("theme").textContent = `Colours: ${theme}`;
  };
  const before = recall(KEY);
  set(before !== null && THEMES.includes(before) ? before : "auto");
  byId("theme").addEventListener("click", () => {
    const index = THEMES.indexOf(document.documentElement.dataset["theme"] ?? "auto");
    const theme = THEMES[(index + 1) % THEMES.length] ?? "auto";
    set(theme);
    remember(KEY, theme);
  });
}
