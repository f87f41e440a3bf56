// SPDX-License-Identifier: MIT
/** What somebody outside had done instead of what the tree recommended, decision by decision: while it goes on, and in the debrief. */
import type { Player, Run } from '../run/run.ts';
import { use_page } from '../ui/page.ts';
import { use_asked } from '../ui/what_if_answer.ts';
import { clock_text, reworded } from '../words/text.ts';

/** As `eyrie explain --json` has it. */
interface Told {
  overruled?: { name: string; tree: string; outside: string }[];
}
/** ms that a decision is looked at before it is asked about. */
const kRest = 120;

/** In the story: from one line to the other, each for itself. */
const kOrders: readonly [begin: string, end: string][] = [['taken over', 'handed back'], ['to a point', 'route again'], ['weapons tight', 'weapons free']];

/** Since when it is told from outside what to do at a time (s); null: it is not. */
export function told_since(run: Run, player: number, time: number): number | null {
  const since = kOrders.map(() => Infinity);
  for (const { t, kind, who, text } of run.story) {
    if (t > time) break;
    if (kind !== 'order' || who !== player) continue;
    kOrders.forEach(([begin, end], i) => {
      if (text.includes(end)) since[i] = Infinity;
      else if (text.includes(begin)) since[i] = Math.min(since[i]!, t);
    });
  }
  const first = Math.min(...since);
  return first < Infinity ? first : null;
}

export function Overruled({ player, index }: { player: Player; index: number }) {
  const { run } = use_page();
  const step = player.decisions.step[index] ?? 0;
  const since = told_since(run, player.index, player.decisions.t[index] ?? 0);
  const asked = use_asked(since === null ? null : `${player.name} ${step}`, async () => {
    const engine = run.engine!;
    // in one go, so that nobody else goes to another step in between
    const [, { decision }] = await Promise.all([engine.seek({ step }), engine.explain({ player: player.name })]);
    return (decision as Told | undefined)?.overruled ?? [];
  }, kRest);
  if (since === null || !asked) return null;
  const rows = asked.value;
  return (
    <section class="overruled" aria-label="From outside" data-count={rows?.length ?? ''}>
      <h3>From outside</h3>
      <p class="dim small">It is told what to do since {clock_text(since)}.{rows?.length === 0 && ' This decision is carried out as its tree recommends.'}</p>
      {asked.problem && <p>{asked.problem}</p>}
      {rows && rows.length > 0 && (
        <table>
          <thead><tr><td /><th scope="col">done</th><th scope="col">its tree</th></tr></thead>
          <tbody>{rows.map(({ name, tree, outside }) => <tr key={name}><th scope="row">{name}</th><td><b>{reworded(outside)}</b></td><td>{reworded(tree)}</td></tr>)}</tbody>
        </table>
      )}
    </section>
  );
}
