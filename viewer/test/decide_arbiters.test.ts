// SPDX-License-Identifier: MIT
/** One small case for each thing that docs/ubf.md says of an arbiter. */
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { decider_of, kDone, type Params, type Proposal } from '../src/decide/arbitrate.ts';
import { make_proposal } from '../src/decide/proposal.ts';
import { kFields, kNever, proposal, type FieldName, type Said } from './decide_run.ts';

const kNode = 9;
const kSchema = { direction: 'heading', magnitude: 'speed', unit_vote: 40 };

/** What it makes of them; `moment` is for those who look at the state. */
function decide(type: string, said: (Said | null)[], params: Params = {}, moment = kNever): Proposal {
  const out = make_proposal(kFields.length);
  const children = said.map((s, i) => (s ? proposal(s, i) : make_proposal(kFields.length)));
  assert.equal(decider_of(type, params, kFields, kNode, children.map((_, i) => i))!(children, out, moment), kDone);
  return out;
}
function value(out: Proposal, name: FieldName): number {
  return out.action[kFields.findIndex((f) => f.name === name)]!;
}
function supplier(out: Proposal, name: FieldName): number {
  return out.supplier[kFields.findIndex((f) => f.name === name)]!;
}
function degrees(x: number): number {
  return (x * 180) / Math.PI;
}
function rad(x: number): number {
  return (x * Math.PI) / 180;
}
function is_near(a: number, b: number): void {
  assert.ok(Math.abs(a - b) < 1e-9, `${a} is not ${b}`);
}
function assert_nothing(out: Proposal): void {
  assert.equal(out.status, 'failure');
  assert.equal(out.vote, 0);
  assert.equal(out.leader, -1);
  assert.ok(out.action.every(Number.isNaN));
  assert.ok(out.supplier.every((s) => s === -1));
}

describe('every arbiter', () => {
  const kAll: [string, Params][] = [
    ['winner_takes_all', {}], ['per_field', {}], ['fusion', {}], ['fusion', { top: 2 }], ['fusion', { conflicts: 'drop' }],
    ['paper_fusion', { high_vote: 50 }], ['motor_schema', kSchema], ['priority', {}], ['verify', { 'bounds.altitude.max': 9000 }],
  ];
  for (const [type, params] of kAll) {
    const name = `${type} ${JSON.stringify(params)}`;
    test(`${name} fails if all fail or abstain`, () => {
      assert_nothing(decide(type, [{ status: 'failure', vote: 40, heading: 1 }, { vote: 0, heading: 1, speed: 200 }], params));
    });
    test(`${name} hands on a voice that is alone`, () => {
      const voice = { status: 'success', vote: 40, heading: 1.25, altitude: 6000, speed: 200, target: 3 } as const;
      const out = decide(type, [{ status: 'failure' }, voice], params);
      assert.equal(out.status, 'success');
      assert.equal(out.vote, 40);
      is_near(value(out, 'heading'), 1.25);
      is_near(value(out, 'speed'), 200);
      assert.equal(value(out, 'altitude'), 6000);
      assert.equal(value(out, 'target'), type === 'paper_fusion' ? NaN : 3);
    });
    test(`${name} wants to hear everybody`, () => {
      const children = [proposal({ vote: 5, heading: 1 }, 0), make_proposal(kFields.length)];
      assert.equal(decider_of(type, params, kFields, kNode, [0, 1])!(children, make_proposal(kFields.length), kNever), 1);
    });
    test(`${name} rescales what goes up`, () => {
      const said = [{ vote: 40.1, heading: 1 }];
      assert.equal(decide(type, said, { ...params, vote: 7 }).vote, 7);
      assert.equal(decide(type, said, { ...params, vote_scale: 0.3 }).vote, Math.fround(Math.fround(40.1) * Math.fround(0.3)));
      assert_nothing(decide(type, [{ status: 'failure' }], { ...params, vote: 7 }));
    });
  }
});

test('winner_takes_all takes the highest vote whole, the earlier of equals', () => {
  const out = decide('winner_takes_all', [{ vote: 40, heading: 1 }, { vote: 60, speed: 200 }, { vote: 60, speed: 300 }]);
  assert.equal(out.leader, 1);
  assert.equal(value(out, 'speed'), 200);
  assert.equal(value(out, 'heading'), NaN);
});

test('per_field takes each field from the highest vote that set it', () => {
  const out = decide('per_field', [
    { vote: 40, heading: 1, speed: 200 }, { status: 'success', vote: 60, target: 4 }, { vote: 40, heading: 2, altitude: 5000 },
  ]);
  assert.equal(value(out, 'heading'), 1);
  assert.deepEqual([supplier(out, 'heading'), supplier(out, 'target'), supplier(out, 'altitude')], [0, 1, 2]);
  assert.deepEqual([out.status, out.vote, out.leader], ['success', 60, 1]);
});

describe('fusion', () => {
  test('takes weighted means and knows the circle', () => {
    const out = decide('fusion', [
      { vote: 30, heading: rad(350), altitude: 1000 }, { vote: 30, heading: rad(10), altitude: 3000 }, { vote: 60, altitude: 4000 },
    ]);
    is_near(Math.cos(value(out, 'heading')), 1);
    is_near(value(out, 'altitude'), 3000);
    assert.equal(out.leader, kNode);
    assert.equal(supplier(out, 'heading'), kNode);
  });
  test('gives opposite headings to the strongest, the earlier of equals', () => {
    const [east, west] = [rad(90), rad(270)];
    is_near(value(decide('fusion', [{ vote: 30, heading: east }, { vote: 30, heading: west }]), 'heading'), east);
    const three = decide('fusion', [{ vote: 20, heading: east }, { vote: 40, heading: west }, { vote: 20, heading: east }]);
    is_near(value(three, 'heading'), west);
  });
  test('keeps equal headings to the bit', () => {
    for (let heading = 0.1; heading < 6.2; heading += 0.1)
      assert.equal(value(decide('fusion', [{ vote: 30, heading }, { vote: 7, heading }]), 'heading'), heading);
  });
  test('gives orders to the strongest and drops disputed modes', () => {
    const out = decide('fusion', [{ vote: 30, target: 1, mode: 0 }, { vote: 40, target: 2, mode: 1 }]);
    assert.equal(value(out, 'target'), 2);
    assert.equal(supplier(out, 'target'), 1);
    assert.equal(value(out, 'mode'), NaN);
    assert.equal(supplier(out, 'mode'), -1);
    const agreed = decide('fusion', [{ vote: 30, mode: 1 }, { vote: 40, mode: 1 }]);
    assert.deepEqual([value(agreed, 'mode'), supplier(agreed, 'mode')], [1, 1]);
  });
  test('listens with top to the strongest few, the earlier of equals', () => {
    const said = [{ vote: 20, altitude: 1000 }, { vote: 10, altitude: 9000 }, { vote: 20, altitude: 3000 }, { vote: 20, altitude: 7000 }];
    is_near(value(decide('fusion', said, { top: 2 }), 'altitude'), 2000);
    const one = decide('fusion', said, { top: 1 });
    assert.deepEqual([value(one, 'altitude'), supplier(one, 'altitude'), one.leader], [1000, 0, kNode]);
  });
  test('drops with conflicts: drop whatever two differ on', () => {
    const said = [{ vote: 20, altitude: 1000, speed: 200 }, { vote: 30, altitude: 1000, speed: 210 }];
    const out = decide('fusion', said, { conflicts: 'drop' });
    assert.deepEqual([value(out, 'altitude'), value(out, 'speed')], [1000, NaN]);
  });
});

describe('paper_fusion', () => {
  const high = { high_vote: 50 };
  test('averages plainly, headings as numbers', () => {
    const said = [{ vote: 10, heading: rad(350), altitude: 1000 }, { vote: 60, heading: rad(10), altitude: 2000 }];
    const out = decide('paper_fusion', said, high);
    is_near(degrees(value(out, 'heading')), 180);
    is_near(value(out, 'altitude'), 1500);
  });
  test('takes orders from high votes alone', () => {
    assert.equal(value(decide('paper_fusion', [{ vote: 49, target: 2 }, { vote: 60, speed: 200 }], high), 'target'), NaN);
    assert.equal(value(decide('paper_fusion', [{ vote: 50, target: 2 }, { vote: 60, target: 5 }], high), 'target'), 5);
  });
  test('needs to know what a high vote is', () => assert.equal(decider_of('paper_fusion', {}, kFields, kNode, []), null));
});

describe('motor_schema', () => {
  test('adds vectors and never exceeds the longest', () => {
    const across = decide('motor_schema', [{ vote: 20, heading: 0, speed: 200 }, { vote: 20, heading: rad(90), speed: 200 }], kSchema);
    is_near(degrees(value(across, 'heading')), 45);
    is_near(value(across, 'speed'), 100 * Math.SQRT2);
    const along = decide('motor_schema', [{ vote: 40, heading: 1, speed: 200 }, { vote: 40, heading: 1, speed: 150 }], kSchema);
    is_near(value(along, 'speed'), 200);
    assert.deepEqual([along.leader, supplier(along, 'heading'), supplier(along, 'speed')], [kNode, kNode, kNode]);
  });
  test('leaves no direction where vectors cancel', () => {
    const out = decide('motor_schema', [{ vote: 20, heading: 0, speed: 200 }, { vote: 20, heading: Math.PI, speed: 200 }], kSchema);
    assert.deepEqual([value(out, 'heading'), value(out, 'speed'), supplier(out, 'heading')], [NaN, 0, -1]);
  });
  test('takes half a vector for none', () => {
    const out = decide('motor_schema', [{ vote: 20, heading: 1, altitude: 5000 }, { vote: 30, speed: 200 }], kSchema);
    assert.deepEqual([value(out, 'heading'), value(out, 'speed'), value(out, 'altitude'), out.leader], [NaN, NaN, 5000, 1]);
  });
});

test('priority takes the first that is heard, however it votes', () => {
  const out = decide('priority', [{ status: 'failure' }, { vote: 0, heading: 3 }, { vote: 5, heading: 1 }, { vote: 60, heading: 2 }]);
  assert.deepEqual([value(out, 'heading'), out.vote, out.leader], [1, 5, 2]);
});

describe('control nodes', () => {
  const hold = { status: 'success' } as const;
  const fail = { status: 'failure' } as const;
  test('selector takes the first that does not fail and does not need the rest', () => {
    const out = decide('selector', [fail, { heading: 1 }, null]);
    assert.deepEqual([out.status, out.vote, value(out, 'heading'), out.leader], ['running', 0, 1, 1]);
    const unasked = make_proposal(kFields.length);
    assert.equal(decider_of('selector', {}, kFields, kNode, [0, 1])!([proposal(fail, 0), unasked], make_proposal(kFields.length), kNever), 1);
    assert_nothing(decide('selector', [fail, fail]));
  });
  test('sequence sends up the last proposal that was made', () => {
    const out = decide('sequence', [{ ...hold, vote: 5, heading: 1 }, hold, { vote: 7, speed: 200 }, null]);
    assert.deepEqual([out.status, out.vote, value(out, 'heading'), value(out, 'speed')], ['running', 7, NaN, 200]);
    assert_nothing(decide('sequence', [{ ...hold, vote: 5, heading: 1 }, fail, null]));
    const done = decide('sequence', [{ ...hold, vote: 5, heading: 1 }, hold]);
    assert.deepEqual([done.status, done.vote, value(done, 'heading'), done.leader], ['success', 5, 1, 0]);
  });
  test('parallel merges all that did not fail and counts', () => {
    const said = [{ ...hold, vote: 5, heading: 1 }, { vote: 0, heading: 2, speed: 200 }, fail];
    assert_nothing(decide('parallel', said));
    const out = decide('parallel', said, { success_count: 1 });
    assert.deepEqual([out.status, out.vote, value(out, 'heading'), value(out, 'speed'), out.leader], ['success', 5, 1, 200, 0]);
    assert.equal(decide('parallel', said, { failure_count: 2 }).status, 'running');
    assert.equal(decide('parallel', [hold, { ...hold, heading: 2 }, { ...hold, heading: 3 }]).leader, 1);
  });
  test('guard and while look at their condition', () => {
    assert.equal(value(decide('guard', [hold, { heading: 1 }]), 'heading'), 1);
    assert_nothing(decide('guard', [fail, null]));
    assert.equal(value(decide('while', [fail, null, { heading: 2 }]), 'heading'), 2);
  });
  test('decorators turn statuses and drop what failed', () => {
    assert_nothing(decide('inverter', [{ ...hold, vote: 5, heading: 1 }]));
    assert.equal(decide('inverter', [{ vote: 5, heading: 1 }]).vote, 5);
    assert.deepEqual([decide('inverter', [fail]).status, decide('force_success', [fail]).status], ['success', 'success']);
    assert_nothing(decide('force_failure', [{ ...hold, vote: 5, heading: 1 }]));
  });
  test('a vote makes no proposal of nothing', () => {
    const out = decide('selector', [hold], { vote: 20 });
    assert.deepEqual([out.status, out.vote, out.leader], ['success', 0, -1]);
  });
});
