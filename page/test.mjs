// Bundles each test and runs it with Node's test runner.
import { build } from "esbuild";
import { spawnSync } from "node:child_process";
import { mkdtempSync, readdirSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

const ending = ".test.ts";
const tests = readdirSync("src", { recursive: true }).filter((file) => file.endsWith(ending)).sort();
const folder = mkdtempSync(join(tmpdir(), "towermodes-page-"));
await build({
  entryPoints: tests.map((file) => join("src", file)),
  bundle: true,
  outdir: folder,
  outbase: "src",
  outExtension: { ".js": ".mjs" },
  platform: "node",
  format: "esm",
  target: "node20",
  sourcemap: "inline",
  logLevel: "warning",
});
const built = tests.map((file) => join(folder, file.replace(/\.ts$/, ".mjs")));
const { status } = spawnSync(process.execPath, ["--enable-source-maps", "--test", ...built], { stdio: "inherit" });
rmSync(folder, { recursive: true });
process.exit(status ?? 1);
