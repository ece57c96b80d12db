// What the resonance diagram shows, in rpm and Hz: lines of modes, rays of excitations, margins, and
// where the axes end.

import type { Band, DiagramLine, Resonance } from "../protocol.js";

export type Place = [number, number];

/** A line of a mode. */
export interface Line {
  label: string;
  points: Place[];
  /** Index of its colour. */
  series: number;
  isChosen: boolean;
  /** Whether it is one of the tower that is compared with. */
  isOther: boolean;
  /** The number of a tower mode, from 1. */
  mode: number | null;
}

/** An excitation. */
export interface Ray {
  multiple: number;
  /** Whether it is 1P or the blade passing frequency. */
  isStrong: boolean;
}

/** Frequencies of a mode from the softest to the stiffest soil, Hz. */
export interface Span {
  label: string;
  low_hz: number;
  high_hz: number;
  series: number;
}

export interface Content {
  last_rpm: number;
  last_hz: number;
  operation: Place | null;
  lines: Line[];
  rays: Ray[];
  /** Around a multiple in operation the frequencies that are nearer than the margin, and than twice
   * the margin. */
  ribbons: { isMargin: boolean; points: Place[] }[];
  spans: Span[];
  /** How many lines are above the end of the axis. */
  above: number;
}

/** How a line is shown. */
export interface LineLook {
  series: number;
  isChosen: boolean;
}

export interface Source {
  resonance: Resonance;
  look: (line: DiagramLine) => LineLook;
}

/** Diagrams go to this multiple of the highest operating speed. */
const BEYOND = 1.2;
/** The near part ends at this multiple of the lowest two frequencies of the tower … */
const ABOVE_FIRST = 1.3;
/** … and of the end of the ray of the blade passing frequency. */
const ABOVE_RAY = 1.03;
/** The whole diagram ends at this multiple of its highest excitation or line. */
const ABOVE_ALL = 1.06;

/** A rotor speed with three decimals at most, as the program prints it. */
export const speedText = (rpm: number): string => String(Number(rpm.toFixed(3)));

const hzOf = (multiple: number, rpm: number): number => (multiple * rpm) / 60;

/** The content of a diagram; `isWhole` shows all that the excitations reach. */
export function contentOf(own: Source, other: Source | null, band: Band | null, isWhole: boolean): Content {
  const { resonance } = own;
  const last_rpm = lastRpm(resonance);
  const all = [...(other === null ? [] : linesOf(other, true, last_rpm)), ...linesOf(own, false, last_rpm)];
  const last_hz = isWhole ? wholeHz(resonance, all, last_rpm) : nearHz(resonance, all, last_rpm);
  const lines = all.filter(({ points }) => points.some(([, hz]) => hz > 0 && hz <= last_hz));
  return {
    last_rpm, last_hz, lines,
    operation: resonance.operation_rpm,
    rays: resonance.multiples.map((multiple) => ({ multiple, isStrong: isStrong(resonance, multiple) })),
    ribbons: ribbons(resonance),
    spans: band === null ? [] : spans(band, own),
    above: all.filter((line) => !line.isOther && !lines.includes(line)).filter(({ points }) => points.some(([, hz]) => hz > last_hz)).length,
  };
}

const isStrong = ({ blades }: Resonance, multiple: number): boolean => multiple === 1 || multiple === blades;

/** The speed at the right end, rpm. */
export function lastRpm({ lines, operation_rpm }: Resonance): number {
  const ends = lines.map(({ points }) => points.at(-1)?.[0] ?? 0);
  const highest = operation_rpm?.[1] ?? 0;
  const last = Math.max(highest, ...ends);
  return last > highest ? last : BEYOND * highest || 1;
}

/** The lines of a source; those of a tower alone go to the end of the diagram. */
function linesOf({ resonance, look }: Source, isOther: boolean, last_rpm: number): Line[] {
  return resonance.lines.map((line) => {
    const { label, points, mode, curve } = line;
    const [first] = points;
    const isLevel = curve === null && first !== undefined && points.every(([, hz]) => hz === first[1]);
    return { label, mode, isOther, points: isLevel ? [[0, first[1]], [last_rpm, first[1]]] : points, ...look(line) };
  });
}

function nearHz(resonance: Resonance, lines: Line[], last_rpm: number): number {
  const judged = resonance.lines.filter((line) => line.class !== "blades" && line.points.some(([, hz]) => hz > 0));
  // The modes of a floating platform are far below those of its tower.
  const ofTower = judged.filter((line) => line.class === "tower");
  const own = ofTower.length > 0 ? ofTower : judged;
  const lowest = own.map(({ points }) => Math.max(...points.map(([, hz]) => hz))).sort((a, b) => a - b);
  const first = Math.max(0, ...lowest.slice(0, 2));
  const chosen = lines.filter(({ isChosen }) => isChosen).flatMap(({ points }) => points.map(([, hz]) => hz));
  const ray = ABOVE_RAY * hzOf(resonance.blades, last_rpm);
  return Math.max(ABOVE_FIRST * first, ray, ABOVE_ALL * Math.max(0, ...chosen)) || 1;
}

function wholeHz({ multiples, operation_rpm }: Resonance, lines: Line[], last_rpm: number): number {
  const excitation = hzOf(Math.max(1, ...multiples), operation_rpm?.[1] ?? last_rpm);
  const reached = lines.flatMap(({ points }) => points.map(([, hz]) => hz)).filter((hz) => hz <= 2 * excitation);
  return ABOVE_ALL * Math.max(excitation, ...reached);
}

/** The distance |nΩ/f − 1| is less than the margin between nΩ/(1 + margin) and nΩ/(1 − margin). */
function ribbons({ is_checked, operation_rpm, margin, multiples, blades }: Resonance): Content["ribbons"] {
  if (!is_checked || operation_rpm === null) return [];
  const [low, high] = operation_rpm;
  const strong = multiples.filter((multiple) => multiple === 1 || multiple === blades);
  const ribbon = (multiple: number, part: number): Place[] => {
    const upper = part < 1 ? 1 / (1 - part) : Infinity;
    const at = (rpm: number, factor: number): Place => [rpm, Math.min(1e4, factor * hzOf(multiple, rpm))];
    return [at(low, upper), at(high, upper), at(high, 1 / (1 + part)), at(low, 1 / (1 + part))];
  };
  return [2, 1].flatMap((times) => strong.map((multiple) => ({ isMargin: times === 1, points: ribbon(multiple, times * margin) })));
}

function spans({ modes }: Band, { resonance, look }: Source): Span[] {
  return modes.flatMap(({ label, at }) => {
    const line = resonance.lines.find((one) => one.label === label && one.mode !== null);
    const all = at.flatMap((value) => (value === null ? [] : [value.frequency_hz]));
    if (line === undefined || all.length < 2) return [];
    return [{ label, low_hz: Math.min(...all), high_hz: Math.max(...all), series: look(line).series }];
  });
}

/** The frequency of a line at a speed; null where it has no points. */
export function hzAt({ points }: { points: Place[] }, rpm: number): number | null {
  const above = points.findIndex(([at]) => at >= rpm);
  if (above < 0) return null;
  const [high_rpm, high_hz] = points[above]!;
  if (above === 0) return high_rpm === rpm ? high_hz : null;
  const [low_rpm, low_hz] = points[above - 1]!;
  const part = high_rpm > low_rpm ? (rpm - low_rpm) / (high_rpm - low_rpm) : 1;
  return low_hz + part * (high_hz - low_hz);
}
