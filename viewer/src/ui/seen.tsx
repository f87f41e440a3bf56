// SPDX-License-Identifier: MIT
/** What a player saw before a decision; names in brackets are the truth, which it did not know. */
import { useMemo } from 'preact/hooks';
import { last_at, type Player, type Sight, type TrackSeen } from '../run/run.ts';
import { convergence, measure } from '../scene/geo.ts';
import { new_pose, pose_at, type Pose } from '../scene/motion.ts';
import { heading_text, height_text, quantity_text, side_text, value_text, clock_text, number_text } from '../words/text.ts';
import { select } from './actions.ts';
import { Name } from './leaders.tsx';
import { use_page } from './page.ts';

/** `heading`: rad, true. */
function Track({ track, own, heading }: { track: TrackSeen; own: Pose; heading: number }) {
  const page = use_page();
  const { run } = page;
  const { range, bearing } = measure(run.origin, own, track.place);
  const truth = run.players[track.truth];
  return (
    <tr class={track.is_target ? 'target' : ''}>
      <th scope="row"><span class={`identity ${track.identity}`} role="img" title={track.identity} aria-label={track.identity} />{track.is_target && 'target '}#{track.id}</th>
      <td>
        {truth
          ? <button type="button" class="link truth" title="Who it really is; selects"
              onClick={() => select(page, truth.index)}>(<Name name={truth.name} />)</button>
          : <span class="truth">(nothing there)</span>}
      </td>
      <td>{quantity_text(range, 'm')}</td><td>{heading_text(bearing)}</td><td>{side_text(bearing - heading)}</td><td>{height_text(track.place.up)}</td>
      <td>{number_text(track.age, 1)} s</td>
    </tr>
  );
}

function Perceived({ player, sight }: { player: Player; sight: Sight }) {
  const own = new_pose();
  pose_at(player.motion, sight.t, own);
  const heading = own.heading + convergence(use_page().run.origin, own);
  return (
    <table class="tracks">
      <thead><tr><th>track</th><th>truth</th><th>range</th><th>bearing</th><th>off nose</th><th>altitude</th><th>age</th></tr></thead>
      <tbody>
        {sight.tracks.map((track, i) => <Track key={`${track.id}/${i}`} track={track} own={own} heading={heading} />)}
        {sight.warnings.map(({ kind, name, range, bearing }, i) => (
          <tr key={`w${i}`} class={`warning ${kind.startsWith('missile') ? 'missile' : ''}`}>
            <th scope="row">⚠ {kind}</th><td><span class="truth">(<Name name={name} />)</span></td>
            <td>{quantity_text(range, 'm')}</td><td>{heading_text(bearing)}</td><td>{side_text(bearing - heading)}</td><td colSpan={2} />
          </tr>
        ))}
      </tbody>
    </table>
  );
}

function Zone({ min, no_escape, max }: NonNullable<Sight['zone']>) {
  const [least, sure, most] = [min, no_escape, max].map((range) => quantity_text(range, 'm'));
  return <p class="small"><span class="dim">zone of the missile in hand:</span> {least} to {most}, no escape within {sure}</p>;
}

export function Seen({ player, time }: { player: Player; time: number }) {
  const { run } = use_page();
  const index = last_at(player.sights.t, time);
  const sight = useMemo(() => (index < 0 ? null : player.sights.at(index)), [player, index]);
  if (!sight) return <p class="dim">Nothing was recorded of what it saw.</p>;
  const { state } = run.platforms[player.kind];
  const age = time - sight.t;
  return (
    <>
      {age > 1e-6 && <p class="dim small">as of {clock_text(sight.t)}, {number_text(age, 3)} s before the decision</p>}
      <dl class="state">
        {state.map((field, i) => (
          <div key={field.name} class={Number.isNaN(sight.state[i]) ? 'none' : ''} data-state={field.name}>
            <dt>{field.name}</dt><dd>{value_text(run, field, sight.state[i]!)}</dd>
          </div>
        ))}
      </dl>
      {sight.tracks.length + sight.warnings.length > 0 && <Perceived player={player} sight={sight} />}
      {sight.zone && <Zone {...sight.zone} />}
    </>
  );
}
