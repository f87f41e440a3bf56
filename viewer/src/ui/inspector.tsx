// SPDX-License-Identifier: MIT
/** The decision of the selected player at the time of the page: tree, action, what it saw, and what if. */
import type { ComponentChildren } from 'preact';
import { useEffect } from 'preact/hooks';
import { Overruled } from '../live/overruled.tsx';
import type { Player, Run } from '../run/run.ts';
import { clock_text, number_text } from '../words/text.ts';
import { jump, step_decision, step_leader } from './actions.ts';
import { Fields } from './fields.tsx';
import { IconButton } from './icon.tsx';
import { Chip, Name } from './leaders.tsx';
import { NodeDetails } from './node_details.tsx';
import { use_page } from './page.ts';
import { fate_at, fate_words } from './players.tsx';
import { Seen } from './seen.tsx';
import { Machine } from './machine.tsx';
import { label_of, leader_spans, path_of, type Span } from './spans.ts';
import { TreeView } from './tree_view.tsx';
import { use_cell, use_decision, use_paced } from './use.ts';
import { WhatIf } from './what_if.tsx';

function Section({ title, note, children }: { title: string; note?: string; children: ComponentChildren }) {
  return (
    <details class="section" open>
      <summary><h2>{title}</h2>{note && <span class="dim small">{note}</span>}</summary>
      {children}
    </details>
  );
}

/** "from follow_lead: ingress was left for bvr" */
function change_words(run: Run, player: Player, spans: Span[], at: number): string {
  const [before, now] = [spans[at - 1], spans[at]!];
  if (!before) return 'the first decision';
  return `after ${before.label}: ${run.texts[player.decisions.why_not[now.first]!] ?? 'another tree'}`;
}

function Header({ player, index }: { player: Player; index: number }) {
  const page = use_page();
  const { run } = page;
  const shape = run.shapes[player.decisions.shape[index]!];
  const spans = leader_spans(run, player);
  const at = spans.findIndex((span) => index < span.end);
  const span = spans[at];
  const fate = use_paced(page.store, ({ time }) => fate_at(player, time));
  const leader = shape ? label_of(run, shape.tree, shape.leader) : 'nobody';
  return (
    <header class="inspector-head">
      <div class="who-line">
        <h2 class={player.side}><Name name={player.name} /></h2><span class="dim cut" title={player.type}>{player.type}</span>
        {fate !== 'alive' && <b class="badge">{fate_words(fate, player.gone)}</b>}
        <span class="spring" />
        <IconButton icon="back_to" label="Back to where another behavior began to lead" keys="{" onClick={() => step_leader(page, -1)} />
        <IconButton icon="back" label="Previous decision" keys="←" onClick={() => step_decision(page, -1)} />
        <IconButton icon="on" label="Next decision" keys="→" onClick={() => step_decision(page, 1)} />
        <IconButton icon="on_to" label="On to where another behavior begins to lead" keys="}" onClick={() => step_leader(page, 1)} />
      </div>
      {shape && span
        ? <>
            <p class="lead-line"><Chip label={leader} /><b>{leader}</b> leads with {number_text(shape.vote[0]!)}</p>
            <p class="dim small">
              {clock_text(player.decisions.t[index]!)}, step {player.decisions.step[index]}, tree {run.trees[shape.tree]!.name};
              since <button type="button" class="link" onClick={() => jump(page, span.from)}>{clock_text(span.from)}</button>,{' '}
              {change_words(run, player, spans, at)}
            </p>
          </>
        : player.decisions.t.length > 0
          ? <p><button type="button" class="link" onClick={() => jump(page, player.decisions.t[0]!)}>The first decision comes at {clock_text(player.decisions.t[0]!)}</button></p>
          : <p class="dim">{run.is_part ? 'The run is being flown again …' : 'It decides nothing in this run.'}</p>}
    </header>
  );
}

export function Inspector() {
  const page = use_page();
  const { run } = page;
  const { player, index } = use_decision();
  const shape = run.shapes[player.decisions.shape[index]!];
  const tree = shape && run.trees[shape.tree]!;
  const node = use_cell(page.node);
  const t = player.decisions.t[index] ?? 0;
  useEffect(() => page.node.set(-1), [page.node, shape?.tree]);

  return (
    <section class="inspector" aria-label="Decision" data-player={player.name} data-step={player.decisions.step[index] ?? ''}
      data-leader={shape ? path_of(run, shape.tree, shape.leader) : ''} data-vote={shape?.vote[0] ?? ''}>
      <Header player={player} index={index} />
      {shape && tree && (
        <div class="inspector-body">
          <Section title="Tree" note={tree.name}>
            {tree.nodes.map(({ rules }, n) => rules && shape.status[n] !== null
              && <Machine key={`${shape.tree}/${n}`} player={player} index={index} tree={tree} shape={shape} node={n} />)}
            <TreeView tree={tree} shape={shape} />
            {node >= 0 && tree.nodes[node] && <NodeDetails player={player} index={index} tree={tree} shape={shape} node={node} />}
            <WhatIf player={player} tree={shape.tree} />
          </Section>
          <Section title="Action" note="point at a loser to see it in the air picture">
            <Fields player={player} index={index} tree={tree} />
            {run.engine && <Overruled player={player} index={index} />}
          </Section>
          <Section title="Saw" note="in brackets the truth"><Seen player={player} time={t} /></Section>
        </div>
      )}
    </section>
  );
}
