// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <limits>

#include "core/units.hpp"
#include "support/flight.hpp"

namespace eyrie::test {
namespace {

/// s, when the eagles shoot for the first time, over some seeds, the middle one; who never does is
/// later than all. And their kills.
std::pair<double, int> first_shot(const std::vector<std::string>& sets) {
  std::vector<double> times;
  int kills = 0;
  for (std::uint64_t seed = 1; seed <= 15; ++seed) {
    Flight f(load_scenario("jamming", sets), seed);
    f.mission.fly();
    times.push_back(std::numeric_limits<double>::infinity());
    for (const Happened& h : f.log.of(EventKind::launch))
      if (f.scenario->roster.name(PlayerId{static_cast<std::uint32_t>(h.event.detail)})
              .starts_with("eagle")) {
        times.back() = h.time;
        break;
      }
    kills += static_cast<int>(f.tally.side(model::Side::blue).kills);
  }
  std::sort(times.begin(), times.end());
  return {times[times.size() / 2], kills};
}

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
  jammed.fly_until(120);
  const auto [unsure, distance] = knowledge(jammed);
  EXPECT_GT(distance, si(60, "nmi"));
  EXPECT_GT(unsure, 5e3) << "both eagles have directions from nearly the same place";
  Flight clear(load_scenario("jamming", {"data.aircraft.jamming_su27.jammer=null"}));
  clear.fly_until(120);
  const double sure = knowledge(clear).first;
  EXPECT_GT(sure, 0);
  EXPECT_LT(sure, 2e3);
}

TEST(Jamming, MakesThemShootLaterAndStillHit) {
  const auto [jammed, kills] = first_shot({});
  const double clear = first_shot({"data.aircraft.jamming_su27.jammer=null"}).first;
  EXPECT_LT(clear, 1800) << "most of them shoot";
  EXPECT_GT(jammed, clear + 15);
  EXPECT_GT(kills, 0) << "missiles home on the jamming";
}

}  // namespace
}  // namespace eyrie::test
