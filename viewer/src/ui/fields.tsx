// SPDX-License-Identifier: MIT
/** What was decided, field by field: who won, why, and what the others wanted. */
import { useEffect, useRef, useState } from 'preact/hooks';
import { source_of, type Player, type Rival, type Run, type Tree, type Won } from '../run/run.ts';
import type { Ghost } from '../store.ts';
import { told_text, number_text } from '../words/text.ts';
import { Chip } from './leaders.tsx';
import { use_page } from './page.ts';
import { use_rove } from './use.ts';

/** Where `node` would have led; null: it says nothing of where to fly. */
export function ghost_of(run: Run, player: Player, index: number, node: number): Ghost | null {
  const { action } = run.platforms[player.kind];
  const value = (name: string): number | null => {
    const v = player.decisions.value(node, action.findIndex((field) => field.name === name))?.[index] ?? NaN;
    return Number.isNaN(v) ? null : v;
  };
  const [heading, altitude, speed] = [value('heading'), value('altitude'), value('speed')];
  if (heading === null && altitude === null && speed === null) return null;
  const tree = run.trees[run.shapes[player.decisions.shape[index]!]!.tree]!;
  return { player: player.index, t: player.decisions.t[index]!, heading, altitude, speed, label: tree.nodes[node]!.label };
}

/** -1: at nobody. */
type Point = (node: number) => void;

function RivalButton({ rival, text, label, onPoint }: { rival: Rival; text: string; label: string; onPoint: Point }) {
  const words = `${label} ${text} ${number_text(rival.vote)} votes: shows where it would have led`;
  const at = (): void => onPoint(rival.node);
  const away = (): void => onPoint(-1);
  return (
    <button type="button" class="rival" aria-label={words} data-node={rival.node}
      onPointerEnter={at} onPointerLeave={away} onFocus={at} onBlur={away} onClick={at}>
      <Chip label={label} />{label} <b>{text}</b> <span class="votes">{number_text(rival.vote)}</span>
    </button>
  );
}

type RowProps = { won: Won; si: number; tree: Tree; proposed: (node: number) => number; text: (value: number) => string; onPoint: Point };
function FieldRow({ won, si, tree, proposed, text, onPoint }: RowProps) {
  const page = use_page();
  const winner = tree.nodes[won.winner];
  const field = page.run.platforms[tree.kind].action[won.field]!;
  const value = text(si);
  return (
    <tbody data-field={field.name} data-winner={winner?.path ?? ''} data-value={value} data-si={si} data-rivals={won.rivals.length}
      onPointerEnter={() => page.pointed.set(won.winner)} onPointerLeave={() => page.pointed.set(-1)}>
      <tr>
        <th scope="row">{field.name}</th>
        <td class={value.length > 16 ? 'value long' : 'value'}>{value}</td>
        <td>
          <span class="winner"><Chip label={winner?.label ?? 'nobody'} />{winner?.label ?? 'nobody'}</span>{' '}
          <span class="reason">{won.reason}</span>
        </td>
      </tr>
      {won.rivals.length > 0 && (
        <tr>
          <td />
          <td class="rivals" colSpan={2}>
            {won.rivals.map((rival) => (
              <RivalButton key={rival.node} rival={rival} text={text(proposed(rival.node))} label={tree.nodes[rival.node]!.label}
                onPoint={onPoint} />
            ))}
          </td>
        </tr>
      )}
    </tbody>
  );
}

export function Fields({ player, index, tree }: { player: Player; index: number; tree: Tree }) {
  const page = use_page();
  const table = useRef<HTMLTableElement>(null);
  use_rove(table);
  const shape = page.run.shapes[player.decisions.shape[index]!]!;
  const fields = shape.won;
  const value = (node: number, field: number): number => player.decisions.value(node, field)?.[index] ?? NaN;
  const [pointed, point] = useState(-1);
  const asks = pointed >= 0 && fields.some(({ rivals }) => rivals.some(({ node }) => node === pointed));
  useEffect(() => {
    if (!asks) return;
    page.store.set({ ghost: ghost_of(page.run, player, index, pointed) });
    page.pointed.set(pointed);
    return () => {
      page.store.set({ ghost: null });
      page.pointed.set(-1);
    };
  }, [page, player, index, pointed, asks]);
  if (!fields.length) return <p class="dim">Nobody asked for anything; the last order stands.</p>;
  return (
    <table class="fields" ref={table}>
      <colgroup><col class="field-name" /><col class="field-value" /><col /></colgroup>
      <thead class="unseen"><tr><th>field</th><th>value</th><th>who won, and why</th></tr></thead>
      {fields.map((won) => (
          <FieldRow key={won.field} won={won} si={value(source_of(shape, 0, won.field), won.field)} tree={tree} onPoint={point}
            proposed={(node) => value(node, won.field)}
            text={(value) => told_text(page.run, player, player.decisions.t[index]!, page.run.platforms[player.kind].action[won.field]!, value)} />
      ))}
    </table>
  );
}
