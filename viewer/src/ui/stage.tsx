// SPDX-License-Identifier: MIT
/** The air picture with its camera and layers, and how to keep it: as PNG, SVG, or a film of it as it plays. */
import { useEffect, useRef, useState } from 'preact/hooks';
import { AirPicture } from '../scene/scene.ts';
import { kCameras, kLayers, kTrails, kUnits, type Camera, type Layer, type Units } from '../store.ts';
import { use_page } from './page.ts';
import { use_view } from './use.ts';

const kCameraHelp: Record<Camera, string> = {
  whole: 'Everybody in the picture', follow: 'Follow the selected player (f)', top: 'From above, north up',
  free: 'Stay where the camera is',
};
const kLayerWords: Record<Layer, string> = {
  trails: 'trails', drop_lines: 'heights', radar: 'radar', tracks: 'tracks it has', zones: 'missile zones', routes: 'routes',
  rings: 'range rings', bullseye: 'bullseye', labels: 'names', coast: 'coast',
};
const kUnitWords: Record<Units, string> = { aviation: 'ft, nmi, kt', metric: 'm, km, km/h' };

function save(blob: Blob, name: string): void {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}

/** Pictures a second. */
const kRate = 30;

function SaveMenu({ scene }: { scene: { current: AirPicture | null } }) {
  const { run, store, letter } = use_page();
  const playing = use_view(store, (v) => v.playing);
  const [filming, set_filming] = useState(false);
  const film = useRef<MediaRecorder | null>(null);
  const name = (kind: string): string => `${run.about.scenario}${letter && `-${letter}`}-${store.get().time.toFixed(0)}s.${kind}`;
  const picture = (): void => void scene.current!.picture().toBlob((blob) => blob && save(blob, name('png')));
  const begin = (): void => {
    if (!globalThis.MediaRecorder?.isTypeSupported('video/webm')) return alert('This browser cannot record films in WebM.');
    const { canvas, stop } = scene.current!.film();
    const recorder = new MediaRecorder(canvas.captureStream(kRate), { mimeType: 'video/webm', videoBitsPerSecond: 8e6 });
    const parts: Blob[] = [];
    const file = name('webm');
    recorder.ondataavailable = ({ data }) => parts.push(data);
    recorder.onstop = () => {
      stop();
      set_filming(false);
      save(new Blob(parts, { type: 'video/webm' }), file);
    };
    film.current = recorder;
    recorder.start();
    set_filming(true);
    const { time, end } = store.get();
    store.set({ playing: true, time: time >= end - 0.01 ? 0 : time });
  };
  // it ends when the playing does
  useEffect(() => {
    if (!playing && film.current?.state === 'recording') film.current.stop();
  }, [playing]);
  if (filming) return <button type="button" class="filming" onClick={() => store.set({ playing: false })}>● stop the film</button>;
  return (
    <details class="menu">
      <summary aria-label="save the picture or a film">save</summary>
      <div class="menu-body glyphs">
        <button type="button" onClick={picture}>picture, PNG</button>
        <button type="button" onClick={() => save(new Blob([scene.current!.svg()], { type: 'image/svg+xml' }), name('svg'))}>picture, SVG</button>
        <button type="button" onClick={begin}>film from here, WebM</button>
      </div>
    </details>
  );
}

function Tools({ scene }: { scene: { current: AirPicture | null } }) {
  const { store, letter } = use_page();
  const camera = use_view(store, (v) => v.camera);
  const layers = use_view(store, (v) => v.layers);
  const units = use_view(store, (v) => v.units);
  const trail = use_view(store, (v) => v.trail);
  const ruler = use_view(store, (v) => v.ruler);
  return (
    <div class="stage-tools">
      {letter && <b class="letter">{letter}</b>}
      <div class="segments" role="group" aria-label="Camera">
        {kCameras.map((one) => (
          <button type="button" key={one} aria-pressed={camera === one} title={kCameraHelp[one]} aria-label={`${one}: ${kCameraHelp[one]}`}
            onClick={() => store.set({ camera: one })}>{one}</button>
        ))}
      </div>
      <details class="menu">
        <summary aria-label="Layers of the air picture">layers</summary>
        <div class="menu-body">
          {kLayers.map((layer) => (
            <label key={layer}><input type="checkbox" checked={layers[layer]} aria-label={`Layer ${kLayerWords[layer]}`}
              onChange={() => store.set({ layers: { ...layers, [layer]: !layers[layer] } })} />{kLayerWords[layer]}</label>
          ))}
          <label>trails of <select aria-label="Length of the trails" value={trail} onChange={(event) => store.set({ trail: Number(event.currentTarget.value) })}>
            {kTrails.map((one) => <option key={one} value={one}>{one === Infinity ? 'the whole run' : one < 60 ? `${one} s` : `${one / 60} min`}</option>)}
          </select></label>
          <label>units <select aria-label="Units" value={units} onChange={(event) => store.set({ units: event.currentTarget.value as Units })}>
            {kUnits.map((one) => <option key={one} value={one}>{kUnitWords[one]}</option>)}
          </select></label>
        </div>
      </details>
      <SaveMenu scene={scene} />
      {ruler && <button type="button" aria-label="Take the ruler away" onClick={() => store.set({ ruler: null })}>ruler ✕</button>}
    </div>
  );
}

export function Stage({ onMount }: { onMount: (scene: AirPicture) => void }) {
  const { run, store, other, letter } = use_page();
  const host = useRef<HTMLDivElement>(null);
  const scene = useRef<AirPicture | null>(null);
  useEffect(() => {
    const made = (scene.current = new AirPicture(host.current!, run, store, other));
    onMount(made);
    return () => made.dispose();
  }, [store]);
  return (
    <section class="stage" aria-label={letter ? `Air picture of run ${letter}` : 'Air picture'} data-run={letter}>
      <div class="scene" ref={host} />
      <Tools scene={scene} />
    </section>
  );
}
