// The module of WebAssembly and the script that calls it, for Node.
import { build } from "esbuild";
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";

const here = (path) => fileURLToPath(new URL(path, import.meta.url));

export const root = here("../../");
export const page = here("../../target/web/explore.html");
export const wasm = here("../../target/web/towermodes_web.wasm");

/** The exports of src/web/solver.ts. */
export async function solverScript() {
  const { outputFiles } = await build({
    entryPoints: [here("../src/web/solver.ts")], bundle: true, write: false, format: "esm", platform: "node", target: "node20", logLevel: "warning",
  });
  return import(`data:text/javascript;base64,${Buffer.from(outputFiles[0].contents).toString("base64")}`);
}

export async function compiled() {
  return WebAssembly.compile(readFileSync(wasm));
}

/** Files of the repository as the page takes them, without their folders. */
export function filesOf(paths) {
  return paths.map((path) => ({ name: path.split("/").at(-1), content: readFileSync(`${root}${path}`) }));
}
