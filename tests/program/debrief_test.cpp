// SPDX-License-Identifier: MIT
/// \file  The debrief page and the exports as a user has them.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "support/program.hpp"

namespace eyrie::test {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

/// A minute of the sweep, flown once.
struct ShortRun {
  ShortRun() {
    const Ran ran =
        run_program(folder, {"fly", "sweep", "--until", "1 min", "--quiet", "--out", "run"});
    EXPECT_EQ(ran.code, 0) << ran.err;
    out = ran.out;
  }
  TempFolder folder;
  std::string out;
};
const ShortRun& short_run() {
  static const ShortRun run;
  return run;
}
Ran ask(const std::vector<std::string>& arguments, const RunOptions& options = {}) {
  return run_program(short_run().folder, arguments, options);
}
std::string file(const std::string& name) {
  return short_run().folder / name;
}
std::string text_of(const std::string& name) {
  std::ifstream in(file(name), std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}
std::size_t count(const std::string& text, const std::string& word) {
  std::size_t n = 0;
  for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at + 1))
    ++n;
  return n;
}

constexpr const char* kRunTag = "<script type=\"application/x-eyrie-run\">";

TEST(DebriefProgram, FlyWritesThePageBesideTheRun) {
  EXPECT_NE(short_run().out.find("flight.acmi, debrief.html\n"), std::string::npos);
  EXPECT_EQ(count(text_of("run/debrief.html"), kRunTag), 1U);
  const Ran without =
      ask({"fly", "sweep", "--until", "10 s", "--quiet", "--no-debrief", "--out", "without"});
  EXPECT_EQ(without.code, 0);
  EXPECT_FALSE(fs::exists(file("without/debrief.html")));
}

TEST(DebriefProgram, FliesWithoutTheViewerAndSaysWhatIsMissing) {
  const Ran ran = ask({"fly", "sweep", "--until", "10 s", "--quiet", "--out", "no-viewer"},
                      {.viewer = "/nowhere/debrief.html"});
  EXPECT_EQ(ran.code, 0);
  EXPECT_NE(ran.err.find("debrief page is not built: it needs npm"), std::string::npos);
  EXPECT_TRUE(fs::exists(file("no-viewer/run.eyrie")));
  EXPECT_FALSE(fs::exists(file("no-viewer/debrief.html")));
  EXPECT_EQ(ask({"debrief", "run"}, {.viewer = "/nowhere/debrief.html"}).code, 1);
}

TEST(DebriefProgram, MakesTheSamePageAgain) {
  const std::string flown = text_of("run/debrief.html");
  const Ran ran = ask({"debrief", "run", "--out", "again.html"});
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(text_of("again.html"), flown);
  const Ran taken = ask({"debrief", "run", "--out", "again.html"});
  EXPECT_EQ(taken.code, 2);
  EXPECT_NE(taken.err.find("'again.html' exists already"), std::string::npos);
  EXPECT_EQ(ask({"debrief", "run", "--out", "again.html", "--force"}).code, 0);
}

TEST(DebriefProgram, ReplacesNoRunThatItIsMadeFrom) {
  const std::string run = text_of("run/run.eyrie");
  const Ran ran = ask({"debrief", "run", "--out", "run/../run/run.eyrie", "--force"});
  EXPECT_EQ(ran.code, 2);
  EXPECT_EQ(ran.err,
            "--out: 'run/../run/run.eyrie' is what it would be made from; name another file\n");
  EXPECT_TRUE(text_of("run/run.eyrie") == run);
}

TEST(DebriefProgram, PutsTwoRunsOnOnePage) {
  ASSERT_EQ(
      ask({"fly", "sweep", "--until", "20 s", "--seed", "2", "--quiet", "--out", "other"}).code, 0);
  const Ran ran = ask({"debrief", "run", "other", "--out", "two.html"});
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(count(text_of("two.html"), kRunTag), 2U);
  EXPECT_EQ(ask({"debrief", "run", "other", "run"}).code, 2);
  ASSERT_EQ(ask({"debrief", "run", "other"}).code, 0);
  EXPECT_EQ(ask({"debrief", "run", "run"}).code, 2) << "it takes no other page's place";
  EXPECT_EQ(ask({"debrief", "run", "run", "--force"}).code, 0);
}

TEST(DebriefProgram, RefusesWhatIsNoRunOfThisBuildWithWords) {
  const std::string whole = text_of("run/run.eyrie");
  std::ofstream(file("cut.eyrie"), std::ios::binary) << whole.substr(0, whole.size() / 2);
  std::ofstream(file("foreign.eyrie"), std::ios::binary) << "PK\3\4 something else altogether";
  for (const auto& [name, words] :
       {std::pair("cut.eyrie", "cut.eyrie: "), std::pair("foreign.eyrie", "foreign.eyrie: "),
        std::pair("missing.eyrie", "missing.eyrie")})
    for (const char* command : {"debrief", "explain", "export"}) {
      std::vector<std::string> words_of{command, name};
      if (std::string(command) == "explain")
        words_of.insert(words_of.end(), {"--player", "eagle1"});
      if (std::string(command) == "export")
        words_of.insert(words_of.end(), {"--to", "czml"});
      const Ran ran = ask(words_of);
      EXPECT_EQ(ran.code, 2) << command << " " << name;
      EXPECT_NE(ran.err.find(words), std::string::npos) << ran.err;
      EXPECT_EQ(count(ran.err, "\n"), 1U) << ran.err;
    }
  EXPECT_FALSE(fs::exists(file("debrief.html")));
}

TEST(DebriefProgram, LeavesNothingBehindOnAFullDisk) {
  const Ran ran = ask({"debrief", "run", "--out", "full.html"}, {.file_size_limit = 4096});
  EXPECT_EQ(ran.code, 1);
  EXPECT_NE(ran.err.find("cannot write"), std::string::npos) << ran.err;
  for (const auto& entry : fs::directory_iterator(short_run().folder.path()))
    EXPECT_EQ(entry.path().filename().string().find("full.html"), std::string::npos);
}

TEST(ExportProgram, WritesCzmlWithPathsAndLabels) {
  const Ran ran = ask({"export", "run", "--to", "czml"});
  EXPECT_EQ(ran.code, 0) << ran.err;
  const json packets = json::parse(text_of("run/run.czml"));
  EXPECT_EQ(packets[0]["id"], "document");
  EXPECT_EQ(packets[0]["version"], "1.0");
  ASSERT_GE(packets.size(), 7U);  // and six aircraft, and lines between them
  const json& eagle = packets[1];
  EXPECT_EQ(eagle["name"], "eagle1");
  const json& samples = eagle["position"]["cartographicDegrees"];
  ASSERT_EQ(samples.size() % 4, 0U);
  EXPECT_EQ(samples.size() / 4, 61U);                   // a point a second
  EXPECT_NEAR(samples[1].get<double>(), -69.78, 0.01);  // longitude first
  EXPECT_NEAR(samples[2].get<double>(), 32.987, 0.01);
  EXPECT_NEAR(samples[3].get<double>(), 7620, 30);  // 25,000 ft
  EXPECT_EQ(eagle["label"]["text"][0]["string"], "eagle1  navigate 10");
}

TEST(ExportProgram, WritesGeoJsonByTheRules) {
  ASSERT_EQ(ask({"export", "run", "--to", "geojson"}).code, 0);
  const json all = json::parse(text_of("run/run.geojson"));
  EXPECT_EQ(all["type"], "FeatureCollection");
  std::map<std::string, std::size_t> seconds;  // by aircraft
  for (const json& feature : all["features"]) {
    EXPECT_EQ(feature["type"], "Feature");
    ASSERT_TRUE(feature.contains("properties"));
    const json& geometry = feature["geometry"];
    if (feature["properties"]["kind"] == "route") {
      EXPECT_GT(geometry["coordinates"][0].size(), 40U) << "legs are straight on the map";
    }
    if (feature["properties"]["kind"] != "aircraft")
      continue;
    ++seconds[feature["properties"]["name"]];
    ASSERT_EQ(geometry["type"], "MultiLineString");
    EXPECT_EQ(geometry["coordinates"][0].size(), 2U);
    EXPECT_EQ(feature["properties"]["begin"].get<std::string>().size(), 23U);
  }
  EXPECT_EQ(seconds.size(), 6U);
  EXPECT_EQ(seconds["eagle1"], 60U) << "a feature for each";
}

TEST(ExportProgram, WritesAPointForWhoStands) {
  const TempFolder folder;
  ASSERT_EQ(run_program(folder, {"fly", "convoy", "--until", "7 min", "--quiet", "--no-debrief",
                                 "--out", "there"})
                .code,
            0);
  ASSERT_EQ(run_program(folder, {"export", "there", "--to", "geojson"}).code, 0);
  std::size_t points = 0;
  const json all = json::parse(read_text(folder / "there/run.geojson"));
  for (const json& feature : all["features"])
    if (feature["geometry"]["type"] == "MultiLineString") {
      for (const json& line : feature["geometry"]["coordinates"])
        EXPECT_NE(line.front(), line.back());
    } else {
      points += feature["properties"]["kind"] == "vehicle";
    }
  EXPECT_GT(points, 10U);
}

TEST(ExportProgram, CutsLinesAtThe180thMeridianAlsoWhereAPointIsOnIt) {
  const TempFolder folder;
  ASSERT_EQ(run_program(folder, {"fly", "sweep", "--set", "reference.longitude=180 deg", "--until",
                                 "2 s", "--quiet", "--no-debrief", "--out", "there"})
                .code,
            0);
  ASSERT_EQ(run_program(folder, {"export", "there", "--to", "geojson"}).code, 0);
  std::size_t lines = 0, on_it = 0;
  const json all = json::parse(read_text(folder / "there/run.geojson"));
  for (const json& feature : all["features"]) {
    if (feature["geometry"]["type"] != "MultiLineString")
      continue;
    for (const json& line : feature["geometry"]["coordinates"]) {
      ++lines;
      EXPECT_GT(line.size(), 1U);
      for (std::size_t i = 0; i < line.size(); ++i) {
        const double longitude = line[i][0];
        on_it += std::fabs(longitude) == 180;
        EXPECT_LT(std::fabs(longitude - line[i > 0 ? i - 1 : 0][0].get<double>()), 10) << line;
      }
    }
  }
  EXPECT_GT(lines, 10U);
  EXPECT_GT(on_it, 0U);
}

TEST(ExportProgram, WritesDecisionsOfAllOrOfOne) {
  ASSERT_EQ(ask({"export", "run", "--to", "decisions", "--out", "all.csv"}).code, 0);
  ASSERT_EQ(
      ask({"export", "run", "--to", "decisions", "--player", "eagle2", "--out", "d.csv"}).code, 0);
  const std::string all = text_of("all.csv"), one = text_of("d.csv");
  EXPECT_EQ(count(all, "time_s,step,player"), 1U);
  for (const char* who : {",eagle1,", ",eagle4,", ",bogey2,"}) {
    EXPECT_NE(all.find(who), std::string::npos);
    EXPECT_EQ(one.find(who), std::string::npos);
  }
  EXPECT_EQ(count(all, ",eagle2,veteran,"), count(one, "\n") - 1);
  const Ran czml = ask({"export", "run", "--to", "czml", "--player", "eagle1"});
  EXPECT_EQ(czml.code, 2);
  for (int times = 0; times < 2; ++times)
    EXPECT_EQ(ask({"export", "run", "--to", "decisions"}).code, 0);
  const std::vector<std::string> part{"export", "run", "--to", "decisions", "--player", "eagle2"};
  EXPECT_EQ(ask(part).code, 2) << "what holds less takes the place of nothing";
}

}  // namespace
}  // namespace eyrie::test
