// SPDX-License-Identifier: MIT
/// \file  Plug-ins through the real program: flown, listed, recorded, replayed and refused.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>

#include "record/run_file.hpp"
#include "support/plugin.hpp"
#include "support/program.hpp"

namespace eyrie::test {
namespace {

/// Names libgood.so, which the folder has beside it.
const std::string kWithPlugin = R"(eyrie: 1
name: plugged
plugins: [lib/libgood.so]
reference: {latitude: 33 deg, longitude: -68 deg}
until: 5 s
trees:
  pilot: {last_word: [navigate, {hold_course: {course: 40 deg}}]}
blue:
  flights:
    eagle:
      aircraft: f16_without_radar
      tree: pilot
      players: [eagle1]
      start: {north: 0 nmi, east: 0 nmi, altitude: 20000 ft, heading: 90 deg, speed: 450 kt}
)";

class PluggedProgram : public testing::Test {
 protected:
  PluggedProgram() {
    folder.write("dir/plugged.yaml", kWithPlugin);
    std::filesystem::create_directory(folder / "dir/lib");
    std::filesystem::copy(plugin("good"), folder / "dir/lib/libgood.so");
  }
  /// The user trusts libgood.so as it is now.
  void trust() { ASSERT_EQ(trusting({"trust", "dir/lib/libgood.so"}).code, 0); }
  [[nodiscard]] Ran trusting(const std::vector<std::string>& arguments) const {
    return run_program(folder, arguments, {.config = config.path()});
  }
  [[nodiscard]] Ran fly() const {
    return trusting({"fly", "dir/plugged.yaml", "--out", "run", "--json"});
  }

  TempFolder folder, config;
};

TEST_F(PluggedProgram, FindsThePluginBesideTheScenario) {
  trust();
  EXPECT_EQ(trusting({"validate", "dir/plugged.yaml"}).out,
            "dir/plugged.yaml: 1 aircraft in 1 flight, 1 tree\n");
  const Ran ran = fly();
  EXPECT_EQ(ran.code, 0) << ran.err;
  const auto run = record::read_run_file(folder / "run/run.eyrie").run;
  ASSERT_EQ(run.plugins.size(), 1u);
  EXPECT_EQ(run.plugins[0].path,
            std::filesystem::canonical(folder / "dir/lib/libgood.so").string());
  // an arbiter of a plug-in is traced as any other
  EXPECT_NE(read_text(folder / "run/debrief.html").find("type=\"application/x-eyrie-run\""),
            std::string::npos)
      << "the page of a plug-in's run has columns: its engine cannot fly that";
  const Ran why = trusting({"explain", "run", "--player", "eagle1", "--at", "1"});
  EXPECT_EQ(why.code, 0) << why.err;
  EXPECT_NE(why.out.find("> last_word"), std::string::npos) << why.out;
}

/// With the file that the README puts it into the sweep by, which is the one that `new` writes.
TEST_F(PluggedProgram, FliesTheBehaviorOfTheReadmeInTheSweepAndSeesItWin) {
  const std::string page = read_text(source_root() + "/README.md");
  const std::size_t begin = page.find("```yaml\nextends:") + 8;
  const std::string sweep = page.substr(begin, page.find("```", begin) - begin);
  ASSERT_EQ(run_program(folder, {"new", "behavior", "greet"}).code, 0);
  const std::string written = read_text(folder / "greet/greet.yaml");
  EXPECT_EQ(written.substr(written.find('\n') + 1), sweep);
  EXPECT_EQ(written.substr(0, written.find('\n')),
            "# yaml-language-server: $schema=build/greet.schema.json");

  std::filesystem::create_directories(folder / "greet/build");
  std::filesystem::copy_file(plugin("greet"), folder / "greet/build/libgreet.so");
  const std::string library = folder / "greet/build/libgreet.so";
  const Ran ran = run_program(folder, {"fly", "greet/greet.yaml", "--plugin", library, "--until",
                                       "1 min", "--quiet", "--no-debrief"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  const Ran why =
      run_program(folder, {"explain", "runs/greet-19", "--player", "eagle1", "--plugin", library});
  EXPECT_TRUE(
      std::regex_search(why.out, std::regex("navigate +-> greet +navigate voted 10 against 50")))
      << why.out << why.err;
}

TEST_F(PluggedProgram, TakesPluginsFromTheCommandLine) {
  std::string without = kWithPlugin;
  without.erase(without.find("plugins:"), without.find("reference") - without.find("plugins:"));
  folder.write("x.yaml", without);
  EXPECT_EQ(run_program(folder, {"validate", "x.yaml"}).code, 2);
  EXPECT_EQ(run_program(folder, {"validate", "--plugin", plugin("good"), "x.yaml"}).code, 0);
  EXPECT_EQ(run_program(folder, {"fly", "--plugin", plugin("good"), "x.yaml", "--quiet"}).code, 0);
  EXPECT_EQ(run_program(folder, {"replay", "runs/plugged-1", "--plugin", plugin("good")}).code, 0);
}

TEST_F(PluggedProgram, ListsTheOriginInEveryFormOfTheCatalog) {
  const auto listed = [&](std::vector<std::string> how) {
    how.insert(how.begin(), {"catalog", "--plugin", plugin("good")});
    const Ran ran = run_program(folder, how);
    EXPECT_EQ(ran.code, 0) << ran.err;
    return ran.out;
  };
  const auto has = [](const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << part;
  };
  has(listed({}), "flies straight on (of libgood.so)\n");
  has(listed({}), "f16_without_radar of libgood.so");
  has(listed({"--markdown"}),
      "#### last_word\n\nThe proposal of the last. Below it: `children`.\n"
      "\nFrom the plug-in `libgood.so`.\n");
  has(listed({"--markdown"}), "\n`f16_without_radar` is from the plug-in `libgood.so`.\n");
  const auto schema = nlohmann::json::parse(listed({"--json-schema"}))["definitions"];
  EXPECT_EQ(schema["node"]["anyOf"][1]["properties"]["hold_course"]["description"],
            "flies straight on (behavior of libgood.so)");
  has(schema["model.aircraft"]["description"], "; f16_without_radar is of libgood.so");
}

TEST_F(PluggedProgram, RefusesWithWordsAndCode2) {
  const auto expect = [&](const std::vector<std::string>& arguments, const std::string& words) {
    const auto before = folder.everything();
    const Ran ran = run_program(folder, arguments);
    EXPECT_EQ(ran.code, 2);
    EXPECT_EQ(ran.err, words + "\n");
    EXPECT_EQ(ran.out, "");
    EXPECT_EQ(folder.everything(), before);
  };
  expect({"catalog", "--plugin", "libx.so"}, "--plugin libx.so: there is no such file");
  expect({"validate", "merge", "--plugin", "dir/plugged.yaml"},
         "--plugin dir/plugged.yaml: it is not a shared library");
  expect({"fly", "merge", "--plugin", plugin("throwing")},
         "--plugin " + plugin("throwing") + ": it failed while it was adding: no licence found");
  std::filesystem::remove(folder / "dir/lib/libgood.so");
  expect({"fly", "dir/plugged.yaml"},
         "dir/plugged.yaml:3:11: plug-in 'lib/libgood.so': there is no such file");
  for (const auto& [name, words] :
       {std::pair{"old", "it was built for Eyrie 0.0.9, this is "},
        std::pair{"taken", "there is already a node 'pursue' (of eyrie)\n"},
        std::pair{"unresolved", "it uses 'eyrie::pilot::nowhere(double)', which is nowhere"}}) {
    std::filesystem::copy(plugin(name), folder / "dir/lib/libgood.so",
                          std::filesystem::copy_options::overwrite_existing);
    trust();
    const Ran ran = trusting({"fly", "dir/plugged.yaml"});
    EXPECT_EQ(ran.code, 2);
    EXPECT_TRUE(ran.err.starts_with("dir/plugged.yaml:3:11: plug-in 'lib/libgood.so': " +
                                    std::string(words)))
        << ran.err;
  }
}

TEST_F(PluggedProgram, ReplaysWithTheSamePluginFromAnywhere) {
  trust();
  ASSERT_EQ(fly().code, 0);
  const TempFolder elsewhere;
  const Ran ran = run_program(elsewhere, {"replay", folder / "run"},
                              {.home = "/nowhere", .config = config.path()});
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(ran.out.find(": the same, 250 steps"), std::string::npos) << ran.out;
}

TEST_F(PluggedProgram, OpensTwoRunsOfWhichOneHasThePlugin) {
  ASSERT_EQ(trusting({"fly", "merge", "--until", "5 s", "--no-debrief", "--out", "bare"}).code, 0);
  trust();
  ASSERT_EQ(fly().code, 0);
  std::filesystem::create_directory(folder / "other");
  std::filesystem::copy(plugin("old"), folder / "other/libgood.so");
  const std::string mine = plugin("good");
  EXPECT_EQ(run_program(folder, {"diff", "bare", "run", "--plugin", mine}).err,
            "bare/run.eyrie and run/run.eyrie have other players: viper1 is eagle1 in the other\n");
  // of two of that name it takes the one with the bytes of the run
  EXPECT_EQ(run_program(folder, {"diff", "bare", "run", "--plugin", folder / "other/libgood.so",
                                 "--plugin", mine})
                .err,
            "--plugin: these runs have no plug-in 'libgood.so'\n");
  EXPECT_EQ(
      run_program(folder, {"diff", "bare", "run", "--plugin", mine, "--plugin", plugin("magic")})
          .err,
      "--plugin: these runs have no plug-in 'libmagic.so'\n");
}

TEST_F(PluggedProgram, ReplaysOnlyWithTheVeryFileOfTheRun) {
  trust();
  ASSERT_EQ(fly().code, 0);
  const std::string file = std::filesystem::canonical(folder / "dir/lib/libgood.so");
  const auto expect = [&](std::vector<std::string> more, const std::string& words) {
    more.insert(more.begin(), {"replay", "run"});
    const Ran ran = trusting(more);
    EXPECT_EQ(ran.code, 2);
    EXPECT_EQ(ran.err, words + "\n");
  };
  expect({"--plugin", plugin("old")}, "run/run.eyrie: the run has no plug-in 'libold.so'");

  std::filesystem::rename(file, folder / "libgood.so");
  expect({}, "run/run.eyrie: the run needs the plug-in " + file +
                 ", which is not there; --plugin (in Python plugins=) says where it is now");
  const Ran moved = run_program(folder, {"replay", "run", "--plugin", "libgood.so"});
  EXPECT_EQ(moved.code, 0) << moved.err;
  std::filesystem::copy(folder / "libgood.so", folder / "renamed.so");
  const Ran renamed = run_program(folder, {"replay", "run", "--plugin", "renamed.so"});
  EXPECT_EQ(renamed.code, 0) << renamed.err;
  EXPECT_EQ(renamed.out, moved.out);

  std::ofstream(folder / "libgood.so", std::ios::binary | std::ios::app) << "x";
  expect({"--plugin", "libgood.so"},
         "run/run.eyrie: libgood.so is not the libgood.so of the run: it has other bytes");
}

}  // namespace
}  // namespace eyrie::test
