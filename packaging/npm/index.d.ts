/** A scene as docs/reference/scene_format.md describes it: an object, or its JSON text. */
export type Scene = string | Record<string, unknown>;

/** Numbers, or expressions, in place of the formulas of some parameters. */
export type Values = Record<string, number | string>;

type Vector = [number, number];

/** One configuration. Numbers that are not known are NaN, as are rates that the scene does not want. */
export interface Configuration {
  /** As `assur solve` counts, from 1. */
  number: number;
  outputs: Record<string, { position: Vector; velocity: Vector; acceleration: Vector }>;
  /** The reported links: radians, and rates per unit of time. */
  links: Record<string, { theta: number; omega: number; alpha: number }>;
  /** Of the dyads with three pins, by the inner pin; radians. */
  transmissionAngles: Record<string, number>;
  /** What each driver must exert, where the scene wants forces. */
  efforts: Record<string, number>;
  /** The forces in joints, by `joint.link`, where the scene wants forces. */
  forces: Record<string, Vector>;
}

export interface Solution {
  status: "ok" | "no-assembly";
  /** Why there is no configuration; empty where there is one. */
  reason: string;
  configurations: Configuration[];
  /** How many further configurations there are: at most 24 are listed, the nearest among them. */
  leftOut: number;
  /** The number of the configuration nearest to the scene's reference, if it has one. */
  nearest: number | null;
}

/** One branch: arrays with a row for each step, NaN where the branch does not exist. */
export interface Branch {
  number: number;
  outputs: Record<string, { position: Float64Array; velocity: Float64Array; acceleration: Float64Array }>;
  links: Record<string, { theta: Float64Array; omega: Float64Array; alpha: Float64Array }>;
  transmissionAngles: Record<string, Float64Array>;
  efforts: Record<string, Float64Array>;
  forces: Record<string, Float64Array>;
}

export interface Event {
  /** `fold`, `birth`, `crossing` and others, as docs/guide/sweeps.md lists them. */
  event: string;
  branches: number[];
  parameter: number;
}

export interface Sweep {
  /** The name of the swept parameter. */
  parameter: string;
  /** Its value at each step. The steps of the scene are among them; in between there may be more. */
  values: Float64Array;
  branches: Branch[];
  /** How many further branches there are: at most 24 are listed, the nearest among them. */
  leftOut: number;
  events: Event[];
  /** The number of the branch nearest to the scene's reference, if it has one. */
  nearest: number | null;
}

/** A shape of a drawing: `points` has places among those of a branch, two numbers each. */
export interface Shape {
  symbol: string;
  link: number;
  name: string;
  fixed: boolean;
  points: number[];
}

/** The data with which pages draw and move a mechanism. */
export interface Film {
  title: string;
  unit: string;
  parameter: string;
  from: number;
  to: number;
  count: number;
  chosen: number;
  nearest: number | null;
  followed: boolean;
  points: number;
  shapes: Shape[];
  outputs: string[];
  links: string[];
  parameters: { name: string; value: number; own: boolean }[];
  branches: { number: number; points: Float64Array; outputs: Float64Array; angles: Float64Array }[];
  events: Event[];
}

/** A pose that was seen last, whose branch is to be followed. */
export interface SeenPose {
  /** The part of the sweep that was gone through, from 0 to 1. */
  part: number;
  /** x and y of each point of the shapes. */
  points: number[];
}

/** The configurations of a scene, 24 at most. Rejects with an Error for a scene that cannot be solved. */
export function solve(scene: Scene, values?: Values): Promise<Solution>;
/** The branches of a scene's sweep, 24 at most. Rejects also for a scene without a sweep. */
export function sweep(scene: Scene, values?: Values): Promise<Sweep>;
/** The branches of the sweep, or the configurations of a scene without one, as shapes that move. */
export function film(scene: Scene, values?: Values, seen?: SeenPose): Promise<Film>;
