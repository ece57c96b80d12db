// Chooses the colours of the page and opens everything for paper. Nothing is fetched; without this
// script nothing is missing.

/** Colours: as the system has them, or dark, or light, for the visit. */
const THEMES = ["auto", "dark", "light"];
const KEY = "towermodes-theme";
const root = document.documentElement;

function remember(theme: string): void {
  try { sessionStorage.setItem(KEY, theme); } catch { /* A page opened from disk may have no memory. */ }
}

function remembered(): string | null {
  try { return sessionStorage.getItem(KEY); } catch { return null; }
}

export function preparePage(): void {
  root.classList.add("has-script");
  const button = document.getElementById("theme")!;
  const setTheme = (theme: string): void => {
    root.dataset.theme = theme;
    button.textContent = `Colours: ${theme}`;
  };
  // What the page says of itself holds unless the reader chose otherwise.
  setTheme([remembered(), root.dataset.theme].find((theme) => theme != null && THEMES.includes(theme)) ?? "auto");
  button.addEventListener("click", () => {
    const theme = THEMES[(THEMES.indexOf(root.dataset.theme!) + 1) % THEMES.length]!;
    setTheme(theme);
    remember(theme);
  });
  // Paper shows everything.
  let opened: HTMLDetailsElement[] = [];
  window.addEventListener("beforeprint", () => {
    opened = [...document.querySelectorAll<HTMLDetailsElement>("details:not([open])")];
    opened.forEach((details) => { details.open = true; });
  });
  window.addEventListener("afterprint", () => opened.forEach((details) => { details.open = false; }));
}
