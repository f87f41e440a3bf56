// SPDX-License-Identifier: MIT
/** The tree at one decision: who was asked, what each answered, and the way to who leads. The root is at the left, there is a row
 * for each node that is shown, and columns are as wide as they must be. */
import { useEffect, useMemo, useRef, useState } from 'preact/hooks';
import { hierarchy, tree as tidy } from 'd3-hierarchy';
import type { Shape, Tree } from '../run/run.ts';
import { answer_words, path_of_leader } from '../words/contest.ts';
import { number_text } from '../words/text.ts';
import { use_page } from './page.ts';
import { use_cell } from './use.ts';
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
interface Layout {
  placed: Placed[];
  width: number;
  height: number;
}

const kFont = 12;
const kRow = 20.5;
const kPill = 17;
const kGap = 20;
const kPadding = 3;

/** Nodes below `node`, without itself. */
function below(tree: Tree, node: number): number {
  return tree.nodes[node]!.children.reduce((sum, child) => sum + 1 + below(tree, child), 0);
}

function link(x0: number, y0: number, x1: number, y1: number): string {
  const bend = x1 - kGap / 2;
  return `M${x0} ${y0}L${bend - 6} ${y0}C${bend + 4} ${y0} ${bend - 4} ${y1} ${x1} ${y1}`;
}

/** `width_of` gives what a node needs; below those that are not open nothing is shown. */
export function layout_tree(tree: Tree, is_open: (node: number) => boolean, width_of: (node: number, hidden: number) => number): Layout {
  const root = hierarchy<number>(0, (node) => (is_open(node) ? tree.nodes[node]!.children : []));
  const points = tidy<number>().nodeSize([kRow, 1]).separation(() => 1)(root).descendants();
  const hidden = points.map(({ data }) => (is_open(data) ? 0 : below(tree, data)));
  const widths = points.map(({ data }, i) => width_of(data, hidden[i]!));

  const columns: number[] = [];
  points.forEach(({ depth }, i) => (columns[depth] = Math.max(columns[depth] ?? 0, widths[i]!)));
  const left = columns.map((_, depth) => kPadding + columns.slice(0, depth).reduce((sum, width) => sum + width + kGap, 0));
  const top = Math.min(...points.map((p) => p.x)) - kRow / 2 - kPadding;

  const index = new Map(points.map((point, i) => [point, i]));
  const placed = points.map((point, i): Placed => {
    const [x, y] = [left[point.depth]!, point.x - top];
    const parent = point.parent && { x: left[point.depth - 1]! + widths[index.get(point.parent)!]!, y: point.parent.x - top };
    return { node: point.data, x, y, width: widths[i]!, hidden: hidden[i]!, link: parent ? link(parent.x, parent.y, x, y) : '' };
  });
  return {
    placed,
    width: left.at(-1)! + columns.at(-1)! + kPadding,
    height: Math.max(...placed.map((p) => p.y)) + kRow / 2 + kPadding,
  };
}

/** Of the status, in a box from 0 to 10; `open` ones are stroked. */
const kIcons: Record<string, { path: string; open: boolean }> = {
  failure: { path: 'M2.2 2.2L7.8 7.8M7.8 2.2L2.2 7.8', open: true },
  success: { path: 'M1.6 5.4L4 8L8.6 2.2', open: true },
  running: { path: 'M2.4 1.4L8.6 5L2.4 8.6Z', open: false },
  none: { path: 'M3 5H7', open: true },
};

let measuring: CanvasRenderingContext2D | null = null;
const kMeasured = new Map<string, number>();
function text_width(text: string, size: number): number {
  const key = `${size}/${text}`;
  let width = kMeasured.get(key);
  if (width === undefined) {
    measuring ??= document.createElement('canvas').getContext('2d')!;
    measuring.font = `${size}px system-ui, sans-serif`;
    kMeasured.set(key, (width = measuring.measureText(text).width));
  }
  return width;
}

/** The type of a composite, where its label does not say it. */
function type_words(tree: Tree, shape: Shape, node: number): string {
  const { label, type, kind } = tree.nodes[node]!;
  return shape.status[node] === null || label === type || kind === 'condition' || kind === 'decorator' ? '' : type;
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
  const words = text_width(tree.nodes[node]!.label, kFont) + (type ? 5 + text_width(type, kSmall) : 0);
  return kIndent + words + (shape.vote[node]! > 0 ? 22 : 5) + more_width(hidden);
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
      <text x={kIndent} y="12.2">{tree.nodes[node]!.label}{type && <tspan class="type" dx="5">{type}</tspan>}</text>
      {vote > 0 && <text class="votes" x={width - 4 - more_width(hidden)} y="12">{number_text(vote, 1)}</text>}
    </>
  );
}

function Pill(shown: Shown & { on_way: boolean; most: number; focusable: boolean }) {
  const { tree, shape, place, on_way, focusable, onToggle } = shown;
  const page = use_page();
  const looked = use_cell(page.node) === place.node;
  const pointed = use_cell(page.pointed) === place.node;
  const changed = change_of(use_cell(page.changes), shape.tree, place.node) !== undefined;
  const { node, x, y, hidden } = place;
  const { type, path, children, depth } = tree.nodes[node]!;
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
      role="treeitem" tabIndex={focusable ? 0 : -1} aria-selected={looked} aria-level={depth + 1}
      aria-expanded={children.length ? hidden === 0 : undefined} aria-description={answer_words(shape, node)}>
      <g>
        <title>{`${path}\n${type}: ${answer_words(shape, node)}`}</title>
        <Face {...shown} />
        {children.length > 0 && <Toggle place={place} onToggle={onToggle} />}
      </g>
    </g>
  );
}

/** Arrows up and down go from node to node. */
function walk(event: KeyboardEvent): void {
  if (event.key !== 'ArrowUp' && event.key !== 'ArrowDown') return;
  const nodes = [...(event.currentTarget as Element).querySelectorAll<SVGGElement>('[role=treeitem]')];
  const rows = nodes.map((node) => ({ node, y: node.getBoundingClientRect().top })).sort((a, b) => a.y - b.y);
  const next = rows[rows.findIndex(({ node }) => node === event.target) + (event.key === 'ArrowUp' ? -1 : 1)];
  next?.node.focus();
  event.preventDefault();
}

export function TreeView({ tree, shape }: { tree: Tree; shape: Shape }) {
  const page = use_page();
  const looked = use_cell(page.node);
  const scroller = useRef<HTMLDivElement>(null);
  /** By node, what the user wants instead of: open where it was asked. */
  const [turned, set_turned] = useState<ReadonlyMap<number, boolean>>(new Map());
  useEffect(() => set_turned(new Map()), [tree]);
  const is_open = (node: number): boolean => turned.get(node) ?? shape.status[node] !== null;
  const layout = useMemo(() => layout_tree(tree, is_open, (node, hidden) => width_of(tree, shape, node, hidden)), [tree, shape, turned]);
  const way = useMemo(() => path_of_leader(page.run, shape), [page, shape]);
  const most = Math.max(...shape.vote, 1);

  // who leads is in sight
  useEffect(() => {
    const place = layout.placed.find(({ node }) => node === shape.leader);
    const view = scroller.current!;
    if (!place) return;
    const scale = view.scrollHeight / layout.height;
    const [top, bottom] = [(place.y - kPill) * scale, (place.y + kPill) * scale];
    if (top < view.scrollTop || bottom > view.scrollTop + view.clientHeight) view.scrollTop = (top + bottom - view.clientHeight) / 2;
    view.scrollLeft = Math.max((place.x + place.width) * scale - view.clientWidth, 0);
  }, [layout, shape.leader]);

  const toggle = (node: number): void => set_turned(new Map(turned).set(node, !is_open(node)));
  const focusable = layout.placed.some(({ node }) => node === looked) ? looked : 0;
  return (
    <div class="tree" ref={scroller} tabIndex={0} role="group" aria-label="Tree">
      <svg role="tree" aria-label="Decision tree" viewBox={`0 0 ${layout.width} ${layout.height}`} onKeyDown={walk}
        style={{ width: `${layout.width / kFont}rem`, height: `${layout.height / kFont}rem` }}>
        <g class="links">
          {layout.placed.filter(({ link }) => link).map(({ node, link }) => (
            <path key={node} d={link} class={way.has(node) ? 'way' : shape.status[node] === null ? 'none' : ''} />
          ))}
        </g>
        {layout.placed.map((place) => (
          <Pill key={place.node} tree={tree} shape={shape} place={place} on_way={way.has(place.node)} most={most}
            focusable={place.node === focusable} onToggle={toggle} />
        ))}
      </svg>
    </div>
  );
}

