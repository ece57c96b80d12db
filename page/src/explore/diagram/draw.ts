// The resonance diagram as SVG in pixels of the page: texts have the size of the page's.

import { speedText, type Content, type Line, type Place } from "./content.js";
import { apart, ticks } from "./ticks.js";

/** Room for numbers and names of the axes, in pixels: a multiple of the size of the text. */
const LEFT = 3.1;
const RIGHT = 3.4;
const TOP = 1.4;
const BOTTOM = 2.7;
/** Between two numbers along an axis. */
const BETWEEN_X = 4.5;
const BETWEEN_Y = 2.4;
/** More colours than these begin again, dashed. */
const COLOURS = 7;

export interface Frame {
  width: number;
  height: number;
  /** The size of texts, px. */
  text: number;
}

/** From rpm and Hz to pixels and back. */
export interface Scale {
  left: number;
  right: number;
  top: number;
  bottom: number;
  x(rpm: number): number;
  y(hz: number): number;
  rpm(x: number): number;
  hz(y: number): number;
}

export function scaleOf({ last_rpm, last_hz }: Content, { width, height, text }: Frame): Scale {
  const [left, right] = [LEFT * text, width - RIGHT * text];
  const [top, bottom] = [TOP * text, height - BOTTOM * text];
  return {
    left, right, top, bottom,
    x: (rpm) => left + (rpm / last_rpm) * (right - left),
    y: (hz) => bottom - (hz / last_hz) * (bottom - top),
    rpm: (x) => ((x - left) / (right - left)) * last_rpm,
    hz: (y) => ((bottom - y) / (bottom - top)) * last_hz,
  };
}

const n = (value: number): string => String(Number(value.toFixed(1)));
const escaped = (text: string): string => text.replaceAll("&", "&amp;").replaceAll("<", "&lt;");

/** The whole drawing; `words` say what it shows. */
export function drawing(content: Content, frame: Frame, words: string): string {
  const scale = scaleOf(content, frame);
  const { left, right, top, bottom } = scale;
  const inside = [
    ...operation(content, scale),
    ...content.ribbons.map(({ isMargin, points }) => `<path class="${isMargin ? "margin" : "twice"}" d="${path(points, scale)}Z"/>`),
    ...grid(content, scale, frame.text),
    ...content.rays.map(({ multiple, isStrong }) =>
      `<path class="ray${isStrong ? " strong" : ""}" d="${path([[0, 0], [content.last_rpm, (multiple * content.last_rpm) / 60]], scale)}"/>`),
    ...content.spans.map((span) => {
      const [high, low] = [scale.y(span.high_hz), scale.y(span.low_hz)];
      return `<rect class="span${colour(span.series)}" x="${n(left)}" y="${n(high)}" width="${n(right - left)}" height="${n(Math.max(1, low - high))}"/>`;
    }),
    ...inOrder(content.lines).map((line) => lineOf(line, scale)),
  ];
  return `<svg xmlns="http://www.w3.org/2000/svg" width="${n(frame.width)}" height="${n(frame.height)}" role="img" font-size="${frame.text}">`
    + `<title>Resonance diagram</title><desc>${escaped(words)}</desc>`
    + `<clipPath id="diagram-inside"><rect x="${n(left)}" y="${n(top)}" width="${n(right - left)}" height="${n(bottom - top)}"/></clipPath>`
    + `<g clip-path="url(#diagram-inside)">${inside.join("")}</g>`
    + `<path class="axis" d="M${n(left)} ${n(top)}V${n(bottom)}H${n(right)}"/>`
    + [...numbers(content, scale, frame.text), ...names(content, scale, frame), ...ends(content, scale, frame.text)].join("")
    + "</svg>";
}

/** The chosen one is in front of its own, these in front of those that they are compared with. */
function inOrder(lines: Line[]): Line[] {
  const rank = (line: Line): number => (line.isOther ? 0 : line.isChosen ? 2 : 1);
  return [...lines].sort((a, b) => rank(a) - rank(b));
}

const colour = (series: number): string => ` series${series % COLOURS}`;

function lineOf(line: Line, scale: Scale): string {
  const { series, isChosen, isOther, points } = line;
  const look = [isChosen ? " chosen" : "", isOther ? " other" : "", series >= COLOURS ? " second" : ""].join("");
  return `<path class="line${colour(series)}${look}" d="${path(points, scale)}"/>`;
}

function path(points: Place[], { x, y }: Scale): string {
  return points.map(([rpm, hz], k) => `${k === 0 ? "M" : "L"}${n(x(rpm))} ${n(Math.max(-1e4, y(hz)))}`).join("");
}

function operation({ operation: speeds }: Content, { x, top, bottom }: Scale): string[] {
  if (speeds === null) return [];
  const [from, to] = speeds.map(x) as [number, number];
  const width = Math.max(4, to - from);
  return [`<rect class="operation" x="${n(0.5 * (from + to) - width / 2)}" y="${n(top)}" width="${n(width)}" height="${n(bottom - top)}"/>`];
}

function ticksOf({ last_rpm, last_hz }: Content, { left, right, top, bottom }: Scale, text: number): [number[], number[]] {
  return [ticks(last_rpm, (right - left) / (BETWEEN_X * text)), ticks(last_hz, (bottom - top) / (BETWEEN_Y * text))];
}

function grid(content: Content, scale: Scale, text: number): string[] {
  const [rpm, hz] = ticksOf(content, scale, text);
  return [
    ...rpm.map((at) => `<path class="grid" d="M${n(scale.x(at))} ${n(scale.top)}V${n(scale.bottom)}"/>`),
    ...hz.map((at) => `<path class="grid" d="M${n(scale.left)} ${n(scale.y(at))}H${n(scale.right)}"/>`),
  ];
}

function numbers(content: Content, scale: Scale, text: number): string[] {
  const [rpm, hz] = ticksOf(content, scale, text);
  return [
    ...rpm.map((at) => `<text x="${n(scale.x(at))}" y="${n(scale.bottom + 1.2 * text)}" text-anchor="middle">${at}</text>`),
    ...hz.map((at) => `<text x="${n(scale.left - 0.4 * text)}" y="${n(scale.y(at) + 0.35 * text)}" text-anchor="end">${at}</text>`),
  ];
}

function names(content: Content, scale: Scale, { height, text }: Frame): string[] {
  const { right, top } = scale;
  const below = `<text class="name" x="${n(right)}" y="${n(height - 0.3 * text)}" text-anchor="end">rotor speed, rpm</text>`;
  const beside = `<text class="name" x="2" y="${n(0.95 * text)}">Hz</text>`;
  if (content.operation === null) return [below, beside];
  const { at, words } = titleOf(content.operation, scale, text);
  return [below, beside, `<text class="name" x="${n(at)}" y="${n(top - 0.4 * text)}" text-anchor="middle">${words}</text>`];
}

/** The operating speeds in words, the middle of these above the field, and half their width. */
function titleOf([from, to]: Place, { x, left, right }: Scale, text: number): { at: number; half: number; words: string } {
  const words = `operation ${from === to ? "" : `${speedText(from)} to `}${speedText(to)} rpm`;
  const half = 0.3 * text * words.length;
  return { at: Math.min(Math.max(x(0.5 * (from + to)), left + half), right - half), half, words };
}

/** At the right edge: numbers of the modes, and excitations where they leave the field. */
function ends(content: Content, scale: Scale, text: number): string[] {
  const { last_rpm, last_hz } = content;
  const isInside = (hz: number): boolean => hz >= 0 && hz <= last_hz;
  const rays = content.rays.map(({ multiple, isStrong }) => ({ hz: (multiple * last_rpm) / 60, words: `${multiple}P`, of: isStrong ? "ray-end strong" : "ray-end" }));
  const modes = new Map<string, { hz: number; words: string; of: string }>();
  for (const line of content.lines) {
    const end = line.points.at(-1);
    if (line.isOther || line.mode === null || end === undefined || !isInside(end[1])) continue;
    const key = end[1].toPrecision(3);
    const known = modes.get(key);
    const of = `end${colour(line.series)}${line.isChosen ? " chosen" : ""}`;
    modes.set(key, { hz: end[1], words: known ? `${known.words} ${line.mode}` : String(line.mode), of: known && !line.isChosen ? known.of : of });
  }
  const all = [...modes.values(), ...rays.filter(({ hz }) => isInside(hz))];
  const places = apart(all.map(({ hz }) => scale.y(hz)), 1.05 * text, [scale.top, scale.bottom]);
  const right = all.map(({ words, of }, k) => `<text class="${of}" x="${n(scale.right + 0.4 * text)}" y="${n(places[k]! + 0.35 * text)}">${words}</text>`);
  const title = content.operation && titleOf(content.operation, scale, text);
  const above = rays.filter(({ hz }) => !isInside(hz)).flatMap(({ words, of, hz }) => {
    const x = scale.x((last_rpm * last_hz) / hz);
    const isFree = title === null || Math.abs(x - title.at) > title.half + 1.5 * text;
    return isFree ? [`<text class="${of}" x="${n(x)}" y="${n(scale.top - 0.4 * text)}" text-anchor="middle">${words}</text>`]
      : [`<text class="${of}" x="${n(x - 0.5 * text)}" y="${n(scale.top + text)}" text-anchor="end">${words}</text>`];
  });
  return [...right, ...above];
}
