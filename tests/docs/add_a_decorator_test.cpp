// SPDX-License-Identifier: MIT
/// \file  The code of docs/howto/add-a-decorator.md, word for word (pages_test.cpp compares), so
/// that the page is compiled and run.
#include <gtest/gtest.h>

#include "core/yaml.hpp"
#include "pilot/catalog.hpp"
#include "support/pilot/testing.hpp"
#include "ubf/composite.hpp"

namespace eyrie::pilot {
namespace {

class Gently final : public ubf::Decorator<State, Action> {
 public:
  static constexpr std::string_view type_name = "gently";
  static constexpr std::string_view help = "turns no harder than so";
  static constexpr auto params() {
    return std::tuple{
        param("most", &Gently::most_, range(1, 12), "g, the most that its child turns with")};
  }

  Status tick(const Tick& t, Proposal& out) const override {
    const Status answer = ask_child(t, out);
    if (answer != Status::failure && out.action.load_factor)
      out.action.load_factor = std::min(*out.action.load_factor, most_);
    return answer;
  }

 private:
  double most_ = 4;
};

struct StubbornMemory {
  double end = 0;  ///< s, when it gives in; 0: the child has said nothing yet
  ubf::HeldProposal<Action> said;
};

class Stubborn final : public ubf::WithMemory<ubf::Decorator<State, Action>, StubbornMemory> {
 public:
  static constexpr std::string_view type_name = "stubborn";
  static constexpr std::string_view help = "repeats what its child said last";
  static constexpr auto params() {
    return std::tuple{param("patience", &Stubborn::patience_, "s", positive(), "for so long")};
  }

  Status tick(const Tick& t, Proposal& out) const override {
    auto& m = memory(t);
    const Status answer = ask_child(t, out);
    if (answer != Status::failure) {
      m.end = t.time + patience_;
      m.said.keep(out);
      return answer;
    }
    if (m.end == 0 || ubf::passed(t.time, m.end, 0)) {
      m = {};
      return fails(t, "its child has been silent for too long");
    }
    out.clear();
    m.said.get(out);
    return Status::running;
  }

 private:
  double patience_ = 5;
};

/// Sits in the cockpit of `desk` with a tree of a file.
class Flown {
 public:
  explicit Flown(const char* text) {
    Registry registry = make_registry();
    registry.add<Gently>();
    registry.add<Stubborn>();
    Diagnostics diagnostics;
    tree_ = registry.build_tree("test", parse_yaml(text, "test.yaml", diagnostics), diagnostics);
    EYRIE_DEMAND(tree_.has_value(), "the page's tree has a mistake");
    slab_.resize(tree_->memory_bytes());
  }
  testing::Desk desk;
  Proposal out;
  Status tick(ubf::Trace<Action>* trace = nullptr) {
    out.clear();
    const State state = desk.state();
    return tree_->tick({.state = state, .time = desk.time, .memory = slab_.data(), .trace = trace},
                       out);
  }

 private:
  std::optional<Tree> tree_;
  std::vector<std::byte> slab_;
};

TEST(AddADecorator, ChangesWhatItsChildProposes) {
  Flown gentle("{gently: {most: 2, child: navigate}}"), plain("navigate");
  ASSERT_EQ(plain.tick(), Status::running);
  ASSERT_EQ(gentle.tick(), Status::running);
  EXPECT_EQ(gentle.out.vote, plain.out.vote);
  EXPECT_GT(plain.out.action.load_factor, 2);
  EXPECT_EQ(gentle.out.action.load_factor, 2);
}

TEST(AddADecorator, RepeatsWhatItsChildSaidUntilItsPatienceEnds) {
  Flown flown(
      "{stubborn: {patience: 5 s, child: {guard: {when: altitude < 3000 m, child: navigate}}}}");
  flown.desk.own.altitude = 4000;
  EXPECT_EQ(flown.tick(), Status::failure) << "nothing was said yet";
  flown.desk.own.altitude = 2000;
  flown.desk.time = 10;
  EXPECT_EQ(flown.tick(), Status::running);
  const auto said = flown.out.action.altitude;
  flown.desk.own.altitude = 4000;
  flown.desk.time = 14;
  EXPECT_EQ(flown.tick(), Status::running);
  EXPECT_EQ(flown.out.action.altitude, said);
  flown.desk.time = 15;
  EXPECT_EQ(flown.tick(), Status::failure);
  flown.desk.time = 16;
  EXPECT_EQ(flown.tick(), Status::failure) << "it has forgotten";
}

}  // namespace
}  // namespace eyrie::pilot
