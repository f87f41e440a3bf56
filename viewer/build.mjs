// SPDX-License-Identifier: MIT
// Bundles each page into one file without data: node build.mjs FOLDER [ENGINE.wasm] makes debrief.html, and playground.html
// if there is an engine. The program puts what they show at the place of <!--%PARTS%-->, each as <script
// type="application/x-eyrie-TYPE">a zlib stream as text</script>: run files, which the engine in the page flies again,
// columns where there is none, launch zones, and the texts of a playground.
import { build } from 'esbuild';
import { spawnSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { mkdir, readdir, readFile, rename, rm, writeFile } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import { deflateSync } from 'node:zlib';
import { fileURLToPath } from 'node:url';
import { ascii85 } from './ascii85.mjs';
import { worker_text } from './worker_text.mjs';

const here = dirname(fileURLToPath(import.meta.url));
const folder = process.argv[2] ?? join(here, 'dist');
const engine = process.argv[3];

const common = { bundle: true, minify: true, write: false, metafile: true, target: 'es2022', legalComments: 'none', logLevel: 'warning' };
const bundled = async (file, options = {}) => {
  const { outputFiles, metafile } = await build({ ...common, absWorkingDir: here, entryPoints: [join(here, file)], ...options });
  return { ...outputFiles[0], text: outputFiles[0].text, inputs: Object.keys(metafile.inputs) };
};

// Whose code a page holds, and on which terms: what each package says itself, every text once.
async function notices(inputs) {
  const found = inputs.map((input) => /^node_modules\/((?:@[^/]+\/)?[^/]+)\//.exec(input)?.[1]);
  const by_text = new Map();
  for (const name of [...new Set(found)].filter(Boolean).sort()) {
    const folder = join(here, 'node_modules', name);
    const file = (await readdir(folder)).find((entry) => /^licen[cs]e/i.test(entry));
    const { version, license } = JSON.parse(await readFile(join(folder, 'package.json'), 'utf8'));
    const text = file ? (await readFile(join(folder, file), 'utf8')).trim() : `Licence: ${license}`;
    by_text.set(text, [...(by_text.get(text) ?? []), `${name} ${version}`]);
  }
  const parts = [...by_text].map(([text, names]) => `${names.join(', ')}\n\n${text}`);
  return `\n<!--\nThis page holds the following packages.\n\n${parts.join('\n\n')}\n-->\n`.replace(/(?<!^\n<!)--(?!>\n$)/g, '- -');
}
const packed = (bytes) => ascii85(deflateSync(bytes, { level: 9 }));
// zopfli's zlib streams are a twentieth smaller
async function packed_engine(file) {
  const { status, stdout } = spawnSync('zopfli', ['--zlib', '-c', file], { maxBuffer: 1e8 });
  if (status === 0) return ascii85(stdout);
  console.warn('zopfli is not installed, or failed: the pages get 50 kB larger');
  return packed(await readFile(file));
}
const whole = await bundled('src/whole.ts', { format: 'iife' });
const start = await bundled('src/start.ts', { format: 'esm' });
// nothing but these scripts and this style: a text of a run that were taken for either would do nothing
const source = (text) => `'sha256-${createHash('sha256').update(text).digest('base64')}'`;
const module = engine ? `<script type="application/x-eyrie-engine">${await packed_engine(engine)}</script>` : '';
const shell = await readFile(join(here, 'index.html'), 'utf8');

async function make(name, title, script_file, style_file) {
  const script = await bundled(script_file, { format: 'esm', jsx: 'automatic', jsxImportSource: 'preact', loader: { '.json': 'json' }, plugins: [worker_text(common)] });
  const style = await bundled(style_file);
  const looks = style.text;
  const policy = `default-src 'none'; script-src ${source(whole.text)} ${source(start.text)} blob: 'wasm-unsafe-eval'; worker-src blob:; style-src ${source(looks)}; img-src data:; base-uri 'none'; form-action 'none'`;
  const html = shell.replace('%POLICY%', () => policy).replace('%TITLE%', title).replace('/*%STYLE%*/', () => looks)
    .replace('/*%WHOLE%*/', () => whole.text).replace('/*%SCRIPT%*/', () => start.text).replace('<!--%ENGINE%-->', () => module).replace('%CODE%', () => packed(script.contents));
  const out = join(folder, name);
  await writeFile(`${out}.part`, html + (await notices([...script.inputs, ...style.inputs])));
  await rename(`${out}.part`, out);
}

await mkdir(folder, { recursive: true });
await make('debrief.html', 'Eyrie debrief', 'src/main.tsx', 'src/style.css');
if (engine) await make('playground.html', 'Eyrie playground', 'src/play/playground.tsx', 'src/play/style.css');
else await rm(join(folder, 'playground.html'), { force: true });
