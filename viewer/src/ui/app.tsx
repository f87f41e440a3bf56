// SPDX-License-Identifier: MIT
/** The page: players and story at the left, the air picture, the decision at the right, and time below. */
import { useEffect, useState } from 'preact/hooks';
import { listen } from '../events.ts';
import type { AirPicture } from '../scene/scene.ts';
import { Cell } from '../store.ts';
import { clock_text } from '../words/text.ts';
import { rem_size } from './canvas.ts';
import { CompareRows } from './compare.tsx';
import { Header, type Back } from './header.tsx';
import { LiveOver } from '../live/over.tsx';
import { Orders } from '../live/controls.tsx';
import { Inspector } from './inspector.tsx';
import { Help, use_keys, mind_manners } from './keys.tsx';
import { Moments, Story } from './story.tsx';
import { EveryoneRow, LeaderRow, Legend, OtherRow, WhatIfRow } from './leaders.tsx';
import { PageContext, use_page, type Page } from './page.ts';
import { Players } from './players.tsx';
import { Splitter } from './splitter.tsx';
import { Stack } from './stack.tsx';
import { Stage } from './stage.tsx';
import { Strips } from './strips.tsx';
import { Events, Overview } from './timeline.tsx';
import { Transport } from './transport.tsx';
import { kNarrow, use_view } from './use.ts';
import { forget, ForgetFuture } from './what_if.tsx';

type Panel = 'left' | 'right' | 'bottom';
type Sizes = Record<Panel, number>;

/** rem: least and most. */
const kLimits: Record<Panel, [number, number]> = { left: [12, 40], right: [22, 80], bottom: [8, 60] };
/** Lanes for everybody fit below the timeline up to this many players. */
const kMostLanes = 12;

/** rem: what leaves most of the screen to the air picture. */
function first_sizes(): Sizes {
  const rem = rem_size();
  const [wide, high] = [innerWidth / rem, innerHeight / rem];
  const within = (value: number, least: number, most: number): number => Math.round(Math.min(Math.max(value, least), most));
  return { left: within(wide * 0.17, 18, 28), right: within(wide * 0.315, 32, 50), bottom: within(high * 0.36, 19, 36) };
}

function Bottom({ pages }: { pages: Page[] }) {
  const page = use_page();
  const { run } = page;
  const player = run.players[use_view(page.store, (v) => v.selected)]!;
  const [everyone, set_everyone] = useState(run.players.length <= kMostLanes && !matchMedia(kNarrow).matches && innerHeight / rem_size() > 70);
  return (
    <section class="bottom" aria-label="Timeline and strips">
      <Transport>
        <button type="button" class="tool words" aria-pressed={everyone} title="Who led in everybody's tree"
          onClick={() => set_everyone(!everyone)}>
          everybody
        </button>
      </Transport>
      <Stack>
        <Overview />
        <Events />
        {pages.length > 1 ? <CompareRows pages={pages} player={player} /> : <LeaderRow player={player} />}
        <WhatIfRow player={player} />
        <OtherRow player={player} />
        <Legend player={player} />
        {everyone && <EveryoneRow />}
        <Strips />
      </Stack>
    </section>
  );
}

/** Of a narrow window: over the timeline, one at a time. */
const kSheets: readonly Panel[] = ['left', 'right'];

const kPanels: { panel: Panel; label: string }[] = [
  { panel: 'left', label: 'Players and story' }, { panel: 'bottom', label: 'Timeline and strips' }, { panel: 'right', label: 'Decision' },
];

/** Where the panels are and how large. */
function use_layout() {
  const [sizes, set_sizes] = useState(first_sizes);
  const [touched, touch] = useState(false);
  const [narrow, set_narrow] = useState(() => matchMedia(kNarrow).matches);
  const [hidden, set_hidden] = useState<readonly Panel[]>(narrow ? kSheets : []);
  useEffect(() => {
    const media = matchMedia(kNarrow);
    return listen(media, { change: () => {
      set_narrow(media.matches);
      set_hidden(media.matches ? kSheets : []);
    } });
  }, []);
  useEffect(() => {
    if (!touched) return listen(window, { resize: () => set_sizes(first_sizes()) });
  }, [touched]);
  const shown = (panel: Panel): boolean => !hidden.includes(panel);
  return {
    shown,
    // of two sheets one is open at a time
    flip: (panel: Panel): void => set_hidden(shown(panel) ? [...hidden, panel]
      : [...hidden, ...(narrow && panel !== 'bottom' ? kSheets : [])].filter((p) => p !== panel)),
    splitter: (panel: Panel, label: string, grows: 'left' | 'right' | 'up') => shown(panel) && !narrow && (
      <Splitter label={label} size={sizes[panel]} limits={kLimits[panel]} grows={grows} onHide={() => set_hidden([...hidden, panel])}
        onChange={(size) => { touch(true); set_sizes({ ...sizes, [panel]: size }); }} />
    ),
    style: Object.fromEntries((['left', 'right', 'bottom'] as const).map((p) => [`--${p}`, `${shown(p) ? sizes[p] : 0}rem`])),
  };
}

export function App({ pages, back, onScene }: {
  pages: Page[]; back: Back | undefined; onScene: (page: Page, scene: AirPicture) => void;
}) {
  const [letter, activate] = useState(pages[0]!.letter);
  const active = pages.find((page) => page.letter === letter) ?? pages[0]!;
  const [ghosts, set_ghosts] = useState(false);
  const show_ghosts = (wanted: boolean): void => {
    for (const page of pages) {
      forget(page);
      page.other.set(wanted && page.twin ? { from: 0, run: page.twin.run, label: page.twin.letter } : null);
    }
    set_ghosts(wanted);
  };
  const [help] = useState(() => new Cell(false));
  const layout = use_layout();
  const clock = use_view(active.store, (v) => clock_text(v.end).length);  // letters of a time, at most
  use_keys(active, help);
  useEffect(mind_manners, []);
  return (
    <PageContext.Provider value={active}>
      <div class="page" style={{ ...layout.style, '--clock': clock }}>
        <Header pages={pages} active={active} back={back} help={help} onSwitch={(page) => activate(page.letter)} ghosts={ghosts} onGhosts={show_ghosts}
          panels={kPanels.map((one) => ({ ...one, shown: layout.shown(one.panel), flip: () => layout.flip(one.panel) }))} />
        <Moments />
        {layout.shown('left') && <aside class="left" aria-label="Players and story"><Players /><Story key={active.letter} /></aside>}
        <main class="stages">
          {pages.filter((page) => !ghosts || page === active).map((page) => (
            <PageContext.Provider key={page.letter} value={page}><Stage onMount={(scene) => onScene(page, scene)} /></PageContext.Provider>
          ))}
          {pages.map((page) => <PageContext.Provider key={page.letter} value={page}><ForgetFuture /></PageContext.Provider>)}
          {active.live && <LiveOver live={active.live} />}
        </main>
        {layout.shown('right') && <aside class="right" aria-label="Decision">{active.live && <Orders live={active.live} />}<Inspector key={active.letter} /></aside>}
        {layout.shown('bottom') && <Bottom pages={pages} />}
        <div role="region" aria-label="Borders of the panels">
          {layout.splitter('left', 'Width of players and story', 'right')}
          {layout.splitter('right', 'Width of the decision', 'left')}
          {layout.splitter('bottom', 'Height of the strips', 'up')}
        </div>
      </div>
      <Help open={help} />
    </PageContext.Provider>
  );
}
