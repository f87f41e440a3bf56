// SPDX-License-Identifier: MIT
/** The tree at one decision: who was asked, what each answered, and the way to who leads. An outline: a row for each node that is shown,
 * children below their parent and to the right of where it begins. */
import { useEffect, useMemo, useRef, useState } from 'preact/hooks';
import type { Shape, Tree, TreeNode } from '../run/run.ts';
import { answer_words, path_of_leader } from '../words/answer.ts';
import { number_text, reworded } from '../words/text.ts';
import { text_width } from './canvas.ts';
import { use_page } from './page.ts';
import { use_cell, use_rove, use_view } from './use.ts';
import { change_of } from './what_if_answer.ts';

interface Placed {
  node: number;
  /** Left and middle, in the units of the font, whose size is kFont. */
  x: number;
  y: number;
  width: number;
  hidden: number;  // How many nodes below are not shown.
  link: string;  // From the parent to here; "" for the root.
}

/** Trees no larger are seen as a whole. */
const kFew = 12;
const kFont = 12;
const kRow = 24;
const kPill = 18;
const kPadding = 3;
/** Of each depth. */
const kStep = 14;

/** Nodes below `node`, without itself. */
function below(tree: Tree, node: number): number {
  return tree.nodes[node]!.children.reduce((sum, child) => sum + 1 + below(tree, child), 0);
}

/** `width_of` gives what a node needs; below those that are not open nothing is shown. */
export function layout_tree(tree: Tree, is_open: (node: number) => boolean, width_of: (node: number, hidden: number) => number) {
  const placed: Placed[] = [];
  const place = (node: number, above: Placed | null): void => {
    const { depth, children } = tree.nodes[node]!;
    const hidden = is_open(node) ? 0 : below(tree, node);
    const [x, y] = [kPadding + depth * kStep, kPadding + (placed.length + 0.5) * kRow];
    const here = { node, x, y, width: width_of(node, hidden), hidden, link: above ? `M${above.x + 6} ${above.y + kPill / 2}V${y}H${x}` : '' };
    placed.push(here);
    if (is_open(node)) for (const child of children) place(child, here);
  };
  place(0, null);
  // beside the last one is the handle that closes it
  return { placed, width: Math.max(...placed.map(({ x, width }) => x + width)) + kPadding + 8, height: kRow * placed.length + 2 * kPadding };
}

/** Of the status, in a box from 0 to 10; `open` ones are stroked. */
const kIcons: Record<string, { path: string; open: boolean }> = {
  failure: { path: 'M2.2 2.2L7.8 7.8M7.8 2.2L2.2 7.8', open: true },
  success: { path: 'M1.6 5.4L4 8L8.6 2.2', open: true },
  running: { path: 'M2.4 1.4L8.6 5L2.4 8.6Z', open: false },
  none: { path: 'M3 5H7', open: true },
};

/** The type of a composite, where its label does not say it; of a sequencer's condition where it leads. */
function type_words(tree: Tree, shape: Shape, node: number): string {
  const { label, type, kind, parent } = tree.nodes[node]!;
  const above = tree.nodes[parent];
  const rule = above?.rules?.[above.children.indexOf(node) - above.children.length + above.rules.length];
  if (rule) return `→ ${tree.nodes[above!.children[rule[1]]!]!.label}`;
  return shape.status[node] === null || label === type || kind === 'condition' || kind === 'decorator' ? '' : type;
}

/** So many letters of a label fit wherever it stands; its title has all. */
const kLongest = 38;
function label_words({ label }: TreeNode): string {
  const words = reworded(label);
  return words.length > kLongest ? `${words.slice(0, kLongest - 1).trimEnd()}…` : words;
}

const kSmall = kFont * 0.82;
/** What "+3" needs. */
function more_width(hidden: number): number {
  return hidden ? text_width(`+${hidden}`, kSmall) + 6 : 0;
}
/** Where the label begins. */
const kIndent = 15;
function width_of(tree: Tree, shape: Shape, node: number, hidden: number): number {
  const type = type_words(tree, shape, node);
  const words = text_width(label_words(tree.nodes[node]!), kFont) + (type ? 5 + text_width(type, kSmall) : 0);
  const vote = shape.vote[node]!;
  return kIndent + words + (vote > 0 ? Math.max(text_width(number_text(vote, 1), kSmall) + 10, 22) : 5) + more_width(hidden);
}

interface Shown {
  tree: Tree;
  shape: Shape;
  place: Placed;
  onToggle: (node: number) => void;
}

/** Opens and closes what is below. */
function Toggle({ place: { node, width, hidden }, onToggle }: Pick<Shown, 'place' | 'onToggle'>) {
  const more = more_width(hidden);
  const turn = (event: MouseEvent): void => {
    event.stopPropagation();
    onToggle(node);
  };
  return (
    <g class="toggle" onClick={turn}>
      <rect x={hidden ? width - more : width} y="0" width={hidden ? more : 12} height={kPill} />
      {hidden ? <text class="more" x={width - 3} y="12">+{hidden}</text> : <path d={`M${width + 3} ${kPill / 2 - 2.5}h5`} />}
    </g>
  );
}

/** What a node looks like: icon of its status, words, vote as number and bar. */
function Face({ tree, shape, place: { node, width, hidden }, most }: Omit<Shown, 'onToggle'> & { most: number }) {
  const icon = kIcons[shape.status[node] ?? 'none']!;
  const vote = shape.vote[node]!;
  const type = type_words(tree, shape, node);
  return (
    <>
      <rect class="pill" width={width} height={kPill} rx="3.5" />
      {vote > 0 && <rect class="vote" x="1.5" y={kPill - 2.6} width={Math.max((width - 3) * (vote / most), 1)} height="2" rx="1" />}
      <path class={icon.open ? 'status open' : 'status'} d={icon.path} transform={`translate(3.5 ${kPill / 2 - 5})`} />
      <text x={kIndent} y="12.2">{label_words(tree.nodes[node]!)}{type && <tspan class="type" dx="5">{type}</tspan>}</text>
      {vote > 0 && <text class="votes" x={width - 4 - more_width(hidden)} y="12">{number_text(vote, 1)}</text>}
    </>
  );
}

function Pill(shown: Shown & { on_way: boolean; most: number }) {
  const { tree, shape, place, on_way, onToggle } = shown;
  const page = use_page();
  const looked = use_cell(page.node) === place.node;
  const pointed = use_cell(page.pointed) === place.node;
  const changed = change_of(use_cell(page.changes), shape.tree, place.node) !== undefined;
  const { node, x, y, hidden } = place;
  const { type, label, path, children, depth } = tree.nodes[node]!;
  const status = shape.status[node] ?? 'none';
  const marks = { way: on_way, looked, pointed, changed };
  const classes = ['node', status, ...Object.entries(marks).flatMap(([name, is]) => (is ? [name] : []))];
  const look = (): void => page.node.set(looked ? -1 : node);
  const press = (event: KeyboardEvent): void => {
    if (event.key === 'Enter') look();
    else if (event.key === ' ' && children.length) onToggle(node);
    else return;
    event.preventDefault();
    event.stopPropagation();
  };
  return (
    <g class={classes.join(' ')} transform={`translate(${x} ${y - kPill / 2})`} onClick={look} onKeyDown={press}
      data-path={path} data-status={status} data-vote={shape.vote[node]!} data-asked={status !== 'none'}
      role="treeitem" tabindex={-1} aria-selected={looked} aria-level={depth + 1}
      aria-expanded={children.length ? hidden === 0 : undefined} aria-description={answer_words(shape, node)}>
      <g>
        <title>{`${path}\n${label === type ? '' : `${reworded(label)}\n`}${type}: ${answer_words(shape, node)}`}</title>
        <Face {...shown} />
        {children.length > 0 && <Toggle place={place} onToggle={onToggle} />}
      </g>
    </g>
  );
}

export function TreeView({ tree, shape }: { tree: Tree; shape: Shape }) {
  const page = use_page();
  const looked = use_cell(page.node);
  const scroller = useRef<HTMLDivElement>(null);
  use_rove(scroller, 'ArrowUp', 'ArrowDown', '[role=treeitem]');
  /** By node, what the user wants instead of: open where it was asked. */
  const [turned, set_turned] = useState<ReadonlyMap<number, boolean>>(new Map());
  useEffect(() => set_turned(new Map()), [tree]);
  const is_open = (node: number): boolean => turned.get(node) ?? shape.status[node] !== null;
  const units = use_view(page.store, (v) => v.units);  // labels have quantities
  const layout = useMemo(() => layout_tree(tree, is_open, (node, hidden) => width_of(tree, shape, node, hidden)), [tree, shape, turned, units]);
  const way = useMemo(() => path_of_leader(page.run, shape), [page, shape]);
  const most = Math.max(...shape.vote, 1);

  // who leads is in sight
  useEffect(() => {
    const place = layout.placed.find(({ node }) => node === (looked >= 0 ? looked : shape.leader));
    const view = scroller.current!;
    if (!place) return;
    const scale = view.scrollHeight / layout.height;
    const [top, bottom] = [(place.y - kPill) * scale, (place.y + kPill) * scale];
    if (top < view.scrollTop || bottom > view.scrollTop + view.clientHeight) view.scrollTop = (top + bottom - view.clientHeight) / 2;
    view.scrollLeft = Math.max((place.x + place.width) * scale - view.clientWidth, 0);
  }, [layout, shape.leader, looked]);

  const toggle = (node: number): void => set_turned(new Map(turned).set(node, !is_open(node)));
  /** Of the nodes whose path has these words the first one that is not yet looked at, then the next. */
  const find = (words: string): void => {
    const found = words ? tree.nodes.flatMap(({ path }, node) => (path.includes(words) ? [node] : [])) : [];
    const next = found.find((node) => node > looked) ?? found[0];
    if (next === undefined) return;
    const open = new Map(turned);
    for (let node = tree.nodes[next]!.parent; node >= 0; node = tree.nodes[node]!.parent) open.set(node, true);
    set_turned(open);
    page.node.set(next);
  };
  return (<>
    {tree.nodes.length > kFew && (
      <input type="search" class="find" placeholder="find a node, enter for the next" aria-label="Find a node of the tree"
        onKeyDown={(event) => event.key === 'Enter' && find(event.currentTarget.value.trim())} />
    )}
    <div class="tree" ref={scroller} tabIndex={0} role="group" aria-label="Tree">
      <svg role="tree" aria-label="Decision tree" viewBox={`0 0 ${layout.width} ${layout.height}`}
        style={{ width: `${layout.width / kFont}rem`, height: `${layout.height / kFont}rem` }}>
        <g class="links">
          {layout.placed.filter(({ link }) => link).map(({ node, link }) => (
            <path key={node} d={link} class={way.has(node) ? 'way' : shape.status[node] === null ? 'none' : ''} />
          ))}
        </g>
        {layout.placed.map((place) => (
          <Pill key={place.node} tree={tree} shape={shape} place={place} on_way={way.has(place.node)} most={most} onToggle={toggle} />
        ))}
      </svg>
    </div>
  </>);
}

