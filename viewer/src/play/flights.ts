// SPDX-License-Identifier: MIT
/** Flies scenarios in a worker, one at a time, and keeps what became of them. */
import type { Flown, Player } from '../engine/questions.ts';
import type { RunningEngine } from '../engine/engine.ts';
import { started } from '../parts.ts';
import { is_edited, name_of, texts_of, type Project } from './project.ts';

export interface Flight extends Flown {
  number: number;  // From 1.
  project: Project;
  is_edited: boolean;  // What it flies with is not as shipped.
  name: string;
  seed: string;
  players: Player[];
  time: number;
  until: number;  // s, when it ends at the latest.
  took: number;  // ms of the clock that flying took, without loading.
  file?: Uint8Array;
}

/** s of simulated time between two looks at a flight. */
const kSlice = 10;

export class Flier {
  private engine: Promise<RunningEngine> | null = null;
  private count = 0;
  private flies = false;
  private is_to_end = false;

  constructor(private readonly module: WebAssembly.Module) {}

  /** Flies until it is over or stopped, telling how far it is. Rejected with the EngineError of the loader, or when it is stopped before it flies. */
  async fly(project: Project, told: (flight: Flight) => void): Promise<Flight> {
    const engine = await (this.engine ??= started(this.module));
    const { scenario, seed } = project;
    const about = await engine.load({ texts: { files: texts_of(project), scenario }, ...(seed && { seed }) });
    let flight: Flight = {
      number: this.count + 1, project, is_edited: is_edited(project), name: about.scenario || name_of(scenario), seed: about.seed, players: about.players,
      time: 0, until: about.until ?? 0, took: 0, story: [], hash: '', fault: '',
    };
    const began = performance.now();
    [this.flies, this.is_to_end] = [true, false];
    try {
      for (let until = kSlice; !flight.result; until += kSlice) {
        told(flight);
        const flown = await (this.is_to_end ? engine.end_flight() : engine.fly({ until }));
        flight = { ...flight, ...flown, time: flown.time ?? 0, took: performance.now() - began, story: [...flight.story, ...flown.story] };
      }
    } finally {
      this.flies = false;
    }
    this.count = flight.number;
    flight.file = (await engine.run_file()).bytes;
    return flight;
  }

  /** Ends what is flying where it is, which is a run as others are; gives up what is being loaded, or does not end. */
  async stop(): Promise<void> {
    if (this.flies && !this.is_to_end) return void (this.is_to_end = true);
    const { engine } = this;
    this.engine = null;
    (await engine)?.end();
  }
}
