// SPDX-License-Identifier: MIT
#include "campaign/replicate.hpp"

#include <algorithm>

namespace eyrie::campaign {

Flown fly(const std::shared_ptr<const scenario::Scenario>& scenario, std::uint64_t seed,
          sim::Observer* observer, std::optional<double> until, bool (*given_up)()) {
  scenario::Mission mission(scenario, seed, until);
  sim::Run& run = mission.run();
  if (observer)
    run.attach(*observer);
  while (mission.step())
    if (given_up && given_up())
      mission.stop();
  run.finish();
  Flown flown{.seed = seed,
              .steps = run.world().step(),
              .hash = run.world().hash(),
              .outcome = mission.outcome(),
              .time = run.time(),
              .fault = {}};
  if (const sim::Fault* fault = run.fault())
    flown.fault = scenario::fault_text(*fault, scenario->roster, run.simulation().dt());
  return flown;
}

std::string fly_command(
    const std::string& scenario,
    const std::vector<std::pair<const char*, std::vector<std::string>>>& options) {
  std::string text = "eyrie fly";
  if (!scenario.empty())
    text += " " + scenario::shell_word(scenario);
  for (const auto& [option, values] : options)
    for (const std::string& value : values)
      text += fmt::format(" {} {}", option, scenario::shell_word(value));
  return text;
}

SeedFlown fly_seed(const std::shared_ptr<const scenario::Scenario>& scenario, std::uint64_t seed,
                   std::optional<double> until, bool (*given_up)()) {
  record::Tally tally(*scenario);
  const Flown flown = fly(scenario, seed, &tally, until, given_up);
  return {flown, tally.side(model::Side::blue), tally.side(model::Side::red)};
}

void SeedTable::add(const SeedFlown& flown) {
  ++flown_;
  ++outcomes_[static_cast<std::size_t>(flown.outcome)];
  hash_.word(flown.seed);
  hash_.word(flown.hash);
  if (flown.outcome == scenario::Outcome::fault) {
    first_fault_ = first_fault_.value_or(flown.seed);
    return;  // what it came to until then says nothing of whole flights
  }
  const record::Tally::OfSide &blue = flown.blue, &red = flown.red;
  const Figures figures{double(blue.losses), double(red.losses), double(blue.shots),
                        double(red.shots), flown.time};
  rows_.push_back({flown.seed, figures});
  for (std::size_t i = 0; i < figures.size(); ++i)
    figures_[i].add(figures[i]);
  exchange_.add(red.losses, blue.losses);
  blue_kills_.add(blue.kills, blue.shots);
  red_kills_.add(red.kills, red.shots);
}

std::vector<SeedEstimate> SeedTable::estimates() const {
  std::vector<SeedEstimate> all;
  constexpr const char* kNames[] = {"blue losses", "red losses", "blue shots", "red shots",
                                    "end time, s"};
  for (std::size_t i = 0; i < figures_.size(); ++i) {
    all.push_back({kNames[i]});
    if (!rows_.empty())
      all.back().value = figures_[i].mean();
    all.back().interval = stats::t_interval(figures_[i]);
  }
  const auto add = [&](const char* name, const stats::Ratio& ratio) {
    all.push_back({name, ratio.value(), ratio.fieller()});
  };
  add("red losses per blue loss", exchange_);
  add("kills per blue shot", blue_kills_);
  add("kills per red shot", red_kills_);
  return all;
}

std::vector<SeedTable::StandsOut> SeedTable::stand_out() const {
  std::vector<StandsOut> found;
  if (first_fault_)
    found.push_back({*first_fault_, "fault"});
  if (rows_.empty())
    return found;
  found.push_back({rows_.front().seed, "first"});
  // of several alike the first
  const auto least = [&](const char* why, auto figure) {
    const auto row =
        std::ranges::min_element(rows_, {}, [&](const Row& r) { return figure(r.figures); });
    found.push_back({row->seed, why});
  };
  least("typical", [&](const Figures& of) {
    double sum = 0;
    for (std::size_t i = 0; i < of.size(); ++i)
      if (const double variance = figures_[i].variance(); variance > 0)
        sum += (of[i] - figures_[i].mean()) * (of[i] - figures_[i].mean()) / variance;
    return sum;
  });
  if (figures_[0].variance() > 0 || figures_[1].variance() > 0) {
    least("best for blue", [](const Figures& of) { return of[0] - of[1]; });
    least("worst for blue", [](const Figures& of) { return of[1] - of[0]; });
  }
  least("longest", [](const Figures& of) { return -of[4]; });

  // a line each
  std::ranges::stable_sort(found, {}, &StandsOut::seed);
  std::vector<StandsOut> merged;
  for (StandsOut& one : found)
    if (merged.empty() || merged.back().seed != one.seed)
      merged.push_back(std::move(one));
    else
      merged.back().why += ", " + one.why;
  return merged;
}

}  // namespace eyrie::campaign
