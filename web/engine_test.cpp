// SPDX-License-Identifier: MIT
#include "web/engine.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>

#include "core/text.hpp"
#include "record/run_file.hpp"
#include "scenario/data.hpp"
#include "support/small_scenario.hpp"

namespace eyrie::web {
namespace {

/// The texts of a scenario beside what is in data/.
Texts texts_of(const std::string& scenario) {
  Texts texts{.files = {{"small.yaml", scenario}}, .scenario = "small.yaml", .sets = {}};
  auto disk = scenario::Source::disk(".");
  for (const std::string_view kind : scenario::DataLoader::kinds())
    for (const std::string& name : disk.data_names(kind))
      texts.files[disk.data_name(kind, name)] = disk.read(disk.data_name(kind, name)).value();
  return texts;
}

Json asked(Engine& engine, const Json& request, std::string* bytes = nullptr) {
  std::string none;
  return Json::parse(answer(engine, request.dump(), bytes ? *bytes : none));
}

/// The small scenario, flown to its end.
Engine flown(const std::vector<test::Change>& changes = {}) {
  Engine engine;
  engine.load({.texts = texts_of(test::changed_scenario(changes)), .seed = {}});
  engine.fly({});
  return engine;
}

std::string file_of(Engine& engine) {
  std::string file;
  engine.run_file({}, file);
  return file;
}

/// As the playground has them: the shipped texts under their own names, and a file beside them.
TEST(WebEngine, ReadsAScenarioThatExtendsAShippedOne) {
  const auto hash = [](const std::string& words) {
    Texts texts = texts_of(words);
    auto disk = scenario::Source::disk(".");
    for (const char* file : {"scenarios/merge.yaml", "scenarios/packages/veteran.yaml",
                             "scenarios/packages/pilots.yaml", "scenarios/packages/defense.yaml"})
      texts.files[file] = disk.read(file).value();
    Engine engine;
    engine.load({.texts = texts, .seed = {}});
    return engine.fly({.until = 5.0}).hash;
  };
  EXPECT_EQ(hash("extends: merge\n"), hash("extends: scenarios/merge.yaml\n"));
  EXPECT_NE(hash("extends: merge\n"), hash("extends: merge\nseed: 99\n"));
}

TEST(WebEngine, FliesToTheWorldThatAMissionFliesTo) {
  Engine engine;
  const About about = engine.load({.texts = texts_of(test::kSmallScenario), .seed = "7"});
  EXPECT_EQ(about.players.size(), 2u);
  EXPECT_EQ(about.players[1].name, "eagle2");
  const Flown half = engine.fly({.until = 1.0});
  EXPECT_DOUBLE_EQ(half.time, 1.0);
  EXPECT_FALSE(half.result);
  const Flown whole = engine.fly({});
  EXPECT_EQ(whole.result->outcome, "time");
  EXPECT_EQ(whole.result->blue.losses, 0u);

  scenario::Mission mission(
      scenario::load({"small.yaml"},
                     scenario::Source::bundle(texts_of(test::kSmallScenario).files)),
      7);
  mission.fly();
  EXPECT_EQ(whole.hash, fmt::format("{:#018x}", mission.run().world().hash()));
}

TEST(WebEngine, OpensTheRunFileThatItWroteAndVerifiesIt) {
  Engine first = flown();
  const std::string file = file_of(first);
  Engine second;
  EXPECT_EQ(second.open(file).until, 2.0);
  std::string packed;
  EXPECT_EQ(second.page({.until = 1.0}, packed).step, 50u);
  const std::size_t part = packed.size();
  EXPECT_EQ(second.page({}, packed).step, 100u);
  EXPECT_GT(packed.size(), part);
  EXPECT_EQ(file_of(second), file);

  std::string damaged = file;
  damaged[damaged.size() / 2] ^= 1;
  EXPECT_THROW(second.open(damaged), BadRequest);
}

TEST(WebEngine, EndsAFlightAsARunThatWasStopped) {
  Engine engine;
  engine.load({.texts = texts_of(test::kSmallScenario), .seed = "7"});
  const Flown half = engine.fly({.until = 1.0});
  const Flown ended = engine.end_flight();
  EXPECT_EQ(ended.result.value().outcome, "stopped");
  EXPECT_EQ(ended.hash, half.hash);
  Engine other;
  EXPECT_EQ(other.open(file_of(engine)).until, 1.0);
  std::string packed;
  EXPECT_EQ(other.page({}, packed).hash, half.hash);
  EXPECT_EQ(record::decode(file_of(engine)).run.outcome, "stopped");
  EXPECT_EQ(other.outcome().outcome, "stopped");
  other.seek({.step = 20});
  EXPECT_EQ(other.branch({.player = "eagle1", .sets = {"root/navigate.vote=30"}}, packed).time, 1.0)
      << "no farther than what it is compared with";
  EXPECT_THROW(engine.end_flight(), BadRequest);
}

/// The vote of navigate, times 1000 so many times, and at last times `scale`.
std::vector<test::Change> multiplied(int times, const std::string& scale) {
  std::string tree = "navigate: {vote: 1000, speed: 480 kt}";
  for (int i = 0; i <= times; ++i)
    tree = "winner_takes_all: {vote_scale: " + (i < times ? "1000" : scale) + ", children: [{" +
           tree + "}]}";
  return {{"navigate: {vote: 10, speed: 480 kt}", tree}};
}

TEST(WebEngine, SaysWhichFaultHasEndedAFlight) {
  Engine engine;
  engine.load({.texts = texts_of(test::changed_scenario(multiplied(11, "1000"))), .seed = {}});
  const Flown ended = engine.fly({});
  EXPECT_EQ(ended.result.value().outcome, "fault");
  EXPECT_NE(ended.fault.find("vote is inf"), std::string::npos) << ended.fault;
  EXPECT_EQ(engine.outcome().outcome, "fault");
}

TEST(WebEngine, SaysAtWhichFaultOtherTreesWouldEndARun) {
  Engine engine = flown(multiplied(11, "1"));
  const debrief::WhatIf answer =
      engine.what_if({.player = "eagle1", .sets = {"root/winner_takes_all.vote_scale=1000"}});
  EXPECT_NE(answer.fault.find("vote is inf"), std::string::npos) << answer.fault;
}

TEST(WebEngine, GoesToAnyStepForthAndBack) {
  Engine engine = flown();
  const Moment late = engine.seek({.step = 97});
  const Moment early = engine.seek({.step = 3});
  EXPECT_EQ(early.step, 3u);
  EXPECT_NE(early.hash, late.hash);
  std::string packed;
  engine.page({}, packed);  // keeps worlds on the way
  EXPECT_EQ(engine.seek({.step = 97}).hash, late.hash);
  EXPECT_THROW(engine.seek({.step = 101}), BadRequest);
}

/// The first step from `from` on in which the player decides.
Json decision_after(Engine& engine, std::uint64_t from, const char* player) {
  for (std::uint64_t step = from;; ++step) {
    engine.seek({.step = step});
    if (auto decided = engine.explain({.player = player}).decision)
      return *decided;
  }
}

TEST(WebEngine, ExplainsWhatWasDecided) {
  Engine engine = flown();
  const Json as_flown = decision_after(engine, 40, "eagle1");
  EXPECT_EQ(as_flown["tree"], "cruise");
  EXPECT_EQ(as_flown["leader"], "root/navigate");
  EXPECT_EQ(as_flown["player"], "eagle1");
  EXPECT_EQ(as_flown["vote"], 10);
  EXPECT_THROW(static_cast<void>(engine.explain({.player = "eagle3"})), BadRequest);
}

TEST(WebEngine, SaysHowManyDecisionsOtherTreesWouldHaveChanged) {
  Engine engine = flown();
  const auto same = engine.what_if({.player = "eagle1", .sets = {}});
  EXPECT_EQ(same.decisions, 20u);  // 10 Hz for 2 s
  EXPECT_EQ(same.different, 0u);
  EXPECT_EQ(same.leaders.size(), 20u);
  const auto slower = engine.what_if({.player = "eagle1", .sets = {"root/navigate=egress"}});
  EXPECT_EQ(slower.decisions, 20u);
  EXPECT_EQ(slower.different, 20u);
  EXPECT_EQ(slower.first->flown, "navigate");
  EXPECT_THROW(
      static_cast<void>(engine.what_if({.player = "eagle1", .sets = {"trees.another=navigate"}})),
      BadRequest);
}

TEST(WebEngine, FliesOnOtherwiseFromAMoment) {
  Engine engine = flown({{"until: 2 s", "until: 4 s"}});
  engine.seek({.step = 50});
  const Otherwise branch{.player = "eagle1", .sets = {"root/navigate.vote=30"}};
  std::string packed, again;
  const auto outcome = engine.branch(branch, packed);
  EXPECT_EQ(outcome.outcome, "time");
  EXPECT_DOUBLE_EQ(outcome.time, 4.0);
  EXPECT_EQ(engine.outcome().time, 4.0);
  // from what page() has kept it flies to the same end
  engine.page({}, again);
  EXPECT_EQ(engine.branch(branch, again).time, 4.0);
  EXPECT_EQ(packed, again);
}

/// Others, who fly the small scenario and give orders.
struct Others {
  Others()
      : scenario(scenario::load(
            {"small.yaml"}, scenario::Source::bundle(
                                texts_of(test::changed_scenario(
                                             {{"until: 2 s", "until: 4 s"},
                                              {"blue:\n",
                                               "orders: [{at: 0.8 s, player: eagle2, lose: true}]\n"
                                               "blue:\n"}}))
                                    .files))),
        mission(scenario, 7) {
    mission.run().attach(trail);
  }
  [[nodiscard]] std::string hash() const { return hash_text(mission.run().world().hash()); }
  void fly_to(std::uint64_t step) {
    while (mission.run().world().step() < step)
      mission.step();
  }
  /// What they have flown, with the orders that they have given by then.
  [[nodiscard]] std::string run_file() const {
    record::RunFile run = record::run_file_of(*scenario, 7, "others");
    run.trail = trail.trail_to(mission.run().world());
    return record::encode(run);
  }
  [[nodiscard]] std::vector<std::string> orders() const {
    std::vector<std::string> all;
    for (const sim::Order& order : mission.run().orders())
      all.push_back(base64({reinterpret_cast<const char*>(&order), sizeof order}));
    return all;
  }
  std::shared_ptr<const scenario::Scenario> scenario;
  scenario::Mission mission;
  sim::TrailRecorder trail;
};

TEST(WebEngine, FliesAlongWithOthersAndTheirOrders) {
  Others others;
  others.fly_to(30);
  Engine engine;
  const Followed followed = engine.follow(others.run_file());
  EXPECT_EQ(followed.about.until, 4.0);
  EXPECT_EQ(followed.flown.step, 30u);
  std::string drawn;
  const auto to = [&](std::uint64_t step, std::vector<std::string> orders, std::string hash) {
    return engine.advance({.step = step,
                           .orders = std::move(orders),
                           .hash = std::move(hash),
                           .outcome = "running",
                           .draw = step >= 30},
                          drawn);
  };
  EXPECT_EQ(to(20, {}, "").moment.step, 20u);
  EXPECT_EQ(drawn, "");
  EXPECT_TRUE(to(30, {}, followed.flown.hash).agrees);
  const std::size_t first = drawn.size();
  others.fly_to(60);
  EXPECT_TRUE(to(60, others.orders(), others.hash()).agrees);
  EXPECT_LT(drawn.size(), first);  // the trees, and what was flown until then, are known
  EXPECT_FALSE(to(60, {}, followed.flown.hash).agrees);
  EXPECT_THROW(to(60, others.orders(), ""), BadRequest);  // their step is over
  EXPECT_THROW(to(60, {"AAAA"}, ""), BadRequest);

  // everything else can be asked meanwhile
  EXPECT_EQ(engine.seek({.step = 45}).step, 45u);
  EXPECT_THROW(engine.seek({.step = 61}), BadRequest);
  EXPECT_EQ(decision_after(engine, 41, "eagle1")["leader"], "root/navigate");
  EXPECT_EQ(engine.what_if({.player = "eagle1", .sets = {}}).decisions, 12u);
  EXPECT_EQ(engine.outcome().outcome, "running");
  EXPECT_EQ(engine.branch({.player = "eagle1", .sets = {"root/navigate.vote=30"}}, drawn).time,
            4.0);
  EXPECT_TRUE((others.fly_to(80), to(80, {}, others.hash()).agrees));

  // what was flown so far is a run like any other
  Engine second;
  second.open(file_of(engine));
  EXPECT_EQ(second.page({}, drawn).hash, others.hash());
  EXPECT_THROW(second.advance({.step = 90}, drawn), BadRequest);
}

TEST(WebEngine, SaysWhatTreesAreMadeOf) {
  const NodeTypes types = Engine().node_types();
  const auto find = [](const auto& all, std::string_view name) {
    return *std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.name == name; });
  };
  const NodeType fusion = find(types.aircraft, "paper_fusion");
  EXPECT_EQ(fusion.kind, "arbiter");
  EXPECT_TRUE(fusion.takes_children);
  EXPECT_EQ(find(fusion.parameters, "high_vote").max, 1000);
  EXPECT_FALSE(find(types.vehicle, "navigate").takes_children);
}

TEST(WebQuestions, AreAnsweredInJsonAndRefusedInWords) {
  Engine engine;
  EXPECT_EQ(asked(engine, {{"ask", "seak"}, {"step", 1}})["error"],
            "there is no question 'seak'; did you mean 'seek'?");
  EXPECT_EQ(asked(engine, {{"ask", "seek"}})["error"], "step is missing");
  EXPECT_EQ(asked(engine, {{"ask", "seek"}, {"step", 1}, {"stop", 2}})["error"],
            "there is no stop");
  EXPECT_EQ(asked(engine, {{"ask", "seek"}, {"step", -1}})["error"],
            "step: expected a whole number from 0 to 2^53");
  EXPECT_EQ(asked(engine, {{"ask", "seek"}, {"step", 1}})["error"],
            "there is no run: open one, or fly to the end");
  EXPECT_EQ(asked(engine, {{"ask", "fly"}})["error"], "nothing was loaded that could be flown");
  EXPECT_TRUE(asked(engine, Json::array()).contains("error"));
  std::string none;
  EXPECT_TRUE(Json::parse(answer(engine, "{\"ask\":", none)).contains("error"));
}

TEST(WebQuestions, TakeTheBytesOfAFile) {
  Engine engine;
  std::string zones = "damaged";
  EXPECT_EQ(asked(engine, {{"ask", "take_zones"}}, &zones), Json::object());
  EXPECT_EQ(zones, "");
  std::string run = "damaged";
  EXPECT_TRUE(asked(engine, {{"ask", "open"}}, &run).contains("error"));
}

TEST(WebQuestions, NameEveryMistakeOfATextWithItsPlace) {
  Engine engine;
  const Json answered = asked(
      engine, {{"ask", "validate"},
               {"files", {{"a.yaml", test::changed_scenario({{"tree: cruise", "tree: cruse"}})}}},
               {"scenario", "a.yaml"}});
  const std::string all = answered.dump();
  EXPECT_NE(all.find("did you mean 'cruise'?"), std::string::npos) << all;
  EXPECT_NE(all.find("\"file\":\"a.yaml\",\"line\":"), std::string::npos) << all;
}

}  // namespace
}  // namespace eyrie::web
