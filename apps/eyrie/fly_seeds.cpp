// SPDX-License-Identifier: MIT
/// \file  fly --seeds: one scenario, many flights on all cores.
#include <nlohmann/json.hpp>
#include <thread>

#include "campaign/in_order.hpp"
#include "campaign/replicate.hpp"
#include "campaigns.hpp"
#include "command.hpp"
#include "commands.hpp"
#include "record/json_text.hpp"
#include "say.hpp"
#include "scenario/end_guard.hpp"

namespace eyrie::app {
namespace {

using campaign::SeedFlown;
using campaign::SeedTable;
using Json = nlohmann::ordered_json;

/// First and last: "1..500", or "500", which is the same.
std::pair<std::uint64_t, std::uint64_t> range_of(const std::string& text) {
  constexpr std::uint64_t kMost = 1'000'000;
  const auto range =
      campaign::two_numbers(text.find("..") == text.npos ? "1.." + text : text, "..");
  if (!range || range->second < range->first)
    refuse("--seeds: '{}' is no range of seeds such as 1..500, or 500 for the same", text);
  if (range->second - range->first >= kMost)
    refuse("--seeds: '{}' are more than {} seeds", text, kMost);
  return *range;
}

/// What shows one seed.
std::string command_for(const FlyOptions& options, std::uint64_t seed) {
  std::vector<std::string> until;
  if (!options.until.empty())
    until = {options.until};
  return campaign::fly_command(options.scenario, {{"--seed", {std::to_string(seed)}},
                                                  {"--set", options.sets},
                                                  {"--plugin", options.plugins},
                                                  {"--allow-include", options.includes},
                                                  {"--until", until}});
}

/// Calls `use` for every outcome that came.
template <class Use>
void each_outcome(const SeedTable& seeds, Use use) {
  for (const auto& [name, outcome] : EnumNames<scenario::Outcome>::names)
    if (const stats::Share share = seeds.share(outcome); share.count)
      use(name, share, stats::wilson(share));
}

Json closing_json(const SeedTable& seeds, const FlyOptions& options) {
  Json outcomes = Json::array(), estimates = Json::array(), stand_out = Json::array();
  each_outcome(seeds, [&](auto name, stats::Share share, stats::Interval i) {
    outcomes.push_back({{"outcome", name},
                        {"runs", share.count},
                        {"share", share.value()},
                        {"low", i.low},
                        {"high", i.high}});
  });
  for (const auto& [name, value, interval] : seeds.estimates()) {
    estimates.push_back({{"name", name}, {"value", Json(value ? Json(*value) : Json())}});
    if (interval)
      estimates.back().update({{"low", interval->low}, {"high", interval->high}});
  }
  for (const auto& [seed, why] : seeds.stand_out())
    stand_out.push_back({{"seed", seed}, {"why", why}, {"command", command_for(options, seed)}});
  return {{"flown", seeds.flown()}, {"confidence", 0.95},     {"outcomes", outcomes},
          {"estimates", estimates}, {"stand_out", stand_out}, {"hash", hash_text(seeds.hash())}};
}

void print_closing(const SeedTable& seeds, const FlyOptions& options) {
  say("\n{:<26} {:>8} {:>9}   95 % interval\n", "outcome", "runs", "share");
  each_outcome(seeds, [](auto name, stats::Share share, stats::Interval i) {
    say("{:<26} {:>8} {:>7.1f} %   {:.1f} to {:.1f} %\n", name, share.count, 100 * share.value(),
        100 * i.low, 100 * i.high);
  });
  say("\n{:<26} {:>18}   95 % interval\n", "", "mean");
  for (const auto& [name, value, interval] : seeds.estimates())
    say("{:<26} {:>18}   {}\n", name, value ? fmt::format("{:.2f}", *value) : "-",
        interval ? fmt::format("{:.2f} to {:.2f}", interval->low, interval->high)
                 : "has no bounds");
  say("\nworth a look\n");
  for (const auto& [seed, why] : seeds.stand_out())
    say("  {:<30} {}\n", why, command_for(options, seed));
  say("\nhash of all {}\n", hash_text(seeds.hash()));
}

/// Whose flight this thread makes: a plug-in that ends the program ends all of them.
thread_local std::uint64_t seed_in_the_air = 0;

}  // namespace

unsigned cores() {
  return std::clamp(std::thread::hardware_concurrency(), 1U, 256U);
}

int fly_seeds(const FlyOptions& options, const std::shared_ptr<const scenario::Scenario>& scenario,
              std::optional<double> until) {
  const auto range = range_of(options.seeds);
  const std::uint64_t asked = range.second - range.first + 1;
  listen_for_interrupts();
  if (!options.json)
    say("{}: seeds {} to {}\n", scenario->spec.name, range.first, range.second);

  SeedTable seeds;
  std::uint64_t faults = 0;
  std::string first_fault;
  {
    const scenario::EndGuard guard(1, [&](const std::string& done) {
      complain("eyrie: {} and ended the program; {} shows it\n", done,
               command_for(options, seed_in_the_air));
    });
    Progress progress("seeds", asked);
    campaign::in_order<SeedFlown>(
        asked, options.workers.value_or(cores()),
        [&](std::uint64_t i) {
          seed_in_the_air = range.first + i;
          return campaign::fly_seed(scenario, seed_in_the_air, until, interrupted);
        },
        [&](std::uint64_t, SeedFlown&& flown) {
          if (flown.outcome == scenario::Outcome::stopped)
            return false;
          seeds.add(flown);
          if (!flown.fault.empty() && faults++ == 0)
            first_fault = fmt::format("seed {}: {}", flown.seed, flown.fault);
          if (options.json)
            say("{}\n",
                Composed{record::json_text(flown_json(
                    flown, {{"blue", side_json(flown.blue)}, {"red", side_json(flown.red)}}))});
          progress.at(seeds.flown());
          return !options.json || lost_output() == 0;
        });
  }
  if (options.json)
    say("{}\n", Composed{record::json_text(closing_json(seeds, options))});
  else
    print_closing(seeds, options);
  if (interrupted())
    complain("eyrie: interrupted: {} of {} seeds were flown\n", seeds.flown(), asked);
  if (faults)
    complain("eyrie: {} of {} flights ended with a fault, the first {}\n", faults, seeds.flown(),
             first_fault);
  return faults ? 1 : 0;
}

}  // namespace eyrie::app
