// SPDX-License-Identifier: MIT
#pragma once
/// \file  The UBF types for drivers, under one name each.
#include "core/describe.hpp"
#include "core/units.hpp"
#include "driver/action.hpp"
#include "ubf/agent.hpp"
#include "ubf/registry.hpp"

namespace eyrie::driver {
struct State;
}
/// What expressions and switches may read of a driver's state: driver/state_fields.cpp.
template <>
struct eyrie::ubf::StateFields<eyrie::driver::State> {
  [[nodiscard]] static std::span<const StateField<eyrie::driver::State>> all();
};
/// Over what loops go: the aircraft in sight.
template <>
struct eyrie::ubf::StateLists<eyrie::driver::State> {
  [[nodiscard]] static std::span<const StateList<eyrie::driver::State>> all();
};

namespace eyrie::driver {

using Behavior = ubf::Behavior<State, Action>;
using Condition = ubf::Condition<State, Action>;
using Tick = ubf::Tick<State>;
using Proposal = ubf::Proposal<Action>;
using Status = ubf::Status;
using Tree = ubf::Tree<State, Action>;
using Trees = ubf::Trees<State, Action>;
using Registry = ubf::Registry<State, Action>;
using Trace = ubf::Trace<Action>;

/// What behaviors for every platform (src/team) need to know of vehicles.
struct Platform {
  using State = driver::State;
  using Action = driver::Action;
  static constexpr double cruise = si(50, "km/h");
  static constexpr auto speeds = range(0.5, 50);  ///< m/s
  static constexpr std::string_view speed_help = "on legs that give none";
};

}  // namespace eyrie::driver
