// SPDX-License-Identifier: MIT
/// \file  Every control node over every combination of child statuses, up to three children and
/// three ticks in a row, against an interpreter that works in another way.
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
  std::vector<bool> asked, halted;
};

/// Keeps for each child whether it is going on; from that alone follows everything.
class Reference {
 public:
  Reference(std::string type, std::size_t width, std::size_t successes = 0,
            std::size_t failures = 0)
      : type_(std::move(type)), successes_(successes), failures_(failures), going_(width) {}

  Expected tick(const std::vector<Status>& says) {
    Expected now{.asked = std::vector<bool>(going_.size()),
                 .halted = std::vector<bool>(going_.size())};
    now.status = type_ == "parallel" ? parallel(says, now) : line(says, now);
    for (std::size_t i = 0; i < going_.size(); ++i) {
      const bool runs = now.asked[i] && says[i] == kRunning;
      const bool ended = now.status != kRunning;
      now.halted[i] = (going_[i] && !now.asked[i]) || (runs && ended);
      going_[i] = runs && !ended;
    }
    return now;
  }

 private:
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
    const auto count = [&](Status status) {
      return static_cast<std::size_t>(std::count(says.begin(), says.end(), status));
    };
    if (count(kSuccess) >= successes_)
      return kSuccess;
    return count(kFailure) >= failures_ ? kFailure : kRunning;
  }

  std::string type_;
  std::size_t successes_, failures_;
  std::vector<bool> going_;
};

/// The child whose proposal must go up; every probe proposes its number as altitude, the later the
/// higher its vote. Kept simple: of those asked that did not fail, the last.
std::optional<double> expected_altitude(const Expected& now, const std::vector<Status>& says) {
  std::optional<double> altitude;
  if (now.status == kFailure)
    return altitude;
  for (std::size_t i = 0; i < says.size(); ++i)
    if (now.asked[i] && says[i] != kFailure)
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
