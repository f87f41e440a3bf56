// SPDX-License-Identifier: MIT
/** One node of the tree at one decision: what it answered, what it asked for, and what could be asked of it. */
import { answer_words } from '../decide/contest.ts';
import { value_text } from '../decide/text.ts';
import { flown_text, is_grouped } from '../decide/units.ts';
import { arbiters_for, with_param, type ArbiterChoice, type ParamChoice } from '../decide/what_if.ts';
import type { ActionField, Player, Run, Shape, Tree } from '../run/run.ts';
import { use_page } from './page.ts';
import { use_cell } from './use.ts';
import { ask, change_of } from './what_if_answer.ts';

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
          <dd>{value_text(run, player.kind, action[field]!, player.decisions.value(supplier, field)?.[index] ?? NaN)}
            {supplier !== node && <span class="dim"> {tree.nodes[supplier]!.label}</span>}</dd>
        </div>
      ))}
    </dl>
  );
}

type Params = Tree['nodes'][number]['params'];

function params_text(params: Params, fields: readonly ActionField[]): string {
  const words = (name: string, value: Params[string]): string =>
    Array.isArray(value) ? value.map((one) => (typeof one === 'object' ? `“${one.that}”` : one)).join(' ') : flown_text(name, value, fields);
  return Object.entries(params).map(([name, value]) => `${param_words(name)} ${words(name, value)}`).join(', ');
}

/** "altitude min" for "bounds.altitude.min". */
function param_words(name: string): string {
  return name.split('.').slice(is_grouped(name) ? 1 : 0).join(' ');
}

interface SliderProps {
  name: string;
  unit?: string;
  min: number;
  max: number;
  value: number;
  onChange: (value: number) => void;
}

function Slider({ name, unit, min, max, value, onChange }: SliderProps) {
  const put = (text: string): void => {
    const number = Number(text);
    if (text !== '' && Number.isFinite(number)) onChange(Math.min(Math.max(number, min), max));
  };
  return (
    <label class="slider"><span>{unit ? `${param_words(name)}, ${unit}` : param_words(name)}</span>
      <input type="range" min={min} max={max} step="1" value={value} aria-label={name}
        onInput={(event) => put(event.currentTarget.value)} />
      <input type="number" min={min} max={max} step="any" value={value} aria-label={`${name} in numbers`}
        onInput={(event) => put(event.currentTarget.value)} />
    </label>
  );
}

function Param({ param, value, onChange }: { param: ParamChoice; value: string | number; onChange: (value: string | number) => void }) {
  const { name, unit, values } = param;
  if (!Array.isArray(values)) return <Slider name={name} unit={unit} min={values.min} max={values.max} value={Number(value)} onChange={onChange} />;
  return (
    <label class="choice"><span>{param_words(name)}</span>
      <select aria-label={name} value={String(value)} onChange={(event) => onChange(values[event.currentTarget.selectedIndex]!)}>
        {values.map((one) => <option key={one} value={String(one)}>{one}</option>)}
      </select>
    </label>
  );
}

function AskArbiter({ choices, tree, node, label }: { choices: ArbiterChoice[]; tree: number; node: number; label: string }) {
  const page = use_page();
  const change = change_of(use_cell(page.changes), tree, node);
  const flown = choices[0]!;
  const now = choices.find(({ type }) => type === change?.type) ?? flown;
  const put = (type: string): void => {
    const chosen = choices.find((choice) => choice.type === type)!;
    // some arbiters are none without their parameters
    const params = Object.fromEntries(chosen.params.map(({ name, value }) => [name, value]));
    ask(page, tree, node, chosen === flown ? { type: undefined, params: undefined } : { type, params });
  };
  return (
    <>
      <label class="choice"><span>arbiter</span>
        <select aria-label={`Arbiter of ${label}`} value={now.type} onChange={(event) => put(event.currentTarget.value)}>
          {choices.map(({ type }) => <option key={type} value={type}>{type}{type === flown.type ? ' (as flown)' : ''}</option>)}
        </select>
      </label>
      {now.params.map((param) => (
        <Param key={param.name} param={param} value={change?.params?.[param.name] ?? param.value}
          onChange={(value) => ask(page, tree, node,
            { params: with_param(page.run, page.run.trees[tree]!, node, now.type, change?.params ?? {}, param.name, value) })} />
      ))}
    </>
  );
}

/** The vote of a leaf that votes, now or in another decision; null: it never does. */
function vote_of(run: Run, { shape, tree, node }: Looked): number | null {
  const { params, children } = tree.nodes[node]!;
  if (typeof params.vote === 'number') return params.vote;
  if (children.length > 0) return null;
  return shape.vote[node] || run.shapes.find((other) => other.tree === shape.tree && other.vote[node]! > 0)?.vote[node] || null;
}

export function NodeDetails(looked: Looked) {
  const page = use_page();
  const changes = use_cell(page.changes);
  const { tree, shape, node } = looked;
  const { label, path, type, kind, params, remembers } = tree.nodes[node]!;
  const change = change_of(changes, shape.tree, node);
  const told = params_text(params, page.run.platforms[tree.kind].action);
  const choices = arbiters_for(page.run, tree, node, change?.params);
  const vote = vote_of(page.run, looked);
  return (
    <section class="details" aria-label={`Node ${label}`} data-node={path}>
      <header>
        <h3>{label}</h3><code>{path}</code>
        <button type="button" class="quiet" aria-label="Close the node" onClick={() => page.node.set(-1)}>✕</button>
      </header>
      <p class="answer">{answer_words(shape, node)}</p>
      <p class="dim small">{kind} {type}{told && `, ${told}`}{remembers ? ', remembers' : ''}</p>
      <Proposed {...looked} />
      {(choices.length > 0 || vote !== null) && (
        <fieldset class="asks">
          <legend>what if</legend>
          {choices.length > 0 && <AskArbiter key={node} choices={choices} tree={shape.tree} node={node} label={label} />}
          {vote !== null && (
            <Slider name={`vote of ${label}`} min={0} max={100} value={change?.vote ?? vote}
              onChange={(value) => ask(page, shape.tree, node, { vote: value === vote ? undefined : value })} />
          )}
          {change && <button type="button" onClick={() => page.changes.set(changes.filter((c) => c !== change))}>as flown</button>}
        </fieldset>
      )}
    </section>
  );
}
