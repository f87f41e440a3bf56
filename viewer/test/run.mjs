// SPDX-License-Identifier: MIT
// Bundles each *.test.ts and runs it with node's own test runner: node test/run.mjs [NAME...]
import { build } from 'esbuild';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readdirSync, rmSync } from 'node:fs';
import { availableParallelism, tmpdir } from 'node:os';
import { basename, dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { worker_text } from '../worker_text.mjs';

const here = dirname(fileURLToPath(import.meta.url));
const wanted = process.argv.slice(2);
const names = readdirSync(here).filter((f) => f.endsWith('.test.ts') && (!wanted.length || wanted.some((w) => f.startsWith(w))));
if (!names.length) {
  console.error(`no test of viewer/test begins with ${wanted.join(' or ')}`);
  process.exit(2);
}
const out = mkdtempSync(join(tmpdir(), 'eyrie-viewer-'));
try {
  await build({
    entryPoints: names.map((f) => join(here, f)), outdir: out, outExtension: { '.js': '.mjs' }, bundle: true, platform: 'node', format: 'esm',
    target: 'node18', jsx: 'automatic', jsxImportSource: 'preact', sourcemap: 'inline', logLevel: 'warning', external: ['puppeteer-core'],
    plugins: [worker_text({})],
  });
  const files = names.map((f) => join(out, basename(f).replace(/\.ts$/, '.mjs')));
  // by itself node would leave one processor free; before 18.19 it cannot be told
  const wide = `--test-concurrency=${availableParallelism()}`;
  const abreast = spawnSync(process.execPath, [wide, '--version']).status === 0 ? [wide] : [];
  const { status } = spawnSync(process.execPath, ['--enable-source-maps', '--test', ...abreast, ...files], { stdio: 'inherit', env: { ...process.env, EYRIE_VIEWER_FOLDER: dirname(here) } });
  process.exitCode = status ?? 1;
} finally {
  rmSync(out, { recursive: true, force: true });
}
