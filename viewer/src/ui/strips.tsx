// SPDX-License-Identifier: MIT
/** Quantities over time, several players over each other, on the axis of the timeline. */
import { useEffect, useMemo, useRef } from 'preact/hooks';
import uPlot from 'uplot';
import type { Player, Run } from '../run/run.ts';
import { count_text } from '../words/text.ts';
import { color, rem_size } from './canvas.ts';
import { namesake, use_page, type Page } from './page.ts';
import { kQuantities, resample, series_of, type Quantity } from './series.ts';
import { ticks_of } from './timeline.tsx';
import { use_cell, use_paced, use_range, use_size, use_view } from './use.ts';

/** Samples a pixel: finer shows no more. */
const kFine = 1.5;
/** Lines of a side are told apart by their dashes; the selected one is solid and thick. */
const kDashes = [[1, 2], [6, 3], [8, 3, 2, 3], [3, 3], [12, 4], [2, 5]];

interface Line {
  player: Player;
  run: Run;
  name: string;
  selected: boolean;
}

function data_of(quantity: Quantity, lines: Line[], [from, to]: [number, number], width: number): uPlot.AlignedData {
  const count = Math.max(Math.round(width * kFine), 2);
  const grid = Array.from({ length: count }, (_, i) => from + ((to - from) * i) / (count - 1));
  return [grid, ...lines.map(({ player, run }) => {
    const series = series_of(run, player, quantity);
    return series ? resample(series, grid, quantity.steps, player.gone) : grid.map(() => null);
  })];
}

function is_empty(data: uPlot.AlignedData): boolean {
  return data.slice(1).every((values) => (values as (number | null)[]).every((v) => v === null));
}

/** Room above and below; an axis also where there is nothing to see, and no noise made large. */
function y_range({ least: span }: Quantity): uPlot.Range.Function {
  return (_, least: number | null, most: number | null) => {
    if (least === null || most === null) return [0, 1];
    const room = Math.max((most - least) * 0.08, (span - (most - least)) / 2);
    return [least - room, most + room];
  };
}

function options_of(quantity: Quantity, lines: Line[], width: number, height: number, gutter: number, edge: number): uPlot.Options {
  const rem = rem_size();
  const font = `${0.8 * rem}px system-ui, sans-serif`;
  const grid = { stroke: color('grid'), width: 1 };
  return {
    width, height, padding: [1.2 * rem, edge, 0.35 * rem, 0], legend: { show: false },
    cursor: { x: false, y: false, drag: { x: false, y: false, setScale: false }, points: { size: 0.5 * rem } },
    scales: { x: { time: false, range: (u) => [u.data[0]![0]!, u.data[0]!.at(-1)!] }, y: { range: y_range(quantity) } },
    axes: [
      {
        size: 0, values: () => [], grid, ticks: { show: false },
        splits: (u, _, from, to) => ticks_of(from, to, u.width - gutter - edge, rem).ticks,
      },
      {
        size: gutter, font, stroke: color('dim'), grid, ticks: { show: false }, gap: 0.35 * rem, space: rem,
        values: (u, splits) => splits.map((v) => (is_empty(u.data) ? '' : count_text(Number(v.toFixed(quantity.digits + 1)) || 0))),
      },
    ],
    series: [{}, ...lines.map(({ player, name, selected }, i): uPlot.Series => ({
      label: name, stroke: color(player.side === 'none' ? 'ink' : player.side), width: (selected ? 0.16 : 0.1) * rem, points: { show: false },
      ...(selected ? {} : { dash: kDashes[(i - 1) % kDashes.length]! }),
      ...(quantity.steps ? { paths: uPlot.paths.stepped!({ align: 1 }) } : {}),
    }))],
  };
}

function Strip({ quantity, lines }: { quantity: Quantity; lines: Line[] }) {
  const page = use_page();
  const host = useRef<HTMLDivElement>(null);
  const plot = useRef<uPlot | null>(null);
  const [width, height] = use_size(host);
  const theme = use_view(page.store, (v) => v.theme);
  const [from, to] = use_range();
  useEffect(() => {
    if (!width || !height) return;
    const style = getComputedStyle(host.current!);
    const gutter = parseFloat(style.getPropertyValue('--gutter')) * rem_size();
    const edge = parseFloat(style.getPropertyValue('--edge')) * rem_size();
    const options = options_of(quantity, lines, width, height, gutter, edge);
    const made = new uPlot(options, data_of(quantity, lines, [from, to], width), host.current!);
    plot.current = made;
    const stop = page.hover.subscribe((hover) => {
      const left = hover ? made.valToPos(hover.t, 'x') : -10;
      made.setCursor({ left, top: hover ? 1 : -10 }, false);
    });
    return () => {
      stop();
      made.destroy();
      plot.current = null;
    };
  }, [page, quantity, lines, width, height, theme]);
  useEffect(() => {
    plot.current?.setData(data_of(quantity, lines, [from, to], width));
  }, [from, to]);
  return (
    <div class="row strip" data-row={quantity.key}>
      <div class="strip-host" ref={host} role="img" aria-label={`${quantity.label} over time`} />
      <Readout quantity={quantity} lines={lines} />
    </div>
  );
}

/** The values under the pointer, or now. */
function Readout({ quantity, lines }: { quantity: Quantity; lines: Line[] }) {
  const page = use_page();
  const hover = use_cell(page.hover);
  const now = use_paced(page.store, (v) => v.time);
  const t = hover ? hover.t : now;
  const [unit] = quantity.unit();
  const at = ({ player: { index }, run }: Line): number => {
    const player = run.players[index]!;  // of a mission that is flown: as it is now, not as its line was drawn
    const series = series_of(run, player, quantity);
    return (series && resample(series, [t], quantity.steps, player.gone)[0]) ?? NaN;
  };
  const said = (v: number): string => (Number.isNaN(v) ? '–' : count_text(Number(v.toFixed(quantity.digits))));
  // who else is shown may be in both runs, too
  const twin = page.twin && lines[1]?.run === page.twin.run ? lines[1] : undefined;
  const apart = twin ? at(twin) - at(lines[0]!) : NaN;
  return (
    <div class="readout">
      <b>{quantity.label}</b>{unit && <span class="dim"> {unit}</span>}
      {lines.map((line) => (
        <span key={line.name} class={`${line.player.side} ${line.selected ? 'strong' : ''}`}>{line.name} <output>{said(at(line))}</output></span>
      ))}
      {twin && <span data-apart={apart}>Δ {apart > 0 && '+'}{said(apart)}</span>}
    </div>
  );
}

export function Strips() {
  const page = use_page();
  const { quantities, players } = use_cell(page.strips);
  const selected = use_view(page.store, (v) => v.selected);
  // the same player in the other run comes second
  const lines = useMemo(() => [selected, ...players.filter((p) => p !== selected)].flatMap((p): Line[] => {
    const line = ({ run, letter }: Page, player: Player): Line => ({ player, run, name: `${letter} ${player.name}`.trim(), selected: run === page.run && p === selected });
    const [own, twin] = [page.run.players[p]!, page.twin?.run.players[namesake(page.twin, page.run.players[p])]];
    return [line(page, own), ...(twin ? [line(page.twin!, twin)] : [])];
  }), [page, selected, players]);
  const is_there = (q: Quantity): boolean => quantities.includes(q.key) && lines.some(({ player, run }) => series_of(run, player, q));
  return <>{kQuantities.filter(is_there).map((q) => <Strip key={q.key} quantity={q} lines={lines} />)}</>;
}

/** Which strips there are, and of whom. */
export function StripMenu() {
  const page = use_page();
  const choice = use_cell(page.strips);
  const flip = <T,>(list: T[], one: T): T[] => (list.includes(one) ? list.filter((x) => x !== one) : [...list, one]);
  return (
    <details class="menu up">
      <summary aria-label="Which strips are shown">strips</summary>
      <div class="menu-body two">
        <fieldset>
          <legend>quantities</legend>
          {kQuantities.map(({ key, label }) => (
            <label key={key}><input type="checkbox" checked={choice.quantities.includes(key)} aria-label={`Strip of ${label}`}
              onChange={() => page.strips.set({ ...choice, quantities: flip(choice.quantities, key) })} />{label}</label>
          ))}
        </fieldset>
        <fieldset class="long">
          <legend>besides the selected player</legend>
          {page.run.players.map(({ name, index, side }) => (
            <label key={name} class={side}><input type="checkbox" checked={choice.players.includes(index)} aria-label={`Overlay ${name}`}
              onChange={() => page.strips.set({ ...choice, players: flip(choice.players, index) })} />{name}</label>
          ))}
        </fieldset>
      </div>
    </details>
  );
}
