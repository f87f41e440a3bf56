// SPDX-License-Identifier: MIT
// Made from web/messages.hpp and web/questions.hpp: a test writes what has changed.

/** What was loaded. */
export interface About {
  scenario: string;  // Its name.
  seed: string;  // In digits.
  until: number | null;  // s, when it ends, at the latest if it was not flown yet.
  latitude: number | null;  // deg, of the middle of the map.
  longitude: number | null;  // deg, of the same.
  players: Array<Player>;  // In the order of their ids, which count from 1.
}

/** How far what is followed may go on. */
export interface Advance {
  step: number;  // Steps made by then.
  orders: Array<string>;  // From outside, by step: base64 of 48 bytes each.
  hash: string;  // Of the world there, as others have it; empty: unknown.
  outcome: string;  // Of the run, as others have it.
  draw: boolean;  // Whether it is drawn.
}

/** How far it is. */
export interface Advanced {
  moment: Moment;  // Where.
  agrees: boolean;  // Whether the world is the one that others have.
}

/** A field that would have been another. */
export interface Changed {
  name: string;  // Such as heading.
  flown: string;  // For people; - for nothing.
  other: string;  // For people; - for nothing.
}

/** A decision, if one was due. */
export interface Decided {
  decision?: object;  // As `eyrie explain --json` prints it.
}

/** Who decided. */
export interface Decider {
  player: string;  // Whose name.
}

/** The first other decision. */
export interface FirstOther {
  step: number;  // Of the world.
  time: number | null;  // s.
  flown: string;  // Who led.
  other: string;  // Who would have led.
  fields: Array<Changed>;  // What would have been another.
}

/** How far a flight is. */
export interface Flown {
  time: number | null;  // s.
  hash: string;  // Of the world, as the terminal prints it.
  result?: Outcome;  // How it ended, once it is over.
  fault: string;  // Why, if a fault has ended it.
  story: Array<Line>;  // What happened since the last answer.
}

/** A run that others are flying. */
export interface Followed {
  about: About;  // What it is.
  flown: Moment;  // How far they were; advance() comes there.
}

/** A line of the story. */
export interface Line {
  time: number | null;  // s.
  who: string;  // Who does it.
  text: string;  // What happens.
}

/** A scenario to be flown. */
export interface Load {
  texts: Texts;  // What it is made of.
  seed?: string;  // In digits; the scenario's own without it.
}

/** Where the run is looked at. */
export interface Moment {
  step: number;  // Steps made before it.
  time: number | null;  // s.
  hash: string;  // Of the world, as the terminal prints it.
}

/** What a tree may be made of. */
export interface NodeType {
  name: string;  // As files write it.
  kind: string;  // behavior, condition, arbiter, control or decorator.
  help: string;  // What it does.
  takes_children: boolean;  // Whether it may have any number of children.
  parameters: Array<Parameter>;  // Besides its children.
}

/** Every type of node. */
export interface NodeTypes {
  aircraft: Array<NodeType>;  // Of trees of pilots.
  vehicle: Array<NodeType>;  // Of trees of drivers.
}

/** No parameters. */
export interface Nothing {
}

/** Other trees. */
export interface Otherwise {
  player: string;  // Whose, where a path names none; whose states are meant.
  sets: Array<string>;  // What is other, as `eyrie whatif --set` takes it.
}

/** How a run ended. */
export interface Outcome {
  outcome: string;  // Why it was over.
  time: number | null;  // s.
  blue: Tally;  // Of blue.
  red: Tally;  // Of red.
}

/** Of a type of node. */
export interface Parameter {
  name: string;  // As files write it.
  kind: string;  // number, flag, choice or other.
  unit: string;  // A unit of its dimension; empty for none.
  help: string;  // What it means.
  standard: string;  // What it is if nobody says; empty if it must be said.
  min?: number | null;  // The least number, in SI, if there is one.
  max?: number | null;  // The greatest number, in SI, if there is one.
  choices: Array<string>;  // If it is one of several words.
}

/** Somebody in the scenario. */
export interface Player {
  name: string;  // As the scenario says.
  side: string;  // blue or red.
}

/** A mistake in a text. */
export interface Problem {
  file: string;  // Whose.
  line: number;  // From 1; 0: unknown.
  column: number;  // From 1; 0: unknown.
  message: string;  // What is wrong, and the nearest right name.
}

/** Every mistake that was found. */
export interface Problems {
  problems: Array<Problem>;  // In the order of the texts; empty: it can be flown.
}

/** A moment of a run. */
export interface Step {
  step: number;  // Steps made before it: 0 is the start.
}

/** How a side fared. */
export interface Tally {
  losses: number;  // Players lost.
  shots: number;  // Missiles shot.
  kills: number;  // Enemies killed.
  home: number;  // Came home.
}

/** A scenario and what it includes. */
export interface Texts {
  files: Record<string, string>;  // Texts by name: data/KIND/NAME.yaml, packages, scenarios.
  scenario: string;  // Which of them is flown.
  sets?: Array<string>;  // Overrides as `--set` takes them: PATH=VALUE.
}

/** How far. */
export interface Until {
  until?: number | null;  // s of simulated time; to the end without it.
}

/** What other trees would have decided. */
export interface WhatIf {
  decisions: number;  // Looked at.
  different: number;  // Whose action would have been another one.
  first?: FirstOther;  // The first of them.
  steps: Array<number>;  // Of the world, by decision.
  leaders: Array<number>;  // By decision the node that would have led; 65535: nobody.
  spans: Array<[number, number]>;  // s, from the first to the last of other decisions in a row.
  until: number | null;  // s, when the player was last there.
  fault: string;  // Why nothing was asked from there on; empty: it was asked to the end.
}

/** Numbers are SI, times s of simulated time. A question that cannot be answered is rejected with an EngineError. */
export interface Engine {
  /** Launch zones of the shipped missiles, which then need not be flown. */
  take_zones(file: Uint8Array): Promise<Nothing>;
  /** What trees may be made of. */
  node_types(): Promise<NodeTypes>;
  /** Every mistake in a scenario and its files. */
  validate(request: Texts): Promise<Problems>;
  /** Reads a scenario; fly() begins at its start. */
  load(request: Load): Promise<About>;
  /** On with what was loaded; when it is over it has become a run. */
  fly(request: Until): Promise<Flown>;
  /** Ends what was loaded where it is, as a run that was stopped. */
  end_flight(): Promise<Flown>;
  /** The run file of what was flown to its end, or so far. */
  run_file(): Promise<Nothing & { bytes: Uint8Array }>;
  /** Opens a run file. */
  open(file: Uint8Array): Promise<About>;
  /** The run once more from the start on, every hash compared with the recorded ones; the bytes are what src/run/decode.ts reads. */
  page(request: Until): Promise<Moment & { bytes: Uint8Array }>;
  /** Opens a run that others are flying, with what was flown so far; at its start. */
  follow(file: Uint8Array): Promise<Followed>;
  /** On with what is followed; the bytes are what came since the last ones (src/live/grown.ts), none if it is not to be drawn. seek() and the others know what was flown so far. */
  advance(request: Advance): Promise<Advanced & { bytes: Uint8Array }>;
  /** Goes to a step of the run. */
  seek(request: Step): Promise<Moment>;
  /** What a player decided in the step that follows. */
  explain(request: Decider): Promise<Decided>;
  /** What it would have decided during the whole run, its states being what they were. */
  what_if(request: Otherwise): Promise<WhatIf>;
  /** How the run ended. */
  outcome(): Promise<Outcome>;
  /** How it would have ended, flown on from the moment of seek() with other trees and models; the bytes are as of page(). */
  branch(request: Otherwise): Promise<Outcome & { bytes: Uint8Array }>;
}
