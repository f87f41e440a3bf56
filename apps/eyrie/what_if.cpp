// SPDX-License-Identifier: MIT
/// \file  whatif: another tree or parameter for a recorded run.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "campaign/in_order.hpp"
#include "campaign/replicate.hpp"
#include "campaigns.hpp"
#include "command.hpp"
#include "commands.hpp"
#include "core/text.hpp"
#include "debrief/look.hpp"
#include "debrief/what_if.hpp"
#include "disk/sink.hpp"
#include "locate.hpp"
#include "record/json_text.hpp"
#include "say.hpp"
#include "scenario/path.hpp"
#include "stats/sample.hpp"

namespace eyrie::app {
namespace {

using Json = nlohmann::ordered_json;
using campaign::SeedFlown;

Json first_json(const debrief::Otherwise& first) {
  Json fields = Json::array();
  for (const debrief::Changed& field : first.fields) {
    fields.push_back({{"name", field.name}, {"flown", field.flown}, {"other", field.other}});
    if (field.difference)
      fields.back()["difference"] = *field.difference;
    if (!field.unit.empty())
      fields.back()["unit"] = field.unit;
  }
  return {{"time_s", first.time},
          {"step", first.step},
          {"leader", {{"flown", first.flown}, {"other", first.other}}},
          {"fields", fields}};
}

Json outcome_json(const debrief::Outcome& outcome) {
  return {{"outcome", outcome.outcome},
          {"time_s", outcome.time},
          {"blue", side_json(outcome.blue)},
          {"red", side_json(outcome.red)}};
}

void print_outcomes(const debrief::Outcome& flown, const debrief::Outcome& otherwise) {
  say("\n  {:<10} {:<10} {:>8}   {:<7}   {:<7}   {:<7}\n  {:<30}   blu red   blu red   blu red\n",
      "", "outcome", "time", "losses", "shots", "home", "");
  for (const auto& [name, o] : {std::pair("flown", &flown), {"otherwise", &otherwise}})
    say("  {:<10} {:<10} {:>8}   {:>3} {:>3}   {:>3} {:>3}   {:>3} {:>3}\n", name, o->outcome,
        record::clock_text(o->time), o->blue.losses, o->red.losses, o->blue.shots, o->red.shots,
        o->blue.home, o->red.home);
}

/// The same seeds flown both ways: the differences are paired.
Json over_seeds(const debrief::Recorded& recorded,
                const std::shared_ptr<const scenario::Scenario>& other, std::uint32_t seeds,
                std::optional<double> until, bool quiet) {
  struct Figure {
    const char* name;
    double (*of)(const SeedFlown&);
    stats::Moments flown{}, other{}, difference{};
  };
  Figure figures[] = {{"blue losses", [](const SeedFlown& o) { return double(o.blue.losses); }},
                      {"red losses", [](const SeedFlown& o) { return double(o.red.losses); }},
                      {"blue shots", [](const SeedFlown& o) { return double(o.blue.shots); }},
                      {"red shots", [](const SeedFlown& o) { return double(o.red.shots); }},
                      {"time_s", [](const SeedFlown& o) { return o.time; }}};
  using Both = std::pair<SeedFlown, SeedFlown>;
  std::uint64_t flown = 0, faults = 0;
  std::string first_fault;
  listen_for_interrupts();
  {
    Progress progress("seeds", seeds);
    campaign::in_order<Both>(
        seeds, cores(),
        [&](std::uint64_t i) {
          return Both{campaign::fly_seed(recorded.scenario, i + 1, until, interrupted),
                      campaign::fly_seed(other, i + 1, until, interrupted)};
        },
        [&](std::uint64_t i, const Both& both) {
          for (const SeedFlown* one : {&both.first, &both.second}) {
            if (one->outcome == scenario::Outcome::stopped)
              return false;
            if (!one->fault.empty() && faults++ == 0)
              first_fault = fmt::format("seed {}: {}", one->seed, one->fault);
          }
          const bool both_whole = both.first.fault.empty() && both.second.fault.empty();
          for (Figure& figure : std::span(figures, both_whole ? std::size(figures) : 0)) {
            const double before = figure.of(both.first), after = figure.of(both.second);
            figure.flown.add(before);
            figure.other.add(after);
            figure.difference.add(after - before);
          }
          progress.at(flown = i + 1);
          return !interrupted();
        });
  }
  if (flown < seeds)
    complain("eyrie: interrupted: {} of {} seeds were flown\n", flown, seeds);
  if (faults)
    complain("eyrie: {} of {} flights ended with a fault, the first {}\n", faults, 2 * flown,
             first_fault);
  Json all = Json::array();
  if (!quiet)
    say("\nover seeds 1 to {}: mean, and of the difference its standard error\n", flown);
  for (const Figure& figure : figures) {
    const std::uint64_t pairs = figure.difference.n();  // of seeds without a fault
    if (pairs == 0)
      break;
    const double error_of = figure.difference.error(),
                 difference = stats::mean_difference(figure.difference);
    const Json error = pairs < 2 ? Json() : Json(error_of);  // of one: unknown
    if (!quiet)
      say("  {:<12} {:>8.2f} -> {:>8.2f}   {:+.2f} ± {}\n", figure.name, figure.flown.mean(),
          figure.other.mean(), difference, error.is_null() ? "-" : fmt::format("{:.2f}", error_of));
    all.push_back({{"name", figure.name},
                   {"flown", figure.flown.mean()},
                   {"other", figure.other.mean()},
                   {"difference", difference},
                   {"standard_error", error}});
  }
  return {{"seeds", flown}, {"faults", faults}, {"figures", all}};
}

/// The part of a scenario that an override goes to: "trees" of "trees.bvr.top=2".
std::string_view part_of(std::string_view set) {
  return set.substr(0, set.find_first_of(".="));
}

/// "; did you mean 'root/bvr/pursue'?" for `bvr/pursue.vote=70`, and 'root' for `rot/bvr=fusion`.
std::string node_meant(const scenario::Scenario& scenario, std::string_view set) {
  std::string_view path = set.substr(0, set.find('='));
  const std::string_view whole = path;
  for (int with_parameter = 0; with_parameter < 2; ++with_parameter) {
    for (const ubf::AnyTree* tree : scenario.all_trees())
      for (std::size_t i = 0; i < tree->size(); ++i)
        if (const std::string is = tree->path(static_cast<ubf::NodeIndex>(i));
            is.ends_with(fmt::format("/{}", path)))
          return fmt::format("; did you mean {}?", quote(is));
    path = path.substr(0, path.rfind('.'));
  }
  return did_you_mean(whole.substr(0, whole.find_first_of("/.")),
                      std::array<std::string_view, 1>{"root"});
}

/// Says which overrides cannot be asked. The recorded states answer for other trees and for nothing
/// else; what changes the flight itself is told by flights from the start, over seeds.
void check_parts(const std::vector<std::string>& sets, const WhatIfOptions& options,
                 const scenario::Scenario& scenario, Diagnostics& wrong) {
  constexpr std::array<std::string_view, 9> kParts{
      "trees", "data", "environment", "blue", "red", "ends", "orders", "rates", "reference"};
  for (const std::string& set : sets) {
    const std::string_view part = part_of(set);
    const Location where{"--set " + set, 1, 1};
    if (part == "trees" || set.find('=') == std::string::npos)
      continue;
    if (std::ranges::find(kParts, part) == kParts.end()) {
      const std::string meant = did_you_mean(part, kParts);
      wrong.error(where, "whatif asks other trees; {} says nothing about decisions{}", quote(part),
                  meant.empty() ? node_meant(scenario, set) : meant);
    } else if (options.seeds == 0 || options.branch)
      wrong.error(where,
                  "the recorded states do not tell what another {} would have changed: use "
                  "--seeds, without --branch",
                  quote(part));
  }
}

/// The run with the files that overrides name, such as other networks, as they are now: they stand
/// on the disk and not in the run file. Only who typed their names may read them by this.
debrief::Recorded with_files_of(debrief::Recorded recorded, const std::vector<std::string>& sets) {
  for (const std::string& set : sets) {
    const std::string name = set.substr(std::min(set.size(), set.find('=') + 1));
    const disk::FileRead read = disk::read_file(name, scenario::Source::kLargestBytes);
    if (read.problem.empty())
      recorded.run.files.insert_or_assign(name, base64(read.bytes));
  }
  return recorded;
}

}  // namespace

int what_if(const WhatIfOptions& options) {
  const double typed = options.at.empty() ? 0 : time_named("--at", options.at);
  const debrief::Recorded recorded = open_run(options.run, options.plugins);
  const double from = first_shown(recorded, typed);
  const PlayerId who = decider_named(recorded.scenario->roster, options.player);
  demand_within(recorded, "--at", options.at, from);
  for (const auto& [first, again] : scenario::set_twice(options.sets))
    refuse("eyrie: --set {}: --set {} sets it, too", quote(options.sets[first]),
           quote(options.sets[again]));
  Diagnostics wrong;
  auto overrides = debrief::read_overrides(*recorded.scenario, who, options.sets, wrong);
  check_parts(overrides.sets, options, *recorded.scenario, wrong);
  const bool asks_trees = overrides.sets.empty() || !overrides.changes.empty() ||
                          std::ranges::any_of(overrides.sets, [](const std::string& set) {
                            return part_of(set) == "trees";
                          });
  if ((!asks_trees || options.seeds > 0) && !options.at.empty())
    refuse(
        "eyrie: --at: flights over seeds begin at their start; only another tree can be asked of a "
        "time, without --seeds");
  wrong.throw_if_any();
  const auto other = debrief::with_overrides(with_files_of(recorded, options.sets), overrides.sets,
                                             std::move(overrides.changes));
  if (asks_trees && other->all_trees().size() != recorded.scenario->all_trees().size())
    refuse("the change adds or removes a tree; change one that is there");

  for (const std::string& node : debrief::votes_left_out(recorded, *other))
    complain(
        "eyrie: the vote given to {} from outside is left out: with this change there is no "
        "such node\n",
        node);
  const std::size_t all = recorded.run.orders.size(), own = recorded.scenario->orders.size();
  const std::size_t given = all - std::min(all, own);
  if (options.seeds > 0 && given > 0)
    complain("eyrie: --seeds: {} from outside {} left out: other seeds fly without\n",
             counted(given, "order"), given == 1 ? "is" : "are");

  debrief::WhatIf result;
  Json json{{"run", recorded.file}, {"player", options.player}};
  if (asks_trees) {
    result = debrief::what_if(recorded, *other, who, from);
    if (result.decisions == 0 && result.fault.empty() && !options.at.empty())
      refuse("{}", debrief::nothing_text(options.player, {.from = from}, {.until = result.until}));
    json["decisions"] = result.decisions;
    json["different"] = result.different;
    if (result.first)
      json["first"] = first_json(*result.first);
    json["spans_s"] = result.spans;
    if (!result.fault.empty())
      json["fault"] = result.fault;
  }
  if (asks_trees && !options.json) {
    say("{}: {} of {} would have been different\n", options.player, result.different,
        counted(result.decisions, "decision"));
    if (result.first) {
      say("first at {} (step {}): {} -> {}\n", record::clock_text(result.first->time),
          result.first->step, result.first->flown, result.first->other);
      for (const debrief::Changed& field : result.first->fields)
        say("  {:<12} {} -> {}\n", field.name, field.flown, field.other);
    }
  }
  if (!result.fault.empty())
    complain("eyrie: with this change a run ends there, so nothing was asked after it: {}\n",
             result.fault);
  std::optional<debrief::Outcome> flown;
  std::optional<double> until;
  if (options.branch || options.seeds > 0) {
    flown = debrief::outcome_of(recorded);
    until = debrief::limit_of(recorded, *flown);
  }
  const auto first =
      options.branch ? debrief::first_otherwise(recorded, *other, who, from) : std::nullopt;
  if (first) {
    std::string problem;
    const auto branched = debrief::branch(
        recorded, other, debrief::past_at(recorded, first->decision.step), until, problem);
    if (!branched)
      refuse("--branch: {}", problem);
    const debrief::Outcome ended = branched->fly();
    const std::string& name = recorded.scenario->roster.name(first->who);
    json["branch"] = {{"player", name},
                      {"step", first->decision.step},
                      {"time_s", first->decision.time},
                      {"flown", outcome_json(*flown)},
                      {"other", outcome_json(ended)}};
    if (!options.json) {
      if (first->who != who)
        say("flown on from {} (step {}), where {} is the first to decide otherwise\n",
            record::clock_text(first->decision.time), first->decision.step, name);
      print_outcomes(*flown, ended);
    }
  }
  if (options.seeds > 0)
    json["over_seeds"] = over_seeds(recorded, other, options.seeds, until, options.json);
  if (options.json)
    say("{}", Composed{record::json_lines(json)});
  const bool faults = options.seeds > 0 && json["over_seeds"]["faults"] != 0;
  return faults || !result.fault.empty() ? 1 : 0;
}

}  // namespace eyrie::app
