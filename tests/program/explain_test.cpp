// SPDX-License-Identifier: MIT
/// \file  explain, whatif and diff as a user has them.
#include <gtest/gtest.h>

#include <csignal>

#include <cmath>
#include <nlohmann/json.hpp>
#include <regex>

#include "support/program.hpp"

namespace eyrie::test {
namespace {

using nlohmann::json;

/// Two runs of the sweep, flown once.
struct RecordedRuns {
  RecordedRuns() {
    const std::vector<std::string> flight{"fly",    "sweep_phases", "--until",
                                          "11 min", "--quiet",      "--out"};
    auto a = flight, b = flight;
    a.insert(a.end(), {"a"});
    b.insert(b.end(), {"b", "--set", "trees.bvr.per_field.release_weapon.zone=0.3"});
    for (auto* flown : {&a, &b})
      flown->push_back("--no-debrief");
    EXPECT_EQ(run_program(folder, a).code, 0);
    EXPECT_EQ(run_program(folder, b).code, 0);
  }
  TempFolder folder;
};
Ran debriefed(const std::vector<std::string>& arguments) {
  static const RecordedRuns runs;
  return run_program(runs.folder, arguments);
}
bool says(const std::string& text, const std::string& pattern) {
  return std::regex_search(text, std::regex(pattern));
}

TEST(ExplainProgram, ShowsTheTreeOfOneDecisionWithItsWinners) {
  const Ran ran = debriefed({"explain", "a", "--player", "eagle2", "--at", "5:12.4"});
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_TRUE(
      says(ran.out, R"(eagle2 at 05:12\.4 \(step 15618\), by tree sweep: follow_lead leads)"))
      << ran.out;
  EXPECT_TRUE(says(ran.out, R"(\n>     follow_lead +running, votes 20: heading)"));
  EXPECT_TRUE(says(ran.out, R"(\n        break_turn +failed: no missile is known to come\n)"));
  EXPECT_TRUE(
      says(ran.out, R"(\n  heading +09\d° +follow_lead +voted 20 against 10 \(navigate 123°\)\n)"));
  // which of the two it is, is the sort's choice: pilot/sort_test.cpp
  EXPECT_TRUE(says(ran.out, R"(target #\d+ \(bogey\d\): identity hostile, range)"));
  EXPECT_TRUE(says(ran.out, "unseen never,")) << "no eye reaches so far";
}

TEST(ExplainProgram, ShowsWarningsAsTheyWerePerceived) {
  const Ran ran = debriefed({"explain", "a", "--player", "bogey1", "--event", "break"});
  EXPECT_TRUE(says(ran.out, R"(radar #\d+ \(eagle\d\): kind search, bearing)")) << ran.out;
  EXPECT_TRUE(says(ran.out, R"(missile #\d+ \(AIM-120 #\d+ of eagle\d\): bearing)"));
}

TEST(ExplainProgram, ListsWhoTookOverFromWhomAndWhy) {
  const Ran ran = debriefed({"explain", "a", "--player", "eagle2", "--changes"});
  EXPECT_EQ(ran.code, 0);
  EXPECT_TRUE(
      says(ran.out, R"(follow_lead +-> pursue +ingress was left for bvr: hostile_track holds)"));
  std::string all;
  for (const char* who : {"eagle1", "eagle2", "eagle3", "eagle4"})
    all += debriefed({"explain", "a", "--player", who, "--changes"}).out;
  EXPECT_TRUE(says(all, R"(pursue +-> release_weapon +pursue voted 40 against 60)")) << all;
  EXPECT_EQ(debriefed({"explain", "a", "--player", "eagle2"}).out, ran.out) << "the default";
}

TEST(ExplainProgram, LeadsFromEachLaunchToTheDecisionToRelease) {
  std::size_t decisions = 0, launches = 0;
  for (const char* who : {"eagle1", "eagle2", "eagle3", "eagle4", "bogey1", "bogey2"}) {
    const Ran ran = debriefed({"explain", "a", "--player", who, "--event", "fox"});
    for (const auto& [word, count] : {std::pair(" leads with ", &decisions),
                                      {" release_weapon   nobody else asked for it", &launches}})
      for (auto at = ran.out.find(word); at != ran.out.npos; at = ran.out.find(word, at + 1))
        ++*count;
  }
  const std::string story = debriefed({"explain", "a"}).out;
  std::size_t told = 0;
  for (auto at = story.find(" fox "); at != story.npos; at = story.find(" fox ", at + 1))
    ++told;
  EXPECT_GT(told, 1U);
  EXPECT_EQ(launches, told);
  EXPECT_EQ(decisions, told);
}

TEST(ExplainProgram, TellsOnWhichDecisionsARunTurned) {
  const Ran ran = debriefed({"explain", "a"});
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_TRUE(says(ran.out,
                   R"(eagle1 +fox 3 on bogey\d[^\n]*\n    eagle1: \d\d:\d\d\.\d  release_weapon )"))
      << ran.out;
  EXPECT_TRUE(says(ran.out, R"(splash bogey1 [^\n]*\n    bogey1: )")) << "what its victim did";
  EXPECT_TRUE(says(ran.out, R"(eagle flight: bvr\n    eagle1: \d\d:\d\d\.\d  pursue )"));
  EXPECT_TRUE(says(ran.out, R"(, target #\d+ \(bogey\d\), release AIM-120 at #\d+ \(bogey\d\)\n)"));
  EXPECT_FALSE(says(ran.out, R"(#\d+(,|\n)|store \d)")) << "a number without a name\n" << ran.out;
  const json moments = json::parse(debriefed({"explain", "a", "--json"}).out);
  ASSERT_GT(moments.size(), 5U);
  for (const json& moment : moments)
    EXPECT_LE(moment.at("decision").at("time_s"), moment.at("time")) << moment;
  const Ran at = debriefed({"explain", "a", "--at", "5:12"});
  EXPECT_EQ(at.code, 2);
  EXPECT_TRUE(says(at.err, "--at requires --player"));
}

TEST(ExplainProgram, FindsTheDecisionsAtEventsByAWordOfTheStory) {
  const Ran ran = debriefed({"explain", "a", "--player", "bogey1", "--event", "break"});
  EXPECT_EQ(ran.code, 0);
  EXPECT_TRUE(says(ran.out, R"(^\d\d:\d\d\.\d  bogey1 +defending: breaks.*\nbogey1 at )"));
  EXPECT_TRUE(says(ran.out, R"(break_turn leads with 80)"));
  EXPECT_EQ(debriefed({"explain", "a", "--player", "bogey1", "--event", "reak"}).code, 2);
  const json found = json::parse(
      debriefed({"explain", "a", "--player", "bogey1", "--event", "break", "--json"}).out);
  EXPECT_TRUE(
      says(found.at(0).at("events").at(0).get<std::string>(), "bogey1    defending: breaks"));
  const Ran none = debriefed({"explain", "a", "--player", "bogey1", "--event", "ditch"});
  EXPECT_EQ(none.code, 2);
  EXPECT_TRUE(says(none.err,
                   "^--event 'ditch': bogey1 had no such event in this run; it had "
                   "[a-z_, ]*launch[a-z_, ]*\n$"))
      << none.err;
}

TEST(ExplainProgram, SaysHowLongTheRunIsWhenATimeIsNotInIt) {
  const Ran at = debriefed({"explain", "a", "--player", "eagle2", "--at", "99:00"});
  EXPECT_EQ(at.code, 2);
  EXPECT_EQ(at.err, "--at '99:00': the run ends at 11:00.0\n");
  const Ran from = debriefed({"explain", "a", "--player", "eagle2", "--from", "20 min"});
  EXPECT_EQ(from.code, 2);
  EXPECT_EQ(from.err, "--from '20 min': the run ends at 11:00.0\n");
}

TEST(WhatIfProgram, RefusesWhatTheRecordedStatesCannotTell) {
  const auto ask = [](std::vector<std::string> more) {
    more.insert(more.begin(), {"whatif", "a", "--player", "eagle2"});
    return debriefed(more);
  };
  for (const char* set : {"seed=7", "until=1 s", "help=x", "name=x", "eyrie=1",
                          "plugins=/etc/passwd", "include=x.yaml"}) {
    const Ran ran = ask({"--set", set});
    EXPECT_EQ(ran.code, 2) << set;
    EXPECT_EQ(ran.out, "") << set;
    EXPECT_TRUE(says(ran.err, "^--set " + std::string(set) + ":1:1: whatif asks other trees; '"))
        << ran.err;
  }
  for (const char* set : {"orders=[]", "rates={kinematics: 50 Hz}", "environment={}",
                          "blue.flights.eagle.bingo=1000 kg"})
    for (const std::vector<std::string>& more :
         {std::vector<std::string>{}, {"--branch"}, {"--branch", "--seeds", "1"}}) {
      std::vector<std::string> words{"--set", set};
      words.insert(words.end(), more.begin(), more.end());
      const Ran ran = ask(words);
      EXPECT_EQ(ran.code, 2) << set;
      EXPECT_EQ(ran.out, "") << set;
      EXPECT_TRUE(says(ran.err, "use --seeds, without --branch\n$")) << ran.err;
    }
}

TEST(WhatIfProgram, FliesWhatChangesTheFlightOverSeeds) {
  const Ran ran = debriefed({"whatif", "a", "--player", "eagle2", "--set",
                             "blue.flights.eagle.loadout=[]", "--seeds", "1", "--json"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  const json all = json::parse(ran.out);
  EXPECT_FALSE(all.contains("decisions")) << "the recorded states were not asked";
  EXPECT_EQ(all["over_seeds"]["seeds"], 1);
}

TEST(ExplainProgram, GivesToolsTheSame) {
  const Ran ran =
      debriefed({"explain", "a", "--player", "eagle2", "--from", "300", "--to", "5:01", "--json"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  const json all = json::parse(ran.out);
  ASSERT_EQ(all.size(), 11u) << "ten decisions in a second: 05:00.0 to 05:01.0";
  const json& d = all.at(0);
  EXPECT_EQ(d.at("player"), "eagle2");
  EXPECT_EQ(d.at("leader"), "root/ingress/follow_lead");
  for (const json& field : d.at("action"))
    if (field.at("name") == "heading") {
      EXPECT_EQ(field.at("winner"), "root/ingress/follow_lead");
      EXPECT_EQ(field.at("rivals").at(0).at("node"), "root/ingress/navigate");
      EXPECT_EQ(field.at("unit"), "rad");
    }
  EXPECT_EQ(d.at("nodes").at(0).at("asked"), true);
  EXPECT_GT(d.at("state").size(), 20u);
}

TEST(ExplainProgram, WritesATableOfWhatEveryNodeProposed) {
  const Ran ran =
      debriefed({"explain", "a", "--player", "eagle2", "--from", "300", "--to", "5:00.2", "--csv"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_TRUE(
      ran.out.starts_with("time_s,step,player,tree,node,status,vote,field,value,unit,won\n"));
  EXPECT_TRUE(says(ran.out,
                   R"(\n300\.\d+,\d+,eagle2,sweep,root/ingress/follow_lead,running,20,heading,)"
                   R"([0-9.]+,rad,1\n)"))
      << ran.out;
  EXPECT_TRUE(says(ran.out, R"(root/ingress/navigate,running,10,mode,"route",,0\n)"));
  EXPECT_TRUE(says(ran.out, R"(root/ingress/survive/break_turn,failure,0,,,,\n)"));
}

TEST(ExplainProgram, WhatIfAndDiffAgreeOnTheFirstActionThatIsAnotherOne) {
  const Ran parted = debriefed({"diff", "a", "b", "--json"});
  EXPECT_EQ(parted.code, 1);
  const json difference = json::parse(parted.out);
  std::uint64_t first = ~std::uint64_t{0};
  for (const char* player : {"eagle1", "eagle2", "eagle3", "eagle4"}) {
    const Ran ran = debriefed({"whatif", "a", "--player", player, "--set",
                               "trees.bvr.per_field.release_weapon.zone=0.3", "--json"});
    ASSERT_EQ(ran.code, 0) << ran.err;
    const json j = json::parse(ran.out);
    if (j.contains("first"))
      first = std::min(first, j.at("first").at("step").get<std::uint64_t>());
  }
  EXPECT_EQ(difference.at("action").at("step"), first);
  EXPECT_EQ(debriefed({"diff", "a", "a"}).out, "the same, 33000 steps\n");
  const std::string words = debriefed({"diff", "a", "b"}).out;
  EXPECT_TRUE(says(words, R"(\naction +\S+  eagle\d: [^\n]+; and [^\n]+ in the other\n)")) << words;
  EXPECT_FALSE(says(words, R"(: ([^\n]+); and \1 in the other)")) << words;
}

TEST(ExplainProgram, SpeaksOneSetOfUnitsAndWritesDirectionsInThreeDigits) {
  for (const bool metric : {false, true}) {
    std::vector<std::string> line{"explain", "a", "--player", "eagle2", "--at", "5:00"};
    if (metric)
      line.insert(line.end(), {"--units", "metric"});
    const Ran ran = debriefed(line);
    ASSERT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(says(ran.out, R"(\d (ft|nmi|kt|lb)\b)"), !metric) << ran.out;
    EXPECT_EQ(says(ran.out, R"(\d (m|km|km/h|kg)\b)"), metric) << ran.out;
    EXPECT_TRUE(says(ran.out, R"(\bheading \d\d\d°)")) << ran.out;
    EXPECT_FALSE(says(ran.out, R"(\bdeg\b|\b(heading|bearing) +(-?\d|-?\d\d|-\d+)°)")) << ran.out;
  }
}

TEST(ExplainProgram, SaysOnWhichSideOfTheNoseATrackIs) {
  const json all = json::parse(
      debriefed({"explain", "a", "--player", "eagle2", "--at", "5:12.4", "--json"}).out);
  double own = 0;
  for (const json& field : all.at(0).at("state"))
    own = field.at("name") == "heading" ? field.at("value").get<double>() : own;
  int seen = 0;
  for (const json& one : all.at(0).at("perceived")) {
    const json &bearing = one.at("values").at(2), &side = one.at("values").at(3);
    ASSERT_EQ(bearing.at("name"), "bearing");
    ASSERT_EQ(side.at("name"), "off nose");
    const double off = side.at("value").get<double>();
    EXPECT_NEAR(std::remainder(bearing.at("value").get<double>() - own - off, 2 * M_PI), 0, 1e-6);
    const double size = std::round(std::fabs(off) * 180 / M_PI);
    const std::string where = size == 0 || size == 180 ? "" : off < 0 ? " left" : " right";
    EXPECT_EQ(side.at("text"), std::to_string(static_cast<int>(size)) + "°" + where);
    if (++seen == 3)
      break;
  }
  EXPECT_GT(seen, 1);
}

TEST(ExplainProgram, KeepsTheSeedsThatWereFlownBeforeAnInterrupt) {
  const TempFolder folder;
  ASSERT_EQ(run_program(folder, {"fly", "merge", "--no-debrief", "--quiet"}).code, 0);
  // a terminal shows the progress: the first seeds were flown when it does
  const Ran ran = run_line(folder, R"sh(
    script -qefc 'echo $$ >asked; exec "$EYRIE" whatif runs/latest --player viper1 \
      --set root/wvr=fusion --seeds 100000 >told' shown </dev/null >/dev/null & asked=$!
    while kill -0 $asked && ! grep -qs 'of 100000' shown; do sleep 0.02; done
    kill -TERM $(cat asked); wait $asked)sh");
  EXPECT_EQ(ran.code, 128 + SIGTERM);
  EXPECT_TRUE(says(read_text(folder / "shown"),
                   R"(\x1b\[Keyrie: interrupted: [1-9]\d* of 100000 seeds were flown\r\n)"))
      << read_text(folder / "shown");
  EXPECT_TRUE(says(read_text(folder / "told"), R"(\nover seeds 1 to [1-9]\d*: )"));
}

TEST(ExplainProgram, SaysWhatIsWrongWithWhatWasAsked) {
  const auto refused = [](const std::vector<std::string>& arguments) {
    const Ran ran = debriefed(arguments);
    EXPECT_EQ(ran.code, 2);
    EXPECT_EQ(ran.out, "");
    return ran.err;
  };
  EXPECT_EQ(refused({"explain", "a", "--player", "eagel2"}),
            "--player: there is no player 'eagel2'; did you mean 'eagle2'?\n");
  EXPECT_EQ(refused({"explain", "a", "--player", "eagle2", "--at", "noon"}),
            "--at 'noon': expected a time such as 312.4, '5 min' or 5:12.4\n");
  EXPECT_EQ(refused({"explain", "nowhere", "--player", "eagle2"}).substr(0, 9), "nowhere: ");
  EXPECT_EQ(
      refused({"whatif", "a", "--player", "eagle2", "--set",
               "trees.bvr.per_field.release_weapon.zon=0.3"}),
      "--set trees.bvr.per_field.release_weapon.zon=0.3:1:36: release_weapon has no parameter "
      "'zon'; did you mean 'zone'?\n");
  EXPECT_EQ(refused({"whatif", "a", "--player", "eagle2", "--set", "trees.more=navigate"}),
            "the change adds or removes a tree; change one that is there\n");
}

TEST(WhatIfProgram, ChangesANodeByItsPath) {
  const auto asked = [](std::vector<std::string> sets) {
    std::vector<std::string> words{"whatif", "a", "--player", "eagle2", "--json"};
    for (std::string& set : sets)
      words.insert(words.end(), {"--set", std::move(set)});
    const Ran ran = debriefed(words);
    EXPECT_EQ(ran.code, 0) << ran.err;
    return json::parse(ran.out);
  };
  // the same question by the path in the file and by the path in the tree
  const json by_file = asked({"trees.bvr.per_field.pursue.vote=15"});
  const json by_node = asked({"root/bvr/pursue.vote=15"});
  EXPECT_GT(by_node["different"], 100);
  EXPECT_EQ(by_node["spans_s"], by_file["spans_s"]);
  EXPECT_EQ(by_node["first"], by_file["first"]);
  // another arbiter keeps the children, and may have parameters of its own
  const json winner = asked({"root/bvr=winner_takes_all"});
  EXPECT_EQ(winner["first"]["leader"]["other"], "pursue");
  EXPECT_EQ(winner["first"]["fields"][0]["name"], "follow");
  const json fused = asked({"root/bvr=fusion", "root/bvr.top=2"});
  EXPECT_EQ(fused["first"]["leader"]["other"], "bvr");
  // of another tree than the player's: nothing changes for him
  EXPECT_EQ(asked({"patrol:root/bvr/pursue.vote=1"})["different"], 0);
}

/// How flights of `seeds` with `more` arguments ended, as fly itself tells it.
std::vector<json> flown(const std::vector<std::string>& seeds, std::vector<std::string> more) {
  const TempFolder folder;
  std::vector<json> ends;
  for (const std::string& seed : seeds) {
    std::vector<std::string> words{"fly",          "sweep_phases", "--until", "11 min", "--json",
                                   "--no-debrief", "--seed",       seed,      "--out",  seed};
    words.insert(words.end(), more.begin(), more.end());
    const Ran ran = run_program(folder, words);
    EXPECT_EQ(ran.code, 0) << ran.err;
    ends.push_back(json::parse(ran.out));
  }
  return ends;
}

TEST(WhatIfProgram, FliesOnBothWaysAndOverManySeeds) {
  const std::string zone = "trees.bvr.per_field.release_weapon.zone=0.3";
  const auto asked = [&](const char* player, std::vector<std::string> more) {
    std::vector<std::string> words{"whatif", "a", "--player", player, "--set", zone, "--json"};
    words.insert(words.end(), more.begin(), more.end());
    const Ran ran = debriefed(words);
    EXPECT_EQ(ran.code, 0) << ran.err;
    return json::parse(ran.out);
  };
  // the tree is everybody's, so that whoever is asked about, the first to differ is where it
  // branches: until then all fly alike, and the branch ends as if it had begun so
  const json said = asked("eagle4", {"--branch", "--seeds", "3"});
  EXPECT_NE(said["branch"]["player"], "eagle4");
  const auto ends_as = [&](const json& branch, const json& flight) {
    for (const char* side : {"blue", "red"})
      for (const char* what : {"losses", "shots", "kills", "home"})
        EXPECT_EQ(branch[side][what], flight["sides"][side][what]) << side << ' ' << what;
  };
  ends_as(said["branch"]["flown"], flown({"1"}, {})[0]);
  ends_as(said["branch"]["other"], flown({"1"}, {"--set", zone})[0]);
  const auto as_it_is = flown({"1", "2", "3"}, {}),
             changed = flown({"1", "2", "3"}, {"--set", zone});
  EXPECT_EQ(said["over_seeds"]["seeds"], 3);
  const std::pair<const char*, const char*> kFigures[] = {
      {"blue", "losses"}, {"red", "losses"}, {"blue", "shots"}, {"red", "shots"}};
  double differences = 0;
  for (std::size_t i = 0; i < std::size(kFigures); ++i) {
    const auto [side, what] = kFigures[i];
    const auto mean = [&](const std::vector<json>& all) {
      double sum = 0;
      for (const json& one : all)
        sum += one["sides"][side][what].get<double>();
      return sum / 3;
    };
    const json& figure = said["over_seeds"]["figures"][i];
    EXPECT_EQ(figure["name"], std::string(side) + ' ' + what);
    EXPECT_NEAR(figure["flown"].get<double>(), mean(as_it_is), 1e-12) << side << ' ' << what;
    EXPECT_NEAR(figure["other"].get<double>(), mean(changed), 1e-12) << side << ' ' << what;
    differences += std::fabs(figure["difference"].get<double>());
  }
  EXPECT_GT(differences, 0) << "the change does not matter: nothing was compared";
}

TEST(WhatIfProgram, SaysWhatIsWrongWithThePathOfANode) {
  for (const auto& [set, words] :
       {std::pair("root/bvrr=fusion",
                  ":1:1: tree 'sweep' has no node 'root/bvrr'; did you mean "
                  "'root/bvr'?"),
        std::pair("root/bvr=fusio", ":1:10: there is no node 'fusio'; did you mean 'fusion'?"),
        std::pair("root/bvr/pursue.vot=1",
                  ":1:17: pursue has no parameter 'vot'; did you mean 'vote'?"),
        std::pair("root/bvr/pursue.vote=-1", ":1:22: "), std::pair("root/bvr=[1]", ":1:10: "),
        std::pair("patrl:root/bvr=fusion", ":1:1: there is no tree 'patrl'"),
        std::pair("root/bvr=pursue", ":1:10: ")}) {
    const Ran ran = debriefed({"whatif", "a", "--player", "eagle2", "--set", set});
    EXPECT_EQ(ran.code, 2) << set;
    EXPECT_NE(ran.err.find("--set " + std::string(set) + words), std::string::npos) << ran.err;
  }
}

}  // namespace
}  // namespace eyrie::test
