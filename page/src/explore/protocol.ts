// What the page asks the program, and what it answers. All addresses are relative to that of the
// page, which contains
// the token. Bodies and answers are JSON; a broken request is answered with an error status and a
// text.
//
//   GET  sheet                             → Sheet
//   POST solve          State              → Answer | Refusal
//   POST coupled        State              → Coupled | Refusal
//   POST whirl          WhirlQuestion      → Whirl | Refusal
//   POST band           State              → Band | Refusal
//   POST target         TargetQuestion     → Found | Refusal
//   POST elasticities   ElasticityQuestion → Elasticities | Refusal
//   POST reproduce      State              → Reproduction
//   POST take           State & Take       → the file, with its name in Content-Disposition

import type { TowerScene, Shape } from "../view/scene.js";
import type { Turbine } from "../view/turbine.js";

/** The numbers that differ from the file, by name. All others have the values of the file. */
export interface State {
  numbers: Record<string, number>;
  /** Whether they are those of the tower that the program was told to compare with. */
  is_of_other?: boolean;
}

/** The tower as its file describes it. */
export interface Sheet {
  version: string;
  /** The name of the tower; that of the file if it has none. */
  name: string;
  /** Name of the file, and its format: "TOML", "windIO". */
  file: string;
  format: string;
  /** The command that explores this file again: `towermodes explore examples/monopile.toml`. */
  command: string;
  groups: Group[];
  parameters: Parameter[];
  /** Notes of the reader. */
  notes: string[];
  /** Whether the file has a turbine whose rotor can turn. */
  has_turbine: boolean;
  /** Whether its frequencies depend on soil. */
  has_soil: boolean;
  /** The tower to compare with: its file, the names of the values of its answers. */
  against: { file: string; names: string[]; has_turbine: boolean } | null;
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
  /** The column of another list whose factor multiplies it too. */
  also_in: string | null;
  /** Index of the number with whose slider it moves, if it has none of its own. */
  follows: number | null;
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
  /** Damping ratios; null where the file gives no damping. */
  damping?: { ratio: number | null; running: [number, number][] } | null;
  /**
   * "1P at 0.31 Hz: 4 % away", and the word of the verdict; null if no excitation is near or there
   * is no rotor.
   */
  verdict: { word: Word; text: string } | null;
}

export interface Remark {
  text: string;
  /** The parameters that it is about. */
  parameters: string[];
}

export type Word = "pass" | "warn" | "fail" | "undecided";

export interface Resonance {
  /** The worst verdict. */
  word: Word;
  /** The conclusion in sentences. */
  conclusion: string[];
  is_checked: boolean;
  /** The lowest and the highest operating speed, rpm; null if they are unknown. */
  operation_rpm: [number, number] | null;
  blades: number;
  /** The required distance, as a fraction. */
  margin: number;
  multiples: number[];
  lines: DiagramLine[];
  rows: DiagramRow[];
}

/** A natural frequency against the rotor speed. */
export interface DiagramLine {
  label: string;
  /** The number of a tower mode, from 1. */
  mode: number | null;
  /** Of a turbine the curve, from 0. */
  curve: number | null;
  class: string;
  /** Rotor speed (rpm) and frequency (Hz). */
  points: [number, number][];
}

/** The distance of an excitation from a natural frequency, as the command `campbell` lists it. */
export interface DiagramRow {
  label: string;
  multiple: number;
  nearest_rpm: number;
  excitation_hz: number;
  natural_hz: number;
  frequency: string;
  distance: number;
  distance_text: string;
  verdict: Word;
  is_near: boolean;
}

/** The coupled diagram of a turbine. */
export interface Coupled {
  refused: null;
  resonance: Resonance;
  proof: string;
  speeds: number;
  answer_ms: number;
}

export interface WhirlQuestion extends State {
  rpm: number;
}

/** The modes of a turbine at a rotor speed. */
export interface Whirl {
  refused: null;
  modes: WhirlMode[];
  scene: Turbine;
  answer_ms: number;
}

export interface WhirlMode {
  /** The name of a line of the diagram. */
  name: string;
  frequency_hz: number;
  frequency: string;
  remark: string;
  /** The mode of the tower with a rigid rotor that has the same motion; null of one of the rotor. */
  tower_mode: { family: string; order: number } | null;
}

/** Frequencies in softer and stiffer soil. */
export interface Band {
  refused: null;
  factors: number[];
  modes: BandMode[];
  failed: { factor: number; reason: string }[];
  shared: { factor: number; modes: string }[];
}

export interface BandMode {
  label: string;
  family: string;
  order: number;
  at: ({ frequency_hz: number; error_hz: number; verdict: Word | null } | null)[];
}

/** A question for a tower whose mode has a frequency in a band. */
export interface TargetQuestion extends State {
  /** `fore-aft 1`. */
  mode: string;
  min_hz: number | null;
  max_hz: number | null;
  variables: TargetVariable[];
}

/** A number, or a factor on a column: `scale(stations[*].wall)`. */
export interface TargetVariable {
  name: string;
  low: number;
  high: number;
}

export interface Found extends State {
  refused: null;
  sentences: string[];
  solves: number;
}

/** A tower that cannot be, or cannot be solved. */
export interface Refusal {
  refused: { message: string; hint: string | null; parameters: string[] };
}

/** What the elasticities of a mode are asked with. */
export interface ElasticityQuestion extends State {
  /** Place of the mode in the list of the answer to this state, from 1. */
  mode: number;
  label: string;
  /** Numbers and columns, the most wanted first. */
  names: string[];
}

/** d ln f / d ln p of a mode. */
export interface Elasticities {
  refused: null;
  mode: string;
  /** By name. */
  elasticities: Record<string, number>;
  /** Of a factor on all numbers of a column, by the name of the column. */
  columns: Record<string, number>;
  /** Why a number or a column has none; `short` stands in its place. */
  reasons: Record<string, NoElasticity>;
  /** The names that are to be asked again: the time was over. */
  left: string[];
  answer_ms: number;
}

export interface NoElasticity {
  short: string;
  text: string;
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
