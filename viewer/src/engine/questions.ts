// SPDX-License-Identifier: MIT
// Made from web/messages.hpp and web/questions.cpp: a test writes what has changed.

/** What was loaded. */
export interface About {
  /** Its name. */
  scenario: string;
  /** What it says of itself. */
  help: string;
  /** In digits. */
  seed: string;
  /** Who recorded it; empty before it was flown. */
  build: string;
  /** s per step. */
  dt: number | null;
  /** s, when it ends, at the latest if it was not flown yet. */
  until: number | null;
  /** In the order of their ids, which count from 1. */
  players: Array<Player>;
  /** What rows() can be asked for. */
  tables: Array<string>;
}

/** What one node answered. */
export interface Answer {
  /** Its label. */
  label: string;
  /** Its type. */
  type: string;
  /** From the root, as `eyrie explain` writes it. */
  path: string;
  /** Below the root. */
  depth: number;
  /** Whether it was asked. */
  asked: boolean;
  /** 0 failure, 1 running, 2 success. */
  status: number;
  /** Its vote. */
  vote: number | null;
  /** Why it failed. */
  why: string;
  /** What it proposed. */
  action: Array<Value>;
}

/** Another future, from the moment of seek() on. */
export interface Branch {
  /** What is other from there on, as `eyrie whatif --set` takes it. */
  sets: Array<string>;
  /** Whose tree is meant where a path names none. */
  player: string;
  /** s, when it ends at the latest, instead of the scenario's. */
  until?: number | null;
}

/** A field that would have been another. */
export interface Changed {
  /** Such as heading. */
  name: string;
  /** SI. */
  unit: string;
  /** For people; - for nothing. */
  flown: string;
  /** For people; - for nothing. */
  other: string;
  /** Other minus flown, directions the short way round. */
  difference?: number | null;
}

/** One number of every row. */
export interface Column {
  /** COLUMN.FIELD, with [i] if the field has several numbers. */
  name: string;
  /** SI; empty for none. */
  unit: string;
  /** By row. */
  values: Array<number | null>;
}

/** A decision, if one was due. */
export interface Decided {
  /** The decision. */
  decision?: Decision;
}

/** What an agent decided, and why. */
export interface Decision {
  /** Of the world. */
  step: number;
  /** s. */
  time: number | null;
  /** Its name. */
  tree: string;
  /** Of the root. */
  vote: number | null;
  /** Whose recommendation led; 65535: nobody's. */
  leader: number;
  /** Every node, in pre-order. */
  nodes: Array<Answer>;
  /** Who won each field, and against whom. */
  action: Array<Won>;
  /** What it was decided on. */
  state: Array<Value>;
  /** What it believed to be there. */
  perceived: Array<Perceived>;
}

/** The first other decision. */
export interface FirstOther {
  /** Of the world. */
  step: number;
  /** s. */
  time: number | null;
  /** Who led. */
  flown: string;
  /** Who would have led. */
  other: string;
  /** What would have been another. */
  fields: Array<Changed>;
}

/** How far a flight is. */
export interface Flown {
  /** Steps made. */
  step: number;
  /** s. */
  time: number | null;
  /** Of the world, as the terminal prints it. */
  hash: string;
  /** running, or why it is over. */
  outcome: string;
  /** How it ended, once it is over. */
  result?: Outcome;
  /** What happened since the last answer. */
  story: Array<Line>;
}

/** A line of the story. */
export interface Line {
  /** s. */
  time: number | null;
  /** Who does it. */
  who: string;
  /** What happens. */
  text: string;
}

/** A scenario to be flown. */
export interface Load {
  /** What it is made of. */
  texts: Texts;
  /** In digits; the scenario's own without it. */
  seed?: string;
  /** s, when it ends at the latest, instead of the scenario's. */
  until?: number | null;
}

/** Where the run is looked at. */
export interface Moment {
  /** Steps made before it. */
  step: number;
  /** s. */
  time: number | null;
  /** Of the world, as the terminal prints it. */
  hash: string;
}

/** What a tree may be made of. */
export interface NodeType {
  /** As files write it. */
  name: string;
  /** behavior, condition, arbiter, control or decorator. */
  kind: string;
  /** What it does. */
  help: string;
  /** Whether it may have any number of children. */
  takes_children: boolean;
  /** Besides its children. */
  parameters: Array<Parameter>;
}

/** Every type of node. */
export interface NodeTypes {
  /** Of trees of pilots. */
  aircraft: Array<NodeType>;
  /** Of trees of drivers. */
  vehicle: Array<NodeType>;
}

/** No parameters. */
export interface Nothing {
}

/** Other trees for a player's states. */
export interface Otherwise {
  /** Whose. */
  player: string;
  /** What is other, as `eyrie whatif --set` takes it. */
  sets: Array<string>;
  /** s, from when on; from the start without it. */
  from?: number | null;
}

/** How a run ended. */
export interface Outcome {
  /** Why it was over. */
  outcome: string;
  /** s. */
  time: number | null;
  /** Of blue. */
  blue: Tally;
  /** Of red. */
  red: Tally;
}

/** Of a type of node. */
export interface Parameter {
  /** As files write it. */
  name: string;
  /** number, flag, choice or other. */
  kind: string;
  /** A unit of its dimension; empty for none. */
  unit: string;
  /** What it means. */
  help: string;
  /** What it is if nobody says; empty if it must be said. */
  standard: string;
  /** The least number, in SI, if there is one. */
  min?: number | null;
  /** The greatest number, in SI, if there is one. */
  max?: number | null;
  /** If it is one of several words. */
  choices: Array<string>;
}

/** Something that the agent believed to be there. */
export interface Perceived {
  /** target, track, radar, missile or aircraft. */
  kind: string;
  /** As the agent knows it; in brackets the truth. */
  name: string;
  /** Range, bearing, identity ... */
  values: Array<Value>;
}

/** Somebody in the scenario. */
export interface Player {
  /** As the scenario says. */
  name: string;
  /** blue or red. */
  side: string;
  /** Of aircraft or vehicle. */
  type: string;
}

/** A mistake in a text. */
export interface Problem {
  /** Whose. */
  file: string;
  /** From 1; 0: unknown. */
  line: number;
  /** From 1; 0: unknown. */
  column: number;
  /** What is wrong, and the nearest right name. */
  message: string;
}

/** Every mistake that was found. */
export interface Problems {
  /** In the order of the texts; empty: it can be flown. */
  problems: Array<Problem>;
}

/** Somebody who proposed a field that another one won. */
export interface Rival {
  /** Which node. */
  node: number;
  /** What it proposed. */
  value: Value;
  /** The vote of the branch with the winner. */
  against: number | null;
  /** The vote of the branch with the rival. */
  vote: number | null;
}

/** A table of the world, at a moment. */
export interface Rows {
  /** Of the players, row by row. */
  ids: Array<number>;
  /** Whatever they keep. */
  columns: Array<Column>;
}

/** A moment of a run. */
export interface Step {
  /** Steps made before it: 0 is the start. */
  step: number;
}

/** A table of the world. */
export interface Table {
  /** Its name, such as aircraft or missiles. */
  table: string;
}

/** How a side fared. */
export interface Tally {
  /** Players lost. */
  losses: number;
  /** Missiles shot. */
  shots: number;
  /** Enemies killed. */
  kills: number;
  /** Came home. */
  home: number;
}

/** A scenario and what it includes. */
export interface Texts {
  /** Texts by name: data/KIND/NAME.yaml, packages, scenarios. */
  files: Record<string, string>;
  /** Which of them is flown. */
  scenario: string;
  /** Overrides as `--set` takes them: PATH=VALUE. */
  sets?: Array<string>;
}

/** How far. */
export interface Until {
  /** s of simulated time; to the end without it. */
  until?: number | null;
}

/** A value of the state or of an action. */
export interface Value {
  /** Such as heading. */
  name: string;
  /** SI; empty for none. */
  unit: string;
  /** In that unit, if it is a number. */
  number?: number | null;
  /** For people. */
  text: string;
}

/** What other trees would have decided. */
export interface WhatIf {
  /** Looked at. */
  decisions: number;
  /** Whose action would have been another one. */
  different: number;
  /** The first of them. */
  first?: FirstOther;
  /** Of the world, by decision. */
  steps: Array<number>;
  /** By decision the node that would have led; 65535: nobody. */
  leaders: Array<number>;
  /** s, from the first to the last of other decisions in a row. */
  spans: Array<[number, number]>;
}

/** A player. */
export interface Who {
  /** Its name. */
  player: string;
}

/** A field of the action of the root. */
export interface Won {
  /** What came out. */
  value: Value;
  /** Which node's. */
  winner: number;
  /** The winner made it of what its children said. */
  blended: boolean;
  /** The highest vote first. */
  rivals: Array<Rival>;
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
  /** The run file of what was flown to its end. */
  run_file(): Promise<Nothing & { bytes: Uint8Array }>;
  /** Opens a run file. */
  open(file: Uint8Array): Promise<About>;
  /** The run once more from the start on, every hash compared with the recorded ones; the bytes are what src/run/decode.ts reads. */
  page(request: Until): Promise<Moment & { bytes: Uint8Array }>;
  /** Goes to a step of the run. */
  seek(request: Step): Promise<Moment>;
  /** A table of the world there. */
  rows(request: Table): Promise<Rows>;
  /** What a player decided in the step that follows. */
  explain(request: Who): Promise<Decided>;
  /** What it would have decided there with other trees. */
  decide(request: Otherwise): Promise<Decided>;
  /** What it would have decided during the whole run, its states being what they were. */
  what_if(request: Otherwise): Promise<WhatIf>;
  /** How the run ended. */
  outcome(): Promise<Outcome>;
  /** How it would have ended, flown on from there with other trees and models; the bytes are as of page(). */
  branch(request: Branch): Promise<Outcome & { bytes: Uint8Array }>;
}
