// SPDX-License-Identifier: MIT
#pragma once
/// \file  The UBF types for pilots, under one name each.
#include "pilot/action.hpp"
#include "ubf/agent.hpp"
#include "ubf/registry.hpp"

namespace eyrie::pilot {
struct State;
}
/// What expressions and switches may read of a pilot's state: pilot/state_fields.cpp.
template <>
struct eyrie::ubf::StateFields<eyrie::pilot::State> {
  [[nodiscard]] static std::span<const StateField<eyrie::pilot::State>> all();
};
/// Over what loops go: tracks and hostiles, each in turn as the target.
template <>
struct eyrie::ubf::StateLists<eyrie::pilot::State> {
  [[nodiscard]] static std::span<const StateList<eyrie::pilot::State>> all();
};

namespace eyrie::pilot {

using Behavior = ubf::Behavior<State, Action>;
using Condition = ubf::Condition<State, Action>;
using Tick = ubf::Tick<State>;
using Proposal = ubf::Proposal<Action>;
using Status = ubf::Status;
using Tree = ubf::Tree<State, Action>;
using Trees = ubf::Trees<State, Action>;
using Registry = ubf::Registry<State, Action>;
using Trace = ubf::Trace<Action>;

/// What behaviors for every platform (src/team) need to know of aircraft.
struct Platform {
  using State = pilot::State;
  using Action = pilot::Action;
  static constexpr double cruise = si(480, "kt");
  static constexpr auto speeds = range(50, 1000);  ///< m/s
  static constexpr std::string_view speed_help = "true airspeed on legs that give none";
};

}  // namespace eyrie::pilot
