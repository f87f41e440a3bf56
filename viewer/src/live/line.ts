// SPDX-License-Identifier: MIT
/** The line to the program that serves the page: WebSocket at /live. It is taken up again whenever it breaks. */
import type { Grant } from './lockstep.ts';

export interface News extends Grant {
  rate: number | 'max';
  paused: boolean;
  viewers: number;
  shared?: boolean;  // Other programs take part, which do not wait.
}
/** How well the program keeps to the clock; times in s. */
export interface Pacing {
  frames: number;
  missed: number;
  p50: number;
  p99: number;
  p999: number;
  max: number;
  load: number;
}
export type Do =
  | { do: 'play' } | { do: 'pause' } | { do: 'step'; steps: number } | { do: 'rate'; rate: number | 'max' }
  | ({ do: 'order'; order: string } & Record<string, unknown>);

/** What is heard; `joined` gets the run so far, and is told again after each break. */
export interface Ear {
  joined(file: Uint8Array): void;
  news(news: News): void;
  pacing(pacing: Pacing): void;
  refused(words: string): void;
  /** Why there is no line now. */
  broken(words: string): void;
}

/** A WebSocket, or what a test has instead. */
export interface Socket {
  binaryType: string;
  readyState: number;
  onmessage: ((event: { data: unknown }) => void) | null;
  onclose: ((event: { reason: string }) => void) | null;
  send(text: string): void;
  close(): void;
}

/** ms: from a break to the next try, at first and at most; and without a word, though there is one each second: it is broken. */
const kWaits = { first: 250, last: 5000, silence: 8000 };
const kOpen = 1;

export class Line {
  private socket: Socket | null = null;
  private wait: number;
  private silence: ReturnType<typeof setTimeout> | undefined;
  private again: ReturnType<typeof setTimeout> | undefined;
  private over = false;

  constructor(private readonly open: () => Socket, private readonly ear: Ear, private readonly waits = kWaits) {
    this.wait = waits.first;
    this.take_up();
  }

  /** False: there is no line now. */
  say(what: Do): boolean {
    if (this.socket?.readyState !== kOpen) return false;
    this.socket.send(JSON.stringify(what));
    return true;
  }
  end(): void {
    this.over = true;
    clearTimeout(this.silence);
    clearTimeout(this.again);
    this.socket?.close();
  }

  private take_up(): void {
    const socket = (this.socket = this.open());
    socket.binaryType = 'arraybuffer';
    socket.onmessage = ({ data }) => {
      if (this.socket !== socket) return;
      this.listen(socket);
      this.hear(data);
    };
    socket.onclose = ({ reason }) => this.lost(socket, reason || 'nobody answers');
    this.listen(socket);
  }
  private listen(socket: Socket): void {
    clearTimeout(this.silence);
    this.silence = setTimeout(() => {
      this.lost(socket, 'nothing is heard');
      socket.close();
    }, this.waits.silence);
  }
  private lost(socket: Socket, words: string): void {
    if (this.socket !== socket || this.over) return;
    this.socket = null;
    clearTimeout(this.silence);
    this.ear.broken(words);
    this.again = setTimeout(() => this.take_up(), this.wait);
    this.wait = Math.min(this.waits.last, 2 * this.wait);
  }
  private hear(data: unknown): void {
    if (typeof data !== 'string') {
      this.wait = this.waits.first;
      return this.ear.joined(new Uint8Array(data as ArrayBuffer));
    }
    const said = JSON.parse(data) as Partial<News> & { pacing?: Pacing; refused?: string };
    if (said.pacing) this.ear.pacing(said.pacing);
    else if (said.refused !== undefined) this.ear.refused(said.refused);
    else if (said.step !== undefined) this.ear.news(said as News);
  }
}
