// SPDX-License-Identifier: MIT
/** Who won a field and against whom, in the words of the terminal: src/debrief/decision_test.cpp. */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { answer_words, contest, parting, path_of_leader, reason, why_not } from '../src/words/contest.ts';
import { find, leaf, node, run_of, type Said } from './words_run.ts';

const kTree = node('root', 'sequencer', [
  node('ingress', 'winner_takes_all', [leaf('ground'), leaf('navigate')]),
  node('bvr', 'per_field', [
    node('survive', 'winner_takes_all', [leaf('avoid'), leaf('break')]), leaf('release'), leaf('pursue'), leaf('follow'),
  ]),
  leaf('hostile_track'),
]);
const kIngress: Record<string, Said> = { ground: { status: 'failure' }, navigate: { vote: 10, heading: 1 } };
const kBvr: Record<string, Said> = {
  avoid: { status: 'failure' }, break: { vote: 15, heading: 3 }, release: { vote: 60, target: 2 },
  pursue: { vote: 40, heading: 1.5, speed: 250 }, follow: { vote: 20, heading: 0.5, speed: 200 }, hostile_track: { status: 'success' },
};

/** The page does not arbitrate a sequencer: it is told whose answer it handed on. */
function made(decisions: Record<string, Said>[]) {
  return run_of(kTree, decisions.map((d) => ({ ...d, root: {} })), (all, tree) => {
    const active = tree.nodes[0]!.children.find((c) => all[c]!.status !== null)!;
    all[0] = { ...all[active]!, supplier: all[active]!.supplier, action: all[active]!.action };
  });
}

test('each field has a winner, its reason, and rivals by the votes where they met', () => {
  const run = made([kBvr]);
  const fields = contest(run, 0, 0);
  assert.deepEqual(fields.map((f) => [f.field, f.winner, f.value]), [
    [0, find(run, 'pursue'), 1.5], [2, find(run, 'pursue'), 250], [4, find(run, 'release'), 2],
  ]);
  const [heading, , target] = fields;
  assert.deepEqual(heading!.rivals.map((r) => [r.node, r.value, r.vote, r.against]), [
    [find(run, 'follow'), 0.5, 20, 40], [find(run, 'break'), 3, 15, 40],
  ]);
  assert.equal(heading!.reason, 'voted 40 against 20');
  assert.equal(target!.reason, 'nobody else asked for it');
});

test('votes that an arbiter gave count in the place of its children\'s own', () => {
  const run = run_of(node('root', 'winner_takes_all', [leaf('pursue'), leaf('navigate')]),
    [{ pursue: { vote: 40, heading: 1 }, navigate: { vote: 50, heading: 2 } }], (all) => {
      all[1]!.given = 1.5;
      all[2]!.given = 80;
    });
  assert.equal(contest(run, 0, 0)[0]!.reason, 'voted 80 against 1.5');
  assert.equal(why_not(run.trees[0]!, run.shapes[0]!, 1), 'pursue voted 1.5 against 80');
});

test('what decided in the place of votes is told, and who abstains does not come up', () => {
  const fields = (type: string, navigate_votes: number) => {
    const run = run_of(node('root', type, [leaf('pursue'), leaf('navigate')]), [{ pursue: { vote: 40, heading: 1 }, navigate: { vote: navigate_votes, heading: 2 } }]);
    return [contest(run, 0, 0)[0]!.reason, why_not(run.trees[0]!, run.shapes[0]!, find(run, 'navigate'))];
  };
  assert.deepEqual(fields('winner_takes_all', 10), ['voted 40 against 10', 'navigate voted 10 against 40']);
  assert.deepEqual(fields('weighted_random', 10), ['40 against 10, and chance decided', 'navigate voted 10 against 40, and chance decided']);
  assert.equal(fields('winner_takes_all', 0)[0], "nobody else's came up to it");
});

test('a blend is won by the arbiter that made it', () => {
  const run = run_of(node('mix', 'fusion', [leaf('pursue'), leaf('follow'), leaf('navigate')]),
    [{ pursue: { vote: 40, speed: 250 }, follow: { vote: 20, speed: 200 }, navigate: { vote: 10, heading: 1 } }]);
  const [heading, speed] = contest(run, 0, 0);
  assert.deepEqual([heading!.winner, heading!.blended], [find(run, 'navigate'), false]);
  assert.deepEqual([speed!.winner, speed!.blended, speed!.reason], [0, true, 'blended of 2']);
  assert.ok(Math.abs(speed!.value - 700 / 3) < 1e-9);
});

test('of a blend only what it was made of is counted, and it comes first', () => {
  const run = run_of(node('root', 'winner_takes_all', [node('mix', 'fusion', [leaf('pursue'), node('best', 'winner_takes_all', [leaf('follow'), leaf('break')])]), leaf('navigate')]),
    [{ pursue: { vote: 20, speed: 250 }, follow: { vote: 20, speed: 200 }, break: { vote: 10, speed: 150 }, navigate: { vote: 15, speed: 100 } }]);
  const [speed] = contest(run, 0, 0);
  assert.deepEqual([speed!.winner, speed!.blended, speed!.reason], [find(run, 'mix'), true, 'blended of 2']);
  assert.deepEqual(speed!.rivals.map((r) => [r.node, r.blended]), [
    [find(run, 'pursue'), true], [find(run, 'follow'), true], [find(run, 'break'), false], [find(run, 'navigate'), false],
  ]);
});

test('who was kept back by what failed above it did not lose by votes', () => {
  const run = run_of(node('root', 'selector', [node('quiet', 'inhibit', [leaf('pursue')]), leaf('navigate')]),
    [{ pursue: { vote: 50, heading: 1 }, navigate: { vote: 3, heading: 2 } }], (all) => {
      all[1] = { ...all[1]!, status: 'failure', vote: 0, supplier: all[1]!.supplier.map(() => -1) };
      all[0] = { ...all[3]! };
    });
  assert.equal(why_not(run.trees[0]!, run.shapes[0]!, find(run, 'pursue')), 'pursue was kept back by quiet');
  run.shapes[0]!.why[find(run, 'quiet')] = 'refused: too fast';
  assert.equal(why_not(run.trees[0]!, run.shapes[0]!, find(run, 'pursue')), 'pursue was kept back by quiet: refused: too fast');
});

test('of who was not asked it is told what had to hold', () => {
  const run = run_of(node('root', 'winner_takes_all', [node('guard', 'guard', [node('selector', 'selector', [leaf('in_sight'), leaf('near')]), leaf('pursue')]), leaf('navigate')]),
    [{ in_sight: { status: 'failure' }, near: { status: 'failure' }, navigate: { vote: 3, heading: 2 } }]);
  const [shape] = run.shapes;
  for (const name of ['guard', 'selector', 'in_sight', 'near']) shape!.status[find(run, name)] = 'failure';
  shape!.status[find(run, 'pursue')] = null;
  shape!.why[find(run, 'in_sight')] = 'does not hold';
  shape!.why[find(run, 'near')] = 'nobody is known';
  assert.equal(why_not(run.trees[0]!, shape!, find(run, 'pursue')), 'pursue was not asked: in_sight does not hold, near failed: nobody is known');
});

test('of who did not come up it is told where he lost', () => {
  const run = run_of(node('root', 'winner_takes_all', [node('fight', 'winner_takes_all', [leaf('pursue'), leaf('navigate')]), leaf('break')]),
    [{ pursue: { vote: 40, heading: 1 }, navigate: { vote: 1, heading: 2 }, break: { vote: 56, heading: 3 } }]);
  assert.equal(why_not(run.trees[0]!, run.shapes[0]!, find(run, 'navigate')), 'navigate lost in fight, which voted 40 against 56');
  assert.equal(why_not(run.trees[0]!, run.shapes[0]!, find(run, 'pursue')), 'pursue voted 40 against 56');
});

test('reasons have words for ties and for places', () => {
  const won = (vote: number, against: number, came_up = true) => reason({ held: false, rivals: [{ node: 1, value: 0, vote, against, decided_by: '', came_up, blended: false }] });
  assert.equal(won(40, 40), 'voted 40 as the other did, and comes first');
  assert.equal(won(60, 40), '40 against 60, and votes did not decide');
  assert.equal(won(60, 40, false), "nobody else's came up to it");
});

test('two nodes part below the lowest node that has both', () => {
  const run = made([kBvr]);
  const [tree] = run.trees;
  const at = (a: string, b: string) => parting(tree!, find(run, a), find(run, b)).map((n) => tree!.nodes[n]!.label);
  assert.deepEqual(at('break', 'pursue'), ['survive', 'pursue']);
  assert.deepEqual(at('navigate', 'break'), ['ingress', 'bvr']);
  assert.deepEqual(at('bvr', 'break'), ['bvr', 'survive']);
});

test('a decision that failed has no fields', () => {
  const run = run_of(node('mix', 'per_field', [leaf('pursue')]), [{ pursue: { status: 'failure' } }]);
  assert.deepEqual(contest(run, 0, 0), []);
  assert.deepEqual(path_of_leader(run, run.shapes[0]!), new Set());
});

test('answers and changes of leader are told in words', () => {
  const run = made([kIngress, kBvr]);
  const [tree] = run.trees;
  const [then, now] = run.shapes;
  now!.why[find(run, 'avoid')] = 'the ground is far';
  assert.equal(answer_words(then!, find(run, 'navigate')), 'running, votes 10');
  assert.equal(answer_words(then!, find(run, 'pursue')), 'not asked');
  assert.equal(answer_words(then!, find(run, 'ground')), 'failed');
  assert.equal(answer_words(now!, find(run, 'avoid')), 'failed: the ground is far');
  assert.equal(answer_words(now!, find(run, 'hostile_track')), 'success');
  const told = (before: string) => why_not(tree!, now!, find(run, before));
  assert.equal(told('navigate'), 'ingress was left for bvr: hostile_track holds');
  assert.equal(told('avoid'), 'avoid failed: the ground is far');
  assert.equal(told('follow'), 'follow voted 20 against 60');
  assert.equal(told('break'), 'break voted 15 against 60');
  assert.equal(why_not(tree!, now!, -1), 'nobody led');
  assert.deepEqual(path_of_leader(run, now!), new Set([find(run, 'release'), find(run, 'bvr'), 0]));
});

test('the conditions below a transition that has no words of its own are named', () => {
  const holds = { status: 'success' } as const;
  const run = run_of(node('root', 'sequencer', [leaf('ingress'), leaf('bvr'), node('sequence', 'sequence', [leaf('near'), node('delay', 'delay', [leaf('low')])])]),
    [{ root: { vote: 5 }, bvr: { vote: 5, heading: 1 }, sequence: holds, near: holds, delay: holds, low: holds }]);
  const told = () => why_not(run.trees[0]!, run.shapes[0]!, find(run, 'ingress'));
  assert.equal(told(), 'ingress was left for bvr: near holds, low holds');
  run.trees[0]!.nodes[find(run, 'sequence')]!.label = 'close enough';
  assert.equal(told(), 'ingress was left for bvr: close enough holds');
});

for (const [now, pursue_says] of [['did not propose it this time', { status: 'failure' }], ['proposes another one, without a vote', { vote: 0, heading: 5 }]] as const)
  test(`what a node holds of somebody who ${now} is neither blended nor won by votes against him`, () => {
    const run = run_of(node('root', 'per_field', [node('steady', 'commitment', [leaf('pursue'), leaf('navigate')]), leaf('follow')]),
      [{ pursue: pursue_says, navigate: { vote: 10, heading: 2 }, follow: { vote: 20, heading: 3 } }], (all, tree) => {
        const pursue = tree.nodes.findIndex(({ label }) => label === 'pursue');
        for (const holder of [0, tree.nodes.findIndex(({ label }) => label === 'steady')]) {
          const supplier = Int16Array.from(all[holder]!.supplier, (_, f) => (f === 0 ? pursue : -1));
          all[holder] = { ...all[holder]!, status: 'running', vote: 40, supplier, held: Array.from(supplier, (_, f) => f === 0), action: Float64Array.of(1) };
        }
      });
    const [heading] = contest(run, 0, 0);
    assert.deepEqual([heading!.value, heading!.held, heading!.blended, heading!.reason], [1, true, false, 'held from an earlier decision']);
    assert.deepEqual(heading!.rivals.map(({ vote, against }) => [vote, against]), [[20, 40], [10, 40]]);
  });
