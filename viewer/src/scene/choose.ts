// SPDX-License-Identifier: MIT
/** What the browser can draw with, and what is shown if it cannot. */
import type { Store } from '../store.ts';
import { css, palette_of } from './palette.ts';
import type { SceneHandle } from './scene.ts';

/** Whether there is no graphics card, and the processor stands in for it. */
export function is_slow(): boolean {
  const probe = document.createElement('canvas').getContext('webgl2');
  const named = probe?.getExtension('WEBGL_debug_renderer_info');
  const name: unknown = probe && named && probe.getParameter(named.UNMASKED_RENDERER_WEBGL);
  probe?.getExtension('WEBGL_lose_context')?.loseContext();
  return typeof name === 'string' && /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name);
}

/** Instead of the picture, where the browser cannot draw it. */
export function mount_apology(host: HTMLElement, store: Store): SceneHandle {
  const text = 'The air picture needs WebGL 2, which this browser does not offer or has switched off. Everything else on this page works.';
  const box = document.createElement('p');
  box.textContent = text;
  box.style.cssText = 'position:absolute;inset:0;margin:0;padding:2rem;display:grid;place-items:center;text-align:center';
  host.setAttribute('role', 'img');
  host.setAttribute('aria-label', text);
  host.append(box);
  const paint = (): void => {
    const palette = palette_of(store.get().theme);
    box.style.color = css(palette.text);
    box.style.backgroundColor = css(palette.sea);
  };
  paint();
  const stop = store.subscribe(paint);
  return {
    resize: () => undefined,
    frames: () => ({ count: 0, worst_ms: 0, mean_ms: 0 }),
    dispose: () => {
      stop();
      box.remove();
    },
  };
}
