// SPDX-License-Identifier: MIT
/** What the page shows of itself to tests. */
import type { Run } from '../run/run.ts';
import type { AirPicture } from '../scene/scene.ts';
import type { Store } from '../store.ts';

declare global {
  interface Window {
    eyrie?: {
      /** The first run, its store and its air picture. */
      run: Run;
      store: Store;
      scene: AirPicture;
      runs: Run[];
    };
  }
}
