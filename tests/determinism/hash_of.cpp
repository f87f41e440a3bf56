// SPDX-License-Identifier: MIT
/// \file  Flies a scenario with its own seed and prints the hash of the last world. Nothing but
/// what a step needs, so that tools/check-bits builds little for each way of compiling.
// usage: hash_of SCENARIO     in the root of the source tree
#include <cinttypes>
#include <cstdio>

#include "core/diagnostics.hpp"
#include "scenario/mission.hpp"

int main(int argc, char** argv) {
  using namespace eyrie;
  if (argc != 2)
    return 2;
  try {
    const auto scenario = scenario::load({argv[1], {}}, scenario::Source::disk("."));
    scenario::Mission mission(scenario, scenario->spec.seed);
    mission.fly();
    std::printf("0x%016" PRIx64 "\n", mission.run().world().hash());
  } catch (const ConfigError& mistakes) {
    std::fprintf(stderr, "%s\n", mistakes.what());
    return 2;
  }
}
