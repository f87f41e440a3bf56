// SPDX-License-Identifier: MIT
/// \file  Plug-ins are loaded, or refused with words; those of this folder are built for it.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "scenario/plugin_file.hpp"
#include "scenario/plugins.hpp"
#include "scenario/scenario.hpp"
#include "support/plugin.hpp"
#include "support/program.hpp"

namespace eyrie::test {
namespace {

using scenario::Plugins;
using scenario::Source;
using Words = std::vector<std::string>;

/// What is said of a plug-in, and that nothing of a refused one stays.
Words words_about(const std::string& path) {
  Source source = Source::disk(".");
  Plugins plugins;
  const std::size_t nodes = plugins.registries().pilots.catalog().size();
  Words words = plugins.load(path, source);
  EXPECT_FALSE(words.empty()) << path;
  EXPECT_EQ(plugins.registries().pilots.catalog().size(), nodes) << path;
  EXPECT_TRUE(plugins.files().empty()) << path;
  EXPECT_EQ(source.origin("radars", "mine"), std::nullopt) << path;
  return words;
}

TEST(PluginLoading, TakesNodesAndModelsWithTheirOrigin) {
  Source source = Source::disk(".");
  Plugins plugins;
  ASSERT_EQ(plugins.load(plugin("good"), source), Words{});
  const auto* node = plugins.registries().pilots.find("hold_course");
  ASSERT_TRUE(node);
  EXPECT_EQ(node->origin, "libgood.so");
  EXPECT_EQ(node->parameters.at(0).name, "course");
  EXPECT_EQ(plugins.registries().pilots.find("last_word")->kind, ubf::Kind::arbiter);
  ASSERT_TRUE(plugins.registries().drivers.find("halt"));
  EXPECT_EQ(plugins.registries().drivers.find("halt")->origin, "libgood.so");
  EXPECT_FALSE(plugins.registries().pilots.find("halt"));
  EXPECT_EQ(source.origin("aircraft", "f16_without_radar"), "libgood.so");
  EXPECT_EQ(source.origin("aircraft", "f16c"), std::nullopt);
  ASSERT_EQ(plugins.files().size(), 1u);
  EXPECT_EQ(plugins.files()[0].hash, scenario::hash_of(read_text(plugin("good"))));
}

TEST(PluginLoading, TakesAFileOnceByWhateverPath) {
  Source source = Source::disk(".");
  Plugins plugins;
  const TempFolder folder;
  std::filesystem::create_symlink(plugin("good"), folder / "other.so");
  EXPECT_EQ(plugins.load(plugin("good"), source), Words{});
  EXPECT_EQ(plugins.load(folder / "other.so", source), Words{});
  EXPECT_EQ(plugins.files().size(), 1u);
}

TEST(PluginLoading, RefusesWhatAnotherPluginHasAdded) {
  Source source = Source::disk(".");
  Plugins plugins;
  const TempFolder folder;
  std::filesystem::copy(plugin("good"), folder / "libtwin.so");
  EXPECT_EQ(plugins.load(plugin("good"), source), Words{});
  EXPECT_EQ(plugins.load(folder / "libtwin.so", source),
            (Words{"there is already a node 'hold_course' (of libgood.so)",
                   "there is already a node 'last_word' (of libgood.so)",
                   "there is already a node 'halt' (of libgood.so)",
                   "there is already a model 'f16_without_radar' "
                   "(plugin:libgood.so/aircraft/f16_without_radar.yaml)"}));
}

TEST(PluginLoading, SaysEverythingThatIsWrongWithNames) {
  EXPECT_EQ(
      words_about(plugin("taken")),
      (Words{"there is already a node 'pursue' (of eyrie)",
             "there is already a node 'fresh' (of libtaken.so)", "'tree' is no name for a node",
             "there is already a model 'f16c' (data/airframes/f16c.yaml)",
             "there is no kind of model 'airframe'; did you mean 'airframes'?",
             "'../mine' is no name for a model", "it adds the model 'mine' twice"}));
}

TEST(PluginLoading, RefusesNamesThatMeanSomethingElseOrNothing) {
  EXPECT_EQ(words_about(plugin("misnamed")),
            (Words{"node 'unmade' could not be made: no licence",
                   "node 'unfit' has a default that is none: below: 200 m is outside [0 m, 100 m]",
                   "the name of a node: '' is no word: a letter, then letters, digits, '_' and '-'",
                   "the name of a node: 'a/b[0]' is no word: a letter, then letters, digits, '_' "
                   "and '-'",
                   "'leads' is no name for a node: alone it is the condition that this field of "
                   "the state is true",
                   "node 'twice': 'than' is no name for a parameter, it is taken",
                   "node 'twice': 'name' is no name for a parameter, it is taken",
                   "the name of a node: 'range < 10 nmi' is no word: a letter, then letters, "
                   "digits, '_' and '-'",
                   "the name of a node: 'not' means something else in a scenario"}));
}

TEST(PluginLoading, RefusesWhatWasBuiltForAnotherEyrieBeforeRunningIt) {
  EXPECT_EQ(
      words_about(plugin("old")),
      Words{fmt::format("it was built for Eyrie 0.0.9, this is {}; build it again", kVersion)});
  EXPECT_EQ(words_about(plugin("layout")),
            Words{"it was built with other headers of Eyrie than this program; build it again"});
  EXPECT_EQ(words_about(plugin("format")),
            Words{"it was built for another version of Eyrie; build it again"});
  EXPECT_EQ(words_about(plugin("magic")), Words{"its eyrie_plugin was not made by EYRIE_PLUGIN"});
}

TEST(PluginLoading, RefusesWhatIsNoPlugin) {
  const TempFolder folder;
  EXPECT_EQ(words_about(plugin("foreign")),
            Words{"it is not a plug-in: there is no EYRIE_PLUGIN in it"});
  EXPECT_EQ(words_about(plugin("unresolved")),
            Words{"it uses 'eyrie::pilot::nowhere(double)', which is nowhere; eyrie_add_plugin "
                  "links what it needs"});
  EXPECT_EQ(words_about(folder.write("text.so", "int main() {}\n")),
            Words{"it is not a shared library"});
  EXPECT_EQ(words_about(folder.write("long.so", std::string(10'000, 'x'))),
            Words{"it is not a shared library"});
  EXPECT_EQ(words_about(folder / "lonk.so"),
            Words{"there is no such file; did you mean 'long.so'?"});
  EXPECT_EQ(words_about(folder.path()), Words{"it is a folder, not a file"});
  ASSERT_EQ(::mkfifo((folder / "fifo.so").c_str(), 0600), 0);
  EXPECT_EQ(words_about(folder / "fifo.so"), Words{"it is a pipe, not a file"}) << "nobody waits";
  EXPECT_EQ(words_about("/dev/zero"), Words{"it is a device, not a file"});
  folder.write("huge.so", "");
  std::filesystem::resize_file(folder / "huge.so", scenario::kLargestPlugin + (1 << 20));
  EXPECT_EQ(words_about(folder / "huge.so"),
            Words{"it is larger than 512 MB, the most that is read"});
}

TEST(PluginLoading, SurvivesAPluginThatFails) {
  EXPECT_EQ(words_about(plugin("throwing")),
            Words{"it failed while it was adding: no licence found"});
}

/// One aircraft, a tree and what stands before them.
std::string small_scenario(const std::string& head, const std::string& aircraft = "f16c") {
  return "eyrie: 1\nname: small\n" + head +
         "reference: {latitude: 33 deg, longitude: -68 deg}\nuntil: 2 s\n"
         "trees: {pilot: {last_word: [navigate, hold_course]}}\n"
         "blue: {flights: {eagle: {aircraft: " +
         aircraft +
         ", tree: pilot, players: [eagle1], start: {north: 0 nmi, east: 0 nmi, "
         "altitude: 20000 ft, heading: 90 deg, speed: 450 kt}}}}\n";
}

/// What a test trusts: everything that it names.
std::string everything(const std::string&, const std::string&) {
  return {};
}

std::string load_error(std::map<std::string, std::string> files, Words plugins = {},
                       Words sets = {}, scenario::PluginPermission may_open = everything) {
  Source source = Source::disk(".");
  for (auto& [name, text] : files)
    source.add(name, text);
  try {
    static_cast<void>(scenario::load(
        {.file = "small.yaml", .sets = sets, .plugins = plugins, .may_open = std::move(may_open)},
        std::move(source)));
  } catch (const ConfigError& e) {
    return e.what();
  }
  return "";
}

TEST(PluginScenario, NamesItsPluginsAndUsesTheirNodesAndModels) {
  Source source = Source::disk(".");
  source.add("small.yaml",
             small_scenario("plugins: [" + plugin("good") + "]\n", "f16_without_radar"));
  const auto loaded =
      scenario::load({.file = "small.yaml", .may_open = everything}, std::move(source));
  EXPECT_EQ(loaded->trees->size(), 1u);
  ASSERT_EQ(loaded->plugins.size(), 1u);
  EXPECT_EQ(loaded->plugins[0].path, plugin("good"));
  EXPECT_TRUE(loaded->files.contains("plugin:libgood.so/aircraft/f16_without_radar.yaml"));
}

TEST(PluginScenario, MayNameThemInMoreThanOnePlace) {
  const std::string none = small_scenario("");
  EXPECT_NE(load_error({{"small.yaml", none}}), "");
  EXPECT_EQ(load_error({{"small.yaml", none}}, {plugin("good")}), "");
  EXPECT_EQ(load_error({{"small.yaml", none}}, {}, {"plugins=[" + plugin("good") + "]"}), "");
  EXPECT_EQ(load_error({{"small.yaml", small_scenario("plugins:\n")}}, {plugin("good")}),
            "small.yaml:3:1: plugins: expected a file or a list of files, got nothing");
  EXPECT_EQ(load_error({{"small.yaml", small_scenario("include: [a.yaml, b.yaml]\n")},
                        {"a.yaml", "plugins: " + plugin("good") + "\n"},
                        {"b.yaml", "plugins: [" + plugin("good") + "]\n"}}),
            "");
}

TEST(PluginScenario, OpensNothingThatNobodyAllowed) {
  const std::string path = plugin("good");
  const std::string named = small_scenario("plugins: " + path + "\n");
  const std::string refused = fmt::format(
      "it was not opened: it is not trusted; add '--plugin {}', or trust it with "
      "'eyrie trust {}'",
      path, path);
  EXPECT_EQ(load_error({{"small.yaml", named}}, {}, {}, {}),
            fmt::format("small.yaml:3:10: plug-in {}: {}", quote(path), refused));
  // what was typed is opened, and may then be named
  EXPECT_EQ(load_error({{"small.yaml", named}}, {path}, {}, {}), "");
  // --set is no such permission: it may be what somebody else wrote
  EXPECT_EQ(load_error({{"small.yaml", small_scenario("")}}, {}, {"plugins=" + path}, {}),
            fmt::format("--set plugins={}:1:9: plug-in {}: {}", path, quote(path), refused));
  // asked with the canonical path, and once that is allowed with what is in the file
  Words asked;
  const auto ask = [&](const std::string& file, const std::string& sha256) {
    asked.insert(asked.end(), {file, sha256});
    return std::string(sha256.empty() ? "" : "not today");
  };
  EXPECT_NE(load_error({{"small.yaml", named}}, {}, {}, ask).find("not opened: not today; add"),
            std::string::npos);
  EXPECT_EQ(asked, (Words{path, "", path, scenario::sha256(read_text(path))}));
}

TEST(PluginScenario, IsToldWhereItsMistakeIs) {
  EXPECT_EQ(load_error({{"small.yaml", small_scenario("plugins: [nowhere/libx.so, {a: b}]\n")}}),
            "small.yaml:3:11: plug-in 'nowhere/libx.so': there is no such file\n"
            "small.yaml:3:28: plugins: expected a file, got a map");
  EXPECT_EQ(load_error({{"small.yaml", small_scenario("plugins: {a: b}\n")}}),
            "small.yaml:3:10: plugins: expected a file or a list of files, got a map");
  EXPECT_EQ(load_error({{"small.yaml", small_scenario("include: dir/a.yaml\n")},
                        {"dir/a.yaml", "plugins:\n  - libx.so\n"}}),
            "dir/a.yaml:2:5: plug-in 'libx.so': there is no such file");
  EXPECT_EQ(load_error({{"small.yaml", small_scenario("")}}, {"libx.so", plugin("foreign")}),
            "--plugin libx.so: there is no such file\n--plugin " + plugin("foreign") +
                ": it is not a plug-in: there is no EYRIE_PLUGIN in it");
}

TEST(PluginScenario, IsToldOfAMistakeInAModelOfAPlugin) {
  EXPECT_EQ(
      load_error(
          {{"small.yaml",
            small_scenario("data: {aircraft: {mine: {base: f16c, airframe: brick}}}\n", "mine")}},
          {plugin("good"), plugin("broken")}),
      "plugin:libbroken.so/airframes/brick.yaml:2:13: empty_mass: expected a mass such as "
      "'900 kg', got '2 nmi' (a length)");
}

TEST(PluginScenario, IsToldOfAMistakeInAModelThatNobodyFlies) {
  EXPECT_EQ(load_error({{"small.yaml", small_scenario("")}}, {plugin("good"), plugin("broken")}),
            "plugin:libbroken.so/airframes/brick.yaml:2:13: empty_mass: expected a mass such as "
            "'900 kg', got '2 nmi' (a length)");
}

TEST(PluginScenario, LoadsNothingOutOfABundle) {
  const std::string text = small_scenario("plugins: nowhere/libx.so\n");
  Source bundle = Source::bundle({{"small.yaml", text}});
  try {
    static_cast<void>(scenario::load({"small.yaml"}, std::move(bundle)));
    FAIL() << "the nodes are not there";
  } catch (const ConfigError& e) {
    EXPECT_NE(std::string(e.what()).find("there is no node 'last_word'"), std::string::npos)
        << e.what();
  }
}

}  // namespace
}  // namespace eyrie::test
