// SPDX-License-Identifier: MIT
#include "record/json_schema.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "core/diagnostics.hpp"
#include "scenario/scenario.hpp"

namespace eyrie::record {
namespace {
namespace fs = std::filesystem;
using nlohmann::json;

const std::string& schema_text() {
  static const std::string text =
      catalog_json_schema(scenario::make_catalog(scenario::Source::disk(".")));
  return text;
}

/// Calls `visit` for every object of a document.
template <class Visit>
void each_object(const json& at, const Visit& visit) {
  if (at.is_object())
    visit(at);
  for (const json& below : at)
    if (below.is_structured())
      each_object(below, visit);
}

/// Editors take it from there: what scenarios say in their first line.
TEST(JsonSchema, IsKeptBesideTheData) {
  std::ifstream kept("data/eyrie.schema.json");
  EXPECT_TRUE(schema_text() == std::string(std::istreambuf_iterator<char>(kept), {}))
      << "data/eyrie.schema.json is not what the program says. Make it anew:\n"
         "  ./eyrie catalog --json-schema > data/eyrie.schema.json";
  for (const auto& file : fs::recursive_directory_iterator("scenarios")) {
    if (file.path().extension() != ".yaml")
      continue;
    constexpr std::string_view kModeline = "# yaml-language-server: $schema=";
    std::ifstream text(file.path());
    std::string line;
    std::getline(text, line);
    ASSERT_TRUE(line.starts_with(kModeline)) << file.path();
    EXPECT_TRUE(fs::equivalent(file.path().parent_path() / line.substr(kModeline.size()),
                               "data/eyrie.schema.json"))
        << file.path();
  }
}

TEST(JsonSchema, RefersOnlyToWhatItDefines) {
  const json schema = json::parse(schema_text());
  int references = 0;
  each_object(schema, [&](const json& object) {
    if (!object.contains("$ref"))
      return;
    ++references;
    const std::string name = object["$ref"];
    ASSERT_TRUE(name.starts_with("#/definitions/")) << name;
    EXPECT_TRUE(schema["definitions"].contains(name.substr(14))) << name;
    EXPECT_EQ(object.size(), 1u) << "beside $ref draft-07 ignores everything: " << object;
  });
  EXPECT_GT(references, 100);
}

TEST(JsonSchema, LeavesNoMapOpenWithoutSayingWhatItsKeysAre) {
  each_object(json::parse(schema_text()), [](const json& object) {
    if (object.contains("type") && object["type"] == "object") {
      EXPECT_TRUE(object.contains("additionalProperties")) << object;
    }
  });
}

TEST(JsonSchema, KnowsEveryNodeModelAndParameter) {
  const json schema = json::parse(schema_text());
  const scenario::Catalog catalog = scenario::make_catalog(scenario::Source::disk("."));
  const json& types = schema["definitions"]["node"]["anyOf"][1]["properties"];
  std::vector<ubf::NodeInfo> nodes = catalog.nodes;
  for (const ubf::NodeInfo& node : catalog.others.front().nodes)
    if (std::none_of(nodes.begin(), nodes.end(),
                     [&](const ubf::NodeInfo& n) { return n.name == node.name; }))
      nodes.push_back(node);
  EXPECT_EQ(types.size(), nodes.size() + 1) << "and references to trees";
  for (const ubf::NodeInfo& node : nodes) {
    std::set<std::string> keys;
    each_object(types.at(node.name), [&](const json& object) {
      for (const auto& [key, value] : object.items())
        keys.insert(key);
    });
    for (const ParamInfo& info : node.parameters)
      EXPECT_TRUE(keys.count(info.name)) << node.name << "." << info.name;
    for (const std::string& key : node.child_keys)
      EXPECT_TRUE(keys.count(key)) << node.name << "." << key;
  }
  for (const scenario::ModelKind& kind : catalog.models)
    for (const ParamInfo& info : kind.parameters) {
      const json& map = schema["definitions"]["model." + kind.folder]["properties"];
      ASSERT_TRUE(map.contains(info.name)) << kind.folder << "." << info.name;
      EXPECT_NE(map[info.name]["description"].get<std::string>().find(info.help),
                std::string::npos);
    }
}

TEST(JsonSchema, AcceptsEveryShippedFileAndRefusesMistakes) {
  const fs::path file = fs::path(testing::TempDir()) / "eyrie_scenario_schema.json";
  const fs::path said = fs::path(testing::TempDir()) / "eyrie_scenario_schema.txt";
  std::ofstream(file) << schema_text();
  const std::string command = "/usr/bin/python3 tests/schema/check.py '" + file.string() +
                              "' . tests/schema/cases.txt > '" + said.string() + "' 2>&1";
  const int code = std::system(command.c_str());
  std::ifstream output(said);
  EXPECT_EQ(code, 0) << std::string{std::istreambuf_iterator<char>(output), {}};
  fs::remove(file);
  fs::remove(said);
}

/// The cases of the schema, given to the loader: where they differ, one of them is wrong.
TEST(JsonSchema, AgreesWithTheProgram) {
  std::ifstream cases("tests/schema/cases.txt");
  ASSERT_TRUE(cases);
  int count = 0;
  for (std::string line; std::getline(cases, line);) {
    if (line.empty() || line.starts_with('#'))
      continue;
    ++count;
    std::string mistakes;
    try {
      static_cast<void>(scenario::load({"tests/schema/base.yaml", {line.substr(7)}},
                                       scenario::Source::disk(".")));
    } catch (const ConfigError& e) {
      mistakes = e.what();
    }
    EXPECT_EQ(mistakes.empty(), line.starts_with("accept ")) << line << "\n" << mistakes;
  }
  EXPECT_GT(count, 80);
}

}  // namespace
}  // namespace eyrie::record
