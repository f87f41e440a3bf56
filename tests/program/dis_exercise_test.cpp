// SPDX-License-Identifier: MIT
/// \file  `--dis --ours` in two processes at once, over a group of this machine: one mission.
#include <gtest/gtest.h>

#include <csignal>
#include <nlohmann/json.hpp>

#include "dis/pdu.hpp"
#include "net/datagrams.hpp"
#include "support/live_viewer.hpp"
#include "support/served.hpp"

namespace eyrie::test {
namespace {

using nlohmann::json;

/// The merge, begun close behind the other; blue and red in a process each, by the clock.
struct Exercise {
  explicit Exercise(const std::string& at) {
    const auto words = [&](const char* side, const char* station) {
      const std::string start = "red.flights.bandit.start.";
      return std::vector<std::string>{"fly",           "merge",
                                      "--set",         start + "east=-5.6 nmi",
                                      "--set",         start + "north=0.2 nmi",
                                      "--set",         start + "heading=90 deg",
                                      "--until",       "40 s",
                                      "--ours",        side,
                                      "--dis",         at,
                                      "--dis-station", station,
                                      "--real-time",   "1",
                                      "--out",         side,
                                      "--no-debrief",  "--json"};
    };
    Running blue(folder, words("blue", "1.1.1"));
    Running red(folder, words("red", "1.1.2"));
    // somebody else in the same group: garbage, another exercise, another version
    net::DatagramSender stranger({.to = *net::endpoint_of(at, {})});
    for (const std::uint8_t version : {std::uint8_t{7}, std::uint8_t{3}})
      for (int i = 0; i < 30; ++i) {
        auto bytes = dis::encode({.exercise = 9, .pdu = dis::EntityState{}});
        bytes[0] = std::byte{version};
        bytes[1] = std::byte{version == 7 ? std::uint8_t{9} : std::uint8_t{1}};
        stranger.send(bytes);
        stranger.send(std::span(bytes).first(60));
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
      }
    of_blue = report_of(blue.wait());
    of_red = report_of(red.wait());
  }
  static json report_of(const Ran& ran) {
    EXPECT_EQ(ran.code, 0) << ran.err;
    return json::parse(ran.out);
  }

  TempFolder folder;
  json of_blue, of_red;
};

TEST(DisExercise, IsOneMissionWhoseStoriesAgreeAndIsReplayedWithoutTheNetwork) {
  const Exercise exercise("239.30.12.83:30183");
  for (const char* side : {"blue", "red"})
    for (const char* what : {"kills", "losses"})
      EXPECT_EQ(exercise.of_blue["sides"][side][what], exercise.of_red["sides"][side][what])
          << side << " " << what;
  // the burst that ends the mission comes with its kill, and then is not told of
  for (const char* side : {"blue", "red"})
    EXPECT_NEAR(exercise.of_blue["sides"][side]["shots"].get<int>(),
                exercise.of_red["sides"][side]["shots"].get<int>(), 1)
        << side;
  EXPECT_GE(exercise.of_blue["sides"]["blue"]["shots"].get<int>() +
                exercise.of_blue["sides"]["red"]["shots"].get<int>(),
            1);
  for (const json* report : {&exercise.of_blue, &exercise.of_red}) {
    const json& heard = (*report)["dis"]["heard"];
    EXPECT_GE(heard["entities"], 1);
    EXPECT_GE(heard["states"], 10);
    EXPECT_GE(heard["not_used"]["exercise"], 1);
    EXPECT_GE(heard["not_used"]["version"], 1);
    EXPECT_GE(heard["not_used"]["truncated"], 1);
    EXPECT_GE(heard["not_used"]["own"], 1);
    EXPECT_LT(heard["error_max_m"], 100);
    EXPECT_GT(heard["latency_max_s"], 0);
  }
  for (const char* side : {"blue", "red"}) {
    const json& report = side == std::string("blue") ? exercise.of_blue : exercise.of_red;
    const Ran again = run_program(exercise.folder, {"replay", side, "--workers", "3", "--json"});
    EXPECT_EQ(again.code, 0) << again.err;
    EXPECT_NE(again.out.find(report["hash"].get<std::string>()), std::string::npos) << again.out;
    for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
             {"explain", side, "--player", side == std::string("blue") ? "viper1" : "bandit1",
              "--at", "5"},
             {"whatif", side, "--player", side == std::string("blue") ? "viper1" : "bandit1",
              "--set", "root/wvr=fusion"},
             {"debrief", side},
             {"export", side, "--to", "sqlite"}}) {
      const Ran ran = run_program(exercise.folder, words);
      EXPECT_EQ(ran.code, 0) << words[0] << "\n" << ran.err;
    }
    const std::string theirs = side == std::string("blue") ? "bandit1" : "viper1";
    for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
             {"explain", side, "--player", theirs},
             {"whatif", side, "--player", theirs, "--set", "root/wvr=fusion"}}) {
      const Ran ran = run_program(exercise.folder, words);
      EXPECT_EQ(ran.code, 2) << words[0];
      EXPECT_EQ(ran.err, theirs + " is flown by another program: nobody knows why\n");
    }
  }
}

/// Whether a remote player has appeared in the world of a viewer.
bool is_there(const LiveViewer& viewer, const char* name) {
  const auto& scenario = viewer.scenario();
  const auto found = scenario.find(viewer.world(), *scenario.roster.find(name));
  return found && viewer.world().rows(scenario.remote->aircraft)[found->row].here;
}

TEST(DisExercise, IsServedToViewersWhoFlyItAndReplayedAlike) {
  const std::string at = "239.30.12.84:30184";
  Served blue({"sweep", "--paused", "--set", "until=20 s", "--ours", "blue", "--dis", at,
               "--dis-station", "1.1.1"});
  Running red(blue.folder, {"fly", "sweep", "--ours", "red", "--dis", at, "--dis-station", "1.1.2",
                            "--until", "5 min", "--out", "red", "--no-debrief"});
  LiveViewer first(blue.port), second(blue.port);
  const auto refused = [&](json what) {
    first.say(what);
    return first.follow([](const json& j) { return j.contains("refused"); })["refused"];
  };
  const json take_over{{"do", "order"},  {"order", "manual"}, {"player", "eagle1"},
                       {"heading", 1.5}, {"altitude", 7000},  {"speed", 250}};
  first.say({{"do", "play"}});
  first.say(take_over);
  second.say(
      {{"do", "order"}, {"order", "tree"}, {"player", "eagle2"}, {"tree", "veteran_patrol"}});
  second.follow(
      [&](const json&) { return is_there(second, "bogey1") && is_there(second, "bogey2"); });
  EXPECT_EQ(refused({{"do", "pause"}}), "other programs take part, by the clock: they do not wait");
  EXPECT_EQ(refused({{"do", "order"}, {"order", "lose"}, {"player", "bogey1"}}),
            "bogey1 is another program's");
  LiveViewer late(blue.port);
  EXPECT_TRUE(is_there(late, "bogey1"));
  first.say({{"do", "order"}, {"order", "hand_back"}, {"player", "eagle1"}});
  for (LiveViewer* viewer : {&first, &second, &late}) {
    EXPECT_EQ(viewer->follow_to_the_end()["step"], 1000);
    EXPECT_EQ(viewer->world().hash(), first.world().hash());
    EXPECT_EQ(viewer->orders(), first.orders());
  }
  EXPECT_GE(first.orders(), 3u + 2 * 3 * 2) << "ours, and of each of two where he is, twice";
  blue.server->kill(SIGINT);
  const Ran ran = blue.server->wait();
  EXPECT_NE(ran.err.find("listens there"), std::string::npos) << ran.err;
  const Ran again = run_program(blue.folder, {"replay", "runs/latest", "--workers", "2"});
  EXPECT_EQ(again.out, fmt::format("runs/latest/run.eyrie: the same, 1000 steps, world hash {}\n",
                                   hash_text(first.world().hash())))
      << again.err;
}

TEST(DisExercise, IsFrozenForViewersWhileAnotherProgramSaysSo) {
  const std::string at = "239.30.12.85:30185";
  Served blue({"sweep", "--ours", "blue", "--dis", at, "--dis-obey"});
  LiveViewer viewer(blue.port);
  net::DatagramSender controller({.to = *net::endpoint_of(at, {})});
  const auto ask = [&](dis::Pdu what) {
    controller.send(dis::encode({.exercise = 1, .pdu = std::move(what)}));
  };
  const auto until_paused = [&](bool paused) {
    return viewer.follow([&](const json& j) { return j.value("paused", !paused) == paused; });
  };
  const dis::EntityId from{7, 7, 1};
  ask(dis::StopFreeze{.from = from, .to = dis::kEverybody, .request = 1});
  const json frozen = until_paused(true);
  EXPECT_TRUE(frozen.contains("hash"));
  EXPECT_EQ(viewer.world().step(), frozen["step"]);
  ask(dis::StartResume{.from = from, .to = dis::kEverybody, .request = 2});
  until_paused(false);
  viewer.follow_to(frozen["step"].get<std::uint64_t>() + 50);
  ask(dis::StopFreeze{.from = from, .to = dis::kEverybody, .reason = 2, .request = 3});
  EXPECT_EQ(viewer.follow_to_the_end()["outcome"], "stopped");
}

TEST(DisExercise, SaysNothingOfDeadReckoningWhereNobodyWasHeard) {
  const TempFolder folder;
  const Ran ran = run_program(folder, {"fly", "merge", "--until", "1 s", "--ours", "blue", "--dis",
                                       "239.30.12.85:30185", "--real-time", "max"});
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(ran.out.find(" heard of 0 entities, "), std::string::npos) << ran.out;
  EXPECT_EQ(ran.out.find("dead reckoning"), std::string::npos) << ran.out;
}

TEST(DisExercise, RefusesWhoIsNobodyAndWhatIsNoThreshold) {
  const TempFolder folder;
  for (const auto& [words, said] : std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{"--ours", "blu"}, "did you mean 'blue'"},
           {{"--ours", "viper2"}, "did you mean 'viper"},
           {{"--dis-threshold", "3 kg"}, "--dis-threshold"}}) {
    std::vector<std::string> all{"fly", "merge", "--dis"};
    all.insert(all.end(), words.begin(), words.end());
    const Ran ran = run_program(folder, all);
    EXPECT_EQ(ran.code, 2) << words[1] << "\n" << ran.err;
    EXPECT_NE(ran.err.find(said), std::string::npos) << ran.err;
  }
  EXPECT_EQ(run_program(folder, {"fly", "merge", "--ours", "blue"}).code, 2);
  EXPECT_FALSE(std::filesystem::exists(folder / "runs"));
}

}  // namespace
}  // namespace eyrie::test
