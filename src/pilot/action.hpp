// SPDX-License-Identifier: MIT
#pragma once
/// \file  What a pilot wants: numbers to fly, and orders. An empty field is "no opinion".
#include "model/command.hpp"
#include "ubf/action_traits.hpp"

namespace eyrie::pilot {

/// Whom to follow, and where: what the autopilot's modes follow and loiter need.
struct Follow {
  Vec3 position;    ///< m, local frame, at `time`
  Vec3 velocity;    ///< m/s
  double time = 0;  ///< s
  Vec3 offset;      ///< m, forward, right, down of the heading of who is followed
  friend constexpr bool operator==(const Follow&, const Follow&) = default;
};
[[nodiscard]] std::optional<ubf::ImplausiblePart> implausible_part(const Follow& follow);
/// "1.1 nmi behind, 6001 ft left, 500 ft below", for traces.
[[nodiscard]] std::string to_text(const Follow& follow);

/// Which store at which track.
struct Release {
  TrackId track;
  std::uint32_t store = 0;  ///< index of the missile type in the Library
  friend constexpr bool operator==(const Release&, const Release&) = default;
};
/// "store 2 at #7", for traces.
[[nodiscard]] std::string to_text(const Release& release);

/// What the pilot calls out while doing it: told as an event when it changes. `land` also ends the
/// flight. `notch`, `drag` and `last_ditch` answer a missile, `out` a fighter that may shoot one.
enum class Call : std::uint32_t {
  none,
  defend_far,
  defend_near,
  land,
  notch,
  drag,
  last_ditch,
  out,
};
constexpr auto names_of(Call) {
  return names_from_zero<Call>("none", "defend_far", "defend_near", "land", "notch", "drag",
                               "last_ditch", "out");
}

/// The recommendation of one behavior, or of a whole tree. What a field that stays empty up to the
/// root means is said beside it: "stays" leaves the last order as it is, "ends" takes it back.
///
/// A behavior that recommends a heading or an altitude also says by which mode they are to be flown
/// (docs/adr/0004-modes-in-actions.md), or else the mode of another one would overrule it in a
/// fusion.
struct Action {
  std::optional<double> heading;      ///< rad, true; stays
  std::optional<double> altitude;     ///< m above the ellipsoid; stays
  std::optional<double> speed;        ///< m/s true airspeed; stays
  std::optional<double> climb;        ///< rad above the horizontal, for the mode aim; stays
  std::optional<double> load_factor;  ///< g, the most that turning may use; stays
  /// Flown instead of the numbers unless it is hold. Empty: hold if there is a heading or an
  /// altitude to fly, otherwise it stays.
  std::optional<model::AutopilotMode> mode;
  std::optional<Follow> follow;  ///< for the mode follow; of loiter its position is the center
  std::optional<std::uint32_t> route;       ///< for the mode route: index into the flight's routes
  std::optional<TrackId> target;            ///< the track to attack, an empty id for nobody; stays
  std::optional<Release> release;           ///< ends
  std::optional<bool> trigger;              ///< of the gun; ends
  std::optional<bool> radar;                ///< true: radiates, false: silent; stays
  std::optional<Call> call;                 ///< ends
  std::optional<model::Dispense> dispense;  ///< chaff and flares by the dispenser's program; ends
};

}  // namespace eyrie::pilot

template <>
struct eyrie::ubf::ActionTraits<eyrie::pilot::Action> {
  using A = pilot::Action;
  static constexpr auto fields = Lines{
      field<blend::Angle>("heading", &A::heading, "rad", {-1e4, 1e4}),
      field<blend::Mean>("altitude", &A::altitude, "m", {-100e3, 100e3}),
      field<blend::Mean>("speed", &A::speed, "m/s", {-10e3, 10e3}),
      field<blend::Mean>("climb", &A::climb, "rad", {-1.6, 1.6}),
      field<blend::Mean>("load_factor", &A::load_factor, "", {-100, 100}),
      field<blend::Agreed>("mode", &A::mode),
      field<blend::Agreed>("follow", &A::follow),
      field<blend::Agreed>("route", &A::route),
      field<blend::Strongest>("target", &A::target),
      field<blend::Strongest>("release", &A::release),
      field<blend::Strongest>("trigger", &A::trigger),
      field<blend::Strongest>("radar", &A::radar),
      field<blend::Strongest>("call", &A::call),
      field<blend::Strongest>("dispense", &A::dispense),
  };
};
