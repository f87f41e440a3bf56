// SPDX-License-Identifier: MIT
/// \file  The code of docs/ubf.md, word for word (pages_test.cpp compares), so that the page is
/// compiled and run.
#include <gtest/gtest.h>

#include "support/ubf/testing.hpp"

namespace eyrie {
namespace {

using ubf::testing::Action;
using ubf::testing::State;

class Pursue final : public ubf::Behavior<State, Action> {
 public:
  static constexpr std::string_view type_name = "pursue";
  ubf::Status tick(const ubf::Tick<State>&, ubf::Proposal<Action>& out) const override {
    out.vote = 20;
    return ubf::Status::running;
  }
};
class Navigate final : public ubf::Behavior<State, Action> {
 public:
  static constexpr std::string_view type_name = "navigate";
  ubf::Status tick(const ubf::Tick<State>&, ubf::Proposal<Action>& out) const override {
    out.vote = 10;
    return ubf::Status::running;
  }
};

TEST(UbfInCode, BuildsAndTicksATree) {
  const State state;
  const double now = 0;
  using Wta = ubf::WinnerTakesAll<State, Action>;
  auto fight = ubf::make<Wta>(ubf::make<Pursue>(), ubf::make<Navigate>());
  fight->vote_scale = 2;  // a public member until the tree is made
  const ubf::Tree<State, Action> tree("fight", std::move(fight));

  std::vector<std::byte> slab(tree.memory_bytes());  // one per agent, zero, 8-byte aligned
  ubf::Proposal<Action> out;
  tree.tick({.state = state, .time = now, .dt = 0.1, .memory = slab.data()}, out);
  EXPECT_EQ(out.vote, 40);
  EXPECT_EQ(tree.path(out.leader), "root/pursue");
}

}  // namespace
}  // namespace eyrie
