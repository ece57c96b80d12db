// The digits of the module against those of the program: node web/digits.mjs PROGRAM
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { test } from "node:test";
import { compiled, filesOf, root, solverScript } from "./module.mjs";

const program = process.argv[2];
assert.ok(program, "which program?");

/** Functions such as sin and exp may differ in their last bit, and frequencies by what follows. */
const LIBM = 1e-12;

// The other files of each deck come first: the main file is found.
const TOWERS = [
  ["examples/nrel-5mw.toml"],
  ["examples/monopile.toml"],
  ["examples/monopile-layers.toml"],
  ["examples/monopile-foundation.toml"],
  ["examples/floating.toml"],
  ["examples/guyed.toml"],
  ["examples/cans.csv", "examples/cans.toml"],
  ["examples/nrel-5mw_sections.dat", "examples/nrel-5mw.bmi"],
  ["examples/nrel-5mw.yaml"],
  ["examples/small-turbine/Blade.dat", "examples/small-turbine/Tower.dat", "examples/small-turbine/ElastoDyn.dat"],
];

const { Failed, Kind, NoTower, Solver, parts } = await solverScript();
const module = await compiled();
const text = ({ content }) => new TextDecoder().decode(content);

function asked(solver, numbers) {
  const reply = solver.ask("solve", { numbers });
  assert.equal(reply.kind, Kind.Json, text(reply));
  const answer = JSON.parse(text(reply));
  assert.equal(answer.refused, null);
  return answer.modes.map((mode) => mode.frequency_hz);
}

function solved(path, count, settings) {
  const options = settings.flatMap((setting) => ["--set", setting]);
  const output = execFileSync(program, ["solve", `${root}${path}`, "--modes", String(count), "--format", "json", ...options], { stdio: ["ignore", "pipe", "ignore"] });
  return JSON.parse(output).modes.map((mode) => mode.frequency_hz);
}

/** Compares the modes of both; says what differs. */
function compare(name, found, expected) {
  assert.equal(found.length, expected.length, name);
  const differences = found.map((value, index) => Math.abs(value / expected[index] - 1));
  const largest = Math.max(...differences.filter(Number.isFinite));
  const equal = found.filter((value, index) => Object.is(value, expected[index])).length;
  console.log(`${name}: ${equal} of ${found.length} frequencies have the same bits, largest relative difference ${largest.toExponential(1)}`);
  for (const [index, value] of found.entries()) {
    assert.ok(Object.is(value, expected[index]) || differences[index] <= LIBM, `${name}, mode ${index + 1}: ${value}, not ${expected[index]}`);
  }
}

for (const files of TOWERS) {
  const main = files.at(-1);
  test(main, async () => {
    const solver = await Solver.open(module, filesOf(files));
    const found = asked(solver, {});
    compare(main, found, solved(main, found.length, []));
    const { parameters } = JSON.parse(text(solver.ask("sheet", null)));
    // The rotor-nacelle assembly of a turbine has no sliders: its numbers follow from those of its parts.
    const changeable = ["rna.mass", "tower.outfitting_factor"].map((name) => parameters.find((one) => one.name === name));
    const { name, value } = changeable.find((one) => one);
    const larger = value === 0 ? 1000 : 1.03125 * value;
    const changed = asked(solver, { [name]: larger });
    compare(`${main} with ${name}=${larger}`, changed, solved(main, changed.length, [`${name}=${larger}`]));
  });
}

test("files that are taken away", async () => {
  const solver = await Solver.open(module, filesOf(TOWERS[0]));
  const taken = parts(solver.ask("take", { numbers: { "rna.mass": 300000 }, what: "tower" }).content);
  assert.equal(taken.name, "nrel-5mw-variant.toml");
  const again = await Solver.open(module, [taken]);
  assert.deepEqual(asked(again, {}), asked(solver, { "rna.mass": 300000 }));
  const png = parts(solver.ask("take", { numbers: {}, what: "shapes-picture", format: "png" }).content);
  assert.equal(png.mediaType, "image/png");
  assert.deepEqual([...png.content.subarray(0, 4)], [0x89, 0x50, 0x4e, 0x47]);
  const report = solver.ask("take", { numbers: { "rna.mass": 300000 }, what: "report" });
  assert.equal(report.kind, Kind.Message);
  assert.match(text(report), /towermodes report nrel-5mw\.toml --set rna\.mass=300000$/);
});

test("what is no tower is refused with a reason", async () => {
  const refusal = async (...files) => {
    try {
      await Solver.open(module, files);
    } catch (error) {
      assert.ok(error instanceof NoTower);
      return error.message;
    }
    return "";
  };
  const file = (name, content) => ({ name, content: new TextEncoder().encode(content) });
  const [toml, monopile, bmi] = filesOf(["examples/nrel-5mw.toml", "examples/monopile.toml", "examples/nrel-5mw.bmi"]);
  assert.match(await refusal(file("notes.txt", "nothing")), /notes\.txt/);
  assert.match(await refusal({ name: "a.bin", content: new Uint8Array([0, 255, 254]) }), /a\.bin: not a text file/);
  assert.match(await refusal(toml, monopile), /each of these files describes a tower: nrel-5mw\.toml, monopile\.toml/);
  assert.match(await refusal(bmi), /Open nrel-5mw\.bmi together with nrel-5mw_sections\.dat\.$/);
  assert.match(await refusal(file("t.toml", "[tower]\nstations = 3\n")), /t\.toml:2:/);
  assert.notEqual(await refusal(), "");
  const solver = await Solver.open(module, [toml]);
  assert.equal(solver.ask("solve", "{").kind, Kind.Message);
  assert.equal(solver.ask("passwd", {}).kind, Kind.Message);
  const refused = JSON.parse(text(solver.ask("solve", { numbers: { "stations[0].wall": -1 } })));
  assert.deepEqual(refused.refused.parameters.includes("stations[0].wall"), true);
});

test("a panic of the module is an error with its message", async () => {
  const solver = await Solver.open(module, filesOf(TOWERS[0]));
  const { room } = solver.exports;
  // More than an address space of 32 bits has.
  solver.exports = { ...solver.exports, room: () => room(0xf0000000) };
  assert.throws(() => solver.ask("solve", { numbers: {} }), (error) => error instanceof Failed && /capacity overflow/.test(error.message));
});
