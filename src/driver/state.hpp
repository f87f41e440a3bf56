// SPDX-License-Identifier: MIT
#pragma once
/// \file  What one driver perceives at one decision: a view of his own rows, never of the truth.
#include <cstdint>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "driver/agent.hpp"
#include "model/columns.hpp"
#include "model/library.hpp"
#include "team/decision.hpp"
#include "team/member.hpp"

namespace eyrie::driver {

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
    return std::tuple{&C::kinematics, &C::driving, &C::lookout, &C::datalink};
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
