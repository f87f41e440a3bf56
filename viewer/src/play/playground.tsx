// SPDX-License-Identifier: MIT
/** The playground: the text of a scenario at the left, what became of it at the right. Opened with the texts that stand in the page. */
import { useEffect, useMemo, useReducer, useRef, useState } from 'preact/hooks';
import { EngineError, words_of } from '../engine/module.ts';
import type { Problem } from '../engine/questions.ts';
import { listen } from '../events.ts';
import { engine_module, painted, parts, started } from '../parts.ts';
import { type Opening, type Shown, flown_again, put_theme, say_failure, show_as_flown } from '../show.tsx';
import { View } from '../store.ts';
import { Logo } from '../ui/header.tsx';
import { IconButton } from '../ui/icon.tsx';
import { mind_manners } from '../ui/keys.tsx';
import { remember_theme, remembered } from '../ui/link.ts';
import { Splitter } from '../ui/splitter.tsx';
import { copy_text } from '../ui/what_if.tsx';
import { use_asked } from '../ui/what_if_answer.ts';
import { Address } from './address.ts';
import { type Editor, make_editor } from './editor.ts';
import { Flier, type Flight } from './flights.ts';
import {
  type Files, type Project, edited, help_of, is_seed, kFirst, name_of, scenarios, seed_of, text_of, texts_of, tree_names,
  with_includes,
} from './project.ts';
import { Results } from './results.tsx';
import { Grammar, type Schema } from './schema.ts';
import { render } from 'preact';
import { unpacked } from '../packed.ts';

/** ms that the keyboard rests before the loader is asked. */
const kRest = 150;
const kMostFlights = 20;
const kTooLarge = 'The changes are too large for a link';

/** What the loader said last of a project, asked when the keyboard rests, and whether that was of what the text is now. */
function use_loader(module: WebAssembly.Module, project: Project): { problems: Problem[]; is_now: boolean } {
  const engine = useRef<ReturnType<typeof started> | null>(null);
  const { scenario, edits } = project;
  const texts = useMemo(() => ({ files: texts_of(project), scenario }), [scenario, edits]);
  const asked = use_asked(texts, async () => (await (engine.current ??= started(module))).validate(texts), kRest);
  const failed = asked?.problem !== undefined && [{ file: scenario, line: 0, column: 0, message: asked.problem }];
  return { problems: failed || (asked?.value?.problems ?? []), is_now: asked?.key === texts };
}

/** The names that a key takes from the texts. */
function names_for(project: Project, path: readonly string[]): string[] {
  const key = path.at(-1);
  if (key === 'tree' || key === 'swap_tree') return tree_names(project);
  if (key === 'extends') return scenarios(project.shipped).map(name_of);
  if (key === 'include') return Object.keys(project.shipped).filter((file) => file.startsWith('scenarios/packages/')).map((file) => file.replace('scenarios/', ''));
  const folder = ['aircraft', 'vehicles'].find((kind) => kind.replace(/s$/, '') === key);
  return folder ? Object.keys(project.shipped).filter((file) => file.startsWith(`data/${folder}/`)).map(name_of) : [];
}

function Tabs({ project, file, onChoose }: { project: Project; file: string; onChoose: (file: string) => void }) {
  const tabs = with_includes(project, project.scenario);
  const others = Object.keys(project.shipped).filter((one) => one.startsWith('data/') && !tabs.includes(one));
  const label = (one: string): string => `${one.replace(/^(scenarios|data)\//, '')}${one in project.edits ? ' •' : ''}`;
  return (
    <nav class="tabs" aria-label="Files of the scenario">
      {tabs.map((one) => <button type="button" key={one} aria-pressed={one === file} data-file={one} onClick={() => onChoose(one)}>{label(one)}</button>)}
      <select aria-label="Another file" class={others.includes(file) ? 'chosen' : ''} value={others.includes(file) ? file : ''}
        onChange={(event) => onChoose(event.currentTarget.value || project.scenario)}>
        <option value="">data …</option>
        {others.map((one) => <option key={one} value={one}>{label(one)}</option>)}
      </select>
    </nav>
  );
}

function Problems({ said: { problems, is_now }, onGo }: { said: ReturnType<typeof use_loader>; onGo: (problem: Problem) => void }) {
  const state = problems.length ? 'wrong' : 'right';
  return (
    <section class={`problems ${state}`} aria-label="Mistakes" aria-live="polite" data-state={is_now ? state : 'reading'}>
      {state === 'right' && <p class={is_now ? 'right-text' : 'dim'}>{is_now ? '✓ The loader finds no mistake.' : 'The loader reads …'}</p>}
      <ol>
        {problems.map((one, i) => (
          <li key={i}>
            <button type="button" class="problem" onClick={() => onGo(one)}>
              <code>{one.line ? `${one.file}:${one.line}:${one.column}` : one.file}</code> {one.message}
            </button>
          </li>
        ))}
      </ol>
    </section>
  );
}

interface Texts {
  files: Files;
  schema: Schema;
}

function Playground({ files, schema, module, host, view }: Texts & { module: WebAssembly.Module; host: HTMLElement; view: View }) {
  const first: Project = { shipped: files, edits: {}, scenario: kFirst, seed: '' };
  const [project, put] = useState(first);
  const [file, put_file] = useState(kFirst);
  // edits that "as shipped" took away, until something is edited
  const [dropped, drop] = useState<Files | null>(null);
  // counts what changes the text besides the editor
  const [version, count] = useReducer((n: number) => n + 1, 0);
  const [flights, put_flights] = useState<Flight[]>([]);
  const [flying, put_flying] = useState<Flight | null>(null);
  const [busy, put_busy] = useState('');
  const [note, put_note] = useState('');
  const [theme, set_theme] = useState(view.theme);
  const [right, set_right] = useState(0);
  const editor = useRef<Editor | null>(null);
  const place = useRef<HTMLDivElement>(null);
  const flier = useMemo(() => new Flier(module), [module]);
  const address = useMemo(() => new Address(first), []);
  // whether a link can hold what is edited
  const [fits, put_fits] = useState(true);
  const said = use_loader(module, project);
  const has_mistakes = said.problems.length > 0;
  // what stands in the field and is no seed
  const [no_seed, put_no_seed] = useState('');
  const wrong = has_mistakes || no_seed !== '';
  const why_no_seed = no_seed && `'${no_seed}' is no seed: a seed is a whole number from 0 to 18446744073709551615`;
  const why_wrong = has_mistakes ? 'Mend the mistakes first' : why_no_seed;
  const [restored, is_restored] = useState(false);
  // what the editor calls is what is now
  const now = useRef({ project, fly: () => {} });

  const choose = (scenario: string): void => {
    put({ ...project, scenario, seed: '' });
    put_no_seed('');
    put_file(scenario);
    count(undefined);
  };
  const put_edits = (edits: Files, instead_of: Files | null): void => {
    put({ ...project, edits });
    drop(instead_of);
    count(undefined);
  };
  const put_seed = (text: string): void => {
    const is_right = text === '' || is_seed(text);
    put_no_seed(is_right ? '' : text);
    if (is_right) put({ ...project, seed: text });
  };
  const restore = async (): Promise<void> => {
    try {
      const linked = await address.read(now.current.project);
      if (linked) {
        put(linked);
        put_no_seed('');
        put_fits(true);
        drop(null);
        const tabs = with_includes(linked, linked.scenario);
        put_file(Object.keys(linked.edits).find((one) => tabs.includes(one) || one.startsWith('data/')) ?? linked.scenario);
        count(undefined);
      }
      put_note('');
    } catch (error) {
      put_note(`The link cannot be used: ${words_of(error)}.`);
    }
    is_restored(true);
  };
  const share = async (): Promise<void> => {
    if (!(await address.write(project))) return put_note(`${kTooLarge}.`);
    put_note((await copy_text(location.href, null)) ? 'The link is copied: it holds your changes.' : 'The address bar has the link: it holds your changes.');
  };
  const debrief = async (runs: Flight[], first: Partial<View>): Promise<void> => {
    if (busy) return;
    put_busy('Making the debrief');
    const focused = document.activeElement as HTMLElement | null;
    const box = Object.assign(document.createElement('div'), { className: 'debriefed' });
    // once the button works again
    const refocus = () => setTimeout(() => document.activeElement === document.body && focused?.focus());
    const left = new AbortController();
    const leave = (): void => {
      left.abort();
      unlisten();
      set_theme(window.eyrie?.store.get().theme ?? theme);
      box.remove();
      host.hidden = false;
      refocus();
      void address.write(now.current.project);  // it is of the editor again
      document.title = 'Eyrie playground';
    };
    let closing: Promise<Shown> | null = null;
    const close = (): void => {
      leave();
      closing?.then((shown) => shown.close(), () => {});
    };
    // the browser's own way back is to the editor, too
    const unlisten = listen(window, { popstate: ({ state }) => state === 'editor' && close() });
    const back = { label: 'editor', go: () => (history.state === 'debrief' ? history.back() : close()) };
    const flights = runs.map(({ file }): Opening => (told, begun) => flown_again(module, file!, told, (part) => {
      document.body.append(box);
      host.hidden = true;
      begun(part);
    }, left.signal));
    try {
      if (!address.holds(project)) await address.write(project);
      history.replaceState('editor', '');
      history.pushState('debrief', '');
      await address.write(runs.at(-1)!.project);
      const told = (percent: number): void => put_busy(`Making the debrief: ${percent} %`);
      closing = show_as_flown(flights, box, told, { theme, ...first }, back);
      await closing;
    } catch (error) {
      if (left.signal.aborted) return void refocus();  // by who went back
      leave();
      put_note(words_of(error));
    } finally {
      put_busy('');
    }
  };
  const fly = async (watch: boolean): Promise<void> => {
    // what the loader said of an earlier text stops nobody: flying reads this one
    if (flying || busy || no_seed || (has_mistakes && said.is_now)) return;
    put_note('');
    put_busy('Loading');
    try {
      const flight = await flier.fly(project, (one) => {
        put_busy('');
        put_flying(one);
      });
      put_flights((all) => [flight, ...all].slice(0, kMostFlights));
      put_flying(null);
      if (watch) await debrief([flight], { playing: true, time: 0 });
    } catch (error) {
      put_note(error instanceof EngineError && error.problems.length ? 'Mend the mistakes first.' : words_of(error));
    } finally {
      put_flying(null);
      put_busy('');
    }
  };
  now.current = { project, fly: () => void fly(false) };

  useEffect(() => {
    editor.current = make_editor(place.current!, {
      grammar: new Grammar(schema),
      names: (path) => names_for(now.current.project, path),
      changed: (name, text) => {
        put((last) => edited(last, name, text));
        drop(null);
      },
      fly: () => now.current.fly(),
    });
    void restore();
    listen(window, {
      hashchange: () => {
        if (host.hidden) address.pass_over();
        else if (history.state !== 'debrief') void restore();
      },
      // forward again to what was closed: what is edited stays
      popstate: ({ state }) => state === 'debrief' && !host.hidden && history.back(),
      beforeunload: (event) => {
        if (!address.holds(now.current.project)) event.preventDefault();
      },
      keydown: (event) => {
        if (event.key !== 'Enter' || !(event.ctrlKey || event.metaKey) || event.defaultPrevented || host.hidden) return;
        event.preventDefault();
        now.current.fly();
      },
    });
    mind_manners();
  }, []);
  useEffect(() => editor.current!.show(file, text_of(project, file)), [file, version]);
  useEffect(() => editor.current!.mark(said.problems.filter((one) => one.file === file)), [said.problems, file]);
  useEffect(() => put_theme(theme), [theme]);
  useEffect(() => put_note(''), [project]);  // it was of what has been changed since
  useEffect(() => {
    if (!restored || address.holds(project)) return;
    // at once if it may be: somebody may leave at once
    const timer = setTimeout(async () => put_fits(await address.write(project)), address.pause);
    return () => clearTimeout(timer);
  }, [project, restored]);

  const go_to = ({ file: there, line, column }: Problem): void => {
    if (!(there in files)) return;
    put_file(there);
    // at once: the cursor goes to a line of it
    editor.current!.show(there, text_of(project, there));
    if (line) editor.current!.go_to(line, column);
  };
  const text = text_of(project, project.scenario);
  const flip_theme = (): void => {
    const other = theme === 'dark' ? 'light' : 'dark';
    set_theme(other);
    remember_theme(other);
  };
  const is_edited = Object.keys(project.edits).length > 0;
  return (
    <div class="playground" style={right ? { '--right': `${right}rem` } : {}}>
      <header class="top">
        <h1><Logo />Eyrie <span class="dim">playground</span></h1>
        <select aria-label="Scenario" value={project.scenario} title={help_of(text)} onChange={(event) => choose(event.currentTarget.value)}>
          {scenarios(files).map((one) => <option key={one} value={one}>{name_of(one)}</option>)}
        </select>
        <label class="seed">seed{' '}
          <input type="text" inputMode="numeric" aria-label="Seed" aria-invalid={no_seed !== ''} size={6} placeholder={seed_of(project)}
            value={no_seed || project.seed} onInput={(event) => put_seed(event.currentTarget.value.trim())} />
        </label>
        <button type="button" class="quiet" title="Another seed" aria-label="Another seed"
          onClick={() => put_seed(String(1 + Math.floor(Math.random() * 999)))}>⚄</button>
        {/* who clicks twice on Fly does not mean Stop, which is there by then */}
        {flying || busy === 'Loading'
          ? <button type="button" class="fly" title="End it here: what was flown so far is kept"
              onClick={({ detail }) => detail > 1 || void flier.stop()}>Stop</button>
          : <button type="button" class="fly" disabled={wrong || busy !== ''} title={why_wrong || 'Fly it to its end (Ctrl Enter)'}
              onClick={() => void fly(false)}>Fly</button>}
        <button type="button" disabled={wrong || flying !== null || busy !== ''} title="Fly it and watch it from the start" onClick={() => void fly(true)}>Watch</button>
        <span class="spring" />
        <span class="dim small" role="status">{busy || why_no_seed || note || (fits ? '' : `${kTooLarge}: they are lost when the page is left.`)}</span>
        {is_edited
          ? <button type="button" onClick={() => put_edits({}, project.edits)}>as shipped</button>
          : dropped && <button type="button" onClick={() => put_edits(dropped, null)}>my changes again</button>}
        <button type="button" disabled={no_seed !== ''} title={why_no_seed || undefined} onClick={() => void share()}>Share</button>
        <IconButton icon={theme === 'dark' ? 'sun' : 'moon'} label={theme === 'dark' ? 'Light' : 'Dark'} onClick={flip_theme} />
      </header>
      <main class="text">
        <Tabs project={project} file={file} onChoose={put_file} />
        <div class="editor" ref={place} />
        <Problems said={said} onGo={go_to} />
      </main>
      <aside class="right">
        <Results flying={flying} flights={flights} help={help_of(text)} busy={busy !== ''} onDebrief={(runs) => void debrief(runs, {})} />
      </aside>
      <Splitter label="Width of the results" size={right || 40} limits={[26, 90]} grows="left" onHide={() => set_right(26)} onChange={set_right} />
    </div>
  );
}

async function open(host: HTMLElement): Promise<void> {
  const view = { ...new View(), ...remembered() };
  put_theme(view.theme);
  const [texts] = parts('texts');
  if (!texts) throw new Error('there are no texts in this page; ./eyrie playground writes one with them');
  await painted();
  const [module, bytes] = await Promise.all([engine_module(), unpacked(texts)]);
  const { files, schema } = JSON.parse(new TextDecoder().decode(bytes)) as Texts;
  host.replaceChildren();
  render(<Playground files={files} schema={schema} module={module} host={host} view={view} />, host);
  document.body.dataset['open'] = 'true';
}

const host = document.getElementById('app')!;
open(host).catch((error: unknown) => say_failure(host, 'The playground cannot be opened', error));
