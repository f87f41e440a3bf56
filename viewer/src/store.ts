// SPDX-License-Identifier: MIT
/** What the user looks at: one object, changed in patches, that scene and panels follow. */

export const kCameras = ['whole', 'follow', 'top', 'free'] as const;
export type Camera = (typeof kCameras)[number];

/** Where a proposal that lost would have led: drawn in the air picture. */
export interface Ghost {
  player: number;
  t: number;
  /** rad true; m; m/s; null: as flown. */
  heading: number | null;
  altitude: number | null;
  speed: number | null;
  label: string;
}

/** Where a camera that nothing moves stands: the place it looks at (km east, up, south of the origin), km of the scene in the picture
 * there, and rad from north and from straight down. */
export type Pose = readonly [x: number, y: number, z: number, height: number, azimuth: number, polar: number];

export class View {
  time = 0;  // s
  playing = false;
  end = 0;  // s: how far the timeline goes; of the longer one of two runs, or of the other future.
  rate = 8;  // Times real time.
  selected = 0;  // Index into Run.players.
  camera: Camera = 'whole';
  pose: Pose | null = null;  // Of the cameras free and top, told when they rest; null: nobody has moved them.
  ruler: [number, number] | null = null;  // Players (indices) between which range and bearing are shown.
  ghost: Ghost | null = null;
  layers = layers_of(kFirstLayers);
  zoom: [number, number] | null = null;  // Of a strip: s; null: the whole run.
  theme = systems_theme();
  units: Units = kUnits[0];
  trail = 60;  // s: how much of the ways behind everybody is drawn; Infinity: all.
}

export const kUnits = ['aviation', 'metric'] as const;
export type Units = (typeof kUnits)[number];
export const kTrails = [20, 60, 300, Infinity];

export const kLayers = ['trails', 'drop_lines', 'radar', 'tracks', 'zones', 'routes', 'rings', 'bullseye', 'labels', 'coast'] as const;
export type Layer = (typeof kLayers)[number];
/** Shown until somebody chooses otherwise. */
export const kFirstLayers: readonly Layer[] = kLayers.filter((layer) => layer !== 'rings' && layer !== 'bullseye');

type Listener<T> = (now: T, before: T) => void;

/** One value that others share and follow. */
export class Cell<T> {
  private readonly listeners = new Set<Listener<T>>();

  constructor(private value: T) {}
  get(): T {
    return this.value;
  }
  set(value: T): void {
    const before = this.value;
    if (Object.is(value, before)) return;
    this.value = value;
    for (const listener of this.listeners) listener(this.value, before);  // as it is, if one of them has changed it
  }
  /** Returns how to stop listening. */
  subscribe(listener: Listener<T>): () => void {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }
}

export class Store extends Cell<View> {
  override set(patch: Partial<View>): void {
    super.set({ ...this.get(), ...patch });
  }
}

export function systems_theme(): 'light' | 'dark' {
  return globalThis.matchMedia?.('(prefers-color-scheme: dark)').matches ? 'dark' : 'light';
}
export function layers_of(shown: readonly string[]): Record<Layer, boolean> {
  return Object.fromEntries(kLayers.map((layer) => [layer, shown.includes(layer)])) as Record<Layer, boolean>;
}
