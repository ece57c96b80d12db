// Chooses the colours of the page and opens everything for paper. Nothing is fetched; without this script nothing is missing.
(() => {
"use strict";

document.documentElement.classList.add("has-script");
const byId = (id) => document.getElementById(id);

// Colours: as the system has them, or dark, or light, for the visit.

const THEMES = ["auto", "dark", "light"];

function remember(theme) {
  try { sessionStorage.setItem("towermodes-theme", theme); } catch { /* A page opened from disk may have no memory. */ }
}

function remembered() {
  try { return sessionStorage.getItem("towermodes-theme"); } catch { return null; }
}

function setTheme(theme) {
  document.documentElement.dataset.theme = theme;
  byId("theme").textContent = `Colours: ${theme}`;
}

function nextTheme() {
  const theme = THEMES[(THEMES.indexOf(document.documentElement.dataset.theme) + 1) % THEMES.length];
  setTheme(theme);
  remember(theme);
}

// What the page says of itself holds unless the reader chose otherwise.
const given = document.documentElement.dataset.theme;
setTheme([remembered(), given].find((theme) => THEMES.includes(theme)) ?? "auto");
byId("theme").addEventListener("click", nextTheme);

// Paper shows everything.

let opened = [];

window.addEventListener("beforeprint", () => {
  opened = [...document.querySelectorAll("details:not([open])")];
  opened.forEach((details) => { details.open = true; });
});
window.addEventListener("afterprint", () => opened.forEach((details) => { details.open = false; }));
})();
