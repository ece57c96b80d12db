// What the view draws: a tower with what surrounds it, and its modes, as the program writes them.

/** A point or a displacement in space, m: x fore-aft (downwind), y side-side, z up. */
export type Point = [number, number, number];

export type Substance = "rna" | "rotor" | "mass" | "foundation" | "ground" | "soil" | "water" | "link";

/**
 * How the points of a body define its form: `solid` is the smallest convex body around them,
 * `ball` a ball around the only one; of `line` and `spring` the first point follows the tower, the
 * last does not move, and those between them move the less the farther they are along it.
 */
export type Form = "solid" | "ball" | "line" | "spring";

/** A body at rest. */
export interface Body {
  /** Height of the section of the tower that it is fixed to, m; absent if it does not move. */
  follows_m?: number;
  of: Substance;
  form: Form;
  points: Point[];
  /** Radius of a ball, m. */
  radius_m?: number;
}

/** A frame under the tower, at rest: joints, and members between two of them. */
export interface Frame {
  joints: Point[];
  /** Outer radius at both ends, m; 0 of what is drawn as a line. */
  members: { joints: [number, number]; radius_m: [number, number] }[];
}

/**
 * A mode at the heights of the scene: the largest translation (of torsion and yaw the largest
 * rotation) is about 1.
 */
export interface Shape {
  number: number;
  label: string;
  family: string;
  frequency_hz: number;
  x: number[];
  y: number[];
  z: number[];
  rotation_x: number[];
  rotation_y: number[];
  rotation_z: number[];
  /**
   * Translations x, y, z of the joints of the frame, then of each member at a quarter, a half and
   * three quarters of its length, one after the other; absent without a frame.
   */
  frame?: number[];
}

/** A tower, its modes and what surrounds it. */
export interface TowerScene {
  /** From the base to the top, m. */
  height_m: number[];
  /** Outer radius at these heights, m. */
  radius_m: number[];
  /** Whether the radius is a nominal one. */
  is_nominal: boolean;
  bodies: Body[];
  /** The frame under the tower. */
  frame?: Frame;
  modes: Shape[];
}

/**
 * Displacements and small or large rotations (vectors, rad) of the sections of a tower, at the
 * heights of its scene.
 */
export interface Pose {
  displacement: Point[];
  rotation: Point[];
  /** Of the frame as in a shape, m. */
  frame: number[];
}

/** A station of the tower that the user can drag. */
export interface Handle {
  /** Index in the list of stations. */
  station: number;
  height_m: number;
  radius_m: number;
  /** Whether its diameter and its height can be changed. */
  hasDiameter: boolean;
  hasHeight: boolean;
}

export type DragPhase = "start" | "move" | "end" | "cancel";

/**
 * A station that is being dragged, with what the pointer asks for. One of the two changes in a
 * drag.
 */
export interface Drag {
  station: number;
  phase: DragPhase;
  quantity: "diameter" | "height";
  /** Diameter or height, m. */
  value_m: number;
  /** Where the pointer is, in pixels from the upper left corner of the view. */
  place: [number, number];
}

/** A tap on the tower, without a drag. */
export interface Tap {
  height_m: number;
  /**
   * Horizontal direction in which the tower is pushed: away from the viewer, a unit vector (x, y).
   */
  direction: [number, number];
}

export interface ViewEvents {
  drag?: (drag: Drag) => void;
  tap?: (tap: Tap) => void;
}
