// SPDX-License-Identifier: MIT
/** A sequencer at one decision as the state machine that it is: its trees are the states, drawn below each other with the transitions as
 * numbered arcs; each in words, in the order in which they are asked; and where the player has been. */
import { useMemo, useRef } from 'preact/hooks';
import { made } from '../made.ts';
import { last_at, type Player, type Run, type Shape, type Tree } from '../run/run.ts';
import { clock_text, reworded } from '../words/text.ts';
import { jump } from './actions.ts';
import { text_width } from './canvas.ts';
import { use_page } from './page.ts';
import { use_rove } from './use.ts';

const state_count = (tree: Tree, node: number): number => tree.nodes[node]!.children.length - tree.nodes[node]!.rules!.length;

/** Of the sequencer `node`, which of its trees was asked; -1: none. */
function state_of(tree: Tree, shape: Shape, node: number): number {
  return tree.nodes[node]!.children.slice(0, state_count(tree, node)).findIndex((child) => shape.status[child] !== null);
}

/** The rule that handed over at a decision; -1: none did. */
export function fired(tree: Tree, shape: Shape, node: number): number {
  const { rules, children } = tree.nodes[node]!;
  const [first, state] = [state_count(tree, node), state_of(tree, shape, node)];
  return rules!.findIndex(([, to], i) => to === state && shape.status[children[first + i]!] === 'success');
}

/** Since when (s) a player was in which states, by its decisions, and the rule that led there; -1: the first, or it is not known. */
export function visits_of(run: Run, { decisions }: Player, tree: number, node: number): { t: number; state: number; rule: number }[] {
  const visits: ReturnType<typeof visits_of> = [];
  const states = run.shapes.map((shape) => (shape.tree === tree ? state_of(run.trees[tree]!, shape, node) : -1));
  decisions.shape.forEach((s, i) => {
    const state = states[s]!;
    if (state >= 0 && visits.at(-1)?.state !== state) visits.push({ t: decisions.t[i]!, state, rule: fired(run.trees[tree]!, run.shapes[s]!, node) });
  });
  return visits;
}

/** "in_sight within 5 nmi": a condition with its numbers. */
function condition_words(tree: Tree, node: number): string {
  const { label, type, children, params } = tree.nodes[node]!;
  const join = { sequence: ' and ', selector: ' or ' }[type];
  if (join) return children.map((child) => condition_words(tree, child)).join(join);
  if (type === 'inverter') return `not ${condition_words(tree, children[0]!)}`;
  // what it asks in words is its label already, and waiting for no time is none
  const given = Object.entries(params).filter(([, value]) => value !== label && value !== '0 s').map(([name, value]) => {
    const words = name.replaceAll('_', ' ');
    return value === 'true' ? words : value === 'false' ? `no ${words}` : `${words} ${reworded(value)}`;
  });
  const below = children.map((child) => condition_words(tree, child));
  return [reworded(label), ...given, ...(below.length ? [`of ${below.join(', ')}`] : [])].join(' ');
}

const kFont = 12;
const kRow = 30;
const kPill = 20;
/** How far an arc reaches for each row that it passes, and the first of them. */
const kReach = 11;

interface Props { player: Player; index: number; tree: Tree; shape: Shape; node: number }

export function Machine({ player, index, tree, shape, node }: Props) {
  const page = use_page();
  const list = useRef<HTMLParagraphElement>(null);
  use_rove(list, 'ArrowLeft', 'ArrowRight');
  const { children, label } = tree.nodes[node]!;
  const rules = tree.nodes[node]!.rules!;
  const names = children.slice(0, state_count(tree, node)).map((child) => tree.nodes[child]!.label);
  const [state, rule] = [state_of(tree, shape, node), fired(tree, shape, node)];
  const visits = useMemo(() => visits_of(page.run, player, shape.tree, node), [page, player, shape.tree, node]);
  const now = last_at(Float64Array.from(visits, ({ t }) => t), player.decisions.t[index]!);

  // arcs of one pair are one; those from any state come from the side
  const arcs = new Map<string, { from: number; to: number; numbers: number[] }>();
  rules.forEach(([from, to], i) => made(arcs, `${from}/${to}`, () => ({ from, to, numbers: [] })).numbers.push(i));
  const wide = Math.max(...names.map((name) => text_width(name, kFont))) + 18;
  const reach = (Math.max(...rules.map(([from, to]) => (from < 0 ? 1 : Math.abs(to - from)))) + 1) * kReach + 22;
  const y_of = (i: number): number => (i + 0.5) * kRow;
  return (
    <section class="machine" aria-label={`State machine ${label}`} data-state={names[state] ?? ''} data-fired={rule}>
      <svg role="img" aria-label={`${label} is in ${names[state] ?? 'no state'}`} viewBox={`${-reach} 0 ${wide + 2 * reach} ${names.length * kRow}`}
        style={{ width: `${(wide + 2 * reach) / kFont}rem` }}>
        {[...arcs.values()].map(({ from, to, numbers }) => {
          // down the states at the right, up again at the left
          const down = from >= 0 && to > from;
          const [x, out] = down ? [wide, 1] : [0, -1];
          const bend = x + out * (from < 0 ? 22 : (Math.abs(to - from) + 1) * kReach);
          const [y0, y1] = [from < 0 ? y_of(to) : y_of(from) + (down ? 4 : -4), from < 0 ? y_of(to) : y_of(to) + (down ? -5 : 5)];
          const [ax, ay] = from < 0 ? [bend, y0] : [x + out * 0.76 * Math.abs(bend - x), (y0 + y1) / 2];
          const is_now = numbers.includes(rule);
          return (
            <g key={`${from}/${to}`} class={is_now ? 'arc now' : 'arc'}>
              <path d={from < 0 ? `M${bend} ${y0}H${x}` : `M${x} ${y0}C${bend} ${y0} ${bend} ${y1} ${x} ${y1}`} />
              <path class="head" d={`M${x} ${y1}l${out * 7} -3.5v7Z`} />
              <text x={ax + (from < 0 ? -1 : 0)} y={ay + 3.5} text-anchor={from < 0 ? 'end' : 'middle'}>{numbers.map((i) => i + 1).join(' ')}</text>
            </g>
          );
        })}
        {names.map((name, i) => (
          <g key={name} class={i === state ? 'state-pill now' : 'state-pill'} transform={`translate(0 ${y_of(i) - kPill / 2})`} onClick={() => page.node.set(children[i]!)}>
            <rect width={wide} height={kPill} rx="10" /><text x={wide / 2} y="14.2" text-anchor="middle">{name}</text>
          </g>
        ))}
      </svg>
      <ol class="rules">
        {rules.map(([from, to], i) => {
          const child = children[names.length + i]!;
          return (
            <li key={i} class={`${shape.status[child] === null ? '' : 'asked'} ${i === rule ? 'now' : ''}`} aria-current={i === rule}>
              {i + 1} {from < 0 ? 'any' : names[from]} → {names[to]}: {condition_words(tree, child)}
            </li>
          );
        })}
      </ol>
      <p class="small visits" ref={list}>
        {visits.map(({ t, state: s, rule: by }, i) => (
          <button type="button" key={t} class="link" aria-current={i === now} title={by < 0 ? 'where it began' : condition_words(tree, children[names.length + by]!)}
            onClick={() => jump(page, t)}>{clock_text(t)} {names[s]}</button>
        ))}
      </p>
    </section>
  );
}
