// SPDX-License-Identifier: MIT
/** Where the nodes of a tree stand: the root at the left, a row for each node that is shown, columns as wide as they must be. */
import { hierarchy, tree as tidy } from 'd3-hierarchy';
import type { Tree } from '../run/run.ts';

export interface Placed {
  node: number;
  /** Left and middle, in the units of the font, whose size is kFont. */
  x: number;
  y: number;
  width: number;
  /** How many nodes below are not shown. */
  hidden: number;
  /** From the parent to here; "" for the root. */
  link: string;
}
export interface Layout {
  placed: Placed[];
  width: number;
  height: number;
}

export const kFont = 12;
const kRow = 20.5;
export const kPill = 17;
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
