// SPDX-License-Identifier: MIT
// esbuild: `import code from 'worker:./x.ts'` is the bundled text of a worker.
import { build } from 'esbuild';
import { join } from 'node:path';

export const worker_text = (common) => ({
  name: 'worker',
  setup(plugins) {
    plugins.onResolve({ filter: /^worker:/ }, ({ path, resolveDir }) => ({ path: join(resolveDir, path.slice('worker:'.length)), namespace: 'worker' }));
    plugins.onLoad({ filter: /.*/, namespace: 'worker' }, async ({ path }) => {
      const { outputFiles } = await build({ ...common, bundle: true, write: false, format: 'iife', entryPoints: [path] });
      return { contents: outputFiles[0].text, loader: 'text' };
    });
  },
});
