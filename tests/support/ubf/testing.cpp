// SPDX-License-Identifier: MIT
#include "support/ubf/testing.hpp"

namespace eyrie::ubf {

std::span<const StateField<testing::State>> StateFields<testing::State>::all() {
  static constexpr std::array kFields = std::to_array<StateField<State>>({
      {{.name = "range", .kind = FieldKind::number, .unit = "m", .help = "to the goal"},
       [](const State& s) { return s.range; }},
      {{.name = "altitude", .kind = FieldKind::number, .unit = "m", .help = "own"},
       [](const State& s) { return s.altitude; }},
      {{.name = "count", .kind = FieldKind::number, .unit = "", .help = "of things"},
       [](const State& s) { return s.count; }},
      {{.name = "alarm", .kind = FieldKind::flag, .unit = "", .help = "it rings"},
       [](const State& s) { return s.alarm ? 1. : 0.; }},
      {{.name = "phase",
        .kind = FieldKind::choice,
        .unit = "",
        .help = "of the errand",
        .choices = State::kPhases},
       [](const State& s) { return static_cast<double>(s.phase); }},
  });
  return kFields;
}

std::span<const StateList<testing::State>> StateLists<testing::State>::all() {
  static constexpr std::array kLists{
      StateList<State>{"things", "that lie about", [](const State& s) { return s.thing_count; },
                       [](State& s, std::size_t i) {
                         s.range = s.things[i];
                         s.cues[0].vote = static_cast<float>(s.things[i]);
                         s.cues[0].action.altitude = s.things[i];
                       }}};
  return kLists;
}

template class Tree<testing::State, testing::Action>;
template class Trace<testing::Action>;
template void add_standard_nodes(Registry<testing::State, testing::Action>&);
}  // namespace eyrie::ubf
