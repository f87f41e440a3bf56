// SPDX-License-Identifier: MIT
#include "campaign/measure.hpp"

#include <gtest/gtest.h>

#include "core/angle.hpp"
#include "core/yaml.hpp"
#include "record/names.hpp"

namespace eyrie::campaign {
namespace {

Measures measures(const std::string& text) {
  Diagnostics diagnostics;
  Measures all = read_measures(parse_yaml(text, "m.yaml", diagnostics), diagnostics);
  EXPECT_TRUE(diagnostics.ok()) << diagnostics.text();
  return all;
}

const scenario::Scenario& sweep() {
  static const auto kSweep =
      scenario::load({.file = "scenarios/sweep.yaml"}, scenario::Source::disk("."));
  return *kSweep;
}

/// What happened, by itself.
struct Log final : sim::Observer {
  void observe(const sim::World& world, const sim::StepInfo& info,
               std::span<const sim::Event> events) override {
    const PlayerId lead{1};
    time = info.time_after();
    for (const sim::Event& e : events)
      if (record::kind_of(e) == model::EventKind::launch)
        launches.push_back(e);
      else if (record::kind_of(e) == model::EventKind::seeker_active)
        active.push_back(e.who);
    const auto found = sweep().find(world, lead);
    if (found && found->fleet.leader(world, found->row) == "pursue") {
      first_pursuit = std::min(first_pursuit, info.time());  // when it was decided
      altitude = found->fleet.motion(world, found->row).altitude;
    }
    if (!found)
      return;
    const team::LastDecision last = found->fleet.agents->last_decision(world, found->row);
    if (std::exchange(ticks, last.ticks) != last.ticks && last.node != ubf::kNone)
      count(found->fleet.trees[last.tree]->node(last.node).type(),
            found->fleet.motion(world, found->row));
  }
  void count(std::string_view leader, const model::Kinematics& k) {
    ++led[std::string(leader)];
    const double bank = degrees(k.roll), climb = degrees(k.pitch);
    const std::string side = bank > 45    ? "hard right "
                             : bank > 10  ? "right "
                             : bank > -10 ? "straight "
                             : bank > -45 ? "left "
                                          : "hard left ";
    ++moved[side + (climb > 5 ? "up" : climb > -5 ? "level" : "down")];
  }
  std::map<std::string, int> led, moved;
  std::uint32_t ticks = 0;
  std::vector<sim::Event> launches;
  std::vector<PlayerId> active;
  double time = 0, first_pursuit = 1e9, altitude = 0;
};

std::map<std::string, double> flown(const Measures& all, Log& log) {
  const auto watcher = watch(all, sweep());
  scenario::Mission mission(std::shared_ptr<const scenario::Scenario>(&sweep(), [](const auto*) {}),
                            65);
  mission.run().attach(*watcher);
  mission.run().attach(log);
  mission.fly();
  const auto values = watcher->values(mission.outcome(), mission.run().time());
  std::map<std::string, double> by_name;
  for (std::size_t i = 0; i < values.size(); ++i)
    by_name[all.columns[i].name] = values[i];
  return by_name;
}

TEST(Measures, AreWhatHappenedInTheFlight) {
  Log log;
  const auto v = flown(measures(R"(
home: {what: outcome, is: [blue_home]}
lost: {what: outcome, is: [blue_lost, time]}
end: {what: end_time}
red: {what: losses, who: red}
blue: {what: losses, who: eagle}
kills: {what: kills, who: blue}
economy: {what: shots_per_kill, who: blue}
exchange: {what: exchange_ratio, who: red}
bvr: {what: time_in_phase, phase: bvr, who: eagle}
red_bvr: {what: time_in_phase, phase: bvr, who: bogey}
active: {what: event, event: seeker_active, who: blue}
fuel: {what: fuel_left, who: blue}
gone: {what: fuel_left, who: bogey}
launches: {what: event, event: launch}
first: {what: event, event: launch, who: blue, take: first, value: range}
shots: {what: event, event: launch, who: blue, take: sum, value: range}
far: {what: event, event: launch, if: range > 500 nmi, take: any}
none: {what: event, event: launch, if: range > 500 nmi, take: last}
felled: {what: event, event: detonation, take: last, value: whom.altitude}
nearest: {what: event, event: launch, whom: red, take: least, value: enemy_range}
pursuit: {what: decision, node: pursue, who: eagle1, take: first}
height: {what: decision, node: pursue, who: eagle1, take: last, value: altitude}
swept: {what: holds, if: red == 2 and end > 10 min and exchange.per > 1}
beaten: {what: holds, if: red < 2 or blue > 1}
various: {what: variety, who: eagle1}
nimble: {what: motion_variety, who: eagle1}
warned: {what: event, event: rwr_warning, take: most, value: bearing}
unwarned: {what: event, event: rwr_warning, take: least, value: bearing}
pressed: {what: decision, node: pursue, if: missile_range < 0.001 nmi, take: any}
)"),
                       log);
  EXPECT_EQ(v.at("home"), 1);
  EXPECT_EQ(v.at("lost"), 0);
  EXPECT_DOUBLE_EQ(v.at("end"), log.time);
  EXPECT_EQ(v.at("red"), 2);
  EXPECT_EQ(v.at("blue"), 1);
  EXPECT_EQ(v.at("kills"), 2);
  EXPECT_EQ(v.at("economy.per"), 2);
  EXPECT_EQ(v.at("exchange.sum"), 1);
  EXPECT_EQ(v.at("exchange.per"), 2);
  EXPECT_NEAR(v.at("bvr"), 467.6, 0.15) << "as `fly` says: 5:47.7 to 9:13.0, 9:27.9 to 13:50.2";
  EXPECT_GT(v.at("red_bvr"), 60);
  EXPECT_LT(v.at("red_bvr"), 673.5) << "the last of them is lost at 11:13.5";
  EXPECT_GT(v.at("fuel"), 1000);
  EXPECT_TRUE(std::isnan(v.at("gone")));
  ASSERT_GE(log.launches.size(), 3U);
  EXPECT_EQ(v.at("launches"), static_cast<double>(log.launches.size()));
  double first = 0, sum = 0, count = 0;
  for (const sim::Event& e : log.launches)
    if (e.detail <= 4) {
      first = first > 0 ? first : e.values[0];
      sum += e.values[0];
      ++count;
    }
  EXPECT_EQ(v.at("economy.sum"), count) << "no gun was fired";
  const auto by_blue = std::count_if(log.active.begin(), log.active.end(), [&](PlayerId missile) {
    return std::any_of(log.launches.begin(), log.launches.end(),
                       [&](const sim::Event& e) { return e.who == missile && e.detail <= 4; });
  });
  EXPECT_GT(by_blue, 0);
  EXPECT_EQ(v.at("active"), static_cast<double>(by_blue)) << "their missiles";
  EXPECT_EQ(v.at("first"), first);
  EXPECT_EQ(v.at("shots"), sum);
  EXPECT_EQ(v.at("far"), 0);
  EXPECT_TRUE(std::isnan(v.at("none")));
  EXPECT_TRUE(std::isnan(v.at("felled"))) << "who is killed by the last one has none";
  EXPECT_LE(v.at("nearest"), first + 1000) << "the nearest enemy is hardly farther than the target";
  EXPECT_EQ(v.at("pursuit"), log.first_pursuit);
  EXPECT_NEAR(v.at("height"), log.altitude, 50) << "at the last decision, not at the last step";
  EXPECT_EQ(v.at("pressed"), 0);
  EXPECT_GT(v.at("warned"), kPi) << "bearings count from 0 to 360 deg, as in tables";
  EXPECT_GE(v.at("unwarned"), 0);
  EXPECT_EQ(v.at("swept"), 1);
  EXPECT_EQ(v.at("beaten"), 0);
  for (const auto& [name, counts] : {std::pair("various", log.led), {"nimble", log.moved}}) {
    double decisions = 0, bits = 0;
    for (const auto& [which, times] : counts)
      decisions += times;
    for (const auto& [which, times] : counts)
      bits -= times / decisions * std::log2(times / decisions);
    EXPECT_GT(counts.size(), 3U);
    EXPECT_NEAR(v.at(name), bits, 1e-9);
  }
}

std::string refusal(const std::string& text) {
  try {
    static_cast<void>(watch(measures(text), sweep()));
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

TEST(Measures, HoldOfTheMeasuresAboveThem) {
  Diagnostics diagnostics;
  const char* const text = "red: {what: losses, who: red}\nwon: {what: holds, if: rad == 2}";
  static_cast<void>(read_measures(parse_yaml(text, "m.yaml", diagnostics), diagnostics));
  EXPECT_NE(diagnostics.text().find("m.yaml:2:24: "), std::string::npos) << diagnostics.text();
  EXPECT_NE(diagnostics.text().find("there is no measure 'rad'; did you mean 'red'?"),
            std::string::npos);
  Diagnostics of_ratio;
  const char* const ratio =
      "exchange: {what: exchange_ratio, who: red}\nwon: {what: holds, if: exchange > 1}";
  static_cast<void>(read_measures(parse_yaml(ratio, "m.yaml", of_ratio), of_ratio));
  EXPECT_EQ(of_ratio.text(),
            "m.yaml:2:24: exchange is a ratio of all flights; one has exchange.sum and "
            "exchange.per");
}

TEST(Measures, NameWhomAScenarioHas) {
  EXPECT_EQ(refusal("m: {what: losses, who: eagel}"),
            "m.yaml:1:24: m: there is no side, flight or player 'eagel'; did you mean 'eagle'?");
  EXPECT_EQ(refusal("m: {what: event, event: hit, whom: bogey3}"),
            "m.yaml:1:36: m: there is no side, flight or player 'bogey3'; did you mean 'bogey'?");
  EXPECT_EQ(refusal("m: {what: time_in_phase, phase: bvrr}"),
            "m.yaml:1:33: m: there is no phase 'bvrr'; did you mean 'bvr'?");
  EXPECT_EQ(
      refusal("m: {what: time_in_phase, phase: press}"),
      "m.yaml:1:33: m: 'press' is a phase within another one; those of the outermost sequencer "
      "count");
  EXPECT_EQ(refusal("m: {what: time_in_phase, phase: bingo}")
                .find("m.yaml:1:33: m: there is no phase 'bingo'"),
            0U);
  EXPECT_EQ(refusal("m: {what: decision, node: persue}"),
            "m.yaml:1:27: m: no tree has a node 'persue'; did you mean 'pursue'?");
}

}  // namespace
}  // namespace eyrie::campaign
