// SPDX-License-Identifier: MIT
#include "model/weapon/launch_zone.hpp"

#include <atomic>

#include "core/executor.hpp"
#include "model/signature.hpp"
#include "model/weapon/engagement.hpp"
#include "model/weapon/missile.hpp"
#include "model/weapon/seeker.hpp"

namespace eyrie::model::weapon {

namespace {

// the grid, slowest index first: the three last axes lie together in memory
constexpr std::array kAspect{0.0,          radians(30),  radians(60), radians(90),
                             radians(120), radians(150), kPi};
constexpr std::array kAltitude{300.0, 3000.0, 6000.0, 9000.0, 12000.0, 15000.0};  // shooter
constexpr std::array kClimb{-6000.0, -3000.0, 0.0, 3000.0,
                            6000.0};  // target's altitude less the shooter's
constexpr std::size_t kLevel = 2;     // of kClimb
constexpr std::array kShooterSpeed{100.0, 250.0, 400.0, 550.0};
constexpr std::array kTargetSpeed{100.0, 200.0, 300.0, 400.0, 550.0};
constexpr std::array kOffBoresight{0.0, 0.5, 1.0};  // of farthest_off()
constexpr std::size_t kInner = kShooterSpeed.size() * kTargetSpeed.size() * kOffBoresight.size();
static_assert(kAspect.size() * kAltitude.size() * kClimb.size() * kInner == ZoneTable::kCells);

static_assert(kAltitude.front() == kLowestZone && kAltitude.back() == kHighestZone);
static_assert(kShooterSpeed.front() == kSlowestZone && kTargetSpeed.front() == kSlowestZone &&
              kShooterSpeed.back() == kFastestZone && kTargetSpeed.back() == kFastestZone);

constexpr double kFarthestOff = radians(60);
constexpr double kLowest = 100;      // m, no target is lower
constexpr double kNearest = 100;     // m, nothing is launched nearer
constexpr double kFarthest = 250e3;  // m, nothing reaches farther
constexpr double kStep = 1.4;        // factor between two ranges of a search
constexpr double kFarTolerance = 1.04, kNearTolerance = 1.1;  // factors, of a range that is found
constexpr EmploymentZone kFirstGuess{.r_max = 40e3, .r_min = 1e3};
constexpr double kVersion = 4;  // of what Search does: raise it when that changes

/// rad, off the boresight that the table goes to: what must be seen before launch is in the gimbal.
double farthest_off(const MissileType& type) {
  return type.locks_before_launch() ? std::min(type.seeker.gimbal, kFarthestOff) : kFarthestOff;
}

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
constexpr std::array kAnyEscape{Escape::run, Escape::beam, Escape::dive};

/// Searches the ranges of one situation by flying.
class Search {
 public:
  Search(const MissileType& type, const Atmosphere& atmosphere, const LaunchSituation& situation)
      : type_(type), atmosphere_(atmosphere) {
    engagement_.situation = situation;
    const double climb = situation.target_altitude - situation.shooter_altitude;
    least_ = std::max(kNearest, 1.001 * std::fabs(climb));
  }

  /// The longest range (m) at which the missile reaches a target that keeps its course, searched
  /// from `guess`, which is rather too long than too short: what is too near fails as well. 0 if
  /// there is none.
  double farthest(double guess) {
    double range = std::clamp(guess, least_, kFarthest);
    escapes_ = kKeepsCourse;
    if (!succeeds(range))
      return farthest(kKeepsCourse, range);
    while (range < kFarthest && succeeds(range * kStep))
      range *= kStep;
    return range < kFarthest ? bisected(range, range * kStep, kFarTolerance) : kFarthest;
  }
  /// The longest range up to `longest` (m) at which it reaches the target whichever of these it
  /// does; 0 if there is none.
  double farthest(std::span<const Escape> escapes, double longest) {
    escapes_ = escapes;
    double good = longest, bad = longest;
    for (; !succeeds(good); good /= kStep) {
      if (good < least_ * kStep)
        return 0;
      bad = good;
    }
    return bisected(good, bad, kFarTolerance);
  }

  /// The shortest range up to `longest` (m, which succeeds) from which on every range succeeds
  /// whichever of these the target does, searched from `guess` (m).
  double nearest(std::span<const Escape> escapes, double longest, double guess) {
    escapes_ = escapes;
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
    return std::ranges::all_of(escapes_, [&](Escape escape) {
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
  zone.r_max = search.farthest(std::max(guess.r_max * kStep, kFirstGuess.r_max));
  if (zone.r_max == 0)
    return {};
  zone.r_tr = search.farthest(kRuns, zone.r_max);
  zone.r_ne = zone.r_tr > 0 ? search.farthest(kEscapes, zone.r_tr) : 0;
  zone.r_min = search.nearest(kKeepsCourse, zone.r_max, guess.r_min);
  // nobody escapes between r_min and r_ne: a turn from near may be more than the missile can follow
  if (zone.r_ne > zone.r_min)
    zone.r_min = std::max(zone.r_min, search.nearest(kAnyEscape, zone.r_ne, zone.r_min));
  return zone;
}

/// The situation of a cell.
LaunchSituation situation_of(const MissileType& type, std::size_t cell) {
  const auto next = [&](const auto& axis) {
    const double value = axis[cell % axis.size()];
    cell /= axis.size();
    return value;
  };
  // the fastest index first
  LaunchSituation s;
  s.off_boresight = next(kOffBoresight) * farthest_off(type);
  s.target_speed = next(kTargetSpeed);
  s.shooter_speed = next(kShooterSpeed);
  const double climb = next(kClimb);
  s.shooter_altitude = next(kAltitude);
  s.aspect = next(kAspect);
  s.target_altitude = std::max(s.shooter_altitude + climb, kLowest);
  return s;
}

std::uint16_t units(double range) {
  return static_cast<std::uint16_t>(range / ZoneTable::kUnit);
}

}  // namespace

EmploymentZone fly_situation(const MissileType& type, const LaunchSituation& situation,
                             const EmploymentZone& guess) {
  const Atmosphere atmosphere;
  return search_zone({type, atmosphere, situation}, guess.r_max > 0 ? guess : kFirstGuess);
}

LaunchSituation launch_situation(const LaunchParty& shooter, const LaunchParty& target) {
  const Vec3 sight = target.position - shooter.position;
  return {.shooter_altitude = shooter.altitude,
          .target_altitude = target.altitude,
          .shooter_speed = norm(shooter.velocity),
          .target_speed = norm(target.velocity),
          .aspect = angle_between(target.velocity, -sight),
          .off_boresight = angle_between(shooter.velocity, sight)};
}

ZoneTable fly_zone(const MissileType& type, unsigned workers, const ZoneProgress& progress) {
  ZoneTable table;
  std::atomic<std::size_t> done = 0;
  Executor(workers).for_chunks(
      table.cells.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
        // a search begins where that of the cell before ended
        EmploymentZone found = kFirstGuess;
        for (std::size_t i = begin; i < end; ++i) {
          const EmploymentZone z = fly_situation(type, situation_of(type, i), found);
          if (z.r_max > 0)
            found = z;
          table.cells[i] = {units(z.r_max), units(z.r_tr), units(z.r_ne),
                            units(z.r_min + ZoneTable::kUnit - 1)};
        }
        done += end - begin;
        if (progress)
          progress(static_cast<double>(done) / static_cast<double>(table.cells.size()));
      });
  // where the difference of altitude is more than the missile reaches, no range of that length
  // exists: the reach of level launches stands there, so that what lies between is not drawn down
  for (std::size_t i = 0; i < table.cells.size(); ++i) {
    const std::size_t climb = i / kInner % kClimb.size();
    ZoneTable::Cell& cell = table.cells[i];
    if (cell.r_max > 0 || kClimb[climb] == 0)
      continue;
    const std::uint16_t least = units(std::fabs(kClimb[climb]));
    const ZoneTable::Cell& level = table.cells[i + (kLevel - climb) * kInner];
    cell = {std::min(level.r_max, least), std::min(level.r_tr, least), std::min(level.r_ne, least),
            std::min(level.r_min, least)};
  }
  return table;
}

std::string zone_search_bits() {
  std::string bits;
  const auto append = [&](const auto&... numbers) { (append_bits(bits, numbers), ...); };
  append(
      kAspect, kAltitude, kClimb, kShooterSpeed, kTargetSpeed, kOffBoresight,
      std::array{kFarthestOff, kLowest, kNearest, kFarthest, kStep, kFarTolerance, kNearTolerance,
                 kFirstGuess.r_max, kFirstGuess.r_min, kEscapeLoadFactor, kVersion});
  return bits;
}

LaunchZone::LaunchZone(const MissileType& type, std::shared_ptr<const ZoneTable> table)
    : table_(std::move(table)), farthest_off_(farthest_off(type)) {
  if (type.locks_before_launch())
    seeker_ = type.seeker;
  constexpr double kRounding = 1.0001;  // of at()'s sum of floats
  if (table_)
    for (const ZoneTable::Cell& cell : table_->cells)
      longest_no_escape_ = std::max(longest_no_escape_, kRounding * cell.r_ne * ZoneTable::kUnit);
}

EmploymentZone LaunchZone::at(const LaunchSituation& s) const {
  if (!table_ || s.off_boresight > farthest_off_)
    return {};
  const GridCell speeds[] = {place(kShooterSpeed, s.shooter_speed),
                             place(kTargetSpeed, s.target_speed),
                             place(kOffBoresight, s.off_boresight / farthest_off_)};
  // the eight neighbors along the three inner axes: where they lie and what each weighs
  std::array<std::size_t, 8> offset;
  std::array<float, 8> inner;
  for (std::size_t i = 0; i < 8; ++i) {
    const std::size_t a = i >> 2, b = (i >> 1) & 1, c = i & 1;
    offset[i] =
        ((speeds[0].index + a) * kTargetSpeed.size() + speeds[1].index + b) * kOffBoresight.size() +
        speeds[2].index + c;
    inner[i] = speeds[0].weight(a != 0) * speeds[1].weight(b != 0) * speeds[2].weight(c != 0);
  }
  const GridCell aspect = place(kAspect, s.aspect);
  const GridCell altitude = place(kAltitude, s.shooter_altitude);
  const GridCell climb = place(kClimb, s.target_altitude - s.shooter_altitude);
  // r_max, r_tr, r_ne and r_min side by side: a cell is read at once, its numbers zero-extended
  using Four = float __attribute__((vector_size(16)));
  using Whole = std::int32_t __attribute__((vector_size(16)));
  using Eight = std::uint16_t __attribute__((vector_size(16)));
  using Long = std::uint64_t __attribute__((vector_size(16)));
  static_assert(std::endian::native == std::endian::little);
  Four ranges{};
  for (std::size_t o = 0; o < 8; ++o) {
    const std::size_t a = o >> 2, b = (o >> 1) & 1, c = o & 1;
    const float weight = aspect.weight(a != 0) * altitude.weight(b != 0) * climb.weight(c != 0);
    const std::size_t row = (aspect.index + a) * kAltitude.size() + altitude.index + b;
    const ZoneTable::Cell* cells = &table_->cells[(row * kClimb.size() + climb.index + c) * kInner];
    for (std::size_t i = 0; i < 8; ++i) {
      const auto cell = std::bit_cast<Eight>(Long{std::bit_cast<std::uint64_t>(cells[offset[i]])});
      const auto units =
          std::bit_cast<Whole>(__builtin_shufflevector(cell, Eight{}, 0, 8, 1, 9, 2, 10, 3, 11));
      ranges += weight * inner[i] * static_cast<float>(ZoneTable::kUnit) *
                __builtin_convertvector(units, Four);
    }
  }
  double seen = kFarthest;
  if (seeker_) {
    const InfraredSignature typical;
    seen = acquisition_range(*seeker_, radiant_intensity(typical, math::cos(s.aspect), 1));
  }
  return {.r_max = std::min<double>(ranges[0], seen),
          .r_tr = std::min<double>(ranges[1], seen),
          .r_ne = std::min<double>(ranges[2], seen),
          .r_min = ranges[3]};
}

}  // namespace eyrie::model::weapon
