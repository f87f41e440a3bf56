// SPDX-License-Identifier: MIT
/// \file  What explain calls a node can be typed: by --set, by whatif and behind `replace`.
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

}  // namespace
}  // namespace eyrie::test
