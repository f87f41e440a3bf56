// SPDX-License-Identifier: MIT
/** The selected flight: where it was told to go, and who keeps to whom. */
import { type Frame, x_of, y_of, z_of } from './frame.ts';

export function draw_routes(frame: Frame): void {
  const { run, view, lines, palette, eye, notes } = frame;
  const flight = run.flights[run.players[view.selected]?.flight ?? -1];
  if (!view.layers.routes || !flight) return;
  const tint = palette.side[flight.side];
  const stops = flight.home ? [...flight.route, flight.home] : flight.route;
  stops.forEach((stop, i) => {
    const [x, y, z] = [x_of(stop), y_of(stop), z_of(stop)];
    const next = stops[i + 1];
    const home = stop === flight.home;
    lines.pen(tint, 1.2, 10);
    if (next) lines.add(x, y, z, x_of(next), y_of(next), z_of(next), next === flight.home ? 0.35 : 0.65);
    lines.pen(tint, 1, 4);
    if (!home && y > 0.1) lines.add(x, y, z, x, 0, z, 0.35);
    if (!eye.project(x, y, z) || !eye.on_screen(20)) return;
    const r = 8 * eye.ui;
    notes.mark(home ? 'triangle' : 'circle', eye.px, eye.py, 8, palette.chip, 1, true, 0.8);
    notes.mark(home ? 'triangle' : 'circle', eye.px, eye.py, 8, tint, 1.2);
    notes.reserve(eye.px - r, eye.py - r, 2 * r, 2 * r);
    if (home) notes.tag(-40, eye.px, eye.py, `${flight.name} home`, '', tint, null, 40);
    else notes.figure(String(i + 1), eye.px, eye.py, tint);
  });
  draw_formation(frame, flight.members);
}

/** From the first of the flight who is alive to the others. */
function draw_formation({ players, lines, palette, run }: Frame, members: number[]): void {
  const lead = members.find((i) => players.shown[i]);
  if (lead === undefined) return;
  lines.pen(palette.side[run.players[lead]!.side], 1);
  for (const i of members)
    if (i !== lead && players.shown[i])
      lines.add(players.x[lead]!, players.y[lead]!, players.z[lead]!, players.x[i]!, players.y[i]!, players.z[i]!, 0.45);
}
