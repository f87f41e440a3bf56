// SPDX-License-Identifier: MIT
#pragma once
/// \file  Random trees of every kind of node, for laws that hold for all trees.
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/draw.hpp"
#include "support/ubf/testing.hpp"

namespace eyrie::ubf::testing {

/// Grows a tree: up to five levels, up to State::kCues leaves, each with a cue of its own. The same
/// seed grows the same tree.
class Gardener {
 public:
  /// `blends`: also nodes that make values of their own (fusion, paper_fusion, motor_schema).
  explicit Gardener(std::uint64_t seed, bool blends = true)
      : draw_(seed, PlayerId{1}, Stream::test, 0), blends_(blends) {}

  [[nodiscard]] Child tree() { return composite(0); }

 private:
  static constexpr std::size_t kDepth = 5;

  [[nodiscard]] std::uint32_t pick(std::uint32_t count) {
    return static_cast<std::uint32_t>(draw_.uniform() * count);
  }
  [[nodiscard]] std::uint32_t next_cue() { return cue_++ % State::kCues; }
  [[nodiscard]] Child node(std::size_t depth) {
    if (depth >= kDepth || cue_ > State::kCues - 6 || pick(3) == 0)
      return pick(8) == 0   ? holds()
             : pick(8) == 0 ? constant()
             : pick(4) == 0 ? check(next_cue())
                            : probe(next_cue());
    return composite(depth);
  }
  [[nodiscard]] Children nodes(std::size_t count, std::size_t depth) {
    Children children;
    for (std::size_t i = 0; i < count; ++i)
      children.push_back(node(depth + 1));
    return children;
  }
  template <class Node>
  [[nodiscard]] Child several(std::size_t depth) {
    auto made = make<Node>(nodes(1 + pick(3), depth));
    if (pick(4) == 0)
      made->vote_scale = 0.5F * static_cast<float>(pick(4));
    else if (pick(6) == 0)
      made->vote = static_cast<float>(pick(5));
    return made;
  }
  [[nodiscard]] Child composite(std::size_t depth) {
    using S = State;
    using A = Action;
    if (pick(2))
      return newer_composite(depth);
    switch (pick(blends_ ? 17 : 15)) {
      case 0:
      case 1:
        return several<WinnerTakesAll<S, A>>(depth);
      case 2:
        return several<PerField<S, A>>(depth);
      case 3:
        return several<Selector<S, A>>(depth);
      case 4:
        return several<Sequence<S, A>>(depth);
      case 5:
        return several<SelectorWithMemory<S, A>>(depth);
      case 6:
        return several<SequenceWithMemory<S, A>>(depth);
      case 7:
        return parallel(depth);
      case 8:
        return make<Inverter<S, A>>(node(depth + 1));
      case 9:
        return forced<ForceSuccess<S, A>>(depth);
      case 10:
        return forced<ForceFailure<S, A>>(depth);
      case 11:
        return timeout(depth);
      case 12:
        return cooldown(depth);
      case 13:
        return make<Guard<S, A>>(node(depth + 1), node(depth + 1));
      case 14:
        return pick(2) ? sequencer(depth) : commitment(depth);
      case 15:
        return fusion(depth);
      default:
        return several<PaperFusion<S, A>>(depth);
    }
  }
  [[nodiscard]] Child newer_composite(std::size_t depth) {
    using S = State;
    using A = Action;
    switch (pick(blends_ ? 18 : 15)) {
      case 0:
        return priority(depth);
      case 1:
        return layers<Suppress<S, A>>(depth, blends_ ? 0.1 * pick(4) : 0);
      case 2:
        return layers<Inhibit<S, A>>(depth, 0.1 * pick(4));
      case 3:
        return weighted_random(depth);
      case 4:
        return verify(depth);
      case 5:
        return parallel_all(depth);
      case 6:
        return several<RandomSelector<S, A>>(depth);
      case 7:
        return branches<IfThenElse<S, A>>(depth);
      case 8:
        return branches<While<S, A>>(depth);
      case 9:
        return counted(make<Repeat<S, A>>(node(depth + 1)), &Repeat<S, A>::count);
      case 10:
        return counted(make<Retry<S, A>>(node(depth + 1)), &Retry<S, A>::attempts);
      case 11:
        return run_once(depth);
      case 12:
        return timed(make<RateLimit<S, A>>(node(depth + 1)), &RateLimit<S, A>::period);
      case 13:
        return timed(make<Delay<S, A>>(node(depth + 1)), &Delay<S, A>::duration);
      case 14:
        return by_phase(depth);
      case 15:
        return over_grid<VoteGrid<S, A>>(depth);
      case 16:
        return over_grid<Utility<S, A>>(depth);
      default:
        return motor_schema(depth);
    }
  }
  template <class Node>
  [[nodiscard]] Child forced(std::size_t depth) {
    auto made = make<Node>(node(depth + 1));
    made->running = pick(2);
    return made;
  }
  template <class Node>
  [[nodiscard]] Child timed(std::unique_ptr<Node> made, double Node::*seconds) {
    made.get()->*seconds = 0.1 * (1 + pick(4));
    return made;
  }
  template <class Node>
  [[nodiscard]] Child counted(std::unique_ptr<Node> made,
                              std::optional<std::uint32_t> Node::*count) {
    if (pick(4))
      made.get()->*count = 1 + pick(3);
    return made;
  }
  template <class Node>
  [[nodiscard]] Child layers(std::size_t depth, double hold) {
    auto made = make<Node>(nodes(2, depth));
    made->hold = hold;
    return made;
  }
  template <class Node>
  [[nodiscard]] Child branches(std::size_t depth) {
    return make<Node>(nodes(3, depth));
  }
  [[nodiscard]] Child constant() {
    switch (pick(3)) {
      case 0:
        return make<AlwaysSuccess<State, Action>>();
      case 1:
        return make<AlwaysFailure<State, Action>>();
      default:
        auto made = make<Wait<State, Action>>();
        made->duration = 0.1 * (1 + pick(4));
        return made;
    }
  }
  [[nodiscard]] Child holds() {
    const Value text =
        Value::scalar(pick(2) ? "phase == home or alarm" : "not alarm and count < 2");
    const std::vector<StateFieldInfo> infos = state_field_infos<State>();
    FieldNames names;
    Diagnostics diagnostics;
    auto made = make<Holds<State, Action>>();
    made->look_at(Expression<State>(*parse_expression(text, infos, names, diagnostics)));
    if (pick(2))
      return made;
    auto loop = make<ForEach<State, Action>>(std::move(made));
    loop->choose = pick(2) ? Choose::first : Choose::strongest;
    loop->go_over(StateLists<State>::all().front());
    return loop;
  }
  template <class Arbiter>
  [[nodiscard]] Child over_grid(std::size_t depth) {
    auto made = make<Arbiter>(nodes(1 + pick(3), depth));
    const bool spread = std::is_same_v<Arbiter, Utility<State, Action>> && pick(2);
    made->grid.add("heading", 0, kTau, 8, 1, spread ? 0.5 : 0);
    if (pick(2))
      made->grid.add("speed", 0, 300, 3, 100, 0);
    return made;
  }
  [[nodiscard]] Child by_phase(std::size_t depth) {
    const std::uint32_t width = 1 + pick(3);
    auto made = make<Switch<State, Action>>(nodes(width, depth));
    std::vector<double> values{0, 1, 2};
    values.resize(width - (width > 1 && pick(2) ? 1 : 0));
    made->look_at([](const State& s) { return static_cast<double>(s.phase); }, std::move(values));
    return made;
  }
  [[nodiscard]] Child run_once(std::size_t depth) {
    auto made = make<RunOnce<State, Action>>(node(depth + 1));
    made->then = static_cast<Afterwards>(pick(3));
    return made;
  }
  [[nodiscard]] Child priority(std::size_t depth) {
    const std::uint32_t width = 1 + pick(3);
    auto made = make<Priority<State, Action>>(nodes(width, depth));
    for (std::uint32_t i = 0; i < width; ++i)
      made->interruptible.push_back(pick(2) == 0);
    return made;
  }
  [[nodiscard]] Child weighted_random(std::size_t depth) {
    auto made = make<WeightedRandom<State, Action>>(nodes(1 + pick(3), depth));
    made->keep = 0.1 * pick(4);
    return made;
  }
  [[nodiscard]] Child verify(std::size_t depth) {
    const std::uint32_t width = 1 + pick(3);
    auto made = make<Verify<State, Action>>(nodes(width, depth));
    made->fallback = width > 1 && pick(2);
    made->bounds.set("altitude", 3000, 7000);
    return made;
  }
  [[nodiscard]] Child parallel_all(std::size_t depth) {
    const std::uint32_t width = 1 + pick(3);
    auto made = make<ParallelAll<State, Action>>(nodes(width, depth));
    made->failure_count = 1 + pick(width);
    return made;
  }
  [[nodiscard]] Child motor_schema(std::size_t depth) {
    auto made = make<MotorSchema<State, Action>>(nodes(1 + pick(3), depth));
    made->direction.choose("heading");
    made->magnitude.choose("speed");
    made->unit_vote = 1 + pick(4);
    return made;
  }
  [[nodiscard]] Child fusion(std::size_t depth) {
    auto made = make<Fusion<State, Action>>(nodes(1 + pick(3), depth));
    if (pick(2))
      made->top = 1 + pick(3);
    made->conflicts = pick(2) ? Conflicts::drop : Conflicts::blend;
    return made;
  }
  [[nodiscard]] Child parallel(std::size_t depth) {
    const std::uint32_t width = 1 + pick(3);
    auto made = make<Parallel<State, Action>>(nodes(width, depth));
    made->success_count = 1 + pick(width);
    made->failure_count = 1 + pick(width);
    made->once = pick(2);
    return made;
  }
  [[nodiscard]] Child timeout(std::size_t depth) {
    auto made = make<Timeout<State, Action>>(node(depth + 1));
    made->after = 0.1 * (1 + pick(4));
    return made;
  }
  [[nodiscard]] Child cooldown(std::size_t depth) {
    auto made = make<Cooldown<State, Action>>(node(depth + 1));
    made->duration = 0.1 * (1 + pick(4));
    return made;
  }
  [[nodiscard]] Child commitment(std::size_t depth) {
    auto made = make<Commitment<State, Action>>(nodes(1 + pick(3), depth));
    made->margin = static_cast<float>(pick(3));
    made->min_time = 0.1 * pick(3);
    made->hold = blends_ ? 0.1 * (1 + pick(3)) : 0;
    if (!blends_)
      made->margin += 1;
    return made;
  }
  [[nodiscard]] Child sequencer(std::size_t depth) {
    const std::uint32_t count = 2 + pick(2);
    Children trees = nodes(count, depth), conditions;
    std::vector<Sequencer<State, Action>::Rule> rules;
    for (std::uint32_t i = 0; i < count; ++i) {
      const auto from = static_cast<std::uint16_t>(i);  // so that every tree can be entered
      rules.push_back({pick(3) ? from : kNone, static_cast<std::uint16_t>((i + 1) % count)});
      conditions.push_back(node(kDepth));
    }
    return make<Sequencer<State, Action>>(std::move(trees), std::move(rules),
                                          std::move(conditions));
  }

  Draw draw_;
  bool blends_;
  std::uint32_t cue_ = 0;
};

/// Cues that change from tick to tick; leaves answer running more often than not.
class Weather {
 public:
  explicit Weather(std::uint64_t seed) : draw_(seed, PlayerId{2}, Stream::test, 0) {}

  void blow(State& state) {
    for (Cue& cue : state.cues) {
      cue.status = static_cast<Status>(std::min(pick(4), 2u));
      if (cue.status == kSuccess && pick(2))
        cue.status = kRunning;
      cue.vote = static_cast<float>(pick(6));
      cue.action.heading = maybe(draw_.uniform(0, 6));
      cue.action.altitude = maybe(draw_.uniform(0, 9000));
      cue.action.speed = maybe(static_cast<float>(pick(300)));
      cue.action.release = maybe(pick(4));
      cue.action.mode = maybe(static_cast<std::uint8_t>(pick(2)));
    }
    state.phase = static_cast<std::uint8_t>(pick(3));
    state.count = pick(4);
    state.thing_count = pick(4);
    state.alarm = pick(2);
  }

 private:
  [[nodiscard]] std::uint32_t pick(std::uint32_t count) {
    return static_cast<std::uint32_t>(draw_.uniform() * count);
  }
  template <class T>
  [[nodiscard]] std::optional<T> maybe(T value) {
    return pick(2) ? std::optional<T>(value) : std::nullopt;
  }
  Draw draw_;
};

}  // namespace eyrie::ubf::testing
