// SPDX-License-Identifier: MIT
#include "scenario/catalog.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include "pilot/catalog.hpp"
#include "scenario/data.hpp"
#include "scenario/scenario.hpp"

namespace eyrie::scenario {
namespace {

/// Tests run in the root of the source tree.
Catalog shipped() {
  return make_catalog(Source::disk("."));
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != text.npos;
}

TEST(Catalog, HasEveryKindOfModelThatCanBeLoaded) {
  const Catalog catalog = shipped();
  const auto kinds = DataLoader::kinds();
  ASSERT_EQ(catalog.models.size(), kinds.size());
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    EXPECT_EQ(catalog.models[i].folder, kinds[i]);
    EXPECT_FALSE(catalog.models[i].names.empty()) << kinds[i];
    EXPECT_FALSE(catalog.models[i].parameters.empty()) << kinds[i];
  }
}

TEST(Catalog, ExplainsEveryParameterOfEveryNodeAndModel) {
  const Catalog catalog = shipped();
  const auto check = [](const std::string& where, std::span<const ParamInfo> parameters) {
    each_parameter(parameters, [&](const std::string& path, const ParamInfo& info) {
      EXPECT_FALSE(info.help.empty()) << where << " " << path;
    });
  };
  for (const FilePart& part : catalog.file)
    check(part.name, part.parameters);
  for (const ubf::NodeInfo& node : catalog.nodes) {
    EXPECT_FALSE(node.help.empty()) << node.name;
    check(node.name, node.parameters);
  }
  for (const ModelKind& kind : catalog.models)
    check(kind.folder, kind.parameters);
}

/// A number that may be as large as a computer can write is a mistake that nobody refuses.
TEST(Catalog, BoundsEveryNumberOfEveryNodeAndModel) {
  const Catalog catalog = shipped();
  const auto check = [](const std::string& where, std::span<const ParamInfo> parameters) {
    each_parameter(parameters, [&](const std::string& path, const ParamInfo& info) {
      const ParamInfo& item = info.kind == ParamKind::list ? info.children.front() : info;
      const bool holds_numbers = item.kind == ParamKind::number ||
                                 item.kind == ParamKind::integer ||
                                 item.kind == ParamKind::table1 || item.kind == ParamKind::table2;
      EXPECT_TRUE(!holds_numbers ||
                  (std::isfinite(item.limits.min) && std::isfinite(item.limits.max)))
          << where << " " << path;
    });
  };
  for (const FilePart& part : catalog.file)
    check(part.name, part.parameters);
  for (const ubf::NodeInfo& node : catalog.nodes)
    check(node.name, node.parameters);
  for (const ubf::NodeInfo& node : catalog.others.front().nodes)
    check(node.name, node.parameters);
  for (const ModelKind& kind : catalog.models)
    check(kind.folder, kind.parameters);
}

TEST(Catalog, NamesEachScenarioOnce) {
  const std::vector<std::string> names = shipped().scenarios;
  EXPECT_GT(names.size(), 10U);
  EXPECT_EQ(std::adjacent_find(names.begin(), names.end()), names.end());
}

TEST(CatalogText, ShowsEachNodeAsAFileMayWriteIt) {
  const Catalog catalog = shipped();
  EXPECT_FALSE(node_text(catalog, "persue"));
  std::size_t loaded = 0;
  for (const ubf::NodeInfo& node : catalog.nodes) {
    const std::string text = node_text(catalog, node.name).value();
    EXPECT_TRUE(text.starts_with(node.name + " (")) << text;
    const std::string begin = "in a tree\n  ";
    const auto at = text.find(begin) + begin.size();
    const std::string example = text.substr(at, text.find('\n', at) - at);
    if (example.find('<') != example.npos)  // somebody has to say it
      continue;
    ++loaded;
    EXPECT_NO_THROW(static_cast<void>(
        load({.file = "scenarios/sweep.yaml", .sets = {"trees.sweep={" + example + "}"}},
             Source::disk("."))))
        << example;
  }
  EXPECT_GT(2 * loaded, catalog.nodes.size());
}

TEST(CatalogText, NamesEachNodeAndModelOnALineOfItsOwn) {
  const Catalog catalog = shipped();
  const std::string text = catalog_text(catalog);
  for (const ubf::NodeInfo& node : catalog.nodes)
    EXPECT_TRUE(contains(text, "\n  " + node.name + " ")) << node.name;
  for (const ModelKind& kind : catalog.models)
    EXPECT_TRUE(contains(text, "\n  " + kind.folder + " ")) << kind.folder;
  for (const ubf::StateFieldInfo& field : catalog.fields)
    EXPECT_TRUE(contains(text, fmt::format("\n  {} ", field.name))) << field.name;
  EXPECT_TRUE(contains(text, "f15c"));
}

TEST(CatalogMarkdown, HasARowForEveryParameter) {
  const Catalog catalog = shipped();
  const std::string text = catalog_markdown(catalog);
  const auto check = [&](std::span<const ParamInfo> parameters) {
    each_parameter(parameters, [&](const std::string& path, const ParamInfo&) {
      EXPECT_TRUE(contains(text, "\n| `" + path + "` |")) << path;
    });
  };
  for (const ubf::NodeInfo& node : catalog.nodes) {
    EXPECT_TRUE(contains(text, "\n#### " + node.name + "\n")) << node.name;
    check(node.parameters);
  }
  for (const ModelKind& kind : catalog.models)
    check(kind.parameters);
  for (const ubf::StateFieldInfo& field : catalog.fields)
    EXPECT_TRUE(contains(text, fmt::format("\n| `{}` |", field.name))) << field.name;
  for (const UnitInfo& unit : units())
    EXPECT_TRUE(contains(text, " `" + std::string(unit.symbol) + "`")) << unit.symbol;
}

TEST(Reference, IsUpToDate) {
  std::ifstream file("docs/reference.md", std::ios::binary);
  const std::string written{std::istreambuf_iterator<char>(file), {}};
  EXPECT_TRUE(written == catalog_markdown(shipped()))
      << "docs/reference.md is not what the program says. Make it anew:\n"
         "  ./eyrie catalog --markdown > docs/reference.md";
}

struct Inner {
  static constexpr std::string_view type_name = "inner";
  static constexpr auto params() {
    return std::tuple{param("store", &Inner::store, "what").required()};
  }
  std::string store;
};

struct Sample {
  static constexpr std::string_view type_name = "sample";
  static constexpr auto params() {
    return std::tuple{param("range", &Sample::range, "m", eyrie::range(0, 50e3), "h"),
                      param("above", &Sample::above, positive(), "h"),
                      param("free", &Sample::free, "rad", any(), "h"),
                      param("count", &Sample::count, at_least(1), "h"),
                      param("seed", &Sample::seed, "h"),
                      param("maybe", &Sample::maybe, "s", at_least(0), "h"),
                      param("three", &Sample::three, "m", "h"),
                      param("inner", &Sample::inner, "h").items(1, 4),
                      param("one", &Sample::one, "h"),
                      param("text", &Sample::text, "h")};
  }
  double range = si(2, "nmi"), above = 1, free = radians(30);
  std::uint8_t count = 1;
  std::uint64_t seed = 1;
  std::optional<double> maybe;
  Vec3 three;
  std::vector<Inner> inner;
  Inner one;
  std::string text;
};

TEST(ParamText, SaysWhatAFileMayWrite) {
  std::string said;
  each_parameter(parameters<Sample>(), [&](const std::string& path, const ParamInfo& info) {
    said += path + " | " + kind_text(info) + " | " + range_text(info) + " | " + default_text(info) +
            "\n";
  });
  EXPECT_EQ(said,
            "range | length | 0 to 50 km | 2 nmi\n"
            "above | number | above 0 | 1\n"
            "free | angle |  | 30°\n"
            "count | whole number | 1 to 255 | 1\n"
            "seed | whole number | at least 0 | 1\n"
            "maybe | time | at least 0 | null\n"
            "three | list of 3 lengths |  | [0 m, 0 m, 0 m]\n"
            "inner | list of 1 to 4 maps |  | []\n"
            "inner[].store | text |  | required\n"
            "one | map |  | \n"
            "one.store | text |  | required\n"
            "text | text |  | empty\n");
}

}  // namespace
}  // namespace eyrie::scenario
