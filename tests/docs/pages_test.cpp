// SPDX-License-Identifier: MIT
/// \file  The pages about trees say what is true: their YAML builds, and their code stands in the
/// tests beside this file, where it is compiled and run.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "campaign/spec.hpp"
#include "core/yaml.hpp"
#include "pilot/catalog.hpp"
#include "pilot/policy/policy_file.hpp"
#include "scenario/scenario.hpp"
#include "support/program.hpp"

namespace eyrie {
namespace {

std::string read(const std::string& path) {
  std::ifstream file(path);
  EYRIE_DEMAND(file.good(), "a page or its test is missing");
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// The fenced blocks of one language, and the line where each begins.
struct Block {
  std::string text;
  int line = 0;
};
std::vector<Block> blocks(const std::string& page, const std::string& language) {
  std::vector<Block> found;
  std::istringstream lines(read(page));
  bool inside = false;
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (inside && line == "```") {
      inside = false;
    } else if (inside) {
      found.back().text += line + "\n";
    } else if (line == "```" + language) {
      inside = true;
      found.push_back({"", number + 1});
    }
  }
  EXPECT_FALSE(inside) << page << ": a block is not closed";
  return found;
}

/// Without what a formatter may change: spaces and line ends.
std::string squeezed(const std::string& text) {
  std::string result;
  for (const char c : text)
    if (c != ' ' && c != '\n')
      result += c;
  return result;
}

template <class... Test>
void code_is_compiled(const std::string& page, const Test&... tests) {
  const std::string source = (squeezed(read(tests)) + ...);
  const auto code = blocks(page, "cpp");
  EXPECT_FALSE(code.empty()) << page;
  for (const Block& block : code)
    EXPECT_NE(source.find(squeezed(block.text)), std::string::npos)
        << page << ":" << block.line << ": this code stands in no test";
}

TEST(Pages, TheirCodeIsCompiledAndRun) {
  code_is_compiled("docs/ubf.md", "tests/docs/ubf_in_code_test.cpp",
                   "tests/package/alone/from_yaml.cpp");
  code_is_compiled("docs/howto/add-a-behavior.md", "tests/docs/add_a_behavior_test.cpp");
  code_is_compiled("docs/howto/add-a-decorator.md", "tests/docs/add_a_decorator_test.cpp");
  code_is_compiled("docs/howto/add-an-arbiter.md", "tests/docs/add_an_arbiter_test.cpp");
  code_is_compiled("docs/howto/write-a-plugin.md", "tests/plugins/good.cpp");
  code_is_compiled("docs/architecture.md", "tests/docs/a_system_test.cpp");
  code_is_compiled("README.md", "tests/plugins/greet.cpp");
}

/// What a page tells its reader to type sets what is there.
TEST(Pages, TheirScenariosTakeWhatTheySet) {
  const std::regex fly(R"(eyrie fly (\w+) ?(.*))"), set(R"(--set ([^\s'`]+(?:'[^']*')?))");
  int taken = 0;
  for (const char* page : {"README.md", "docs/howto/write-a-scenario.md",
                           "docs/howto/explain-a-decision.md", "docs/howto/keep-a-run.md"}) {
    std::istringstream lines(read(page));
    std::smatch found;
    for (std::string line; std::getline(lines, line);) {
      const bool flies = std::regex_search(line, found, fly);
      const std::string file = flies ? "scenarios/" + found[1].str() + ".yaml" : "";
      if (!std::filesystem::exists(file))
        continue;
      std::vector<std::string> sets;
      const std::string options = found[2];
      for (std::sregex_iterator s(options.begin(), options.end(), set), end; s != end; ++s) {
        sets.push_back((*s)[1]);
        std::erase(sets.back(), '\'');
      }
      EXPECT_NO_THROW((void)scenario::load({file, sets}, scenario::Source::disk("."))) << line;
      taken += static_cast<int>(sets.size());
    }
  }
  EXPECT_GE(taken, 4);
}

TEST(Pages, NameFilesThatAreThere) {
  namespace fs = std::filesystem;
  std::set<std::string> sources;
  for (const char* folder : {"src", "tests", "apps", "bench"})
    for (const auto& entry : fs::recursive_directory_iterator(folder))
      sources.insert(entry.path().filename());
  const std::regex name(R"(`((?:\w+/)[\w./-]+|\w+\.[ch]pp)`)");
  const std::regex ours("(src|apps|bench|data|docs|scenarios|tests|tools)/.*");
  std::vector<std::string> pages{"README.md", "docs/architecture.md", "docs/formats.md"};
  for (const auto& entry : fs::directory_iterator("docs/models"))
    if (entry.path().extension() == ".md")
      pages.push_back(entry.path());
  for (const std::string& page : pages) {
    const std::string text = read(page);
    for (std::sregex_iterator n(text.begin(), text.end(), name), end; n != end; ++n) {
      const std::string file = (*n)[1];
      EXPECT_TRUE(file.find('/') == file.npos    ? sources.contains(file)
                  : std::regex_match(file, ours) ? fs::exists(file)
                                                 : true)
          << page << ": " << file;
    }
  }
}

TEST(Pages, TheirScenariosLoad) {
  const auto scenarios = blocks("docs/howto/write-a-scenario.md", "yaml");
  EXPECT_FALSE(scenarios.empty());
  for (const Block& block : scenarios) {
    const test::TempFolder folder;
    EXPECT_NO_THROW((void)scenario::load({.file = folder.write("page.yaml", block.text)},
                                         scenario::Source::disk(test::source_root())))
        << "line " << block.line;
  }
}

TEST(Pages, TheirCampaignsAreRead) {
  const auto campaigns = blocks("docs/campaigns.md", "yaml");
  EXPECT_FALSE(campaigns.empty());
  for (const Block& block : campaigns)
    EXPECT_NO_THROW((void)campaign::parse_spec(block.text, "docs/campaigns.md"));
}

TEST(Pages, EveryTreeInTheReferenceBuilds) {
  const pilot::Registry registry = pilot::make_registry();
  auto trees = blocks("docs/ubf.md", "yaml");
  for (const Block& block : blocks("docs/reference.md", "yaml"))
    trees.push_back(block);
  EXPECT_GE(trees.size(), 13u);
  Diagnostics none;
  const Value ingress = eyrie::parse_yaml("navigate", "a tree that pages name", none);
  for (const Block& block : trees) {
    Diagnostics diagnostics;
    const Value value = eyrie::parse_yaml(block.text, "a page", diagnostics);
    std::vector<ubf::NamedSpec> trees_of_block{{"ingress", &ingress}};
    if (const Value* map = value.find("trees")) {
      for (const Value::Entry& e : map->entries)
        trees_of_block.push_back({e.key, &e.value});
    } else {
      trees_of_block.push_back({"page", &value});
    }
    for (const ubf::NamedSpec& tree : trees_of_block) {
      if (!ubf::needs_arguments(*tree.value)) {
        EXPECT_TRUE(registry.build_tree(tree.name, *tree.value, diagnostics, trees_of_block))
            << "block at line " << block.line << ":\n"
            << diagnostics.text();
      }
    }
  }
}

TEST(Pages, TheReferenceDescribesEveryNodeOfTheLibrary) {
  const std::string page = read("docs/ubf.md");
  const pilot::Registry registry = pilot::make_registry();
  for (const ubf::NodeInfo& info : registry.catalog()) {
    if (info.child_keys.empty())
      continue;
    EXPECT_NE(page.find("`" + info.name), std::string::npos) << info.name;
  }
}

TEST(Pages, ThePageOfPoliciesNamesAllThatTheirFilesMaySay) {
  const std::string page = read("docs/howto/fly-a-policy.md");
  const auto named = [&](std::string_view name) {
    EXPECT_NE(page.find(fmt::format("`{}`", name)), std::string::npos) << name;
  };
  for (const pilot::ControlType& type : pilot::control_types())
    named(type.name);
  for (const std::string_view name : enum_names<pilot::Activation>())
    named(name);
  for (const std::string_view name : enum_names<pilot::Votes>())
    named(name);
}

}  // namespace
}  // namespace eyrie
