// SPDX-License-Identifier: MIT
#pragma once
/// \file  From where a missile reaches a target: found by flying it, kept as a table.
#include <functional>
#include <vector>

#include "model/weapon/seeker_type.hpp"

namespace eyrie::model::weapon {

struct MissileType;

/// A launch situation. Altitudes in m, speeds in m/s.
struct LaunchSituation {
  double shooter_altitude = 0;
  double target_altitude = 0;
  double shooter_speed = 0;
  double target_speed = 0;
  double aspect = 0;         ///< rad in [0, pi]: 0 the target comes head-on, pi it flies away
  double off_boresight = 0;  ///< rad in [0, pi]: shooter's velocity to line of sight
};

/// A range of the zone, as a shot doctrine names it.
enum class ZoneRange : std::uint8_t { r_ne, r_tr, r_max };
constexpr auto names_of(ZoneRange) {
  return names_from_zero<ZoneRange>("r_ne", "r_tr", "r_max");
}

/// Ranges in m from the shooter to the target at launch; r_ne <= r_tr <= r_max, for each set of
/// maneuvers contains the one before. All 0 where no launch succeeds.
struct EmploymentZone {
  double r_max = 0;  ///< reaches a target that keeps its course
  double r_tr = 0;   ///< turn and run: reaches it even so
  double r_ne = 0;  ///< no escape: reaches it whatever it does of these, a beam and a dive (Escape)
  double r_min = 0;  ///< nearer, it cannot arm, turn or get clear in time; no escape up to r_ne

  [[nodiscard]] bool possible() const { return r_max > r_min; }
  [[nodiscard]] double operator[](ZoneRange of) const {
    return of == ZoneRange::r_ne ? r_ne : of == ZoneRange::r_tr ? r_tr : r_max;
  }
  /// m: so many times one of the ranges, and r_max at most.
  [[nodiscard]] double range_at(double share, ZoneRange of) const {
    return std::min(share * (*this)[of], r_max);
  }
};

/// One player at launch: local frame, m and m/s; altitude in m.
struct LaunchParty {
  Vec3 position, velocity;
  double altitude = 0;
};
[[nodiscard]] LaunchSituation launch_situation(const LaunchParty& shooter,
                                               const LaunchParty& target);

/// The ranges that were found, at every situation of a grid.
struct ZoneTable {
  static constexpr double kUnit = 4;  ///< m
  struct Cell {
    std::uint16_t r_max = 0, r_tr = 0, r_ne = 0, r_min = 0;  ///< kUnit; r_min rounded up
    bool operator==(const Cell&) const = default;
  };
  static constexpr std::size_t kCells = 12600;
  std::vector<Cell> cells = std::vector<Cell>(kCells);

  bool operator==(const ZoneTable&) const = default;
};

/// The ends of the table, where shooter and target fly alike: m, and m/s.
inline constexpr double kLowestZone = 300, kHighestZone = 15e3, kSlowestZone = 100,
                        kFastestZone = 550;

/// Says how much of a table has been found, 0 to 1; called from any thread.
using ZoneProgress = std::function<void(double)>;
/// Flies the missile against targets that keep their course and that escape, and bisects the ranges
/// on the grid: about a second on one core. The same bits on every CPU, for any number of workers.
/// docs/models/missile.md has the grid and what it is worth.
[[nodiscard]] ZoneTable fly_zone(const MissileType& type, unsigned workers = 1,
                                 const ZoneProgress& progress = {});
/// The ranges of one situation, which fly_zone() finds for every one of its grid. `guess`: where
/// the search begins.
[[nodiscard]] EmploymentZone fly_situation(const MissileType& type,
                                           const LaunchSituation& situation,
                                           const EmploymentZone& guess = {});
/// The grid and the rules of the search as bytes: a table that was found by others is another one.
[[nodiscard]] std::string zone_search_bits();

/// The employment zone of one missile type, const.
class LaunchZone {
 public:
  /// Everywhere impossible.
  LaunchZone() = default;
  /// `table`: what fly_zone(type) gives.
  LaunchZone(const MissileType& type, std::shared_ptr<const ZoneTable> table);
  [[nodiscard]] const std::shared_ptr<const ZoneTable>& table() const { return table_; }

  /// Multilinear between the situations that were flown, constant beyond them; but none farther off
  /// the boresight than was flown: 60 degrees, or the gimbal of a missile that must be locked on
  /// before launch. Such a one reaches no farther than it sees a target of the default
  /// InfraredSignature at military power.
  [[nodiscard]] EmploymentZone at(const LaunchSituation& situation) const;
  /// m: no r_ne that at() gives is longer.
  [[nodiscard]] double longest_no_escape() const { return longest_no_escape_; }

 private:
  std::shared_ptr<const ZoneTable> table_;
  double farthest_off_ = 1;           ///< rad
  double longest_no_escape_ = 0;      ///< m
  std::optional<SeekerType> seeker_;  ///< if it must see the target before launch
};

}  // namespace eyrie::model::weapon
