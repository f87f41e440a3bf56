// SPDX-License-Identifier: MIT
/// \file  The missiles of data/: how fast they get, and how fast they fade.

#include "evidence.hpp"
#include "load.hpp"
#include "model/weapon/engagement.hpp"
#include "model/weapon/flyout.hpp"

namespace eyrie::evidence {

using namespace model;
using namespace model::weapon;

namespace {

/// Mach over time of a straight flight at one altitude from Mach 0.9.
std::vector<Point> flown(const MissileType& type, double altitude, double seconds) {
  constexpr double kStep = 0.02;
  const Air air = standard_air(altitude);
  Flyout flyout{.velocity = {0.9 * air.speed_of_sound, 0, 0}};
  std::vector<Point> points;
  const int steps = static_cast<int>(std::lround(seconds / kStep));
  for (int i = 0; i <= steps; ++i) {
    points.push_back({i * kStep, norm(flyout.velocity) / air.speed_of_sound});
    fly(type, air, {}, {0, 0, 1}, i * kStep, kStep, {0, 0, -kGravity}, flyout);
  }
  return points;
}

/// The single-lag guidance system under noise: closed forms against flights through seeker, filter,
/// guidance and autopilot.
void noise_rows(std::vector<Row>& rows) {
  const NoisyApproach ideal;
  const auto add = [&](const char* claim, const SeekerType& errors, double unit, double published) {
    rows.push_back({.model = "seeker",
                    .page = "missile.md",
                    .claim = claim,
                    .here = spread_of_miss({.errors = errors}) / unit,
                    .published = published,
                    .source = "adjoint of the single-lag system, Zarchan, ch. 3 and 6 (not seen)",
                    .test = "Noise.MissesAsASingleLagDoes"});
  };
  add("gain 4, one lag T: miss under white glint Φ, in √(Φ/T)",
      {.angle_noise = 0, .glint = 3, .glint_time = 1e-3}, 3 * std::sqrt(ideal.step / ideal.lag),
      std::sqrt(93.0 / 32));
  add("the same: under glint σ that wanders in T, in σ",
      {.angle_noise = 0, .glint = 3, .glint_time = ideal.lag}, 3, std::sqrt(147.0 / 128));
  add("the same: under white angle noise Φ, in V_c √(Φ T)", {.angle_noise = 1e-3},
      1e-3 * ideal.closing * std::sqrt(ideal.step * ideal.lag), std::sqrt(5.0 / 16));
}

double highest(const std::vector<Point>& points) {
  double y = 0;
  for (const Point& p : points)
    y = std::max(y, p.y);
  return y;
}

}  // namespace

Evidence of_missiles(const std::string& home) {
  struct Type {
    const char* name;
    const char* label;
    double low, high;  ///< published Mach at sea level and in thin air
  };
  Evidence out;
  Plot low{.file = "missile_speed_low",
           .title = "Missiles fired level at Mach 0.9, sea level",
           .x = "s",
           .y = "Mach"};
  Plot high{.file = "missile_speed_high",
            .title = "Missiles fired level at Mach 0.9, 12 km",
            .x = "s",
            .y = "Mach"};
  for (const Type& t : {Type{"aim120", "AIM-120", 0, 4},
                        {"r77", "R-77", 0, 4},
                        {"aim9", "AIM-9M", 2.5, 0},
                        {"r73", "R-73", 2.5, 0}}) {
    const auto type = load<MissileType>(home, fmt::format("data/missiles/{}.yaml", t.name));
    const auto below = flown(type, 0, 40), above = flown(type, 12e3, 60);
    for (const auto& [published, points, plot, where] :
         {std::tuple{t.low, &below, &low, "at sea level"}, {t.high, &above, &high, "at 12 km"}}) {
      Series series{t.label, {}};
      for (std::size_t i = 0; i < points->size(); i += 20)
        series.points.push_back((*points)[i]);
      plot->series.push_back(series);
      if (published > 0)
        out.rows.push_back(
            {.model = fmt::format("missile, {}", t.label),
             .page = "missile.md",
             .claim = fmt::format("top Mach {}", where),
             .here = highest(*points),
             .published = published,
             .source = "fact sheets and manufacturers, from general knowledge (not seen)",
             .test = "Motor.OfEachMissileReachesItsPublishedSpeed",
             .plot = plot->file});
    }
  }
  noise_rows(out.rows);
  out.plots = {low, high};
  return out;
}

}  // namespace eyrie::evidence
