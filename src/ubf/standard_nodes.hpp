// SPDX-License-Identifier: MIT
#pragma once
/// \file  Every arbiter, control node and decorator that comes with the library.
#include "ubf/arbiter/fusion.hpp"
#include "ubf/arbiter/grid.hpp"
#include "ubf/arbiter/layers.hpp"
#include "ubf/arbiter/verify.hpp"
#include "ubf/arbiter/weighted_random.hpp"
#include "ubf/arbiter/winner_takes_all.hpp"
#include "ubf/control/branch.hpp"
#include "ubf/control/parallel.hpp"
#include "ubf/control/random_selector.hpp"
#include "ubf/control/sequence.hpp"
#include "ubf/decorator/for_each.hpp"
#include "ubf/decorator/outcome.hpp"
#include "ubf/decorator/timing.hpp"
#include "ubf/leaf/holds.hpp"
#include "ubf/registry.hpp"
#include "ubf/sequencer.hpp"

namespace eyrie::ubf {

template <class State, class Action>
void add_standard_nodes(Registry<State, Action>& registry) {
  registry.template add<Holds<State, Action>>();

  registry.template add<WinnerTakesAll<State, Action>>();
  registry.template add<PerField<State, Action>>();
  registry.template add<Fusion<State, Action>>();
  registry.template add<PaperFusion<State, Action>>();
  registry.template add<Commitment<State, Action>>();
  registry.template add<Priority<State, Action>>();
  registry.template add<Suppress<State, Action>>();
  registry.template add<Inhibit<State, Action>>();
  registry.template add<WeightedRandom<State, Action>>();
  registry.template add<Verify<State, Action>>();
  registry.template add<MotorSchema<State, Action>>();
  registry.template add<VoteGrid<State, Action>>();
  registry.template add<Utility<State, Action>>();

  registry.template add<Selector<State, Action>>();
  registry.template add<Sequence<State, Action>>();
  registry.template add<SelectorWithMemory<State, Action>>();
  registry.template add<SequenceWithMemory<State, Action>>();
  registry.template add<Parallel<State, Action>>();
  registry.template add<ParallelAll<State, Action>>();
  registry.template add<RandomSelector<State, Action>>();
  registry.template add<IfThenElse<State, Action>>();
  registry.template add<While<State, Action>>();
  registry.template add<Switch<State, Action>>();
  registry.template add<Sequencer<State, Action>>();

  registry.template add<Inverter<State, Action>>();
  registry.template add<ForceSuccess<State, Action>>();
  registry.template add<ForceFailure<State, Action>>();
  registry.template add<Timeout<State, Action>>();
  registry.template add<Cooldown<State, Action>>();
  registry.template add<Guard<State, Action>>();
  registry.template add<Repeat<State, Action>>();
  registry.template add<Retry<State, Action>>();
  registry.template add<RunOnce<State, Action>>();
  registry.template add<RateLimit<State, Action>>();
  registry.template add<Delay<State, Action>>();
  registry.template add<ForEach<State, Action>>();
  registry.mark_standard();
}

}  // namespace eyrie::ubf
