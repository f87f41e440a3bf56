// SPDX-License-Identifier: MIT
/// Trees are usually written in YAML. Mistakes point at the line and name the nearest right word.
#include <fmt/format.h>

#include "core/yaml.hpp"
#include "pilot/catalog.hpp"
#include "pilot/state.hpp"

using namespace eyrie;

constexpr std::string_view kGood = R"(winner_takes_all:
  - avoid_ground: {vote: 100, floor: 1000 ft}
  - follow_lead: {vote: 20}
  - navigate: {vote: 10, speed: 480 kt}
)";
constexpr std::string_view kBad = R"(winner_takes_all:
  - avoid_ground: {vote: -4, flor: 1000 ft}
  - folow_lead
  - navigate: {speed: 480 kg}
)";

int main() {
  const auto registry = pilot::make_registry();
  for (const std::string_view text : {kGood, kBad}) {
    Diagnostics mistakes;
    const Value value = eyrie::parse_yaml(text, "pilot.yaml", mistakes);
    if (const auto tree = registry.build_tree("pilot", value, mistakes))
      for (std::size_t i = 0; i < tree->size(); ++i)
        fmt::print("{}\n", tree->path(static_cast<ubf::NodeIndex>(i)));
    else
      fmt::print("\n{}\n", mistakes.text());
  }
}
