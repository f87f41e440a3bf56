// SPDX-License-Identifier: MIT
/** The air picture as a file: PNG, SVG, or a film of it as it plays. */
import { useEffect, useRef, useState } from 'preact/hooks';
import type { AirPicture } from '../scene/scene.ts';
import { use_page } from './page.ts';
import { use_view } from './use.ts';

function save(blob: Blob, name: string): void {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}

/** Pictures a second. */
const kRate = 30;

export function SaveMenu({ scene }: { scene: { current: AirPicture | null } }) {
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
