// SPDX-License-Identifier: MIT
/** What the user looks at: one object, changed in patches, that scene and panels follow. */

export type Camera = 'free' | 'follow' | 'top' | 'whole';

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

export interface View {
  /** s */
  time: number;
  playing: boolean;
  /** s: how far the timeline goes. */
  end: number;
  /** Times real time. */
  rate: number;
  /** Index into Run.players. */
  selected: number;
  camera: Camera;
  /** Of the cameras free and top, told when they rest; null: nobody has moved them. */
  pose: Pose | null;
  /** Players (indices) between which range and bearing are shown. */
  ruler: [number, number] | null;
  ghost: Ghost | null;
  layers: Record<Layer, boolean>;
  /** Of a strip: s; null: the whole run. */
  zoom: [number, number] | null;
  theme: 'light' | 'dark';
}

export const kLayers = ['trails', 'drop_lines', 'radar', 'tracks', 'zones', 'routes', 'labels', 'coast'] as const;
export type Layer = (typeof kLayers)[number];

export type Listener = (now: View, before: View) => void;

export class Store {
  private view: View;
  private readonly listeners = new Set<Listener>();

  constructor(view: View) {
    this.view = view;
  }
  get(): View {
    return this.view;
  }
  set(patch: Partial<View>): void {
    const before = this.view;
    this.view = { ...before, ...patch };
    for (const listener of this.listeners) listener(this.view, before);
  }
  /** Returns how to stop listening. */
  subscribe(listener: Listener): () => void {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }
}

export function first_view(selected: number): View {
  return {
    time: 0,
    playing: false,
    end: 0,
    rate: 8,
    selected,
    camera: 'whole',
    pose: null,
    ruler: null,
    ghost: null,
    layers: { trails: true, drop_lines: true, radar: true, tracks: true, zones: true, routes: true, labels: true, coast: true },
    zoom: null,
    theme: globalThis.matchMedia?.('(prefers-color-scheme: dark)').matches ? 'dark' : 'light',
  };
}
