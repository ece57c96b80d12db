// The page in a Chromium: node web/browser.mjs CHROMIUM [SCREENSHOT]
import assert from "node:assert/strict";
import { writeFileSync } from "node:fs";
import { pathToFileURL } from "node:url";
import { after, before, test } from "node:test";
import { Chromium } from "./chromium.mjs";
import { page, root } from "./module.mjs";

const [program, screenshot] = process.argv.slice(2);
assert.ok(program, "which browser?");
const address = pathToFileURL(page).href;
const SHOWN = "window.towermodes?.isCurrent && !window.towermodes.pending";
const FIRST_HZ = "window.towermodes.answer.modes[0].frequency_hz";

let browser;
before(async () => {
  browser = await Chromium.start(program, 1440, 900);
});
after(() => browser.stop());

async function open(query) {
  await browser.call("Page.navigate", { url: address + query });
  await browser.until(`location.search === ${JSON.stringify(query)} && ${SHOWN}`);
}

/** Gives the page files as a user who chooses them. */
async function choose(...paths) {
  const { root: node } = await browser.call("DOM.getDocument", {});
  const { nodeId } = await browser.call("DOM.querySelector", { nodeId: node.nodeId, selector: "#source input[type=file]" });
  await browser.call("DOM.setFileInputFiles", { nodeId, files: paths.map((path) => `${root}${path}`) });
}

/** The name of the tower's file, on the name of the tower. */
const file = () => browser.value("document.querySelector('#file').title");
const text = (selector) => browser.value(`document.querySelector(${JSON.stringify(selector)})?.textContent ?? ""`);

test("the page opens from disk and solves the first example", async () => {
  await open("");
  assert.equal(await file(), "nrel-5mw.toml");
  // The value of the digits' test and of the README.
  assert.ok(Math.abs((await browser.value(FIRST_HZ)) - 0.3195) < 1e-4);
  if (screenshot) await picture(screenshot);
});

test("a slider moves the first frequency; times are measured", async () => {
  await open("?tower=monopile");
  const before = await browser.value(FIRST_HZ);
  await browser.value("document.querySelectorAll('#groups details').forEach((group) => { group.open = true; })");
  const times = await browser.value(`(async () => {
    const slider = [...document.querySelectorAll('#groups input[type=range]')].find((one) => one.max !== one.min);
    const [low, high] = [Number(slider.min), Number(slider.max)];
    const settled = async () => { do await new Promise(requestAnimationFrame); while (!(${SHOWN})); };
    const first = window.towermodes.timings.length;
    for (let step = 0; step < 120; step++) {
      slider.value = String(low + (high - low) * (0.25 + 0.5 * Math.abs((step % 40) / 20 - 1)));
      slider.dispatchEvent(new Event("input", { bubbles: true }));
      await new Promise(requestAnimationFrame);
    }
    slider.dispatchEvent(new Event("change", { bubbles: true }));
    await settled();
    return window.towermodes.timings.slice(first).map(({ event_ms, solve_ms, answer_ms }) => [event_ms, solve_ms, answer_ms]);
  })()`);
  const at = (column, share) => times.map((row) => row[column]).sort((a, b) => a - b)[Math.floor(share * (times.length - 1))].toFixed(1);
  const said = ["event to drawn result", "solve", "answer"].map((name, column) => `${name} ${at(column, 0.5)} ms, p95 ${at(column, 0.95)} ms`);
  console.log(`${times.length} events: ${said.join("; ")}`);
  assert.ok(times.length >= 100);
  assert.notEqual(await browser.value(FIRST_HZ), before);
});

test("files of the user are opened and survive a reload", async () => {
  await open("");
  await choose("examples/nrel-5mw_sections.dat", "examples/nrel-5mw.bmi");
  await browser.until(`location.search === "?tower=files" && ${SHOWN}`);
  assert.equal(await file(), "nrel-5mw.bmi");
  await browser.call("Page.reload", {});
  await browser.until(`performance.getEntriesByType("navigation")[0].type === "reload" && ${SHOWN}`);
  assert.equal(await file(), "nrel-5mw.bmi");
});

test("files without a tower are refused, and the tower that is shown stays", async () => {
  await open("?tower=monopile");
  await choose("examples/nrel-5mw.bmi");
  await browser.until(`document.querySelector("#notices").textContent.includes("nrel-5mw_sections.dat")`);
  await choose("README.md");
  await browser.until(`document.querySelector("#notices").textContent.includes("README.md")`);
  assert.equal(await file(), "monopile.toml");
});

test("what would need the program is told", async () => {
  await open("");
  await browser.value("[...document.querySelectorAll('#take-list button')].find((one) => one.textContent === 'Report').click()");
  await browser.until(`document.querySelector("#notices").textContent.includes("towermodes report nrel-5mw.toml")`);
});

test("nothing is fetched, and the console stays empty", () => {
  const requests = browser.events.filter(({ method }) => method === "Network.requestWillBeSent");
  const others = requests.map(({ params }) => params.request.url).filter((url) => !url.startsWith(address) && !/^(data|blob):/.test(url));
  assert.deepEqual(others, []);
  const methods = ["Runtime.exceptionThrown", "Runtime.consoleAPICalled", "Log.entryAdded"];
  const said = browser.events.filter(({ method }) => methods.includes(method)).map(({ params }) => params);
  const ofDriver = (params) => /GPU stall due to ReadPixels|swiftshader/i.test(JSON.stringify(params));
  assert.deepEqual(said.filter((params) => !ofDriver(params)), []);
});

async function picture(file) {
  const { data } = await browser.call("Page.captureScreenshot", {});
  writeFileSync(file, Buffer.from(data, "base64"));
}
