// A Chromium without a window, driven through a pipe: the Chrome DevTools Protocol in JSON, each
// message ends with a zero byte.
import { spawn } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

const PATIENCE_MS = 30_000;

export class Chromium {
  #last = 0;
  #waiting = new Map();
  #session = undefined;
  #profile = mkdtempSync(join(tmpdir(), "towermodes-chromium-"));
  /** Events so far. */
  events = [];

  /** A browser with an empty page. */
  static async start(program, width, height) {
    const browser = new Chromium(program, width, height);
    const { targetId } = await browser.call("Target.createTarget", { url: "about:blank" });
    const { sessionId } = await browser.call("Target.attachToTarget", { targetId, flatten: true });
    browser.#session = sessionId;
    for (const domain of ["Page", "Runtime", "Log", "Network", "DOM"]) await browser.call(`${domain}.enable`, {});
    return browser;
  }

  constructor(program, width, height) {
    const options = [
      "--headless", "--remote-debugging-pipe", "--no-sandbox", "--disable-dev-shm-usage", "--no-first-run",
      "--disable-background-networking", "--disable-extensions", "--force-color-profile=srgb", "--hide-scrollbars",
      "--disable-gpu", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
      `--window-size=${width},${height}`, `--user-data-dir=${this.#profile}`,
    ];
    this.process = spawn(program, options, { stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"] });
    let rest = "";
    const replies = this.process.stdio[4];
    replies.setEncoding("utf8");
    replies.on("data", (data) => {
      const messages = (rest + data).split("\0");
      rest = messages.pop();
      for (const message of messages) this.#receive(JSON.parse(message));
    });
  }

  #receive(message) {
    const waiting = this.#waiting.get(message.id);
    if (waiting === undefined) this.events.push(message);
    else if (message.error) waiting.reject(new Error(message.error.message));
    else waiting.resolve(message.result);
  }

  call(method, params) {
    const id = ++this.#last;
    const sessionId = this.#session;
    return new Promise((resolve, reject) => {
      const late = setTimeout(() => reject(new Error(`${method}: no answer`)), PATIENCE_MS);
      const done = (action) => (value) => {
        clearTimeout(late);
        this.#waiting.delete(id);
        action(value);
      };
      this.#waiting.set(id, { resolve: done(resolve), reject: done(reject) });
      this.process.stdio[3].write(`${JSON.stringify({ id, method, params, sessionId })}\0`);
    });
  }

  /** The value of an expression in the page; a promise is awaited. */
  async value(expression) {
    const { result, exceptionDetails } = await this.call("Runtime.evaluate", { expression, awaitPromise: true, returnByValue: true });
    if (exceptionDetails) throw new Error(`${expression}: ${exceptionDetails.exception?.description ?? exceptionDetails.text}`);
    return result.value;
  }

  /** Waits until an expression holds. */
  async until(expression) {
    const end = Date.now() + PATIENCE_MS;
    while (Date.now() < end) {
      // A page that is being loaded has no objects yet.
      if (await this.value(expression).catch(() => false)) return;
      await new Promise((resolve) => setTimeout(resolve, 50));
    }
    throw new Error(`it never holds: ${expression}`);
  }

  async stop() {
    const ended = new Promise((resolve) => this.process.once("exit", resolve));
    this.process.kill();
    await ended;
    rmSync(this.#profile, { recursive: true, force: true, maxRetries: 5 });
  }
}
