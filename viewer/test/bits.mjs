// SPDX-License-Identifier: MIT
// Flies scenarios with the engine as WebAssembly and compares their hashes with the golden ones:
// node test/bits.mjs ENGINE.wasm HOME WHERE [SCENARIO...]   WHERE: node, chromium or firefox
import { build } from 'esbuild';
import { readdirSync, readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import puppeteer from 'puppeteer-core';
import { worker_text } from '../worker_text.mjs';

const here = dirname(fileURLToPath(import.meta.url));
const [engine_file, home, where, ...wanted] = process.argv.slice(2);
const golden = new Map();
let name = '';
for (const line of readFileSync(join(home, 'tests/determinism/golden_runs.txt'), 'utf8').split('\n')) {
  name = /^(\w+) seed /.exec(line)?.[1] ?? name;
  const hash = /^ {2}hash (\w+)/.exec(line)?.[1];
  if (hash) golden.set(name, hash);
}
const names = wanted.length ? wanted : [...golden.keys()];

const files = {};
const read = (folder) => {
  for (const entry of readdirSync(join(home, folder), { withFileTypes: true })) {
    const file = `${folder}/${entry.name}`;
    if (entry.isDirectory()) read(file);
    else if (file.endsWith('.yaml')) files[file] = readFileSync(join(home, file), 'utf8');
    else if (file.endsWith('.safetensors')) files[file] = readFileSync(join(home, file), 'base64');
  }
};
read('data');
read('scenarios');

const common = { bundle: true, write: false, target: 'es2022', logLevel: 'warning' };
const bundle = async (source, format) => (await build({
  ...common, stdin: { contents: source, resolveDir: join(here, '../src/engine'), loader: 'ts' }, format, plugins: [worker_text(common)],
})).outputFiles[0].text;

/** Where the engine runs: what flies a scenario to its hash. */
async function in_node() {
  const code = await bundle("export { Instance } from './module.ts';", 'esm');
  const { Instance } = await import(`data:text/javascript;base64,${Buffer.from(code).toString('base64')}`);
  const instance = await Instance.of(await WebAssembly.compile(readFileSync(engine_file)), () => {});
  return {
    async fly(scenario) {
      instance.ask('load', { texts: { files, scenario } });
      return instance.ask('fly', {}).answer.hash;
    },
    async end() {},
  };
}
const kBrowsers = {
  chromium: { browser: 'chrome', executablePath: process.env.EYRIE_CHROMIUM ?? '/usr/bin/chromium', args: ['--no-sandbox', '--disable-dev-shm-usage'] },
  firefox: { browser: 'firefox', executablePath: process.env.EYRIE_FIREFOX ?? '/usr/bin/firefox-esr', args: [] },
};
async function in_browser(options) {
  const browser = await puppeteer.launch({ headless: true, protocolTimeout: 600_000, ...options });
  const page = await browser.newPage();
  await page.evaluate(await bundle("import { start } from './engine.ts'; globalThis.start = start;", 'iife'));
  await page.evaluate(async (base64) => {
    const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
    globalThis.engine = start(await WebAssembly.compile(bytes), () => {});
  }, readFileSync(engine_file).toString('base64'));
  await page.evaluate((texts) => void (globalThis.files = texts), files);
  return {
    fly: (scenario) => page.evaluate(async (one) => {
      await engine.load({ texts: { files, scenario: one } });
      return (await engine.fly({})).hash;
    }, scenario),
    end: () => browser.close(),
  };
}

const flier = await (where === 'node' ? in_node() : in_browser(kBrowsers[where]));
let wrong = 0;
for (const one of names) {
  const hash = await flier.fly(`scenarios/${one}.yaml`);
  if (hash === golden.get(one)) continue;
  ++wrong;
  console.log(`${one}: ${where} ends with ${hash}, expected ${golden.get(one) ?? 'that it had a golden run'}`);
}
await flier.end();
if (wrong) process.exit(1);
console.log(`${names.length} scenarios in ${where}: the same bits`);
