// Which mode is which from one answer to the next: modes keep their colour when they exchange
// order. The name that a table shows is that of the solver.

import type { Mode } from "../protocol.js";
import type { TowerScene } from "../../view/scene.js";
import { product, signatures, type Signature } from "./similarity.js";

/** What stays with a mode while the tower changes. */
export interface Identity {
  id: number;
  /** What the mode was called when it came into the list. */
  name: string;
  /** Index of its colour, `--tm-series0` to `--tm-series6`, from 7 on the same as rings. */
  series: number;
}

/** A mode of an answer with its identity; the shape times `sign` does not flip from answer to
 * answer. */
export interface Followed extends Identity {
  sign: 1 | -1;
}

interface Track extends Identity {
  signature: Signature;
  sign: 1 | -1;
  mode: Mode;
}

const COLOURS = 14;
/** Below this criterion two shapes are not the same mode. */
const SIMILAR = 0.5;
/** Modes whose frequencies differ by less, relatively, are a pair: any combination of their
 * shapes is a shape too. */
const EQUAL = 1e-6;
/** Where the identities of a copy begin: beyond those that the first one will ever give. */
const COPIED = 1e9;
/** Modes that have left the list and may come back. */
const MOST_GONE = 24;

export class Follower {
  private tracks: Track[] = [];
  private gone: Track[] = [];
  private next = 0;

  /** Begins with identities from before a reload, in the order of the modes. */
  constructor(private remembered: Identity[] = []) {
    this.next = 1 + Math.max(-1, ...remembered.map(({ id }) => id));
  }

  /** The identities of the modes of an answer, in their order. */
  follow(modes: Mode[], scene: TowerScene): Followed[] {
    const shapes = signatures(scene);
    const empty = new Float64Array(0);
    const present = modes.map((mode, index) => ({ mode, signature: shapes[index] ?? empty }));
    const tracks: (Track | undefined)[] = this.tracks.length === 0 ? this.begin(present) : this.match(present);
    const followed = present.map((one, index) => tracks[index] ?? this.create(one, tracks));
    const stays = new Set(followed.map(({ id }) => id));
    const left = this.tracks.filter(({ id }) => !stays.has(id));
    this.gone = [...left, ...this.gone.filter(({ id }) => !stays.has(id))].slice(0, MOST_GONE);
    this.tracks = followed;
    return followed.map(({ id, name, series, sign }) => ({ id, name, series, sign }));
  }

  /** Another one that follows a second tower from here, and gives identities of its own to modes
   * that are new. */
  copy(): Follower {
    const copy = new Follower();
    copy.tracks = this.tracks;
    copy.gone = this.gone;
    copy.next = this.next + COPIED;
    return copy;
  }

  /** The first answer has the identities from before, if they are as many. */
  private begin(present: Present[]): (Track | undefined)[] {
    const { remembered } = this;
    if (remembered.length !== present.length) return [];
    return present.map((one, index) => {
      const identity = remembered[index];
      return identity && { ...identity, ...one, sign: 1 };
    });
  }

  private match(present: Present[]): (Track | undefined)[] {
    const found: (Track | undefined)[] = present.map(() => undefined);
    this.assign(present, this.tracks, found, criterion);
    this.assign(present, this.tracks, found, sameName);
    this.assign(present, this.gone, found, criterion);
    return found;
  }

  /** Gives modes without a track the most similar of the tracks that are free, the largest
   * similarity first. */
  private assign(present: Present[], tracks: Track[], found: (Track | undefined)[], measure: Measure): void {
    const taken = new Set(found.map((track) => track?.id));
    const pairs = present.flatMap((one, index) => {
      if (found[index]) return [];
      const free = tracks.filter(({ id }) => !taken.has(id));
      return free.map((track) => ({ index, track, value: measure(track, one, tracks) }));
    });
    pairs.sort((a, b) => b.value - a.value);
    for (const { index, track, value } of pairs) {
      const one = present[index];
      if (value < SIMILAR || found[index] || taken.has(track.id) || !one) continue;
      taken.add(track.id);
      found[index] = { ...track, ...one, sign: product(track.signature, one.signature) < 0 ? flip(track.sign) : track.sign };
    }
  }

  private create(one: Present, tracks: (Track | undefined)[]): Track {
    const used = tracks.map((track) => track?.series);
    const id = this.next++;
    const free = Array.from({ length: COLOURS }, (_, series) => series).find((series) => !used.includes(series));
    const track: Track = { id, name: one.mode.label, series: free ?? id % COLOURS, sign: 1, ...one };
    tracks[one.mode.number - 1] = track;
    return track;
  }
}

interface Present {
  mode: Mode;
  signature: Signature;
}

type Measure = (track: Track, present: Present, tracks: Track[]) => number;

/** The modal assurance criterion. The modes of an equal pair are told apart by their families. */
function criterion(track: Track, present: Present, tracks: Track[]): number {
  const own = product(track.signature, present.signature) ** 2;
  const twin = tracks.find((other) => other.id !== track.id && isEqualPair(other.mode, track.mode));
  if (twin === undefined) return own;
  const both = Math.min(1, own + product(twin.signature, present.signature) ** 2);
  return track.mode.family === present.mode.family ? both : 0.5 * both;
}

/** Family and order; of the shapes nothing can be said. */
function sameName(track: Track, present: Present): number {
  return track.mode.family === present.mode.family && track.mode.order === present.mode.order ? 1 : 0;
}

function isEqualPair(a: Mode, b: Mode): boolean {
  return Math.abs(a.frequency_hz - b.frequency_hz) <= EQUAL * Math.max(a.frequency_hz, b.frequency_hz);
}

function flip(sign: 1 | -1): 1 | -1 {
  return sign === 1 ? -1 : 1;
}
