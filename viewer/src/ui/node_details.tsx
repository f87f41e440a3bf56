// SPDX-License-Identifier: MIT
/** One node of the tree at one decision: what it answered, what it asked for, and what could be asked of it. */
import { VoteOrder } from '../live/controls.tsx';
import type { Parameter } from '../engine/questions.ts';
import { source_of, type Player, type Shape, type Tree } from '../run/run.ts';
import { answer_words } from '../words/answer.ts';
import { quantity_text, reworded, told_text } from '../words/text.ts';
import { use_page } from './page.ts';
import { use_cell } from './use.ts';
import { ask, change_of, use_node_types, type Change } from './what_if_answer.ts';

interface Looked {
  player: Player;
  index: number;
  tree: Tree;
  shape: Shape;
  node: number;
}

/** What it sent up: its own values, and whose the others were. */
function Proposed({ player, index, tree, shape, node }: Looked) {
  const { run } = use_page();
  const { action } = run.platforms[player.kind];
  const rows = Array.from(shape.supplier[node] ?? [], (supplier, field) => ({ supplier, field })).filter(({ supplier }) => supplier >= 0);
  if (!rows.length) return null;
  return (
    <dl class="state proposed">
      {rows.map(({ supplier, field }) => (
        <div key={field}>
          <dt>{action[field]!.name}</dt>
          <dd>{shape.held[node]![field] && 'held '}
            {told_text(run, player, player.decisions.t[index]!, action[field]!, player.decisions.value(source_of(shape, node, field), field)?.[index] ?? NaN)}
            {supplier !== node && <span class="dim"> {tree.nodes[supplier]!.label}</span>}</dd>
        </div>
      ))}
    </dl>
  );
}

/** A hundredth of the span or less, as a power of ten, so that a slider from `min` on can stand at each of these values. */
export function step_of(min: number, max: number, values: number[]): number {
  const step = (power: number): number => Number(`1e${power}`);
  let power = Math.floor(Math.log10((max - min) / 100));
  const is_between = (value: number): boolean => Math.abs((value - min) / step(power) - Math.round((value - min) / step(power))) > 1e-6;
  while (power > -6 && values.some(is_between)) --power;
  return step(power);
}

/** A slider where there is a span without a unit, and words where there is none: the engine reads them as a file's. `value` is what is
 * asked; undefined: as flown. */
function Edit({ parameter, value, flown, onChange }: {
  parameter: Parameter; value: string | undefined; flown: string; onChange: (value: string | undefined) => void;
}) {
  const { name, kind, unit, help, min, max, choices, standard } = parameter;
  const put = (text: string): void => onChange(text === '' || text === flown ? undefined : text);
  const words = kind === 'flag' ? ['false', 'true'] : choices;
  if (words.length)
    return (
      <label class="choice" title={help}><span>{name}</span>
        <select aria-label={name} value={value ?? flown} onChange={(event) => put(event.currentTarget.value)}>
          {[...new Set([value ?? flown, ...words])].map((one) => <option key={one} value={one}>{one || 'as flown'}</option>)}
        </select>
      </label>
    );
  const [first, here] = [flown || standard, value ?? (flown || standard)].map(Number) as [number, number];
  const values = [first, here].filter(Number.isFinite);
  const most = Math.min(max ?? Infinity, Math.max(100, ...values));
  const range = min != null && max != null ? `${quantity_text(min, unit)} to ${quantity_text(max, unit)}` : '';
  return (
    <label class="slider" title={[help, range].filter(Boolean).join('; ')}><span>{name}</span>
      {kind === 'number' && !unit && min != null && max != null && (
        <input type="range" min={min} max={most} step={step_of(min, most, values)} value={here} aria-label={name}
          onInput={(event) => put(event.currentTarget.value)} />
      )}
      <input type="text" value={value ?? flown} placeholder={standard} aria-label={`${name} in words`}
        onChange={(event) => put(event.currentTarget.value.trim())} />
    </label>
  );
}

function Ask({ shape, tree, node }: Looked) {
  const page = use_page();
  const types = use_node_types(tree.kind);
  const { label, type: flown, params } = tree.nodes[node]!;
  const change = change_of(use_cell(page.changes), shape.tree, node) ?? { tree: shape.tree, node, params: {} };
  const own = types.find(({ name }) => name === flown);
  if (!own) return null;
  const now = types.find(({ name }) => name === (change.type ?? flown)) ?? own;
  const others = own.takes_children ? types.filter((one) => one.takes_children && one.kind === 'arbiter') : [];
  const choices = [own, ...others.filter((one) => one !== own)];
  const put = (patch: Partial<Change>): void => ask(page.changes, { ...change, ...patch });
  const set = (name: string, value: string | undefined): void => {
    const { [name]: _, ...rest } = change.params;
    put({ params: value === undefined ? rest : { ...rest, [name]: value } });
  };
  const choose = (type: string): void => {
    const { type: _, ...rest } = change;
    ask(page.changes, { ...rest, params: {}, ...(type === flown ? {} : { type }) });
  };
  return (
    <fieldset class="asks">
      <legend>what if</legend>
      {choices.length > 1 && (
        <label class="choice"><span>arbiter</span>
          <select aria-label={`Arbiter of ${label}`} value={now.name} onChange={(event) => choose(event.currentTarget.value)}>
            {choices.map(({ name, help }) => <option key={name} value={name} title={help}>{name}{name === flown ? ' (as flown)' : ''}</option>)}
          </select>
        </label>
      )}
      {now.parameters.map((parameter) => (
        <Edit key={`${now.name}/${parameter.name}`} parameter={parameter} value={change.params[parameter.name]}
          flown={now === own ? params[parameter.name] ?? '' : ''} onChange={(value) => set(parameter.name, value)} />
      ))}
      {(change.type !== undefined || Object.keys(change.params).length > 0) && <button type="button" onClick={() => choose(flown)}>as flown</button>}
    </fieldset>
  );
}

export function NodeDetails(looked: Looked) {
  const page = use_page();
  const { tree, shape, node } = looked;
  const { label, path, type, kind, params, remembers } = tree.nodes[node]!;
  const votes = use_node_types(tree.kind).find(({ name }) => name === type)?.parameters.some(({ name }) => name === 'vote');
  const told = Object.entries(params).map(([name, value]) => `${name} ${reworded(value)}`).join(', ');
  return (
    <section class="details" aria-label={`Node ${label}`} data-node={path}>
      <header>
        <h3 class="cut" title={path}>{label}</h3><code>{path}</code>
        <button type="button" class="quiet" aria-label="Close the node" onClick={() => page.node.set(-1)}>✕</button>
      </header>
      <p class="answer">{answer_words(shape, node)}</p>
      <p class="dim small">{kind} {type}{told && `, ${told}`}{remembers ? ', remembers' : ''}</p>
      <Proposed {...looked} />
      {page.live && votes && tree.kind === 'aircraft' && <VoteOrder live={page.live} player={looked.player.name} tree={tree.name} node={path} vote={shape.vote[node]!} />}
      {page.run.engine && <Ask key={`${shape.tree}/${node}`} {...looked} />}
    </section>
  );
}
