// SPDX-License-Identifier: MIT
/// Loads a scenario, flies it to its end and counts what happened.
#include <fmt/format.h>

#include "record/story.hpp"
#include "scenario/mission.hpp"

using namespace eyrie;

int main() {
  const auto sweep = scenario::load({"scenarios/sweep.yaml", {}}, scenario::Source::disk("."));
  for (const std::uint64_t seed : {1, 2, 3}) {
    scenario::Mission mission(sweep, seed);
    record::Tally tally(*sweep);
    mission.run().attach(tally);
    mission.fly();
    const auto blue = tally.side(model::Side::blue), red = tally.side(model::Side::red);
    fmt::print("seed {}: {}, blue lost {} of {}, red lost {} of {}, phases", seed,
               enum_name(mission.outcome()), blue.losses, blue.players, red.losses, red.players);
    for (const auto& phase : tally.phases())
      if (phase.flight == 0)
        fmt::print(" {}", phase.phase);
    fmt::print("\n");
  }
}
