// SPDX-License-Identifier: MIT
/// \file  Flies missions with many seeds, on all cores, and prints how believable the war was.
/// usage: war_health HOME SEEDS SCENARIO...
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <functional>

#include "campaign/in_order.hpp"
#include "debrief/health.hpp"
#include "stats/sample.hpp"

namespace {
using namespace eyrie;
using debrief::Health;

Health over_seeds(const std::string& file, const std::string& home, std::uint64_t seeds,
                  const std::vector<std::string>& sets = {}) {
  const auto scenario = scenario::load({file, sets}, scenario::Source::disk(home));
  Health all;
  campaign::in_order<Health>(
      seeds, std::max(1u, std::thread::hardware_concurrency()),
      [&](std::uint64_t k) { return debrief::measure(scenario, k + 1); },
      [&](std::uint64_t k, const Health& one) {
        all.add(one);
        fmt::print(stderr, "\r{}: {} of {} seeds ", file, k + 1, seeds);
        return true;
      });
  fmt::print(stderr, "\n");
  return all;
}

std::string median(std::vector<float> values) {
  if (values.empty())
    return "-";
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / 2);
  std::nth_element(values.begin(), middle, values.end());
  return fmt::format("{:.2f}", *middle);
}
double share_below(const std::vector<float>& values, float limit) {
  const auto below =
      std::count_if(values.begin(), values.end(), [=](float v) { return v < limit; });
  return static_cast<double>(below) / static_cast<double>(values.size());
}
double ratio(double a, double b) {
  return b > 0 ? a / b : 0;
}
/// "12 % (9 to 16)": with its 95 % interval; "-" of nothing.
std::string share(std::uint64_t count, std::uint64_t n) {
  if (n == 0)
    return "-";
  const auto [low, high] = stats::wilson({count, n});
  return fmt::format("{:.0f} % ({:.0f} to {:.0f})",
                     100 * ratio(static_cast<double>(count), static_cast<double>(n)), 100 * low,
                     100 * high);
}
/// "+5 (-2 to 12)": points that a share is more than another one, with their 95 % interval.
std::string difference(const stats::Share& one, const stats::Share& other) {
  const auto [low, high] = stats::newcombe(one, other);
  return fmt::format("{:+.0f} ({:+.0f} to {:+.0f})", 100 * (one.value() - other.value()), 100 * low,
                     100 * high);
}
/// Of all pairs of ranges the one whose farther shots kill most surely more than the nearer ones,
/// in points. The interval is that of a pair that was not chosen, so it calls rather too much a
/// rise than too little.
std::string greatest_rise(const Health& h) {
  double surest = -2;
  std::string text = "-";
  for (std::size_t far = 1; far < Health::kBins; ++far)
    for (std::size_t near = 0; near < far; ++near) {
      const stats::Share one{h.by_zone[far].kills, h.by_zone[far].shots},
          other{h.by_zone[near].kills, h.by_zone[near].shots};
      if (one.n == 0 || other.n == 0 || stats::newcombe(one, other).low <= surest)
        continue;
      surest = stats::newcombe(one, other).low;
      text = fmt::format("{} from {:.1f} to {:.1f}", difference(one, other),
                         static_cast<double>(near) * Health::kBin,
                         static_cast<double>(far) * Health::kBin);
    }
  return text;
}

/// A line of the table: what is measured, and how it reads.
struct Measure {
  std::string what;
  std::function<std::string(const Health&)> value;
};

std::vector<Measure> measures() {
  const auto d = [](auto v) { return static_cast<double>(v); };
  std::vector<Measure> all{
      {"roll reversals a minute in pursuit beyond 10 nmi",
       [=](const Health& h) {
         return h.pursued > 0 ? fmt::format("{:.1f}", 60 * d(h.reversals) / h.pursued) : "-";
       }},
      {"heading turned per heading gained there",
       [](const Health& h) {
         return h.gained > 0 ? fmt::format("{:.1f}", h.turned / h.gained) : "-";
       }},
      {"Mach in pursuit, median", [](const Health& h) { return median(h.pursuit_mach); }},
      {"below Mach 0.6 in pursuit",
       [](const Health& h) {
         return h.pursuit_mach.empty()
                    ? "-"
                    : fmt::format("{:.0f} %", 100 * share_below(h.pursuit_mach, 0.6F));
       }},
      {"Mach at launch, median", [](const Health& h) { return median(h.launch_mach); }},
      {"shots at the dead", [](const Health& h) { return share(h.at_the_dead, h.missiles); }},
      {"fratricides", [](const Health& h) { return fmt::format("{}", h.fratricides); }},
      {"target changes per pilot who had a target",
       [=](const Health& h) {
         return fmt::format("{:.1f}", ratio(d(h.target_changes), d(h.engagements)));
       }},
      {"pilots' entries into wvr with a living enemy in sight",
       [](const Health& h) { return share(h.wvr_seen, h.wvr); }},
      {"Mach within 5 nmi of an enemy, median",
       [](const Health& h) { return median(h.merged_mach); }},
      {"undecided when time was over", [](const Health& h) { return share(h.undecided, h.runs); }},
      {"runs in which somebody goes home from living enemies",
       [](const Health& h) { return share(h.left_fighting, h.runs); }},
      {"defenses against a missile for somebody else",
       [](const Health& h) { return share(h.for_others, h.defenses); }},
      {"runs with mates nearer than 500 ft",
       [](const Health& h) { return share(h.near_mates, h.runs); }},
      {"pilots who hit somebody in the air",
       [](const Health& h) { return fmt::format("{}", h.collisions); }},
      {"turned in again, of them lost within a minute",
       [](const Health& h) { return share(h.recommits_lost, h.recommits); }},
      {"lost per run, blue and red",
       [=](const Health& h) {
         return fmt::format("{:.2f} of {}, {:.2f} of {}", ratio(d(h.lost[0]), d(h.runs)),
                            h.players[0] / h.runs, ratio(d(h.lost[1]), d(h.runs)),
                            h.players[1] / h.runs);
       }},
      {"runs in which blue loses fewer", [](const Health& h) { return share(h.won[0], h.runs); }},
      {"runs in which red loses fewer", [](const Health& h) { return share(h.won[1], h.runs); }}};
  for (std::size_t i = 0; i < Health::kBins; ++i)
    all.push_back({fmt::format("kills per shot from {:.1f} to {:.1f} no-escape ranges",
                               static_cast<double>(i) * Health::kBin,
                               static_cast<double>(i + 1) * Health::kBin),
                   [i, d](const Health& h) {
                     double shots = 0;
                     for (const auto& bin : h.by_zone)
                       shots += d(bin.shots);
                     const auto& bin = h.by_zone[i];
                     return bin.shots ? fmt::format("{}, {:.0f} % of the shots",
                                                    share(bin.kills, bin.shots),
                                                    100 * ratio(d(bin.shots), shots))
                                      : "-";
                   }});
  all.push_back({"kills per shot, the greatest rise with the range", greatest_rise});
  return all;
}

/// What defenses are worth against one missile: kills per shot of duels, and by how many points
/// each changes them.
void print_effects(const std::string& file, const std::string& home, std::uint64_t seeds) {
  struct Defense {
    std::string name;
    std::vector<std::string> sets;
    std::string effect;   ///< of what it has more than `without`
    std::size_t without;  ///< index
  };
  const std::string tree = "red.flights.bogey.tree=";
  const std::string tows = "red.flights.bogey.aircraft=towing_mig29";
  const std::vector<Defense> defenses{
      {"flies on", {tree + "fly_on"}, "", 0},
      {"notch alone",
       {tree + "notches", "trees.notches.winner_takes_all.1.notch.dispense=none"},
       "the notch",
       0},
      {"notch, chaff", {tree + "notches"}, "chaff in the notch", 1},
      {"drag", {tree + "drags"}, "the drag", 0},
      {"last ditch alone",
       {tree + "breaks", "trees.breaks.winner_takes_all.1.last_ditch.dispense=none"},
       "the last ditch",
       0},
      {"last ditch, chaff", {tree + "breaks"}, "chaff in the last ditch", 4},
      {"as veterans: notch, last ditch, chaff", {tree + "evades"}, "what veterans do", 0},
      {"leaves at 1.1 r_ne", {tree + "leaves"}, "leaving", 0},
      {"flies on, tows a decoy", {tree + "fly_on", tows}, "the towed decoy", 0},
      {"notch alone, tows a decoy",
       {tree + "notches", "trees.notches.winner_takes_all.1.notch.dispense=none", tows},
       "the towed decoy in the notch",
       1}};
  constexpr std::array kRanges{6, 9, 12, 15, 18};  // nmi
  std::vector<std::array<stats::Share, kRanges.size()>> flown(defenses.size());
  for (std::size_t i = 0; i < defenses.size(); ++i)
    for (std::size_t k = 0; k < kRanges.size(); ++k) {
      std::vector<std::string> sets = defenses[i].sets;
      sets.push_back(
          fmt::format("trees.shooter.per_field.sequence.has_target.within={} nmi", kRanges[k]));
      const Health h = over_seeds(file, home, seeds, sets);
      flown[i][k] = {h.killed, h.missiles};
    }

  fmt::print("\n| kills per shot of {} duels, shot at |", seeds);
  for (const int range : kRanges)
    fmt::print(" {} nmi |", range);
  fmt::print("\n| --- | ---: | ---: | ---: | ---: | ---: |\n");
  for (std::size_t i = 0; i < defenses.size(); ++i) {
    fmt::print("| {} |", defenses[i].name);
    for (const stats::Share& one : flown[i])
      fmt::print(" {} |", share(one.count, one.n));
    fmt::print("\n");
  }
  for (std::size_t i = 1; i < defenses.size(); ++i) {
    fmt::print("| effect of {}, points |", defenses[i].effect);
    for (std::size_t k = 0; k < kRanges.size(); ++k)
      fmt::print(" {} |", difference(flown[i][k], flown[defenses[i].without][k]));
    fmt::print("\n");
  }
}

void print_table(const std::vector<std::string>& files, const std::string& home,
                 std::uint64_t seeds) {
  std::string head = fmt::format("| {} seeds each |", seeds), line = "| --- |";
  std::vector<Health> flown;
  for (const std::string& file : files) {
    flown.push_back(over_seeds(file, home, seeds));
    head += fmt::format(" {} |", file);
    line += " ---: |";
  }
  fmt::print("{}\n{}\n", head, line);
  for (const Measure& measure : measures()) {
    fmt::print("| {} |", measure.what);
    for (const Health& health : flown)
      fmt::print(" {} |", measure.value(health));
    fmt::print("\n");
  }
}
}  // namespace

int main(int argc, char** argv) {
  const std::uint64_t seeds = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 0;
  if (argc < 4 || seeds == 0) {
    fmt::print(stderr, "usage: war_health HOME SEEDS SCENARIO...\n");
    return 2;
  }
  try {
    std::vector<std::string> missions, duels;
    for (int i = 3; i < argc; ++i)
      (std::string_view(argv[i]).ends_with("duel_defense.yaml") ? duels : missions)
          .emplace_back(argv[i]);
    if (!missions.empty())
      print_table(missions, argv[1], seeds);
    for (const std::string& file : duels)
      print_effects(file, argv[1], seeds);
  } catch (const std::exception& e) {
    fmt::print(stderr, "{}\n", e.what());
    return 2;
  }
}
