// Makes the page without a server: one file with its styles, its scripts, the solver and examples.
import { build } from "esbuild";
import { createHash } from "node:crypto";
import { readFileSync, writeFileSync } from "node:fs";
import { gzipSync } from "node:zlib";
import { compiled, page, root, solverScript, wasm } from "./module.mjs";

const EXAMPLES = [
  { key: "nrel-5mw", title: "NREL 5 MW, clamped at its base", name: "nrel-5mw.toml" },
  { key: "monopile", title: "monopile in soil and water", name: "monopile.toml" },
];

const read = (path) => readFileSync(`${root}${path}`, "utf8");

async function bundled(entry) {
  const { outputFiles } = await build({
    entryPoints: [`${root}page/src/${entry}`], bundle: true, minify: true, write: false, format: "iife", target: "es2022", charset: "utf8",
    legalComments: "inline", logLevel: "warning",
  });
  return outputFiles[0].text;
}

/** The content of an element that ends at its first end tag. */
function inside(tag, text) {
  if (new RegExp(`</${tag}|<!--`, "i").test(text)) throw new Error(`the content of <${tag}> would end it, or begin a comment`);
  return text;
}

const hash = (text) => `'sha256-${createHash("sha256").update(text).digest("base64")}'`;

async function colours() {
  const { Solver } = await solverScript();
  return (await Solver.start(await compiled())).colours();
}

const styles = [await colours(), await bundled("explore/explore.css"), await bundled("web/web.css")].map((text) => inside("style", text));
const scripts = [await bundled("web/index.ts")].map((text) => inside("script", text));
const solver = gzipSync(readFileSync(wasm), { level: 9 }).toString("base64");
const examples = EXAMPLES.map((example) => ({ ...example, text: read(`examples/${example.name}`) }));

const policy = [
  "default-src 'none'",
  `script-src 'wasm-unsafe-eval' ${scripts.map(hash).join(" ")}`,
  `style-src ${styles.map(hash).join(" ")}`,
  "img-src blob: data:",
  "base-uri 'none'",
  "form-action 'none'",
].join("; ");

const head = [
  `<meta http-equiv="Content-Security-Policy" content="${policy}">`,
  ...styles.map((text) => `<style>${text}</style>`),
];
const tail = [
  `<script type="application/json" id="examples">${JSON.stringify(examples).replaceAll("<", "\\u003c")}</script>`,
  `<script type="text/plain" id="solver">${solver}</script>`,
  ...scripts.map((text) => `<script>${text}</script>`),
];

/**
 * The page of the program without the links to its files, with these at the ends of head and body.
 */
function assembled(html) {
  const links = /<(link rel="stylesheet" href="[^"]*"|script src="[^"]*" defer)>(<\/script>)?\n/g;
  const count = html.match(links)?.length ?? 0;
  if (count !== 3) throw new Error(`page.html has ${count} links to styles and scripts, not 3`);
  const [before, after] = html.replace(links, "").split("</head>");
  const charset = '<meta charset="utf-8">\n';
  if (!before.includes(charset)) throw new Error(`page.html has no ${charset}`);
  return before.replace(charset, () => `${charset}${head.join("\n")}\n`) + "</head>" + after.replace("</body>", () => `${tail.join("\n")}\n</body>`);
}

const html = assembled(read("crates/towermodes-explore/src/page.html"));
writeFileSync(page, html);
const kilobytes = (bytes) => `${Math.round(bytes / 1000)} kB`;
const bytes = readFileSync(wasm);
console.log(`solver ${kilobytes(bytes.length)}, compressed ${kilobytes(gzipSync(bytes, { level: 9 }).length)}`);
console.log(`page ${kilobytes(Buffer.byteLength(html))}, compressed ${kilobytes(gzipSync(html, { level: 9 }).length)}: ${page}`);
