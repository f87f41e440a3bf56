// SPDX-License-Identifier: MIT
/** What a player saw before a decision; names in brackets are the truth, which it did not know. */
import { useMemo } from 'preact/hooks';
import { last_at, type Place, type Player, type Sight, type TrackSeen } from '../run/run.ts';
import { convergence } from '../scene/geo.ts';
import { new_pose, pose_at, wrapped, type Pose } from '../scene/motion.ts';
import { heading_text, height_text, quantity_text, side_text, value_text, clock_text, number_text } from '../words/text.ts';
import { select } from './actions.ts';
import { Name } from './leaders.tsx';
import { use_page } from './page.ts';

function from_here(own: Place, { east, north, up }: Place): { range: number; bearing: number } {
  const [e, n] = [east - own.east, north - own.north];
  return { range: Math.hypot(e, n, up - own.up), bearing: wrapped(Math.atan2(e, n)) };
}

/** `north`: rad, of the map at its place, true; `heading` is true, too. */
function Track({ track, own, north, heading }: { track: TrackSeen; own: Pose; north: number; heading: number }) {
  const page = use_page();
  const { run } = page;
  const { range, bearing: on_map } = from_here(own, track.place);
  const bearing = on_map + north;
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
  const north = convergence(use_page().run.origin, own);
  const heading = own.heading + north;
  return (
    <table class="tracks">
      <thead><tr><th>track</th><th>truth</th><th>range</th><th>bearing</th><th>off nose</th><th>altitude</th><th>age</th></tr></thead>
      <tbody>
        {sight.tracks.map((track, i) => <Track key={`${track.id}/${i}`} track={track} own={own} north={north} heading={heading} />)}
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
