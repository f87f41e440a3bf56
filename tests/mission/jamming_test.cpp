// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <array>

#include "core/units.hpp"
#include "support/flight.hpp"

namespace eyrie::test {
namespace {

PlayerId shooter_of(const Happened& launch) {
  return PlayerId{static_cast<std::uint32_t>(launch.event.detail)};
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

/// They shoot at what they could reach in the clear (33 km), between the chance echoes and the even
/// odds: so jamming costs them no time, but they wait until they know the range.
TEST(Jamming, IsNotShotAtBeforeTheRangeIsKnown) {
  int shots = 0;
  for (std::uint64_t seed = 1; seed <= 9; ++seed) {
    Flight f(load_scenario("jamming"), seed);
    std::optional<Happened> shot;
    for (int tenth = 3000; tenth < 7000 && !(shot = f.log.first(EventKind::launch)); ++tenth)
      f.fly_until(tenth / 10.0);
    const auto shooter = shot ? f.row(f.scenario->roster.name(shooter_of(*shot))) : std::nullopt;
    const auto bogey = shot ? f.row(f.scenario->roster.name(shot->event.whom)) : std::nullopt;
    if (!shooter || !bogey || f.scenario->roster.name(shooter_of(*shot)).starts_with("bogey"))
      continue;
    ++shots;
    const auto& file = f.world().rows(f.scenario->aircraft.tracks)[*shooter];
    const auto places = f.world().rows(f.scenario->aircraft.kinematics);
    const auto track = std::find_if(file.tracks.begin(), file.tracks.end(),
                                    [&](const auto& t) { return t.truth == shot->event.whom; });
    ASSERT_NE(track, file.tracks.end());
    const double range = norm(places[*bogey].position - places[*shooter].position);
    EXPECT_LT(static_cast<double>(track->position_sigma), 0.05 * range) << seed;
    EXPECT_NEAR(norm(track->position - places[*shooter].position), range, 0.1 * range) << seed;
  }
  EXPECT_GE(shots, 3);
}

/// What the bogeys' jammers do to the locks of eagles whose radars lock within 40 nmi, in some
/// seeds.
struct Locks {
  int pulled = 0;    ///< times that the gates were taken along for more than 6 s
  int broken = 0;    ///< of these, those that ended without a lock, or with that on another track
  int regained = 0;  ///< and those that ended on the echo
};
Locks locks_against(const std::string& jammer) {
  Locks result;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Flight f(load_scenario("jamming", {"data.aircraft.jamming_su27.jammer=" + jammer,
                                       "data.radars={far_lock: {base: apg63, lock_range: 40 nmi}}",
                                       "data.aircraft.locking_f15c={base: f15c, radar: far_lock}",
                                       "blue.flights.eagle.aircraft=locking_f15c"}),
             seed);
    std::array<TrackId, 2> pulled{};
    for (int tenth = 3000; tenth < 7000; ++tenth) {
      f.fly_until(tenth / 10.0);
      for (std::size_t i = 0; i < 2; ++i) {
        const auto row = f.row(i == 0 ? "eagle1" : "eagle2");
        if (!row)
          continue;
        const auto& radar = f.world().rows(f.scenario->aircraft.radar)[*row];
        const TrackId on = radar.locked ? radar.designated : TrackId{};
        const bool far = on && radar.pulled > 6;
        result.pulled += far && !pulled[i];
        if (pulled[i] && !far)
          ++(on == pulled[i] ? result.regained : result.broken);
        pulled[i] = far ? on : TrackId{};
      }
    }
  }
  return result;
}

TEST(Jamming, PullsTheGatesOfLocksOffAndBreaksThem) {
  const Locks deceived = locks_against("deceiver"), clear = locks_against("null");
  EXPECT_GT(deceived.pulled, 5);
  EXPECT_GE(deceived.broken, deceived.pulled - 2) << "a locked eagle may be shot down";
  EXPECT_EQ(deceived.regained, 0) << "the echo is too far from the gates";
  EXPECT_EQ(clear.pulled, 0);
}

}  // namespace
}  // namespace eyrie::test
