// SPDX-License-Identifier: MIT
// Bundles the page into one file without data: node build.mjs OUT.html [ENGINE.wasm]. The program puts runs into it
// at the place of <!--%RUNS%-->: run files, which the engine in the page flies again, as <script
// type="application/x-eyrie-run-file">base64</script>, or columns as <script type="application/x-eyrie-run">.
import { build } from 'esbuild';
import { createHash } from 'node:crypto';
import { mkdir, readFile, rename, writeFile } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import { deflateSync } from 'node:zlib';
import { fileURLToPath } from 'node:url';
import { worker_text } from './worker_text.mjs';

const here = dirname(fileURLToPath(import.meta.url));
const out = process.argv[2] ?? join(here, 'dist', 'debrief.html');

const engine = process.argv[3];

const common = { bundle: true, minify: true, write: false, target: 'es2022', legalComments: 'none', logLevel: 'warning' };
const script = await build({ ...common, entryPoints: [join(here, 'src/main.tsx')], format: 'esm', jsx: 'automatic', jsxImportSource: 'preact', loader: { '.json': 'json' }, plugins: [worker_text(common)] });
const style = await build({ ...common, entryPoints: [join(here, 'src/style.css')] });
// the page is packed; these lines unpack and start it
const packed = (bytes) => deflateSync(bytes, { level: 9 }).toString('base64');
const code = `const t=document.getElementById('code').textContent;
const s=new Blob([Uint8Array.from(atob(t),c=>c.charCodeAt(0))]).stream().pipeThrough(new DecompressionStream('deflate'));
import(URL.createObjectURL(new Blob([await new Response(s).text()],{type:'text/javascript'})));`;
const shell = await readFile(join(here, 'index.html'), 'utf8');
const looks = style.outputFiles[0].text;
// nothing but this script and this style: a text of a run that were taken for either would do nothing
const source = (text) => `'sha256-${createHash('sha256').update(text).digest('base64')}'`;
const policy = `default-src 'none'; script-src ${source(code)} blob: 'wasm-unsafe-eval'; worker-src blob:; style-src ${source(looks)}; base-uri 'none'; form-action 'none'`;
const module = engine
  ? `<script type="application/x-eyrie-engine">${packed(await readFile(engine))}</script>`
  : '';
const html = shell.replace('%POLICY%', () => policy).replace('/*%STYLE%*/', () => looks).replace('/*%SCRIPT%*/', () => code)
  .replace('<!--%ENGINE%-->', () => module)
  .replace('%CODE%', () => packed(script.outputFiles[0].contents));
await mkdir(dirname(out), { recursive: true });
await writeFile(`${out}.part`, html);
await rename(`${out}.part`, out);
