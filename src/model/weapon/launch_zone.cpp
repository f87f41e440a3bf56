// SPDX-License-Identifier: MIT
#include "model/weapon/launch_zone.hpp"

#include "model/signature.hpp"
#include "model/weapon/engagement.hpp"
#include "model/weapon/missile.hpp"
#include "model/weapon/seeker.hpp"

namespace eyrie::model::weapon {

namespace {

// the grid, slowest index first: the three last axes lie together in memory
constexpr std::array kAspect{0.0, radians(25), radians(50), radians(90), radians(135), kPi};
constexpr std::array kAltitude{300.0, 3000.0, 6000.0, 9000.0, 12000.0, 15000.0};  // shooter
constexpr std::array kClimb{-5000.0, 0.0, 5000.0};  // target's altitude less the shooter's
constexpr std::array kShooterSpeed{180.0, 420.0};
constexpr std::array kTargetSpeed{150.0, 400.0};
constexpr std::array kOffBoresight{0.0, radians(60)};
constexpr std::size_t kInner = kShooterSpeed.size() * kTargetSpeed.size() * kOffBoresight.size();
static_assert(kInner == 8);
static_assert(kAspect.size() * kAltitude.size() * kClimb.size() * kInner == ZoneTable::kCells);

constexpr double kLowest = 100;      // m, no target is lower
constexpr double kNearest = 100;     // m, nothing is launched nearer
constexpr double kFarthest = 250e3;  // m, nothing reaches farther
constexpr double kStep = 1.25;       // factor between two ranges of a search
constexpr double kFarTolerance = 1.04, kNearTolerance = 1.1;  // factors, of a range that is found
constexpr EmploymentZone kFirstGuess{.r_max = 40e3, .r_tr = 20e3, .r_ne = 15e3, .r_min = 1e3};
constexpr double kVersion = 2;  // of what Search does: raise it when that changes

/// Where a value lies on an axis, clamped to it.
struct GridCell {
  std::size_t index;
  float share;  // of the upper neighbor
  [[nodiscard]] float weight(bool upper) const { return upper ? share : 1 - share; }
};
template <std::size_t N>
GridCell place(const std::array<double, N>& axis, double x) {
  std::size_t i = 0;
  while (i + 2 < N && x >= axis[i + 1])
    ++i;
  const double share = (x - axis[i]) / (axis[i + 1] - axis[i]);
  return {i, static_cast<float>(std::clamp(share, 0.0, 1.0))};
}

// what a target may do, beyond what it may do within the range before
constexpr std::array kKeepsCourse{Escape::none};
constexpr std::array kRuns{Escape::run};
constexpr std::array kEscapes{Escape::beam, Escape::dive};

/// Searches the ranges of one situation by flying.
class Search {
 public:
  Search(const MissileType& type, const Atmosphere& atmosphere, const LaunchSituation& situation)
      : type_(type), atmosphere_(atmosphere) {
    engagement_.situation = situation;
    const double climb = situation.target_altitude - situation.shooter_altitude;
    least_ = std::max(kNearest, 1.001 * std::fabs(climb));
  }

  /// The longest range up to `longest` (m) at which the missile reaches the target whichever of
  /// these it does, searched from `guess` (m); 0 if there is none.
  double farthest(std::span<const Escape> escapes, double longest, double guess) {
    escapes_ = escapes;
    double good = std::clamp(guess, least_, longest);
    double bad = good * kStep;
    if (succeeds(good)) {
      if (good == longest)
        return longest;
      for (; bad < longest && succeeds(bad); bad *= kStep)
        good = bad;
      bad = std::min(bad, longest);
    } else {
      do {
        bad = good;
        good = bad / kStep;
        if (good < least_)
          return 0;
      } while (!succeeds(good));
    }
    return bisected(good, bad, kFarTolerance);
  }

  /// The shortest range up to `longest` (m, which succeeds) from which on every range succeeds,
  /// searched from `guess` (m).
  double nearest(double longest, double guess) {
    escapes_ = kKeepsCourse;
    if (succeeds(least_))
      return least_;
    double good = std::clamp(guess, least_, longest);
    double bad = least_;
    if (succeeds(good)) {
      for (double next = good / kStep; next > least_ && succeeds(next); next = good / kStep)
        good = next;
      bad = std::max(good / kStep, least_);
    } else {
      do {
        bad = good;
        good = std::min(bad * kStep, longest);
      } while (good < longest && !succeeds(good));
    }
    return bisected(good, bad, kNearTolerance);
  }

 private:
  bool succeeds(double range) {
    engagement_.range = range;
    return std::all_of(escapes_.begin(), escapes_.end(), [&](Escape escape) {
      engagement_.escape = escape;
      return engage(type_, atmosphere_, engagement_).success(type_);
    });
  }
  /// The last range that succeeded when the next that failed is within a factor.
  double bisected(double good, double bad, double tolerance) {
    while (std::max(good, bad) > std::min(good, bad) * tolerance) {
      const double range = std::sqrt(good * bad);
      (succeeds(range) ? good : bad) = range;
    }
    return good;
  }

  const MissileType& type_;
  const Atmosphere& atmosphere_;
  Engagement engagement_;
  std::span<const Escape> escapes_;
  double least_ = kNearest;
};

/// The zone of one situation; `guess` is that of a neighbor.
EmploymentZone search_zone(Search search, const EmploymentZone& guess) {
  EmploymentZone zone;
  zone.r_max = search.farthest(kKeepsCourse, kFarthest, guess.r_max);
  if (zone.r_max == 0)
    return {};
  const auto near = [&](double known, double share) {
    return known > 0 ? known : share * zone.r_max;
  };
  zone.r_tr = search.farthest(kRuns, zone.r_max, near(guess.r_tr, 0.5));
  zone.r_ne = zone.r_tr > 0 ? search.farthest(kEscapes, zone.r_tr, near(guess.r_ne, 0.4)) : 0;
  zone.r_min = search.nearest(zone.r_max, guess.r_min);
  return zone;
}

/// The speeds and the angle off the nose make eight columns; each is searched by itself.
void fill_column(const MissileType& type, const Atmosphere& atmosphere, std::size_t i,
                 ZoneTable& table) {
  // a search begins where that of the cell before ended
  EmploymentZone found = kFirstGuess;
  std::size_t cell = i;
  for (const double aspect : kAspect)
    for (const double altitude : kAltitude)
      for (const double climb : kClimb) {
        const LaunchSituation situation{.shooter_altitude = altitude,
                                        .target_altitude = std::max(altitude + climb, kLowest),
                                        .shooter_speed = kShooterSpeed[i >> 2],
                                        .target_speed = kTargetSpeed[(i >> 1) & 1],
                                        .aspect = aspect,
                                        .off_boresight = kOffBoresight[i & 1]};
        const EmploymentZone z = search_zone({type, atmosphere, situation}, found);
        if (z.r_max > 0)
          found = z;
        table.cells[cell] = {static_cast<float>(z.r_max), static_cast<float>(z.r_tr),
                             static_cast<float>(z.r_ne), static_cast<float>(z.r_min)};
        cell += kInner;
      }
}

}  // namespace

LaunchSituation launch_situation(const LaunchParty& shooter, const LaunchParty& target) {
  const Vec3 sight = target.position - shooter.position;
  return {.shooter_altitude = shooter.altitude,
          .target_altitude = target.altitude,
          .shooter_speed = norm(shooter.velocity),
          .target_speed = norm(target.velocity),
          .aspect = angle_between(target.velocity, -sight),
          .off_boresight = angle_between(shooter.velocity, sight)};
}

double EmploymentZone::depth(double range) const {
  if (range <= r_ne)
    return r_ne > 0 ? range / r_ne - 1 : 0;
  if (range <= r_tr)
    return 0.5 * (range - r_ne) / (r_tr - r_ne);
  return r_max > r_tr && range <= r_max ? 0.5 + 0.5 * (range - r_tr) / (r_max - r_tr)
                                        : range / std::max(r_max, 1.0);
}

double EmploymentZone::range_at(double depth) const {
  if (depth <= 0)
    return (1 + depth) * r_ne;
  return depth <= 0.5 ? r_ne + 2 * depth * (r_tr - r_ne) : r_tr + (2 * depth - 1) * (r_max - r_tr);
}

ZoneTable fly_zone(const MissileType& type) {
  const Atmosphere atmosphere;
  ZoneTable table;
  for (std::size_t i = 0; i < kInner; ++i)
    fill_column(type, atmosphere, i, table);
  return table;
}

std::string zone_search_bits() {
  std::string bits;
  append_bits(bits, kAspect);
  append_bits(bits, kAltitude);
  append_bits(bits, kClimb);
  append_bits(bits, kShooterSpeed);
  append_bits(bits, kTargetSpeed);
  append_bits(bits, kOffBoresight);
  append_bits(bits, std::array{kLowest, kNearest, kFarthest, kStep, kFarTolerance, kNearTolerance,
                               kFirstGuess.r_max, kFirstGuess.r_tr, kFirstGuess.r_ne,
                               kFirstGuess.r_min, kEscapeLoadFactor, kVersion});
  return bits;
}

LaunchZone::LaunchZone(const MissileType& type, std::shared_ptr<const ZoneTable> table)
    : table_(std::move(table)) {
  if (type.locks_before_launch())
    seeker_ = type.seeker;
}

EmploymentZone LaunchZone::at(const LaunchSituation& s) const {
  if (!table_ || (seeker_ && s.off_boresight > seeker_->gimbal))
    return {};
  const GridCell shooter_speed = place(kShooterSpeed, s.shooter_speed);
  const GridCell target_speed = place(kTargetSpeed, s.target_speed);
  const GridCell off_boresight = place(kOffBoresight, s.off_boresight);
  std::array<float, kInner> inner;
  for (std::size_t i = 0; i < kInner; ++i)
    inner[i] = shooter_speed.weight((i & 4) != 0) * target_speed.weight((i & 2) != 0) *
               off_boresight.weight((i & 1) != 0);

  const GridCell aspect = place(kAspect, s.aspect);
  const GridCell altitude = place(kAltitude, s.shooter_altitude);
  const GridCell climb = place(kClimb, s.target_altitude - s.shooter_altitude);
  ZoneTable::Cell sum;
  for (std::size_t o = 0; o < 8; ++o) {
    const std::size_t a = o >> 2, b = (o >> 1) & 1, c = o & 1;
    const float weight = aspect.weight(a != 0) * altitude.weight(b != 0) * climb.weight(c != 0);
    const std::size_t row = (aspect.index + a) * kAltitude.size() + altitude.index + b;
    const ZoneTable::Cell* cell = &table_->cells[(row * kClimb.size() + climb.index + c) * kInner];
    for (std::size_t i = 0; i < kInner; ++i, ++cell) {
      const float w = weight * inner[i];
      sum.r_max += w * cell->r_max;
      sum.r_tr += w * cell->r_tr;
      sum.r_ne += w * cell->r_ne;
      sum.r_min += w * cell->r_min;
    }
  }
  double seen = kFarthest;
  if (seeker_) {
    const InfraredSignature typical;
    seen = acquisition_range(*seeker_, radiant_intensity(typical, math::cos(s.aspect), 1));
  }
  return {.r_max = std::min<double>(sum.r_max, seen),
          .r_tr = std::min<double>(sum.r_tr, seen),
          .r_ne = std::min<double>(sum.r_ne, seen),
          .r_min = sum.r_min};
}

}  // namespace eyrie::model::weapon
