// SPDX-License-Identifier: MIT
// Bundles the page into one file without data: node build.mjs OUT.html. The program puts runs into it
// at the place of <!--%RUNS%-->, each as <script type="application/x-eyrie-run">base64</script>.
import { build } from 'esbuild';
import { createHash } from 'node:crypto';
import { mkdir, readFile, rename, writeFile } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));
const out = process.argv[2] ?? join(here, 'dist', 'debrief.html');

const common = { bundle: true, minify: true, write: false, target: 'es2022', legalComments: 'none', logLevel: 'warning' };
const script = await build({ ...common, entryPoints: [join(here, 'src/main.tsx')], format: 'esm', jsx: 'automatic', jsxImportSource: 'preact', loader: { '.json': 'json' } });
const style = await build({ ...common, entryPoints: [join(here, 'src/style.css')] });
const code = script.outputFiles[0].text.replaceAll('</script', '<\\/script');
const shell = await readFile(join(here, 'index.html'), 'utf8');
const looks = style.outputFiles[0].text;
// nothing but this script and this style: a text of a run that were taken for either would do nothing
const source = (text) => `'sha256-${createHash('sha256').update(text).digest('base64')}'`;
const policy = `default-src 'none'; script-src ${source(code)}; style-src ${source(looks)}; base-uri 'none'; form-action 'none'`;
const html = shell.replace('%POLICY%', () => policy).replace('/*%STYLE%*/', () => looks).replace('/*%SCRIPT%*/', () => code);
await mkdir(dirname(out), { recursive: true });
await writeFile(`${out}.part`, html);
await rename(`${out}.part`, out);
