// SPDX-License-Identifier: MIT
/** What a link to a moment says: #t=312.4&p=eagle2&c=follow&z=300-360; e= is where a free camera stands; of theme, layers, units
 * and trails (d=, l=, u=, w=) what is not as usual, which is also remembered. What a playground or a report says stays in it. */
import { listen } from '../events.ts';
import type { Run } from '../run/run.ts';
import { View, kCameras, kFirstLayers, kLayers, kTrails, kUnits, layers_of, systems_theme, type Pose } from '../store.ts';
import type { Page } from './page.ts';

const kTaste = ['theme', 'layers', 'units', 'trail'] as const;
const kTold = ['time', 'selected', 'camera', 'pose', 'zoom', 'ruler', ...kTaste] as const;
const kOthers = ['s', 'measure', 'cell', 'replicate'];
type Taste = Pick<View, (typeof kTaste)[number]>;
type Told = Pick<View, (typeof kTold)[number]>;
const kMemory = 'eyrie';

const short = (value: number, digits: number): string => String(Number(value.toFixed(digits)));

/** The fragment of an address, by name. */
export function said_in(fragment: string): URLSearchParams {
  return new URLSearchParams(fragment.replace(/^#/, ''));
}

/** What is not as usual. */
function taste_text({ theme, layers, units, trail }: Taste): string[] {
  const shown = kLayers.filter((layer) => layers[layer]);
  return [
    ...(theme === systems_theme() ? [] : [`d=${theme}`]),
    ...(shown.join() === kFirstLayers.join() ? [] : [`l=${shown.join()}`]),
    ...(units === kUnits[0] ? [] : [`u=${units}`]),
    ...(trail === 60 ? [] : [`w=${trail}`]),
  ];
}

const is_layer = (name: string): boolean => (kLayers as readonly string[]).includes(name);

function read_taste(said: URLSearchParams): Partial<Taste> {
  const taste: Partial<Taste> = {};
  const theme = said.get('d');
  if (theme === 'light' || theme === 'dark') taste.theme = theme;
  const layers = said.get('l')?.split(',').filter(Boolean);
  if (layers && (!layers.length || layers.some(is_layer))) taste.layers = layers_of(layers);
  const units = kUnits.find((one) => one === said.get('u'));
  if (units) taste.units = units;
  const trail = kTrails.find((one) => String(one) === said.get('w'));
  if (trail) taste.trail = trail;
  return taste;
}

/** What this browser keeps from page to page, or this tab alone; "" for nothing: some are closed to files. */
export function kept(name: string, in_tab = false): string {
  try {
    return (in_tab ? sessionStorage : localStorage).getItem(name) ?? '';
  } catch {
    return '';
  }
}
export function keep(name: string, text: string, in_tab = false): void {
  try {
    (in_tab ? sessionStorage : localStorage).setItem(name, text);
  } catch { /* as above */ }
}

/** What this browser was told on any page before. */
export function remembered(): Partial<Taste> {
  return read_taste(said_in(kept(kMemory)));
}
function remember(taste: Taste): void {
  keep(kMemory, taste_text(taste).join('&'));
}

/** Of a page that shows no run. */
export function remember_theme(theme: View['theme']): void {
  remember({ ...new View(), ...remembered(), theme });
}

export function link_text(run: Run, view: Told, fragment = ''): string {
  const name = (player: number): string => encodeURIComponent(run.players[player]?.name ?? '');
  const parts = [`t=${short(view.time, 2)}`, `p=${name(view.selected)}`, `c=${view.camera}`];
  if (view.pose && (view.camera === 'free' || view.camera === 'top')) parts.push(`e=${view.pose.map((v) => short(v, 4)).join(',')}`);
  if (view.zoom) parts.push(`z=${view.zoom.map((t) => short(t, 2)).join('-')}`);
  if (view.ruler) parts.push(`r=${view.ruler.map(name).join(',')}`);
  parts.push(...taste_text(view));
  const said = said_in(fragment);
  for (const other of kOthers) if (said.has(other)) parts.push(`${other}=${said.get(other)}`);
  return `#${parts.join('&')}`;
}

function seconds(text: string | null, duration: number): number | null {
  const value = text ? Number(text) : NaN;
  return Number.isFinite(value) ? Math.min(Math.max(value, 0), duration) : null;
}

/** What of a link makes sense in this run; the rest is left out. */
export function read_link(run: Run, fragment: string, duration = run.about.duration): Partial<Told> {
  const said = said_in(fragment);
  const player = (name: string | undefined): number => run.players.findIndex((p) => p.name === name);
  const told: Partial<Told> = read_taste(said);

  const time = seconds(said.get('t'), duration);
  if (time !== null) told.time = time;
  const selected = player(said.get('p') ?? undefined);
  if (selected >= 0) told.selected = selected;
  const camera = kCameras.find((c) => c === said.get('c'));
  if (camera) told.camera = camera;
  const pose = (said.get('e') ?? '').split(',').map(Number);
  if (pose.length === 6 && pose.every(Number.isFinite)) told.pose = pose as unknown as Pose;
  const [from, to] = (said.get('z') ?? '').split('-').map((text) => seconds(text, duration));
  if (typeof from === 'number' && typeof to === 'number' && from < to) told.zoom = [from, to];
  const [a, b] = (said.get('r') ?? '').split(',').map(player);
  if (a !== undefined && b !== undefined && a >= 0 && b >= 0 && a !== b) told.ruler = [a, b];
  return told;
}

const kKeys: Readonly<Record<string, keyof Told>> = {
  t: 'time', p: 'selected', c: 'camera', e: 'pose', z: 'zoom', r: 'ruler', d: 'theme', l: 'layers', u: 'units', w: 'trail',
};
/** What of a link was left out: "p=nobody". */
export function not_understood(run: Run, fragment: string): string[] {
  if (is_of_another(run, fragment)) return [];
  const told = read_link(run, fragment);
  return [...said_in(fragment)].flatMap(([key, text]) => {
    if (kOthers.includes(key)) return [];
    const rest = key === 'l' ? text.split(',').filter((name) => name && !is_layer(name)).join() : '';
    return rest || !kKeys[key] || !(kKeys[key] in told) ? [`${key}=${rest || text}`] : [];
  });
}

/** What a link changes in an open page: one to a moment without a stretch and a ruler takes those away. */
export function read_link_in_page(run: Run, fragment: string, duration: number): Partial<Told> {
  return { ...(said_in(fragment).has('t') && { zoom: null, ruler: null }), ...read_link(run, fragment, duration) };
}

// The address that a page has made of another scenario, flown here before, is no link that somebody gave.
const kOwn = 'eyrie-address';
function is_of_another({ about }: Run, fragment: string): boolean {
  const own = kept(kOwn, true);
  return own.endsWith(fragment) && own !== '' && own !== about.scenario + fragment;
}

/** ms: browsers refuse to have it changed much more often. */
const kPace = 500;

/** Keeps the address of the page a link to what it shows. Returns how to stop it. */
export function follow_address({ run, store }: Page): () => void {
  let timer: ReturnType<typeof setTimeout> | null = null;
  const write = (): void => {
    timer = null;
    const text = link_text(run, store.get(), location.hash);
    if (text !== location.hash) history.replaceState(history.state, '', text);
    keep(kOwn, run.about.scenario + text, true);
  };
  const stop = store.subscribe((now, before) => {
    if (kTold.some((key) => now[key] !== before[key])) timer ??= setTimeout(write, kPace);
    if (kTaste.some((key) => now[key] !== before[key])) remember(now);
  });
  const unlisten = listen(window, { hashchange: () => store.set(read_link_in_page(run, location.hash, store.get().end)) });
  return () => {
    stop();
    unlisten();
    clearTimeout(timer ?? undefined);
  };
}
