// SPDX-License-Identifier: MIT
/** Opens the page of a mission that is being flown: joins it, flies along, shows it, and does all that again when the line breaks. */
import type { RunningEngine } from '../engine/engine.ts';
import { engine_module, parts, started } from '../parts.ts';
import { unpacked } from '../packed.ts';
import { say_failure, show, type Shown } from '../show.tsx';
import type { View } from '../store.ts';
import { view_in } from '../ui/page.ts';
import { GrownRun } from './grown.ts';
import { Line, type Socket } from './line.ts';
import { Live } from './live.ts';
import { Lockstep, type Grant } from './lockstep.ts';

/** ms from one drawing of the panels to the next, at least; and how many times as long as it takes. */
const kRefresh = 1000;
const kSpare = 10;

/** Flies along from one joining to the next. */
class Joined {
  private readonly engine: Promise<RunningEngine>;
  private readonly lockstep: Promise<Lockstep>;
  until = Infinity;
  private over = false;

  constructor(
    module: WebAssembly.Module, file: Uint8Array, live: Live, told: (part: number) => void,
    drawn: (bytes: Uint8Array, engine: RunningEngine) => void, failed: (error: unknown) => void,
  ) {
    // what ends because the line broke again is joined anew
    const fails = (error: unknown): void => void (this.over || failed(error));
    this.engine = started(module);
    this.lockstep = this.engine.then(async (engine) => {
      const { about, flown } = await engine.follow(file);
      this.until = about.until ?? Infinity;
      const lockstep = new Lockstep(engine, (news) => {
        if (this.over) return;
        if (news.drawn?.length) drawn(news.drawn, engine);
        live.reached(news);
        if (!news.drawn?.length && flown.step) told(Math.min(1, news.step / flown.step));
      }, fails);
      lockstep.grant({ step: flown.step, hash: flown.hash, outcome: 'running' });
      return lockstep;
    });
    this.lockstep.catch(fails);
  }
  grant(grant: Grant): void {
    this.lockstep.then((lockstep) => lockstep.grant(grant), () => {});
  }
  end(): void {
    this.over = true;
    this.engine.then((engine) => engine.end(), () => {});
  }
}

/** Of the place where the page was loaded from. */
function socket_there(): Socket {
  const address = new URL('live', location.href);
  address.protocol = address.protocol.replace('http', 'ws');
  address.search = address.hash = '';
  return new WebSocket(address) as unknown as Socket;
}

export async function open_live(host: HTMLElement): Promise<void> {
  const opening = host.querySelector('#opening');
  const say = (words: string): void => void (opening && (opening.textContent = words));
  say('Joining the mission …');
  const module = await engine_module();
  const about = JSON.parse(new TextDecoder().decode(await unpacked(parts('live')[0]!))) as { home: boolean };
  let joined: Joined | null = null;
  let line: Line | null = null;
  const live = new Live(() => line, () => joined?.until ?? Infinity, about.home);
  let shown: Shown | null = null;
  let view: Partial<View> = {};
  let grown: GrownRun | null = null;
  let refreshed = 0;
  let refresh_after = 0;

  const failed = (error: unknown): void => {
    line?.end();
    shown?.close();
    say_failure(host, 'The mission cannot be shown any longer', error, 'Load the page again to join it anew.');
  };
  /** What has come since is in the run; the panels are drawn when they have not been for long enough. */
  const refresh = (): void => {
    refreshed = 0;
    const begun = performance.now();
    shown!.grow();
    requestAnimationFrame(() => (refresh_after = Math.max(begun + kRefresh, begun + kSpare * (performance.now() - begun))));
  };
  const drawn = (bytes: Uint8Array, engine: RunningEngine): void => {
    if (!grown) {
      grown = new GrownRun(bytes, engine);
      if (shown) {
        const { run, store } = live.page!;
        view = view_in(grown.run, run, store.get());
        shown.close();
      }
      shown = show([grown.run], host, view, undefined, live);
      refresh_after = performance.now() + kRefresh;
      return;
    }
    grown.add(bytes);
    refreshed ||= window.setTimeout(refresh, Math.max(0, refresh_after - performance.now()));
  };

  line = new Line(socket_there, {
    joined(file) {
      joined?.end();
      live.disagreement.set(null);
      live.checked.set(-1);
      grown = null;
      joined = new Joined(module, file, live, (part) => say(`Flying along: ${Math.floor(100 * part)} %`), drawn, failed);
    },
    news(news) {
      live.news(news);
      joined?.grant(news);
    },
    pacing: (pacing) => live.pacing.set(pacing),
    refused: (words) => live.refused(words),
    broken(words) {
      live.broken(words);
      if (!shown) say(`There is no line to the program (${words}); it is tried again …`);
    },
  });
}
