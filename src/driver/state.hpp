// SPDX-License-Identifier: MIT
#pragma once
/// \file  A driver: what he wants (Action), keeps from decision to decision (Agent) and perceives
/// (State), and the UBF types for these under one name each.
#include "model/columns.hpp"
#include "model/library.hpp"
#include "team/deciding.hpp"
#include "team/decision.hpp"
#include "team/member.hpp"
#include "ubf/registry.hpp"

namespace eyrie::driver {

/// What the driver calls out while doing it: told as an event when it changes.
enum class Call : std::uint32_t { none, scatter };
constexpr auto names_of(Call) {
  return names_from_zero<Call>("none", "scatter");
}

/// The recommendation of one behavior, or of a whole tree. A field that is empty at the root leaves
/// heading and speed as they are.
struct Action {
  std::optional<double> heading;  ///< rad, true
  std::optional<double> speed;    ///< m/s; 0 stands
  std::optional<Call> call;       ///< ends
};

struct State;

}  // namespace eyrie::driver

template <>
struct eyrie::ubf::ActionTraits<eyrie::driver::Action> {
  using A = driver::Action;
  static constexpr auto fields =
      Lines{field<blend::Angle>("heading", &A::heading, "rad", {-1e4, 1e4}),
            field<blend::Mean>("speed", &A::speed, "m/s", {-10e3, 10e3}),
            field<blend::Strongest>("call", &A::call)};
};

/// What expressions and switches may read of a driver's state: driver/state.cpp.
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

/// What a driver keeps from decision to decision besides the memory of his tree. Recorders find
/// here what the last decision was.
struct Agent {
  static constexpr std::string_view system = "driver";  ///< who writes this row

  std::uint64_t decided = 0;  ///< step of the last decision
  PlayerId lead{};            ///< who he believes leads
  std::uint32_t ticks = 0;    ///< decisions so far
  float vote = 0;             ///< of what the tree recommended last
  Call call = Call::none;
  std::uint16_t tree = team::kNoTree;  ///< index into the scenario's trees for drivers
  std::uint16_t node = ubf::kNone;     ///< the behavior whose recommendation led; kNone: none
  std::uint16_t phase = ubf::kNone;    ///< what the outermost sequencer has in charge; kNone: none
  std::uint8_t reserved[2] = {};

  static constexpr auto fields() {
    return field_list(field("decided", &Agent::decided), field("lead", &Agent::lead),
                      field("ticks", &Agent::ticks), field("vote", &Agent::vote),
                      field("call", &Agent::call), field("tree", &Agent::tree),
                      field("node", &Agent::node), field("phase", &Agent::phase),
                      field("reserved", &Agent::reserved));
  }
};

/// What drivers add to the table of vehicles.
using DriverColumns = team::AgentColumns<Agent>;

/// What does not change about one convoy, for its drivers.
struct Spacing {
  double gap = 50;  ///< m, from vehicle to vehicle
};

/// The rows of one vehicle that its driver reads.
struct Cab {
  const model::Kinematics& own;
  const model::Driving& driving;
  const model::Lookout& lookout;
  const model::DatalinkState& datalink;
  const Agent& agent;

  static constexpr auto columns() {
    using C = model::VehicleColumns;
    return Lines{&C::kinematics, &C::driving, &C::lookout, &C::datalink};
  }
};

/// Views into the driver's own rows and what follows from them; good for one decision.
struct State : Cab {
  State(const Cab& cab, const model::Library& models, const model::Fit& fit,
        const Spacing& driven_in, double now);

  const model::VehicleType& type;
  const model::Flight& convoy;
  const Spacing& spacing;
  double time;  ///< s

  std::uint32_t rank = 1;           ///< among the members believed alive, 1 leads
  std::uint32_t alive = 1;          ///< members believed alive, the driver included
  std::int32_t watched_index = -1;  ///< into the lookout: the aircraft looked at; negative: none

  /// The nearest aircraft that is no friend, or the one that a loop looks at; null if there is
  /// none.
  [[nodiscard]] const model::Sighted* watched() const {
    return watched_index < 0 ? nullptr : &lookout.sighted[static_cast<std::size_t>(watched_index)];
  }
  /// m, to where an aircraft was last seen.
  [[nodiscard]] double range_to(const model::Sighted& aircraft) const {
    return norm(aircraft.position - own.position);
  }
  /// rad, true.
  [[nodiscard]] double bearing_to(const Vec3& place) const;

  // what the behaviors of every platform ask for (team/member.hpp)
  [[nodiscard]] bool leads() const { return rank == 1; }
  /// The vehicle ahead in the column: the next lower rank that is believed alive.
  [[nodiscard]] std::optional<team::Leader> leader() const;
  [[nodiscard]] Vec3 place() const { return {-spacing.gap, 0, 0}; }
  /// Straight at the vehicle ahead, so that a column does not swing out in bends.
  [[nodiscard]] double forward_of(const team::Leader& ahead) const {
    return bearing_to(ahead.position);
  }
  [[nodiscard]] std::span<const model::Route> routes() const { return convoy.routes; }
  [[nodiscard]] model::NavState nav() const { return driving.nav; }
  [[nodiscard]] const model::flight::GuidanceGains& guidance() const { return type.guidance; }
  [[nodiscard]] Vec3 wind() const { return {}; }
};

/// What is in a state, for debriefs.
[[nodiscard]] std::vector<team::Perceived> perceived(const State& state);

/// Carries out what the tree recommends.
void execute(const Action& action, model::DriveCommand& command, Agent& agent);

}  // namespace eyrie::driver
