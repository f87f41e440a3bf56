// SPDX-License-Identifier: MIT
/// \file  Every control node and every decorator without a clock or a draw, over every combination
/// of child statuses, up to three children and three ticks in a row, against an interpreter that
/// works in another way.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "ubf/testing.hpp"

namespace eyrie::ubf::testing {
namespace {

constexpr std::array kAll{kFailure, kRunning, kSuccess};

struct Expected {
  Status status = kFailure;
  std::vector<bool> asked, halted, mute;  ///< mute: what it proposes is ignored
};

/// Keeps for each child whether it is going on and how often it ended; from that alone follows
/// everything. `a` and `b` are the node's numbers.
class Reference {
 public:
  Reference(std::string type, std::size_t width, std::size_t a = 0, std::size_t b = 0)
      : type_(std::move(type)), a_(a), b_(b), going_(width), ended_(width, kRunning) {}

  Expected tick(const std::vector<Status>& says) {
    const std::vector<bool> none(going_.size());
    Expected now{.asked = none, .halted = none, .mute = none};
    now.status = decide(says, now);
    for (std::size_t i = 0; i < going_.size(); ++i) {
      const bool runs = now.asked[i] && says[i] == kRunning;
      const bool ended = now.status != kRunning;
      now.halted[i] = now.halted[i] || (going_[i] && !now.asked[i]) || (runs && ended);
      going_[i] = runs && !now.halted[i];
    }
    return now;
  }

 private:
  Status decide(const std::vector<Status>& says, Expected& now) {
    if (type_ == "parallel")
      return parallel(says, now);
    if (type_ == "parallel_all")
      return parallel_all(says, now);
    if (type_ == "if_then_else" || type_ == "while" || type_ == "guard")
      return branch(says, now);
    const bool in_line = type_.starts_with("selector") || type_.starts_with("sequence");
    return in_line ? line(says, now) : decorator(says[0], now);
  }
  Status line(const std::vector<Status>& says, Expected& now) {
    const Status go_on = type_.starts_with("selector") ? kFailure : kSuccess;
    const auto open = std::find(going_.begin(), going_.end(), true);
    const bool resumes = type_.ends_with("with_memory") && open != going_.end();
    for (auto i = resumes ? static_cast<std::size_t>(open - going_.begin()) : 0; i < says.size();
         ++i) {
      now.asked[i] = true;
      if (says[i] != go_on)
        return says[i];
    }
    return go_on;
  }
  Status parallel(const std::vector<Status>& says, Expected& now) {
    now.asked.assign(says.size(), true);
    if (count(says, kSuccess) >= a_)
      return kSuccess;
    return count(says, kFailure) >= b_ ? kFailure : kRunning;
  }
  Status parallel_all(const std::vector<Status>& says, Expected& now) {
    for (std::size_t i = 0; i < says.size(); ++i)
      if (ended_[i] == kRunning) {
        now.asked[i] = true;
        ended_[i] = says[i];
      }
    const auto ended = ended_;
    if (count(ended, kRunning))
      return kRunning;
    ended_.assign(says.size(), kRunning);
    return count(ended, kFailure) >= a_ ? kFailure : kSuccess;
  }
  Status branch(const std::vector<Status>& says, Expected& now) {
    const bool once = type_ == "if_then_else";
    std::size_t chosen = once && going_[1] ? 1 : once && going_[2] ? 2 : 0;
    if (chosen == 0) {
      now.asked[0] = now.mute[0] = true;
      if (once && says[0] == kRunning)
        return kRunning;
      now.halted[0] = says[0] == kRunning;
      chosen = says[0] == kSuccess ? 1 : 2;
    }
    if (chosen == says.size())
      return kFailure;
    now.asked[chosen] = true;
    return says[chosen];
  }
  Status decorator(Status says, Expected& now) {
    now.asked[0] = type_ != "run_once" || ended_[0] == kRunning;
    if (!now.asked[0])
      return ended_[0];
    if (type_ == "run_once")
      ended_[0] = says;
    const Status again = type_ == "repeat" ? kSuccess : kFailure;
    if (says == kRunning || type_ == "run_once")
      return says;
    if (type_ == "inverter")
      return says == kSuccess ? kFailure : kSuccess;
    if (type_ == "force_success" || type_ == "force_failure")
      return type_ == "force_success" ? kSuccess : kFailure;
    rounds_ = says == again ? (rounds_ + 1) % a_ : 0;
    return says == again && rounds_ ? kRunning : says;
  }
  static std::size_t count(const std::vector<Status>& all, Status status) {
    return static_cast<std::size_t>(std::count(all.begin(), all.end(), status));
  }

  std::string type_;
  std::size_t a_, b_, rounds_ = 0;
  std::vector<bool> going_;
  std::vector<Status> ended_;  ///< how each child ended; running if it did not
};

/// The child whose proposal must go up; every probe proposes its number as altitude, the later the
/// higher its vote. Kept simple: of those asked that did not fail, the last.
std::optional<double> expected_altitude(const Expected& now, const std::vector<Status>& says) {
  std::optional<double> altitude;
  if (now.status == kFailure)
    return altitude;
  for (std::size_t i = 0; i < says.size(); ++i)
    if (now.asked[i] && !now.mute[i] && says[i] != kFailure)
      altitude = static_cast<double>(i);
  return altitude;
}

/// Every way in which `width` children can answer in `ticks` ticks.
std::vector<std::vector<std::vector<Status>>> all_answers(std::size_t width, std::size_t ticks) {
  std::vector<std::vector<std::vector<Status>>> result{{}};
  for (std::size_t t = 0; t < ticks; ++t) {
    std::vector<std::vector<Status>> rows{{}};
    for (std::size_t i = 0; i < width; ++i) {
      std::vector<std::vector<Status>> longer;
      for (const auto& row : rows)
        for (const Status status : kAll) {
          longer.push_back(row);
          longer.back().push_back(status);
        }
      rows = std::move(longer);
    }
    std::vector<std::vector<std::vector<Status>>> longer;
    for (const auto& sequence : result)
      for (const auto& row : rows) {
        longer.push_back(sequence);
        longer.back().push_back(row);
      }
    result = std::move(longer);
  }
  return result;
}

void compare(Child node, const Reference& fresh, std::size_t width) {
  Robot robot(std::move(node));
  for (std::size_t i = 0; i < width; ++i)
    robot.cue(i).action.altitude = static_cast<double>(i);
  for (const auto& sequence : all_answers(width, 3)) {
    Reference reference = fresh;
    std::vector<std::uint32_t> remembered(width);
    std::fill(robot.slab.begin(), robot.slab.end(), std::byte{0});
    for (const auto& says : sequence) {
      for (std::size_t i = 0; i < width; ++i)
        robot.say(i, says[i], static_cast<float>(i + 1));
      robot.tick();
      const Expected now = reference.tick(says);
      ASSERT_EQ(robot.status, now.status);
      ASSERT_EQ(robot.out.action.altitude, expected_altitude(now, says));
      for (std::size_t i = 0; i < width; ++i) {
        const auto index = static_cast<NodeIndex>(i + 1);
        ASSERT_EQ(robot.trace.row(index).ticked, now.asked[i]);
        ASSERT_EQ(robot.trace.row(index).halts, now.halted[i] ? 1 : 0);
        remembered[i] = now.halted[i] ? 0 : remembered[i] + now.asked[i];
        const auto& probe = static_cast<const Probe&>(robot.tree.node(index));
        ASSERT_EQ(probe.asked(robot.slab.data()), remembered[i]);
      }
    }
  }
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
