// SPDX-License-Identifier: MIT
/** What buttons and keys do. */
import { last_at } from '../run/run.ts';
import { kCameras } from '../store.ts';
import { neighbor } from './marks.ts';
import { range_of, type Page } from './page.ts';
import { leader_spans } from './spans.ts';

export const kRates = [0.5, 1, 2, 4, 8, 16, 32, 64];
/** s: the shortest stretch that the strips show. */
const kShortest = 2;

export function jump(page: Page, time: number): void {
  const t = Math.min(Math.max(time, 0), page.store.get().end);
  page.store.set({ time: t });
  bring_in_sight(page, t);
}

/** Into the middle of what the strips show, if it is outside of that. */
export function bring_in_sight(page: Page, t: number): void {
  const { zoom } = page.store.get();
  const half = zoom && (zoom[1] - zoom[0]) / 2;
  if (half && (t < zoom[0] || t > zoom[1])) zoom_to(page, t - half, t + half);
}

/** The decision that a line of the story comes of. */
export function show_cause(page: Page, line: number): void {
  const { decider, decided } = page.run.story[line]!;
  if (decider >= 0) select(page, decider);
  jump(page, decided);
}

export function toggle_play({ store, live }: Page): void {
  if (live) return live.toggle();
  const { playing, time, end } = store.get();
  store.set(playing ? { playing: false } : { playing: true, time: time >= end - 0.01 ? 0 : time });
}

export function change_rate({ store, live }: Page, direction: 1 | -1): void {
  if (live) return live.change_rate(direction);
  const at = kRates.indexOf(store.get().rate) + direction;
  if (kRates[at] !== undefined) store.set({ rate: kRates[at] });
}

/** To the next or the previous decision of the selected player. */
export function step_decision(page: Page, direction: 1 | -1): void {
  const { time, selected } = page.store.get();
  const { t } = page.run.players[selected]!.decisions;
  const now = last_at(t, time);
  // between two decisions the one before is where it was
  const next = direction < 0 && now >= 0 && time - t[now]! > 1e-6 ? now : now + direction;
  page.store.set({ playing: false });
  if (t[next] !== undefined) jump(page, t[next]!);
}

export function step_mark(page: Page, direction: 1 | -1): void {
  const t = neighbor(page.marks.map((mark) => mark.t), page.store.get().time, direction);
  if (t !== null) jump(page, t);
}

/** To where somebody else begins to lead in the tree of the selected player. */
export function step_leader(page: Page, direction: 1 | -1): void {
  const { time, selected } = page.store.get();
  const t = neighbor(leader_spans(page.run, page.run.players[selected]!).map((span) => span.from), time, direction);
  if (t !== null) jump(page, t);
}

export function select(page: Page, player: number): void {
  if (page.run.players[player]) page.store.set({ selected: player, ghost: null });
}

/** Range and bearing between the selected player and `player`; once more takes them away. */
export function measure({ store }: Pick<Page, 'store'>, player: number): void {
  const { selected, ruler } = store.get();
  store.set({ ruler: player === selected || (ruler?.[0] === selected && ruler[1] === player) ? null : [selected, player] });
}

export function next_camera({ store }: Page): void {
  store.set({ camera: kCameras[(kCameras.indexOf(store.get().camera) + 1) % kCameras.length]! });
}

export function toggle_theme({ store }: Page): void {
  store.set({ theme: store.get().theme === 'dark' ? 'light' : 'dark' });
}

/** Makes the strips show `factor` times as much, with `around` (s) staying in its place. */
export function zoom_by(page: Page, factor: number, around: number): void {
  const [from, to] = range_of(page.store.get());
  const width = Math.max((to - from) * factor, kShortest);
  const part = (around - from) / (to - from);
  zoom_to(page, around - part * width, around + (1 - part) * width);
}

/** The strips show [from, to], moved into the run. */
export function zoom_to({ store }: Page, from: number, to: number): void {
  const { end } = store.get();
  const width = Math.max(to - from, kShortest);
  if (width >= end) return store.set({ zoom: null });
  const begin = Math.min(Math.max(from, 0), end - width);
  store.set({ zoom: [begin, begin + width] });
}

export function pan_by(page: Page, seconds: number): void {
  const [from, to] = range_of(page.store.get());
  if (page.store.get().zoom) zoom_to(page, from + seconds, to + seconds);
}

/** While it plays, what the strips show goes along. Returns how to stop it. */
export function keep_in_sight(page: Page): () => void {
  return page.store.subscribe(({ playing, time, zoom, end }) => {
    if (!playing || !zoom || (time >= zoom[0] && time <= zoom[1])) return;
    const width = zoom[1] - zoom[0];
    const begin = Math.max(0, Math.min(time - 0.05 * width, end - width));
    // this listener hears of its own change, too
    if (Math.abs(begin - zoom[0]) > 1e-6) zoom_to(page, begin, begin + width);
  });
}

/** From a minute before the first shot to a minute after the last one or the last loss; null: there was none. */
export function fight_of({ run, marks }: Pick<Page, 'run' | 'marks'>): [number, number] | null {
  const shots = run.story.filter(({ kind }) => kind === 'launch' || kind === 'gun_burst').map(({ t }) => t);
  const kills = marks.filter(({ kind }) => kind === 'kill').map(({ t }) => t);
  return shots.length ? [Math.min(...shots) - 60, Math.max(...shots, ...kills) + 60] : null;
}

/** Half a minute around the present, or the whole run again. */
export function toggle_zoom(page: Page): void {
  const { zoom, time } = page.store.get();
  if (zoom) page.store.set({ zoom: null });
  else zoom_to(page, time - 15, time + 15);
}
