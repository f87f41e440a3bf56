// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "core/units.hpp"
#include "support/flight.hpp"

namespace eyrie::test {
namespace {

/// What the eagles believe of the range of the nearer bogey, 1-sigma (m), and how far it is.
std::pair<double, double> knowledge(const Flight& f) {
  const auto row = f.row("eagle1").value();
  const auto& file = f.world().rows(f.scenario->aircraft.tracks)[row];
  const Vec3 own = f.world().rows(f.scenario->aircraft.kinematics)[row].position;
  const Vec3 other =
      f.world().rows(f.scenario->aircraft.kinematics)[f.row("bogey1").value()].position;
  for (std::uint32_t i = 0; i < file.count; ++i)
    if (file.tracks[i].truth == f.scenario->roster.find("bogey1"))
      return {static_cast<double>(file.tracks[i].position_sigma), norm(other - own)};
  return {0, norm(other - own)};
}

TEST(Jamming, GivesDirectionsWithoutRangesUntilItIsBurntThrough) {
  Flight jammed(load_scenario("jamming"));
  jammed.fly_until(200);
  const auto [unsure, distance] = knowledge(jammed);
  EXPECT_GT(distance, si(60, "nmi"));
  EXPECT_GT(unsure, 5e3) << "both eagles have directions from nearly the same place";
  Flight clear(load_scenario("jamming", {"data.aircraft.jamming_su27.jammer=null"}));
  clear.fly_until(200);
  const double sure = knowledge(clear).first;
  EXPECT_GT(sure, 0);
  EXPECT_LT(sure, 2e3);
}

/// m, how far the bogey is when its range is known to 500 m for the first time, in some seeds; 0:
/// never. In order.
std::vector<double> ranges_known_at(const std::vector<std::string>& sets) {
  std::vector<double> ranges;
  for (std::uint64_t seed = 1; seed <= 9; ++seed) {
    Flight f(load_scenario("jamming", sets), seed);
    double known_at = 0;
    for (int second = 10; second < 600 && known_at == 0; second += 2) {
      f.fly_until(second);
      if (!f.row("eagle1") || !f.row("bogey1"))
        break;
      const auto [unsure, distance] = knowledge(f);
      if (unsure > 0 && unsure < 500)
        known_at = distance;
    }
    ranges.push_back(known_at);
  }
  std::sort(ranges.begin(), ranges.end());
  return ranges;
}

TEST(Jamming, HidesTheRangeUntilTheEchoBurnsThrough) {
  const auto clear = ranges_known_at({"data.aircraft.jamming_su27.jammer=null"});
  const auto jammed = ranges_known_at({});
  EXPECT_GT(clear[4], si(50, "nmi"));
  EXPECT_LT(jammed[4], 0.6 * clear[4]);
  EXPECT_GT(jammed[8], 0) << "even odds are at 21 km";
}

}  // namespace
}  // namespace eyrie::test
