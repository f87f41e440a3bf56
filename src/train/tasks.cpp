// SPDX-License-Identifier: MIT
#include <initializer_list>
#include <stdexcept>

#include "core/diagnostics.hpp"
#include "train/task.hpp"

namespace eyrie::train {
namespace {

/// The own motion and energy, as every task has it.
constexpr std::string_view kOwn =
    "altitude linear 0 ft 50000 ft\n"
    "mach linear 0 2\n"
    "pitch sine\n"
    "roll sine\n"
    "roll cosine\n"
    "load_factor linear -1 9\n"
    "available linear 0 9\n"
    "turn_rate linear -25 deg/s 25 deg/s\n";
/// The target, near and far.
constexpr std::string_view kTarget =
    "has_target linear 0 1\n"
    "range linear 0 nmi 40 nmi\n"
    "target_right sine\n"
    "target_right cosine\n"
    "target_up sine\n"
    "target_aspect sine\n"
    "target_aspect cosine\n"
    "target_speed linear 100 m/s 500 m/s\n"
    "target_above linear -20000 ft 20000 ft\n"
    "closing linear -600 m/s 600 m/s\n"
    "target_age linear 0 s 10 s\n";
constexpr std::string_view kNear =
    "range linear 0 nmi 3 nmi\n"
    "target_azimuth sine\n"
    "target_azimuth cosine\n"
    "target_elevation sine\n"
    "drift_right linear -20 deg/s 20 deg/s\n"
    "drift_up linear -20 deg/s 20 deg/s\n"
    "gun_azimuth linear -10 deg 10 deg\n"
    "gun_elevation linear -10 deg 10 deg\n"
    "over_gun_range linear 0 4\n"
    "in_gun linear 0 1\n"
    "rounds linear 0 600\n";
constexpr std::string_view kShots =
    "missiles linear 0 8\n"
    "over_r_max linear 0 2\n"
    "over_r_ne linear 0 2\n"
    "in_zone linear 0 1\n"
    "shots linear 0 4\n"
    "threatened linear 0 1\n"
    "missile_right sine\n"
    "missile_right cosine\n"
    "missile_range linear 0 nmi 20 nmi\n"
    "missile_time linear 0 s 30 s\n";
constexpr std::string_view kFar =
    "over_his_r_max linear 0 2\n"
    "over_his_r_ne linear 0 2\n"
    "supporting linear 0 1\n"
    "spiked linear 0 1\n"
    "spike_right sine\n"
    "spike_right cosine\n";

std::string joined(std::initializer_list<std::string_view> parts) {
  std::string all;
  for (const std::string_view part : parts)
    all += part;
  return all;
}

std::vector<TaskSpec> make() {
  const std::string dogfight =
      "aim_right -180 deg 180 deg cubic\n"
      "aim_up -90 deg 90 deg cubic\n"
      "load_factor 1 9\n"
      "speed 120 m/s 400 m/s\n"
      "shoot\n"
      "release\n";
  const std::string far =
      "turn -180 deg 180 deg\n"
      "altitude_change -10000 ft 10000 ft\n"
      "speed 150 m/s 450 m/s\n"
      "load_factor 2 7\n"
      "release\n"
      "dispense\n";
  const std::vector<Reward> fought{{.term = Term::win, .weight = 1},
                                   {.term = Term::loss, .weight = -1},
                                   {.term = Term::hit, .weight = 0.05},
                                   {.term = Term::hit_by, .weight = -0.05},
                                   {.term = Term::low, .weight = -0.05, .low = 300, .high = 1500}};
  std::vector<TaskSpec> all;

  TaskSpec merge{.name = "merge",
                 .help = "one against one within visual range: the gun and one short missile",
                 .scenario = "scenarios/tasks/merge.yaml",
                 .learners = {"viper1"},
                 .observation = joined({kOwn, kTarget, kNear, kShots}),
                 .controls = dogfight,
                 // time has its price, and winning is worth a risk: else PPO learns to survive
                 .rewards = {{.term = Term::win, .weight = 2},
                             {.term = Term::loss, .weight = -1},
                             {.term = Term::draw, .weight = -1},
                             {.term = Term::hit, .weight = 0.2},
                             {.term = Term::hit_by, .weight = -0.1},
                             {.term = Term::alive, .weight = -0.02},
                             {.term = Term::advantage, .weight = 0.05, .low = 1500, .high = 6e3},
                             {.term = Term::low, .weight = -0.05, .low = 300, .high = 1500}}};
  all.push_back(merge);

  merge.name = "merge_votes";
  merge.help = "the same, by the votes of eight maneuvers written by hand";
  merge.sets = {"blue.flights.viper.tree=arbitrated"};
  merge.controls = "";
  merge.votes = Votes{.arbiter = "root/winner_takes_all", .most = 100};
  all.push_back(merge);

  TaskSpec bvr{.name = "bvr",
               .help = "one against one with radar and missiles of long range",
               .scenario = "scenarios/tasks/bvr.yaml",
               .learners = {"eagle1"},
               .observation = joined({kOwn, kTarget, kShots, kFar}),
               .controls = far,
               .rewards = fought};
  bvr.rewards.push_back({.term = Term::launch, .weight = -0.02});
  all.push_back(bvr);

  TaskSpec sweep = bvr;
  sweep.name = "sweep";
  sweep.help = "four against two, all four learn";
  sweep.scenario = "scenarios/tasks/sweep.yaml";
  sweep.learners = {"eagle1", "eagle2", "eagle3", "eagle4"};
  sweep.observation +=
      "rank linear 1 4\n"
      "alive linear 0 4\n"
      "hostiles linear 0 4\n";
  sweep.rewards.push_back({.term = Term::kill, .weight = 0.5});
  sweep.rewards.push_back({.term = Term::killed, .weight = -0.5});
  all.push_back(std::move(sweep));

  all.push_back({.name = "formation",
                 .help = "keep the place beside a lead that turns and climbs",
                 .scenario = "scenarios/tasks/formation.yaml",
                 .learners = {"eagle2"},
                 .observation = joined({kOwn,
                                        "place_ahead linear -2 km 2 km\n"
                                        "place_right linear -2 km 2 km\n"
                                        "place_above linear -1 km 1 km\n"
                                        "place_ahead linear -100 m 100 m\n"
                                        "place_right linear -100 m 100 m\n"
                                        "place_above linear -100 m 100 m\n"
                                        "lead_course sine\n"
                                        "lead_course cosine\n"
                                        "lead_speed linear 100 m/s 400 m/s\n"}),
                 .controls = "turn -30 deg 30 deg\n"
                             "altitude_change -1000 m 1000 m\n"
                             "speed_change -60 m/s 60 m/s\n",
                 .rewards = {{.term = Term::formation, .weight = 0.1, .low = 20, .high = 1500},
                             {.term = Term::killed, .weight = -5}}});

  all.push_back({.name = "intercept",
                 .help = "find, reach and shoot down who flies his way, unarmed",
                 .scenario = "scenarios/tasks/intercept.yaml",
                 .learners = {"viper1"},
                 .observation = joined({kOwn, kTarget, kNear, kShots}),
                 .controls = dogfight,
                 .rewards = {{.term = Term::win, .weight = 1},
                             {.term = Term::killed, .weight = -1},
                             {.term = Term::nose_on, .weight = 0.001},
                             {.term = Term::closeness, .weight = 0.002, .low = 500, .high = 40e3},
                             {.term = Term::low, .weight = -0.05, .low = 300, .high = 1500}}});
  return all;
}

}  // namespace

std::span<const TaskSpec> tasks() {
  static const std::vector<TaskSpec> all = make();
  return all;
}

const TaskSpec& task(std::string_view name) {
  for (const TaskSpec& one : tasks())
    if (one.name == name)
      return one;
  throw std::invalid_argument("there is no task " + quote(name) +
                              nearest_or_all(name, listed(tasks(), &TaskSpec::name)));
}

}  // namespace eyrie::train
