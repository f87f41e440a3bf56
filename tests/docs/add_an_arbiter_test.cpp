// SPDX-License-Identifier: MIT
/// \file  The code of docs/howto/add-an-arbiter.md, word for word (pages_test.cpp compares), so
/// that the page is compiled and run.
#include <gtest/gtest.h>

#include "core/yaml.hpp"
#include "support/ubf/testing.hpp"

namespace eyrie::ubf {
namespace {

/// Asks every child and hands on the proposal with the second highest vote, or the only one.
template <class State, class Action>
class RunnerUp final : public Arbiter<State, Action> {
 public:
  static constexpr std::string_view type_name = "runner_up";
  static constexpr std::string_view help = "the proposal with the second highest vote";
  static constexpr std::string_view decided_by = "second place";

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    Status best_status = Status::failure, status = Status::failure;
    const AnyNode *first = nullptr, *second = nullptr;
    Proposal<Action> next, best;
    for (const auto& child : this->children_) {
      const Status answer = this->ask(*child, t, next);
      if (answer == Status::failure || next.vote == 0)
        continue;
      if (next.vote > best.vote) {
        out.copy(best);
        status = best_status;
        second = first;
        best.copy(next);
        best_status = answer;
        first = child.get();
      } else if (next.vote > out.vote) {
        out.copy(next);
        status = answer;
        second = child.get();
      }
    }
    if (status == Status::failure) {
      out.copy(best);
      status = best_status;
      second = first;
    }
    if (second)
      this->took(t, *second);
    this->rescale(out);
    return status;
  }
};

using testing::Action;
using testing::kFailure;
using testing::kRunning;
using testing::kSuccess;
using testing::State;

testing::RobotTree from_file(std::string_view text) {
  Registry<State, Action> registry;
  registry.add<testing::Probe>();
  registry.add<ubf::RunnerUp<State, Action>>();
  Diagnostics diagnostics;
  auto tree = registry.build_tree("test", parse_yaml(text, "test.yaml", diagnostics), diagnostics);
  EYRIE_DEMAND(tree.has_value(), "the page's tree has a mistake");
  return std::move(*tree);
}

TEST(RunnerUp, HandsOnTheSecondHighestVoteWhateverTheOrder) {
  testing::Robot robot(
      from_file("{runner_up: [{probe: {cue: 0}}, {probe: {cue: 1}},"
                " {probe: {cue: 2}}]}"));
  const std::array<std::array<float, 3>, 3> orders{{{1, 2, 3}, {3, 2, 1}, {2, 3, 1}}};
  for (const auto& votes : orders) {
    for (std::size_t i = 0; i < 3; ++i)
      robot.cue(i) = {kRunning, votes[i], {.altitude = votes[i]}};
    EXPECT_EQ(robot.tick(), kRunning);
    EXPECT_EQ(robot.out.action.altitude, 2);
    const std::size_t second = std::ranges::find(votes, 2.0F) - votes.begin();
    EXPECT_EQ(robot.supplier(1), fmt::format("root/probe[{}]", second));
  }
}

TEST(RunnerUp, HandsOnTheOnlyOneAndFailsWithoutAny) {
  testing::Robot robot(from_file("{runner_up: {vote_scale: 2, children: [{probe: {cue: 0}}]}}"));
  EXPECT_EQ(robot.tick(), kFailure);
  EXPECT_TRUE(robot.out.is_empty());
  robot.cue(0) = {kSuccess, 3, {.altitude = 1}};
  EXPECT_EQ(robot.tick(), kSuccess);
  EXPECT_EQ(robot.out.vote, 6);
  EXPECT_EQ(robot.supplier(1), "root/probe");
}

}  // namespace
}  // namespace eyrie::ubf
