// Bundles the scripts of the pages into the crates that embed them. The Rust build uses these files
// as they are.
import { build } from "esbuild";

const report = "../crates/towermodes-report/src/built";
const explore = "../crates/towermodes-explore/src/built";

const common = {
  bundle: true,
  minify: true,
  format: "iife",
  target: "es2022",
  charset: "utf8",
  legalComments: "inline",
  logLevel: "warning",
};

await build({ ...common, entryPoints: ["src/report/index.ts"], outfile: `${report}/report.js` });
await build({ ...common, entryPoints: ["src/explore/index.ts"], outfile: `${explore}/explore.js` });
await build({ ...common, entryPoints: ["src/explore/explore.css"], outfile: `${explore}/explore.css` });
