// SPDX-License-Identifier: MIT
/// \file  What explain calls a node can be typed: by --set, by whatif and behind `replace`.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/program.hpp"

namespace eyrie::test {
namespace {

using nlohmann::json;

TEST(NodePaths, GoFromExplainToWhatIfSetAndReplace) {
  const TempFolder folder;
  const auto said = [&](const std::vector<std::string>& words) {
    const Ran ran = run_program(folder, words);
    EXPECT_EQ(ran.code, 0) << ran.err;
    return ran.out;
  };
  said({"fly", "sweep", "--until", "7 min", "--no-debrief", "--quiet", "--out", "a"});
  const std::vector<std::string> asked{"explain", "a", "--player", "eagle1", "--at", "6:30"};
  auto as_json = asked;
  as_json.emplace_back("--json");
  const json decision = json::parse(said(as_json)).at(0);
  std::string document, path = decision.at("leader");
  for (const json& node : decision.at("nodes"))
    if (node.at("path") == path)
      document = node.at("document");
  for (const std::vector<std::string>& words :
       {as_json, {"explain", "a", "--json"}, {"explain", "a", "--json", "--player", "eagle1"}})
    for (const json& one : json::parse(said(words))) {
      const json& told = one.contains("decision") ? one.at("decision") : one;
      for (const json& node : told.at("nodes"))
        EXPECT_TRUE(node.contains("document")) << "every node stands in a file: " << node;
    }
  EXPECT_NE(said(asked).find("\n" + path + " is " + document + "\n"), std::string::npos);

  const auto what_if = [&](const std::string& node) {
    json answer = json::parse(
        said({"whatif", "a", "--player", "eagle1", "--json", "--set", node + ".vote=1"}));
    answer.erase("run");
    return answer;
  };
  EXPECT_GT(what_if(document).at("different"), 100);
  EXPECT_EQ(what_if(document), what_if(path));

  folder.write("x.yaml", "extends: sweep\nreplace:\n  " + document + ".vote: 1\n");
  const auto hash = [&](std::vector<std::string> more) {
    more.insert(more.end(), {"--until", "7 min", "--no-debrief", "--json", "--seed", "1"});
    return json::parse(said(more)).at("hash");
  };
  const json set = hash({"fly", "sweep", "--set", document + ".vote=1"});
  EXPECT_EQ(hash({"fly", "x.yaml"}), set);
  EXPECT_NE(hash({"fly", "sweep"}), set);
}

/// A flight whose tree has a vote that follows the state, parameters that may contradict each
/// other, and a node that may become a condition.
class ChangedNode : public testing::Test {
 protected:
  ChangedNode() {
    folder.write("small.yaml", R"(eyrie: 1
name: small
reference: {latitude: 33 deg, longitude: -68 deg}
until: 2 s
trees:
  pilot:
    commitment:
      margin: 5
      children:
        - navigate: {vote: {most: 60, of: speed, from: 100 kt, to: 500 kt}}
        - {guard: {when: leads, child: {egress: {vote: 30}}}}
blue:
  flights:
    eagle:
      aircraft: f16c
      start: {north: 0 nmi, east: 0 nmi, altitude: 20000 ft, heading: 90 deg, speed: 450 kt}
      tree: pilot
      players: [eagle1]
)");
  }
  [[nodiscard]] Ran what_if(const std::string& set) const {
    if (run_program(folder, {"fly", "small.yaml", "--no-debrief", "--out", "run", "--force"}).code)
      ADD_FAILURE() << "it does not fly";
    return run_program(folder, {"whatif", "run", "--player", "eagle1", "--set", set});
  }
  TempFolder folder;
};

TEST_F(ChangedNode, IsBlamedWhereItWasChangedForWhatContradictsItself) {
  const std::string words =
      "commitment needs 'margin', 'min_time' or 'hold' above 0, or it commits to nothing\n";
  EXPECT_EQ(what_if("root.margin=0").err, "--set root.margin=0:1:13: " + words);
  const std::string set = "trees.pilot.commitment.margin=0";
  EXPECT_EQ(run_program(folder, {"fly", "small.yaml", "--set", set}).err,
            "--set " + set + ":1:31: " + words);
  folder.write("other.yaml", "extends: small.yaml\nreplace:\n  trees.pilot.commitment.margin: 0\n");
  EXPECT_EQ(run_program(folder, {"validate", "other.yaml"}).err, "other.yaml:3:34: " + words);
}

TEST_F(ChangedNode, LosesTheVoteIfItBecomesACondition) {
  const Ran ran = what_if("root/guard/egress=bingo");
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(what_if("root/guard/egress=pursue").code, 0) << "which has a vote";
}

TEST_F(ChangedNode, IsMeantByAPathThatDoesNotBeginAtTheRoot) {
  for (const auto& [set, words] :
       {std::pair("navigate.vote=7",
                  "'navigate' says nothing about decisions; did you mean "
                  "'root/navigate'?"),
        std::pair("guard/egress=pursue",
                  "'guard/egress' says nothing about decisions; did you mean "
                  "'root/guard/egress'?"),
        std::pair("rot/guard=selector",
                  "'rot/guard' says nothing about decisions; did you mean 'root'?"),
        std::pair("tree.pilot=navigate",
                  "'tree' says nothing about decisions; did you mean 'trees'?"),
        std::pair("seed=7", "'seed' says nothing about decisions")}) {
    const Ran ran = what_if(set);
    EXPECT_EQ(ran.code, 2) << set;
    EXPECT_EQ(ran.err, fmt::format("--set {}:1:1: whatif asks other trees; {}\n", set, words));
  }
}

TEST_F(ChangedNode, MayHaveALabelWithAnEqualsSign) {
  std::string named = read_text(folder / "small.yaml");
  named.insert(named.find("vote: {most"), "name: a=b, ");
  folder.write("small.yaml", named);
  for (const char* set : {"root/a=b.vote=7", "root/a=b=pursue"})
    EXPECT_EQ(what_if(set).code, 0) << set;
  EXPECT_EQ(what_if("root/a=c=pursue").err,
            "--set root/a=c=pursue:1:1: tree 'pilot' has no node 'root/a'; did you mean "
            "'root/a=b'?\n");
}

TEST_F(ChangedNode, HasNoPathIntoAParameter) {
  const Ran ran = what_if("root/navigate.vote.most=10");
  EXPECT_EQ(ran.code, 2);
  EXPECT_EQ(
      ran.err,
      "--set root/navigate.vote.most=10:1:15: 'vote.most' is inside a parameter; behind a node "
      "stands a whole one, as in vote={...}, and the path of a file (trees. ...) goes on into "
      "it\n");
  EXPECT_EQ(what_if("trees.pilot.commitment.navigate.vote.most=10").code, 0);
}

TEST(NodePaths, BranchWithANodeThatRemembersLess) {
  const TempFolder folder;
  ASSERT_EQ(run_program(folder, {"fly", "commitment", "--until", "2 min", "--quiet", "--no-debrief",
                                 "--out", "run"})
                .code,
            0);
  const Ran ran = run_program(folder, {"whatif", "run", "--player", "eagle1", "--set",
                                       "root/commitment=winner_takes_all", "--branch", "--json"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  const auto said = nlohmann::json::parse(ran.out);
  EXPECT_GT(said["different"], 0);
  EXPECT_GT(said["branch"]["time_s"], 0) << said["branch"];
}

TEST(NodePaths, AskWhatIfAnotherNetworkFlew) {
  const TempFolder folder;
  EXPECT_EQ(run_program(folder, {"fly", "merge_learned", "--until", "20 s", "--no-debrief",
                                 "--quiet", "--out", "a"})
                .code,
            0);
  const auto ask = [&](const std::string& file) {
    return run_program(folder, {"whatif", "a", "--player", "viper1", "--json", "--set",
                                "root/policy.file=" + file});
  };
  std::string network = read_text(source_root() + "/scenarios/policies/merge.safetensors");
  folder.write("same.safetensors", network);
  for (std::size_t at = network.size() - 1; at > network.size() / 2; at -= 4)
    network[at] = static_cast<char>(network[at] ^ 0x80);  // the sign of a number
  folder.write("other.safetensors", network);
  EXPECT_EQ(json::parse(ask("same.safetensors").out).at("different"), 0);
  const json other = json::parse(ask("other.safetensors").out);
  EXPECT_GT(other.at("different"), 100);
  EXPECT_EQ(other.at("first").at("leader").at("other"), "policy");
  const Ran none = ask("others.safetensors");
  EXPECT_EQ(none.code, 2);
  EXPECT_NE(none.err.find("cannot read 'others.safetensors'"), std::string::npos) << none.err;
}

}  // namespace
}  // namespace eyrie::test
