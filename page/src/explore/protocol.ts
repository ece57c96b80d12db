// What the page asks the program, and what it answers. All addresses are relative to that of the
// page, which contains
// the token. Bodies and answers are JSON; a broken request is answered with an error status and a
// text.
//
//   GET  sheet                             → Sheet
//   POST solve          State              → Answer | Refusal
//   POST elasticities   ElasticityQuestion → Elasticities | Refusal
//   POST reproduce      State              → Reproduction
//   POST take           State & Take       → the file, with its name in Content-Disposition

import type { TowerScene, Shape } from "../view/scene.js";

/** The numbers that differ from the file, by name. All others have the values of the file. */
export interface State {
  numbers: Record<string, number>;
}

/** The tower as its file describes it. */
export interface Sheet {
  version: string;
  /** Name of the file, and its format: "TOML", "windIO". */
  file: string;
  format: string;
  /** The command that explores this file again: `towermodes explore examples/monopile.toml`. */
  command: string;
  groups: Group[];
  parameters: Parameter[];
  /** Notes of the reader. */
  notes: string[];
}

/** A part of the tower, or a column of a list of it. In the order of the tower file. */
export interface Group {
  /** `rna`, `stations[]`, `soil[].rows[]`. */
  name: string;
  /** "rotor-nacelle assembly", "stations". */
  title: string;
  /**
   * The names of its columns if it is a list: `stations[*].wall`; all numbers of a column can be
   * multiplied at once.
   */
  columns: string[];
}

export interface Parameter {
  /** `stations[2].wall`. */
  name: string;
  /** Index of its group. */
  group: number;
  /** The name of its column, if its group is a list: `stations[*].wall`. */
  column: string | null;
  /** The number within its group: "wall", or "3: wall". */
  label: string;
  meaning: string;
  /** "m", "kg"; empty without a unit. */
  unit: string;
  /** The value of the file. JSON has null for one that is infinite; the page has Infinity. */
  value: number;
  /** The range of its slider around the value of the file. */
  low: number;
  high: number;
  /** The quantity that can be dragged in the view: a station's height or diameter. */
  drag: { station: number; quantity: "height" | "diameter" } | null;
}

/** A solved tower. */
export interface Answer {
  refused: null;
  /** Values of all parameters, in the order of the sheet (some numbers follow others); infinite as
   * in the sheet. */
  values: number[];
  /** Name and text: mass of the tower, mass of the RNA, height, buckling load factor, … */
  facts: Fact[];
  modes: Mode[];
  /** "Complete: 10 modes below 2.31 Hz, …" as in the terminal. */
  certificate: string;
  /** "100 segments, rigid bodies and joints; …" */
  method: string;
  warnings: Remark[];
  /** Null without a rotor. */
  resonance: Resonance | null;
  /** Pictures of the program, as SVG: the resonance diagram, null without a rotor. */
  diagram: string | null;
  scene: TowerScene;
  /** Time of the solve and of the whole answer in the program, ms. */
  solve_ms: number;
  answer_ms: number;
}

export interface Fact {
  key: string;
  name: string;
  /** With all digits; NaN is null. */
  value: number | null;
  unit: string;
  /** As the terminal prints it, with its unit. */
  text: string;
}

export interface Mode {
  number: number;
  label: string;
  /** The label with the shares of a coupled mode. */
  shape: string;
  family: string;
  order: number;
  /** All digits. */
  frequency_hz: number;
  error_hz: number;
  /** As the terminal prints them. */
  frequency: string;
  error: string;
  period_s: number | null;
  /**
   * Effective masses in x, y, z and about x, y, z as fractions of the whole; null where there is
   * none.
   */
  effective_mass: (number | null)[];
  /** uᵀMu of the shape of the scene. */
  modal_mass: number;
  /**
   * "1P at 0.31 Hz: 4 % away", and the word of the verdict; null if no excitation is near or there
   * is no rotor.
   */
  verdict: { word: "pass" | "warn" | "fail"; text: string } | null;
}

export interface Remark {
  text: string;
  /** The parameters that it is about. */
  parameters: string[];
}

export interface Resonance {
  /** The worst verdict. */
  word: "pass" | "warn" | "fail";
  /** The conclusion in sentences. */
  conclusion: string[];
}

/** A tower that cannot be, or cannot be solved. */
export interface Refusal {
  refused: { message: string; hint: string | null; parameters: string[] };
}

/** What the elasticities of a mode are asked with. */
export interface ElasticityQuestion extends State {
  /** Place of the mode in the list of the answer to this state, from 1. */
  mode: number;
}

/** d ln f / d ln p of a mode. */
export interface Elasticities {
  refused: null;
  mode: string;
  /** By name; numbers that are 0 have none. */
  elasticities: Record<string, number>;
  /** Of a factor on all numbers of a column, by the name of the column. */
  columns: Record<string, number>;
}

export interface Reproduction {
  /** Lines for a shell, and a script for Python. */
  shell: string;
  python: string;
  /** What the tower file of the state lacks of the old file, in sentences. */
  left_out: string[];
}

export interface Take {
  what: "tower" | "report" | "tower-picture" | "shapes-picture" | "resonance-picture";
  /** Of pictures. */
  format?: "svg" | "png";
}

export type { Shape };
