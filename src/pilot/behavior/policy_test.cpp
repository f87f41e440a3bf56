// SPDX-License-Identifier: MIT
#include "pilot/behavior/policy.hpp"

#include <gtest/gtest.h>

#include "core/hash.hpp"
#include "core/yaml.hpp"
#include "pilot/catalog.hpp"
#include "support/no_allocation.hpp"
#include "support/pilot/networks.hpp"
#include "support/pilot/testing.hpp"
#include "team/explain.hpp"

namespace eyrie::pilot {
namespace {

using namespace pilot::testing;

/// One file, whatever it is called.
class OneFile final : public ubf::NodeFiles {
 public:
  explicit OneFile(std::string bytes) : bytes_(std::move(bytes)) {}
  std::optional<std::string> read(const Value&, Diagnostics&) override {
    ++read_;
    return bytes_;
  }
  std::string path_of(const Value& name) const override { return name.text; }
  [[nodiscard]] int count() const { return read_; }

 private:
  std::string bytes_;
  int read_ = 0;
};

std::optional<Tree> read(const std::string& text, const std::string& bytes,
                         Diagnostics& diagnostics) {
  OneFile file(bytes);
  return make_registry().build_tree("test", parse_yaml(text, "test.yaml", diagnostics), diagnostics,
                                    {}, {}, &file);
}
Tree tree(const std::string& text, const std::string& bytes) {
  Diagnostics diagnostics;
  auto tree = read(text, bytes, diagnostics);
  if (!tree)
    throw ConfigError(diagnostics);
  return std::move(*tree);
}
std::string mistakes(const std::string& text, const std::string& bytes) {
  Diagnostics diagnostics;
  EXPECT_FALSE(read(text, bytes, diagnostics));
  return diagnostics.text();
}

TEST(NodeFiles, ReadAndMakeOnceWhatSeveralNodesName) {
  OneFile files("bytes");
  Diagnostics diagnostics;
  const auto make = [](const std::string& bytes) {
    return std::make_shared<const std::string>(bytes);
  };
  const auto made = [&](const char* name) {
    return files.made_of<std::string>(Value::scalar(name), diagnostics, make);
  };
  const auto one = made("one");
  EXPECT_EQ(*one, "bytes");
  EXPECT_EQ(made("one"), one);
  EXPECT_EQ(files.count(), 1);
  EXPECT_NE(made("two"), one);
  const auto none = [](const std::string&) { return std::shared_ptr<const std::string>(); };
  EXPECT_FALSE(files.made_of<std::string>(Value::scalar("bad"), diagnostics, none));
  EXPECT_TRUE(made("bad")) << "a mistake is not kept";
}

/// A tree with its memory.
struct Mind {
  Tree tree;
  std::vector<std::uint64_t> slab = std::vector<std::uint64_t>(tree.memory_bytes() / 8);

  Proposal ask(const Desk& desk, Status wanted = kRunning) {
    const State state = desk.state();
    Proposal out;
    const NoAllocation guard;
    const Status status =
        tree.tick({.state = state, .memory = reinterpret_cast<std::byte*>(slab.data())}, out);
    EXPECT_EQ(status, wanted);
    return out;
  }
};

/// A policy whose numbers are always those.
std::string constant(const std::string& controls, const std::vector<float>& numbers) {
  return Safetensors()
      .word("eyrie_policy", "1")
      .word("observation", "mach linear 0 2")
      .word("controls", controls)
      .word("network", "linear a")
      .tensor("a.weight", {numbers.size(), 1}, std::vector<float>(numbers.size()))
      .tensor("a.bias", {numbers.size()}, numbers)
      .bytes();
}

TEST(Policy, FliesByWhatTheNetworkSays) {
  Mind mind{tree("policy: {file: a, vote: 60}",
                 constant("turn -90 deg 90 deg\naltitude 1 km 9 km\ntrigger", {0.5F, 0, 1}))};
  const Proposal p = mind.ask({});
  EXPECT_EQ(p.vote, 60);
  EXPECT_NEAR(*p.action.heading, kPi / 4, 1e-6);
  EXPECT_EQ(p.action.altitude, 5000);
  EXPECT_EQ(p.action.mode, model::AutopilotMode::hold);
  EXPECT_EQ(p.action.trigger, true);
  EXPECT_FALSE(p.action.speed || p.action.radar || p.action.call);
}

TEST(Policy, LeavesToOthersWhatItDoesNotCommand) {
  Mind mind{tree("per_field: [{policy: {file: a, vote: 60}}, {navigate: {vote: 10}}]",
                 constant("trigger\nrelease", {-1, -1}))};
  const Proposal p = mind.ask({});
  EXPECT_EQ(p.action.mode, model::AutopilotMode::route);
  EXPECT_FALSE(p.action.trigger || p.action.release);
}

TEST(Policy, RemembersUntilItLosesControl) {
  const std::string text =
      "selector: [{guard: {when: rounds > 0, child: {policy: {file: a}}}}, {navigate: {}}]";
  Mind mind{tree(text, small_policy_file())};
  Desk desk;
  const double first = *mind.ask(desk).action.heading;
  const double second = *mind.ask(desk).action.heading;
  EXPECT_NE(first, second) << "of a memory";
  desk.gun.rounds = 0;
  mind.ask(desk);
  desk.gun.rounds = 1;
  EXPECT_EQ(*mind.ask(desk).action.heading, first) << "it forgot";
}

TEST(Policy, SaysWhatIsWrongWithItsFile) {
  const std::string node = "policy: {file: a}", at = "test.yaml:1:16: a: ";
  EXPECT_EQ(mistakes(node, "none"), at + "no file of tensors (.safetensors), or one that is cut");
  EXPECT_EQ(mistakes(node, Safetensors().word("eyrie_policy", "2").bytes()),
            at + "it is a policy of version '2'; this program reads version 1\n" + at +
                "its metadata has no word 'observation'\n" + at +
                "its metadata has no word 'controls'\n" + at +
                "its metadata has no word 'network'");
  EXPECT_EQ(mistakes(node, constant("turn -1 rad 1 rad", {1, 2})),
            at + "outputs of the network: 2, controls: 1");
  EXPECT_EQ(mistakes(node, Safetensors()
                               .word("eyrie_policy", "1")
                               .word("observation", "mach linear 0 2\nmack linear 0 2")
                               .word("controls", "release")
                               .word("controls_hash", "0x0000000000000001")
                               .word("network", "linear a")
                               .bytes()),
            at + "observation:2:1: there is no state field 'mack'; did you mean 'mach'?\n" + at +
                "controls_hash is '0x0000000000000001', and the controls that stands there has " +
                hash_text(Controls("release").hash()));
  EXPECT_EQ(mistakes("policy: {}", ""), "test.yaml:1:9: policy needs the parameter 'file'");
  Diagnostics diagnostics;
  EXPECT_FALSE(
      make_registry().build_tree("test", parse_yaml(node, "test.yaml", diagnostics), diagnostics));
  EXPECT_EQ(diagnostics.text(),
            "test.yaml:1:16: there is no file 'a': nodes of this tree have no files");
}

std::string votes(const std::string& how, const std::vector<float>& numbers) {
  return Safetensors()
      .word("eyrie_policy", "1")
      .word("observation", "mach linear 0 2")
      .word("votes", how)
      .word("network", "linear a")
      .tensor("a.weight", {numbers.size(), 1}, std::vector<float>(numbers.size()))
      .tensor("a.bias", {numbers.size()}, numbers)
      .bytes();
}

TEST(LearnedVote, LetsTheChildWinThatTheNetworkPrefers) {
  const std::string text =
      "learned_vote: {file: a, children: [{navigate: {vote: 90}}, {egress: {vote: 1}}, "
      "{pursue: {vote: 99}}]}";
  Mind mind{tree(text, votes("softmax", {0, 1, 2}))};
  const Proposal p = mind.ask({});
  EXPECT_EQ(p.leader, 2) << "nobody is there to pursue";
  EXPECT_NEAR(p.vote, 100 * std::exp(1.0) / (1 + std::exp(1.0) + std::exp(2.0)), 1e-4);
  Mind sure{tree(text, votes("sigmoid", {1, -1, 2}))};
  EXPECT_EQ(sure.ask({}).leader, 1);
  EXPECT_NEAR(sure.ask({}).vote, 100 / (1 + std::exp(-1.0)), 1e-4);
  Mind even{tree(text, votes("linear", {-1.5F, 0.5F, 2}))};
  EXPECT_EQ(even.ask({}).leader, 2);
  EXPECT_EQ(even.ask({}).vote, 75);
}

TEST(LearnedVote, TellsWhoeverTracesWhatTheNetworkSaid) {
  const Tree flown =
      tree("learned_vote: {file: a, children: [{navigate: {vote: 90}}, {egress: {vote: 1}}]}",
           votes("linear", {0, 0.5F}));
  const Desk desk;
  const State state = desk.state();
  std::vector<std::uint64_t> slab(flown.memory_bytes() / 8);
  ubf::Trace<Action> trace(flown.size());
  Proposal out;
  flown.tick({.state = state, .memory = reinterpret_cast<std::byte*>(slab.data()), .trace = &trace},
             out);
  EXPECT_EQ(trace.given_vote(1), 50);
  EXPECT_EQ(trace.given_vote(2), 75);
  EXPECT_TRUE(std::isnan(trace.given_vote(0)));
  EXPECT_EQ(trace.row(1).proposal.vote, 90) << "its own";
  const auto nodes = team::answers(team::unanswered(flown), flown, trace);
  const team::Won speed = team::contest(nodes).at(0);
  EXPECT_EQ(speed.winner, 2);
  EXPECT_EQ(speed.rivals.at(0).against, 75);
  EXPECT_EQ(speed.rivals.at(0).vote, 50) << "that of the network decided";
}

TEST(LearnedVote, LeavesOutWhoAbstainsAndFailsWithNobody) {
  Mind mind{tree("learned_vote: {file: a, children: [{navigate: {vote: 0}}, {pursue: {vote: 9}}]}",
                 votes("sigmoid", {1, 1}))};
  mind.ask({}, kFailure);
}

TEST(LearnedVote, SaysWhatDoesNotFit) {
  EXPECT_EQ(mistakes("learned_vote: {file: a, children: [navigate]}", votes("sigmoid", {1, 2})),
            "test.yaml:1:22: the network of 'a' gives 2 votes, for 1 children");
  EXPECT_EQ(mistakes("learned_vote: {file: a, children: [navigate]}", constant("release", {1})),
            "test.yaml:1:22: the network of 'a' commands and does not vote: it is for policy");
  EXPECT_EQ(
      mistakes("policy: {file: a}", votes("sigmoid", {1})),
      "test.yaml:1:16: the network of 'a' votes and commands nothing: it is for learned_vote");
  EXPECT_EQ(mistakes("policy: {file: a}", votes("sigmod", {1})),
            "test.yaml:1:16: a: votes: expected sigmoid, softmax or linear, got 'sigmod'; did you "
            "mean 'sigmoid'?");
}

}  // namespace
}  // namespace eyrie::pilot
