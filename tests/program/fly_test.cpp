// SPDX-License-Identifier: MIT
/// \file  `eyrie fly` as its user sees it: words, JSON, folders, and what it says when the disk
/// fails.
#include <gtest/gtest.h>

#include <csignal>

#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "support/program.hpp"
#include "support/small_scenario.hpp"

namespace eyrie::test {
namespace {

using nlohmann::json;
using Names = std::vector<std::string>;

/// Thirty seconds of the merge: cheap, with a contact in it.
Names merge(Names more) {
  Names all{"fly", "merge", "--until", "30 s"};
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

bool has(const std::string& text, const std::string& pattern) {
  return std::regex_search(text, std::regex(pattern));
}
std::ptrdiff_t times(const std::string& text, const std::string& pattern) {
  const std::regex all(pattern);
  return std::distance(std::sregex_iterator(text.begin(), text.end(), all), {});
}

TEST(FlyWords, TellHeaderStoryAndClosingTable) {
  const TempFolder folder;
  const Ran ran = run_program(folder, {"fly"});  // the default is the sweep
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(ran.err, "");
  EXPECT_EQ(ran.out.find('\x1b'), std::string::npos) << "colour is for terminals";

  // header
  EXPECT_TRUE(ran.out.starts_with("sweep: four F-15s")) << ran.out.substr(0, 80);
  EXPECT_TRUE(has(ran.out, R"(\bseed \d+, blue eagle 4 x F-15C, red bogey 2 x MiG-29S\n)"));
  // story: time, who, what, range, in the field's words
  for (const char* line :
       {R"(\n \d\d:\d\d\.\d  eagle\d     contact, \d+\.\d nmi\n)",
        R"(\n \d\d:\d\d\.\d  eagle\d     bogey\d is hostile, \d+\.\d nmi\n)",
        R"(\n \d\d:\d\d\.\d  eagle\d     commit on bogey\d, \d+\.\d nmi\n)",
        R"(\n \d\d:\d\d\.\d  eagle\d     fox 3 on bogey\d, \d+\.\d nmi \(AIM-120\)\n)",
        R"(\n \d\d:\d\d\.\d  bogey\d     defending: )",
        R"(\n \d\d:\d\d\.\d  eagle1     eagle flight: ingress\n)", R"(eagle flight: bvr\n)",
        R"(eagle flight: egress\n)", R"(\n \d\d:\d\d\.\d  eagle\d     is home\n)"})
    EXPECT_TRUE(has(ran.out, line)) << line;
  // closing table
  EXPECT_TRUE(has(ran.out, R"(\nplayer +side +shots +kills +end +fuel +phase +by\n)"));
  EXPECT_TRUE(has(ran.out, R"(\neagle1 +blue +\d+ +\d+  (home|lost) [0-9:.]+ +\d+ lb  )"))
      << ran.out;
  EXPECT_TRUE(has(ran.out, R"(\nbogey\d [^\n]*lost [^\n]*eagle\d.s AIM-120 from \d+\.\d nmi\n)"))
      << ran.out;
  for (const char* who : {"eagle1", "eagle2", "eagle3", "eagle4"})
    EXPECT_TRUE(
        has(ran.out, std::string("\n") + who + R"( +blue +\d+ +\d+  (home|lost) \d\d:\d\d\.\d)"))
        << who;
  EXPECT_TRUE(has(ran.out, R"(\nbogey1 +red +\d+ +\d+  )"));
  EXPECT_TRUE(has(ran.out, R"(\neagle ingress \d\d:\d\d\.\d +eagle bvr )"));
  std::smatch losses;
  ASSERT_TRUE(std::regex_search(
      ran.out, losses, std::regex(R"(\nblue is home, \d of 4; losses: blue (\d), red (\d)\n)")));
  const std::string splash = R"(\n \d\d:\d\d\.\d  \w+\d     splash )";
  EXPECT_EQ(times(ran.out, splash + R"(eagle\d \()"), std::stoi(losses[1]));
  EXPECT_EQ(times(ran.out, splash + R"(bogey\d \()"), std::stoi(losses[2]));
  EXPECT_TRUE(has(ran.out, splash)) << "a sweep in which nobody is shot down tells little";
  EXPECT_TRUE(has(ran.out, R"(\nworld hash 0x[0-9a-f]{16} after \d+ steps\n)"));
  EXPECT_TRUE(has(ran.out, R"(\n\d+ s flown in \d+\.\d+ s, \d+ x real time\n)"));
  std::smatch seed;
  ASSERT_TRUE(std::regex_search(ran.out, seed, std::regex(R"(\bseed (\d+),)")));
  const std::string place = "runs/sweep-" + seed[1].str();
  EXPECT_TRUE(ran.out.ends_with("written to " + place +
                                ": run.eyrie, events.csv, flight.acmi, debrief.html\n"));
  EXPECT_EQ(folder.everything(),
            (Names{"runs", "runs/latest", place, place + "/debrief.html", place + "/events.csv",
                   place + "/flight.acmi", place + "/run.eyrie"}));
}

TEST(FlyWords, HaveRoomForLongNames) {
  const TempFolder folder;
  const std::string name = "a_flight_that_has_a_rather_long_name";
  folder.write("x.yaml",
               changed_scenario({{"eagle:", name + ":"}, {"[eagle1, eagle2]", "[" + name + "1]"}}));
  const Ran ran = run_program(folder, {"fly", "x.yaml", "--no-debrief"});
  EXPECT_TRUE(has(ran.out, "\nplayer {32}side  shots[^\n]*\n" + name + "1 blue      0 "))
      << ran.out;
}

TEST(FlyQuiet, TellsOnlyHowItEnded) {
  const TempFolder folder;
  const Ran ran = run_program(folder, merge({"--quiet"}));
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(ran.out.find("contact"), std::string::npos) << ran.out;
  EXPECT_EQ(ran.out.find("seed"), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find("time is up at 00:30.0"), std::string::npos) << ran.out;
}

TEST(FlyJson, IsOneObjectWithTheKeysThatScriptsRelyOn) {
  const TempFolder folder;
  const Ran ran = run_program(
      folder, {"fly", "eyrie:scenarios/sweep.yaml", "--seed", "5", "--json", "--out", "here"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(ran.err, "");
  const json j = json::parse(ran.out);  // throws for anything behind the object
  ASSERT_TRUE(j.is_object());
  EXPECT_EQ(j["scenario"], "sweep");
  EXPECT_EQ(j["seed"], 5);
  ASSERT_TRUE(j["steps"].is_number_unsigned());
  EXPECT_NEAR(j["sim_time_s"].get<double>(), j["steps"].get<double>() * 0.02, 1e-6);
  EXPECT_GT(j["wall_time_s"].get<double>(), 0);
  EXPECT_NEAR(j["realtime_factor"].get<double>(),
              j["sim_time_s"].get<double>() / j["wall_time_s"].get<double>(), 1);
  EXPECT_TRUE(has(j["hash"].get<std::string>(), "^0x[0-9a-f]{16}$"));
  ASSERT_TRUE(j["phases"].is_array());
  double last = 0;
  for (const json& phase : j["phases"]) {
    EXPECT_TRUE(phase["flight"] == "eagle" || phase["flight"] == "bogey");
    EXPECT_TRUE(phase["phase"].is_string());
    EXPECT_GE(phase["time_s"].get<double>(), last);
    last = phase["time_s"].get<double>();
  }
  for (const char* side : {"blue", "red"})
    for (const char* key : {"players", "losses", "shots", "kills"})
      EXPECT_TRUE(j["sides"][side][key].is_number_unsigned()) << side << key;
  EXPECT_EQ(j["sides"]["blue"]["players"], 4);
  EXPECT_EQ(j["sides"]["red"]["players"], 2);
  const std::set<std::string> outcomes{"blue_home", "blue_lost", "red_lost", "time"};
  EXPECT_TRUE(outcomes.contains(j["outcome"].get<std::string>()));
  EXPECT_EQ(j["run_dir"], "here");
}

TEST(FlyJson, SaysTheSameForTheSameSeedAndOtherForAnother) {
  const TempFolder folder;
  const auto hash = [&](const Names& more) {
    return json::parse(run_program(folder, merge(more)).out)["hash"].get<std::string>();
  };
  const std::string first = hash({"--json"});
  EXPECT_EQ(hash({"--json", "--workers", "3"}), first);
  EXPECT_EQ(hash({"--json", "--seed", "4"}), first);
  EXPECT_EQ(hash({"--json", "--paranoid"}), first);
  EXPECT_EQ(hash({"--json", "--paranoid", "3", "--workers", "2"}), first);
  EXPECT_NE(hash({"--json", "--seed", "2"}), first);
  EXPECT_NE(hash({"--json", "--set", "blue.flights.viper.players.viper1.fuel=2000 kg"}), first);
}

TEST(FlySet, ReachesFlightsPlayersAndLists) {
  const TempFolder folder;
  const Ran ran =
      run_program(folder, merge({"--json", "--set", "seed=9", "--set", "name=mine", "--set",
                                 "red.flights.bandit.route.0.altitude=15000 ft"}));
  ASSERT_EQ(ran.code, 0) << ran.err;
  const json j = json::parse(ran.out);
  EXPECT_EQ(j["seed"], 9);
  EXPECT_EQ(j["scenario"], "mine");
  EXPECT_EQ(j["sim_time_s"], 30) << "--until is stronger than the file";
  EXPECT_EQ(j["run_dir"], "runs/mine-9");
}

TEST(FlyOut, NumbersItsOwnFoldersAndNeverWritesOverOne) {
  const TempFolder folder;
  for (const char* wanted : {"runs/merge-4", "runs/merge-4.2", "runs/merge-4.3"}) {
    const Ran ran = run_program(folder, merge({"--json"}));
    ASSERT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(json::parse(ran.out)["run_dir"], wanted);
  }
  EXPECT_EQ(read_text(folder / "runs/merge-4/events.csv"),
            read_text(folder / "runs/merge-4.3/events.csv"));
  EXPECT_EQ(read_text(folder / "runs/merge-4/run.eyrie"),
            read_text(folder / "runs/merge-4.3/run.eyrie"));
  EXPECT_EQ(std::filesystem::read_symlink(folder / "runs/latest"), "merge-4.3");
  EXPECT_EQ(run_program(folder, {"replay", "runs/latest"}).code, 0);
}

TEST(FlyOut, LinksTheLatestRunWhoeverElseFlies) {
  const TempFolder folder;
  const Ran ran = run_line(folder,
                           "for i in 1 2 3 4 5 6; do \"$EYRIE\" fly merge --until '5 s' --json "
                           "--no-debrief & done; wait");
  EXPECT_EQ(ran.err, "");
  EXPECT_TRUE(std::filesystem::exists(folder / "runs/latest/run.eyrie"));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder / "runs"), {}), 7);
}

TEST(FlyOut, ReplacesNothingButALinkByTheLatest) {
  const TempFolder folder;
  folder.write("runs/latest/mine", "kept");
  const Ran ran = run_program(folder, merge({"--json"}));
  EXPECT_EQ(ran.code, 1);
  EXPECT_EQ(ran.err, "eyrie: 'runs/latest' is a folder, and not made a link to 'merge-4'\n");
  EXPECT_EQ(read_text(folder / "runs/latest/mine"), "kept");
}

TEST(FlyWatch, FliesAgainWhenAFileChangesIntoTheSameFolder) {
  const TempFolder folder;
  folder.write("x.yaml", kSmallScenario);
  const Ran ran = run_line(folder, R"sh(
    flown() { until [ "$(grep -c waiting said)" = $1 ]; do sleep 0.02; done; }
    "$EYRIE" fly x.yaml --watch --quiet --no-debrief 2>said & flying=$!
    flown 1; sed -i 's/until: 2 s/until: 3 s/' x.yaml
    flown 2; sed -i 's/winner_takes_all/winner_takes_al/' x.yaml
    flown 3; sed -i 's/winner_takes_al:/winner_takes_all:/; s/until: 3 s/until: 4 s/' x.yaml
    flown 4; kill -TERM $flying; wait $flying)sh");
  EXPECT_EQ(ran.code, 128 + SIGTERM);
  const std::string said = read_text(folder / "said");
  EXPECT_NE(said.find("did you mean 'winner_takes_all'"), std::string::npos) << said;
  for (const char* seconds : {"2 s flown", "3 s flown", "4 s flown"})
    EXPECT_NE(ran.out.find(seconds), std::string::npos) << ran.out << said;
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder / "runs"), {}), 2);
}

/// An editor that saves renames the old file first.
TEST(FlyWatch, WaitsForAScenarioThatIsAwayForAMoment) {
  const TempFolder folder;
  folder.write("x.yaml", kSmallScenario);
  const Ran ran = run_line(folder, R"sh(
    flown() { until [ "$(grep -c waiting said)" = $1 ]; do sleep 0.02; done; }
    "$EYRIE" fly x.yaml --watch --quiet --no-debrief 2>said & flying=$!
    flown 1; mv x.yaml away
    flown 2; sed 's/until: 2 s/until: 3 s/' away >x.yaml
    flown 3; kill -TERM $flying; wait $flying)sh");
  EXPECT_EQ(ran.code, 128 + SIGTERM) << ran.err;
  EXPECT_NE(ran.out.find("3 s flown"), std::string::npos) << ran.out;
}

TEST(FlyOut, TakesAnEmptyFolderAndReplacesARunOnlyByForce) {
  const TempFolder folder;
  std::filesystem::create_directory(folder / "empty");
  EXPECT_EQ(run_program(folder, merge({"--quiet", "--out", "empty"})).code, 0);
  EXPECT_TRUE(std::filesystem::exists(folder / "empty/run.eyrie"));

  folder.write("full/kept", "precious");
  EXPECT_EQ(run_program(folder, merge({"--quiet", "--out", "full"})).code, 2);
  EXPECT_EQ(read_text(folder / "full/kept"), "precious");
  const Ran refused = run_program(folder, merge({"--quiet", "--out", "full", "--force"}));
  EXPECT_EQ(refused.code, 2);
  EXPECT_EQ(refused.err, "eyrie: 'full' has no run.eyrie: only the folder of a run is replaced\n");
  EXPECT_EQ(read_text(folder / "full/kept"), "precious");

  std::filesystem::copy(folder / "empty", folder / "old");
  const std::string other = read_text(folder / "old/run.eyrie");
  EXPECT_EQ(run_program(folder, merge({"--quiet", "--out", "old", "--force", "--seed", "2"})).code,
            0);
  EXPECT_NE(read_text(folder / "old/run.eyrie"), other);
}

TEST(FlyOut, SaysThatAFolderCannotBeMade) {
  const TempFolder folder;
  folder.write("file", "kept");
  const Ran ran = run_program(folder, merge({"--out", "file/below"}));
  EXPECT_EQ(ran.code, 2);
  EXPECT_EQ(ran.err, "eyrie: cannot make 'file/below': Not a directory\n");
  EXPECT_EQ(ran.out, "") << "nothing is flown that could not be written";
  EXPECT_EQ(folder.everything(), Names{"file"});
}

/// A limit on the size of files stands for a full disk: writes fail in the middle of the run.
TEST(FlyOut, SaysThatTheDiskIsFullAndLeavesNothing) {
  const TempFolder folder;
  const Ran ran = run_program(folder, {"fly", "sweep", "--quiet", "--out", "here"},
                              {.file_size_limit = 16 * 1024});
  EXPECT_EQ(ran.code, 1);
  EXPECT_TRUE(has(ran.err, "^eyrie: cannot write 'here/run.eyrie': File too large\n$")) << ran.err;
  EXPECT_EQ(folder.everything(), Names{});
}

TEST(FlyWatch, SeesChangesOfShippedFilesThatAScenarioExtends) {
  const TempFolder folder;
  folder.write("x.yaml", "extends: merge\nname: mine\n");
  const Ran ran = run_line(folder, R"sh(
    mkdir home; cp -r "$EYRIE_HOME"/data "$EYRIE_HOME"/scenarios home; export EYRIE_HOME=$PWD/home
    flown() { until [ "$(grep -c waiting said)" = $1 ]; do sleep 0.02; done; }
    "$EYRIE" fly x.yaml --until '5 s' --watch --quiet --no-debrief 2>said & flying=$!
    flown 1; echo '# changed' >>home/scenarios/merge.yaml
    flown 2; echo '# changed' >>home/data/aircraft/f16c.yaml
    flown 3; kill -TERM $flying; wait $flying)sh");
  EXPECT_EQ(ran.code, 128 + SIGTERM) << ran.err;
}

TEST(FlyWords, AreColoredOnATerminalThatWantsColors) {
  const TempFolder folder;
  const auto on_terminal = [&](const std::string& settings) {
    return run_line(folder, "script -qec '" + settings +
                                " \"$EYRIE\" fly merge --until \"5 s\" --no-debrief' shown "
                                "</dev/null >/dev/null; sed -e 1d -e '$d' shown")
        .out;
  };
  EXPECT_NE(on_terminal("TERM=xterm NO_COLOR=").find('\x1b'), std::string::npos);
  EXPECT_EQ(on_terminal("TERM=xterm NO_COLOR=1").find('\x1b'), std::string::npos);
  EXPECT_EQ(on_terminal("TERM=dumb NO_COLOR=").find('\x1b'), std::string::npos);
}

TEST(FlyRealTime, KeepsThePaceMeasuresItAndChangesNothing) {
  const TempFolder folder;
  const Names until{"fly", "merge", "--until", "4 s", "--json", "--no-debrief"};
  Names paced = until;
  paced.insert(paced.end(), {"--real-time", "4"});
  const Ran ran = run_program(folder, paced);
  ASSERT_EQ(ran.code, 0) << ran.err;
  const json j = json::parse(ran.out);
  EXPECT_GE(j["wall_time_s"].get<double>(), 0.98);
  const json& real = j["real_time"];
  EXPECT_EQ(real["frames"], 200);
  EXPECT_EQ(real["frame_s"], 0.005);
  EXPECT_LE(real["missed"].get<int>(), 200);
  EXPECT_GT(real["load"].get<double>(), 0);
  for (const char* of : {"late_s", "work_s"}) {
    const json& spread = real[of];
    EXPECT_GE(spread["p50"].get<double>(), 0);
    EXPECT_LE(spread["p50"], spread["p99"]);
    EXPECT_LE(spread["p99"], spread["p999"]);
    EXPECT_LE(spread["p999"], spread["max"]);
  }
  const json free = json::parse(run_program(folder, until).out);
  EXPECT_EQ(free["hash"], j["hash"]);
  EXPECT_FALSE(free.contains("real_time"));
}

TEST(FlyWords, ReadsEveryNumberAsADecimalOne) {
  const TempFolder folder;
  for (const char* seed : {"010", "08"}) {
    const Ran ran = run_program(
        folder, {"fly", "merge", "--seed", seed, "--until", "0.1 s", "--json", "--no-debrief"});
    ASSERT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(json::parse(ran.out)["seed"], std::stoi(seed));
  }
}

TEST(FlyRealTime, TellsPeopleHowWellTheClockWasKept) {
  const TempFolder folder;
  const Ran ran =
      run_program(folder, {"fly", "merge", "--until", "4 s", "--real-time", "20", "--quiet"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_TRUE(
      has(ran.out,
          R"(\nby the clock: \d+ of 200 frames of 1 ms missed; begun late by [0-9.]+ ms )"
          R"(\(p50\), [0-9.]+ \(p99\), [0-9.]+ \(p99\.9\), [0-9.]+ at most; load )"
          R"([0-9.]+ %, \d+ % at most; )"
          R"((before all others(, \d+ times? on another processor)?|no sooner than others)\n)"))
      << ran.out;
  EXPECT_FALSE(has(run_program(folder, merge({"--real-time", "max"})).out, "by the clock"));
}

TEST(FlyRealTime, KeepsTheRunWhenItIsStopped) {
  const TempFolder folder;
  const Ran ran = run_line(folder,
                           "\"$EYRIE\" fly merge --real-time 0.1 --out run >out 2>err & "
                           "until grep -q seed out; do sleep 0.05; done; sleep 0.5; "
                           "kill -TERM $!; wait $!");
  EXPECT_EQ(ran.code, 128 + SIGTERM);
  EXPECT_TRUE(has(read_text(folder / "out"), "by the clock: ")) << read_text(folder / "err");
  const Ran again = run_line(folder, "eyrie replay run");
  EXPECT_EQ(again.code, 0) << again.out << again.err;
}

TEST(Version, NamesProgramVersionAndCompiler) {
  const TempFolder folder;
  const Ran ran = run_program(folder, {"--version"});
  EXPECT_EQ(ran.code, 0);
  EXPECT_EQ(ran.err, "");
  EXPECT_TRUE(has(ran.out, R"(^eyrie \d+\.\d+\.\d+ \(\w+ [0-9.]+, \w+\)\n$)")) << ran.out;
}

}  // namespace
}  // namespace eyrie::test
