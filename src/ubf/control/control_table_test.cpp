// SPDX-License-Identifier: MIT
/// \file  Every control node and every decorator without a clock or a draw, over every combination
/// of child statuses, up to three children and three ticks in a row, against an interpreter that
/// works in another way.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "support/ubf/testing.hpp"

namespace eyrie::ubf::testing {
namespace {

using Statuses = std::vector<Status>;
constexpr std::size_t kNobody = 9;
/// Of the children: of two the earlier, the later or neither votes higher.
constexpr std::array kVotes{2.F, 1.F, 2.F};

struct Expected {
  Status status = kFailure;
  std::size_t leader = kNobody;  ///< whose proposal goes up
  std::vector<bool> asked, halted;
};

/// Keeps for each child whether it is going on and how it ended; from that alone follows
/// everything. `a` and `b` are the node's numbers.
class Reference {
 public:
  Reference(std::string type, std::size_t width, std::size_t a = 0, std::size_t b = 0)
      : type_(std::move(type)), a_(a), b_(b), going_(width), ended_(width, kRunning) {}

  /// `value` is what a switch looks at.
  const Expected& tick(const Statuses& says, std::size_t value) {
    says_ = says;
    now_.leader = kNobody;
    now_.asked.assign(says.size(), false);
    now_.halted.assign(says.size(), false);
    now_.status = decide(value);
    for (std::size_t i = 0; i < says.size(); ++i) {
      const bool runs = now_.asked[i] && says[i] == kRunning;
      const bool ended = now_.status != kRunning;
      now_.halted[i] = now_.halted[i] || (going_[i] && !now_.asked[i]) || (runs && ended);
      going_[i] = runs && !now_.halted[i];
    }
    if (now_.status == kFailure)
      now_.leader = kNobody;
    return now_;
  }

 private:
  Status decide(std::size_t value) {
    if (type_ == "switch")  // over `a` cases, behind them the default
      return ask(std::min(value, a_));
    if (type_ == "if_then_else" || type_ == "while" || type_ == "guard")
      return branch();
    if (type_.starts_with("parallel") || type_ == "for_each_strongest")
      return everyone();
    const bool in_line = type_.starts_with("se") || type_ == "for_each_first";
    return in_line ? line() : decorator();
  }
  /// The last that proposes something leads a sequence; else the strongest, of equals the earlier.
  Status ask(std::size_t i) {
    if (i == says_.size())
      return kFailure;
    now_.asked[i] = true;
    const bool first = type_.starts_with("sequence") || now_.leader == kNobody;
    if (says_[i] != kFailure && (first || kVotes[i] > kVotes[now_.leader]))
      now_.leader = i;
    return says_[i];
  }
  Status line() {
    const Status go_on = type_.starts_with("sequence") ? kSuccess : kFailure;
    const auto open = std::find(going_.begin(), going_.end(), true);
    const bool resumes = type_.ends_with("with_memory") && open != going_.end();
    auto i = static_cast<std::size_t>(resumes ? open - going_.begin() : 0);
    Status status = ask(i);
    while (status == go_on && ++i < says_.size())
      status = ask(i);
    return status;
  }
  Status everyone() {
    if (type_ != "parallel_all" || !count(kRunning))  // else those that ended are asked no more
      ended_.assign(says_.size(), kRunning);
    for (std::size_t i = 0; i < says_.size(); ++i)
      if (ended_[i] == kRunning)
        ended_[i] = ask(i);
    if (type_ == "for_each_strongest")
      return now_.leader == kNobody ? kFailure : says_[now_.leader];
    if (type_ == "parallel")
      return count(kSuccess) >= a_                                          ? kSuccess
             : count(kFailure) >= b_ || count(kFailure) > says_.size() - a_ ? kFailure
                                                                            : kRunning;
    return count(kRunning) ? kRunning : count(kFailure) >= a_ ? kFailure : kSuccess;
  }
  Status branch() {
    const bool once = type_ == "if_then_else";
    if (once && (going_[1] || going_[2]))
      return ask(going_[1] ? 1 : 2);
    now_.asked[0] = true;  // what it proposes is ignored
    if (once && says_[0] == kRunning)
      return kRunning;
    now_.halted[0] = says_[0] == kRunning;
    return ask(says_[0] == kSuccess ? 1 : 2);
  }
  Status decorator() {
    if (type_ == "run_once")
      return ended_[0] == kRunning ? ended_[0] = ask(0) : ended_[0];
    const Status says = ask(0);
    if (says == kRunning)
      return says;
    if (type_ == "inverter")
      return says == kSuccess ? kFailure : kSuccess;
    if (type_ == "force_success" || type_ == "force_failure")
      return type_ == "force_success" ? kSuccess : kFailure;
    const Status again = type_ == "repeat" ? kSuccess : kFailure;
    rounds_ = says == again ? (rounds_ + 1) % a_ : 0;
    return says == again && rounds_ ? kRunning : says;
  }
  std::size_t count(Status status) const {
    return static_cast<std::size_t>(std::count(ended_.begin(), ended_.end(), status));
  }

  std::string type_;
  std::size_t a_, b_, rounds_ = 0;
  std::vector<bool> going_;
  Statuses ended_, says_;  ///< how each child ended, running if it did not; what each says now
  Expected now_;
};

#ifdef EYRIE_SANITIZED
constexpr std::size_t kStride = 23;  // twenty times as slow there, and the lines are the same
#else
constexpr std::size_t kStride = 1;
#endif

/// Calls `look` after every tick of every history of three ticks, with the slab as it was before.
/// In each tick every child says something, and the state has one of `values` values.
template <class Look>
void compare(Child node, const Reference& fresh, std::size_t width, std::size_t values, Look look) {
  Robot robot(std::move(node));
  robot.state.thing_count = width;
  std::size_t ticks = values;
  for (std::size_t i = 0; i < width; ++i) {
    robot.cue(i).action.altitude = static_cast<double>(i);
    ticks *= 3;
  }
  Statuses says(width);
  for (std::size_t history = 0; history < ticks * ticks * ticks; history += kStride) {
    std::size_t rest = history;
    const auto pick = [&](std::size_t count) {
      const std::size_t picked = rest % count;
      rest /= count;
      return picked;
    };
    Reference reference = fresh;
    std::fill(robot.slab.begin(), robot.slab.end(), std::byte{0});
    for (int tick = 0; tick < 3; ++tick) {
      for (std::size_t i = 0; i < width; ++i) {
        says[i] = static_cast<Status>(pick(3));
        robot.say(i, says[i], kVotes[i]);
      }
      const std::size_t value = pick(values);
      robot.state.phase = static_cast<std::uint8_t>(value);
      const std::vector<std::byte> before = robot.slab;
      robot.tick();
      const Expected& now = reference.tick(says, value);
      ASSERT_EQ(robot.status, now.status) << "history " << history;
      ASSERT_EQ(robot.out.action.altitude.value_or(kNobody), now.leader) << "history " << history;
      ASSERT_NO_FATAL_FAILURE(look(robot, before, now)) << "history " << history;
    }
  }
}
/// The same for a node whose children are probes, and what these remember.
void compare(Child node, const Reference& fresh, std::size_t width, std::size_t values = 1) {
  const auto look = [&](const Robot& robot, const auto& before, const Expected& now) {
    for (std::size_t i = 0; i < width; ++i) {
      const auto index = static_cast<NodeIndex>(i + 1);
      ASSERT_EQ(robot.trace.row(index).ticked, now.asked[i]);
      ASSERT_EQ(robot.trace.row(index).halts, now.halted[i] ? 1 : 0);
      const auto& probe = static_cast<const Probe&>(robot.tree.node(index));
      ASSERT_EQ(probe.asked(robot.slab.data()),
                now.halted[i] ? 0 : probe.asked(before.data()) + now.asked[i]);
    }
  };
  compare(std::move(node), fresh, width, values, look);
}

template <template <class, class> class Control>
void compare_all_widths(const std::string& type) {
  for (std::size_t width = 1; width <= 3; ++width)
    compare(make<Control<State, Action>>(probes(width)), Reference(type, width), width);
}

TEST(ControlTable, Selector) {
  compare_all_widths<Selector>("selector");
}
TEST(ControlTable, Sequence) {
  compare_all_widths<Sequence>("sequence");
}
TEST(ControlTable, SelectorWithMemory) {
  compare_all_widths<SelectorWithMemory>("selector_with_memory");
}
TEST(ControlTable, SequenceWithMemory) {
  compare_all_widths<SequenceWithMemory>("sequence_with_memory");
}

TEST(ControlTable, IfThenElseWhileAndGuard) {
  compare(make<IfThenElse<State, Action>>(probes(3)), Reference("if_then_else", 3), 3);
  compare(make<While<State, Action>>(probes(3)), Reference("while", 3), 3);
  compare(make<Guard<State, Action>>(probes(2)), Reference("guard", 2), 2);
}

TEST(ControlTable, ParallelAllWithEveryThreshold) {
  for (std::size_t width = 1; width <= 3; ++width)
    for (std::size_t failures = 1; failures <= width; ++failures) {
      auto all = make<ParallelAll<State, Action>>(probes(width));
      all->failure_count = static_cast<std::uint32_t>(failures);
      compare(std::move(all), Reference("parallel_all", width, failures), width);
    }
}

TEST(ControlTable, SwitchWithAndWithoutADefault) {
  for (std::size_t cases = 1; cases <= 2; ++cases)
    for (const std::size_t width : {cases, cases + 1}) {
      auto node = make<Switch<State, Action>>(probes(width));
      node->look_at([](const State& s) { return static_cast<double>(s.phase); },
                    cases == 1 ? std::vector<double>{0} : std::vector<double>{0, 1});
      compare(std::move(node), Reference("switch", width, cases), width, 3);
    }
}

/// Says of the thing that is looked at what the probe of its number would, and notes that it did.
class Teller final : public Node {
 public:
  static constexpr std::string_view type_name = "teller";
  explicit Teller(std::vector<bool>& asked) : asked_(asked) {}

  Status tick(const RobotTick& t, RobotProposal& out) const override {
    EYRIE_DEMAND(out.is_empty(), "what a behavior is given to write to is not empty");
    const auto number = static_cast<std::size_t>(t.state.range);
    asked_[number] = true;
    out.action = t.state.cues[number].action;
    out.vote = t.state.cues[number].vote;
    return t.state.cues[number].status;
  }

 private:
  std::vector<bool>& asked_;
};

TEST(ControlTable, ForEachOverNoneToThreeThings) {
  const StateList<State> numbers{"numbers", "of cues", [](const State& s) { return s.thing_count; },
                                 [](State& s, std::size_t i) { s.range = static_cast<double>(i); }};
  for (std::size_t width = 0; width <= 3; ++width)
    for (const Choose choose : {Choose::first, Choose::strongest}) {
      std::vector<bool> asked(width);
      auto node = make<ForEach<State, Action>>(make<Teller>(asked));
      node->choose = choose;
      node->go_over(numbers);
      const auto look = [&](const Robot&, const auto&, const Expected& now) {
        ASSERT_EQ(asked, now.asked);
        asked.assign(width, false);
      };
      const char* type = choose == Choose::first ? "for_each_first" : "for_each_strongest";
      compare(std::move(node), Reference(type, width), width, 1, look);
    }
}

TEST(ControlTable, Decorators) {
  compare(make<Inverter<State, Action>>(probe(0)), Reference("inverter", 1), 1);
  compare(make<ForceSuccess<State, Action>>(probe(0)), Reference("force_success", 1), 1);
  compare(make<ForceFailure<State, Action>>(probe(0)), Reference("force_failure", 1), 1);
  compare(make<RunOnce<State, Action>>(probe(0)), Reference("run_once", 1), 1);
  for (std::uint32_t rounds = 1; rounds <= 3; ++rounds) {
    auto repeat = make<Repeat<State, Action>>(probe(0));
    repeat->count = rounds;
    compare(std::move(repeat), Reference("repeat", 1, rounds), 1);
    auto retry = make<Retry<State, Action>>(probe(0));
    retry->attempts = rounds;
    compare(std::move(retry), Reference("retry", 1, rounds), 1);
  }
}

TEST(ControlTable, ParallelWithEveryPairOfThresholds) {
  for (std::size_t width = 1; width <= 3; ++width)
    for (std::size_t successes = 1; successes <= width; ++successes)
      for (std::size_t failures = 1; failures <= width; ++failures) {
        auto parallel = make<Parallel<State, Action>>(probes(width));
        parallel->success_count = static_cast<std::uint32_t>(successes);
        parallel->failure_count = static_cast<std::uint32_t>(failures);
        compare(std::move(parallel), Reference("parallel", width, successes, failures), width);
      }
}

}  // namespace
}  // namespace eyrie::ubf::testing
