// SPDX-License-Identifier: MIT
#include "model/weapon/homing.hpp"

#include <gtest/gtest.h>

#include "model/weapon/missile.hpp"
#include "support/model/firing_range.hpp"

namespace eyrie::model::weapon {
namespace {

using test::kMedium;
using test::kShort;
using test::Range;

/// A missile at the origin, 8 km up, northbound at 800 m/s, 5 s after launch at `track`.
struct Missile {
  Kinematics k;
  MissileState state;
};
Missile missile(const Range& range, std::uint16_t type, const Track& track) {
  const Library& library = range.library();
  const Kinematics shooter =
      flight::placed(library.reference, library.environment, {0, 0, -8000}, 0, 800);
  const Newborn born = launched(
      {.type = library.missiles[type], .type_index = type, .shooter = PlayerId{1}, .time = -5},
      shooter, track);
  Missile m{born.kinematics, born.state};
  m.state.active = 1;
  return m;
}

/// A range on which somebody carries a jammer.
Library jammed() {
  Library library = Range::standard();
  library.jammers.add("noise", {.power = 1e3});
  return library;
}

struct Homing : ::testing::Test {
  Range range{1, jammed()};
  TargetScene scene() {
    return TargetScene::of(range.world(), range.aircraft(), range.library(), 0);
  }
  Track track_of(PlayerId whom) {
    const Kinematics& k = range.row(range.aircraft().kinematics, whom);
    return {.position = k.position, .velocity = k.velocity, .id = TrackId{1}, .truth = whom};
  }
  std::optional<Detected> look_once(Missile& m, double time = 0) {
    return look(range.library().missiles[m.state.type], m.k, time, scene(),
                Draw(1, PlayerId{9}, Stream::seeker, 0), m.state);
  }
};

TEST_F(Homing, TakesTheCandidateNearestToTheExpectedPlaceFriendOrFoe) {
  range.add({0, 0, -8000}, 0, 250);
  const PlayerId enemy = range.add({9000, 400, -8000}, kPi, 250, Side::red);
  const PlayerId friendly = range.add({8800, -100, -8000}, kPi, 250, Side::blue);
  Track track = track_of(enemy);
  track.position = {8900, 0, -8000};  // a poor track, nearer to the friend
  Missile m = missile(range, kMedium, track);
  const auto seen = look_once(m);
  ASSERT_TRUE(seen);
  EXPECT_EQ(seen->id, friendly);
  EXPECT_EQ(m.state.seen, friendly);
}

TEST_F(Homing, HomesOnTheJammingWhereTheEchoDrownsInItAndKeepsTheBelievedRange) {
  range.add({0, 0, -8000}, 0, 250);
  const PlayerId enemy = range.add({9000, 400, -8100}, kPi, 250, Side::red);
  Track track = track_of(enemy);
  track.position = {11e3, 400, -8100};  // 2 km too far
  Emission& emission = range.row(range.aircraft().emission, enemy);
  for (const double density : {0.0, 1e3 / 500e6}) {
    emission.jamming = density;
    Missile m = missile(range, kMedium, track);
    const auto seen = look_once(m);
    ASSERT_TRUE(seen) << density;
    EXPECT_EQ(seen->on_jam, density > 0);
    const Vec3 direction = normalized(Vec3{9000, 400, -100}, {});
    EXPECT_LT(norm(m.state.sight - direction), 0.01);
    const double believed = norm(m.state.target_position - m.k.position);
    EXPECT_NEAR(believed, density > 0 ? 11e3 : 9e3, 100);
  }
  // weak jamming is burnt through
  emission.jamming = 1e-12;
  Missile m = missile(range, kMedium, track);
  ASSERT_TRUE(look_once(m));
  EXPECT_NEAR(norm(m.state.target_position - m.k.position), 9e3, 100);
}

/// 1 MW in 500 MHz 60 km away, 30 degrees aside of the target: J/N is 47.5 dB in the beam and 23 dB
/// in its side lobes, so the target is found within 1/3.75 of the range that it is otherwise.
TEST_F(Homing, SeesLessFarUnderTheNoiseOfAJammerThatStandsOff) {
  const SeekerType& seeker = range.library().missiles[kMedium].seeker;
  range.add({0, 0, -8000}, 0, 250);
  const PlayerId enemy = range.add({9000, 0, -8100}, kPi, 250, Side::red);
  const PlayerId standoff = range.add({52e3, 30e3, -8000}, kPi, 250, Side::red);
  Emission& emission = range.row(range.aircraft().emission, standoff);
  emission.side = Side::red;
  const double density = 1e6 / 500e6;
  const double noise = jamming_to_noise(density, seeker.field_of_view, 52e3 * 52e3 + 30e3 * 30e3) /
                       math::pow(10, 2.46);
  const double section = range.library().aircraft[0].signature.rcs_front;
  const double reach = acquisition_range(seeker, section / (1 + noise));
  ASSERT_NEAR(noise, 197, 2);
  for (const double share : {0.9, 1.1}) {
    range.row(range.aircraft().kinematics, enemy).position = {share * reach, 0, -8000};
    emission.jamming = density;
    Missile m = missile(range, kMedium, track_of(enemy));
    look_once(m);
    EXPECT_EQ(m.state.locked, share < 1) << "J/N " << noise;
    Missile own = missile(range, kMedium, track_of(enemy));
    own.state.side = Side::red;
    look_once(own);
    EXPECT_EQ(own.state.locked, 1) << "the jammer leaves its own side alone";
    emission.jamming = 0;
    Missile clear = missile(range, kMedium, track_of(enemy));
    look_once(clear);
    EXPECT_EQ(clear.state.locked, 1);
  }
}

/// A missile that looks 50 times a second at an enemy whose repeater pulls for 4 s, then no more.
struct Pulled {
  Range range;
  PlayerId enemy;
  Missile m;
  explicit Pulled(double gain) : range(1, deceived(gain)) {
    range.add({0, 0, -8000}, 0, 250);
    enemy = range.add({9000, 0, -8100}, kPi, 250, Side::red);
    const Kinematics& k = target();
    m = missile(range, kMedium, {.position = k.position, .velocity = k.velocity, .truth = enemy});
  }
  static Library deceived(double gain) {
    Library library = Range::standard();
    AircraftType fighter = library.aircraft[0];
    fighter.index.jammer = library.jammers.add(
        "deceiver",
        {.pull_off = PullOff{.gain = gain, .acceleration = 40, .walk_time = 4, .pause_time = 60}});
    library.aircraft = {};
    library.aircraft.add("fighter", fighter);
    return library;
  }
  Kinematics& target() { return range.row(range.aircraft().kinematics, enemy); }
  void look_at_step(std::uint64_t step) {
    if (step > 0) {
      target().position += 0.02 * target().velocity;
      m.k.position += 0.02 * m.k.velocity;
    }
    const TargetScene scene = TargetScene::of(range.world(), range.aircraft(), range.library(), 0);
    (void)look(range.library().missiles[kMedium], m.k, 0.02 * static_cast<double>(step), scene,
               Draw(1, PlayerId{9}, Stream::seeker, step), m.state);
  }
  /// m, how far behind the target it believes it, and m/s, how much slower it believes to close.
  std::pair<double, double> off() {
    const Vec3 apart = target().position - m.k.position;
    const double closing = dot(m.k.velocity - target().velocity, normalized(apart, {}));
    return {norm(m.state.target_position - m.k.position) - norm(apart),
            closing - m.state.closing_speed};
  }
};

TEST(PulledSeeker, FollowsTheFalseEchoLosesItWhenThatStopsAndFindsTheTargetAgain) {
  Pulled pulled(60);
  for (std::uint64_t step = 0; step < 200; ++step)
    pulled.look_at_step(step);
  EXPECT_EQ(pulled.m.state.locked, 1);
  EXPECT_NEAR(pulled.off().first, 40 * 3.98 * 3.98 / 2, 60);
  EXPECT_NEAR(pulled.off().second, 40 * 3.98, 12);
  pulled.look_at_step(200);
  EXPECT_EQ(pulled.m.state.locked, 0) << "nothing is in its gates";
  pulled.look_at_step(201);
  EXPECT_EQ(pulled.m.state.locked, 1);
  EXPECT_NEAR(pulled.off().first, 0, 60);
  EXPECT_NEAR(pulled.off().second, 0, 12);
}

TEST(PulledSeeker, RestsOnATargetThatOutshinesItsRepeater) {
  Pulled pulled(40);  // 0.7 m^2
  for (std::uint64_t step = 0; step <= 200; ++step) {
    pulled.look_at_step(step);
    ASSERT_EQ(pulled.m.state.locked, 1) << step;
    ASSERT_NEAR(pulled.off().first, 0, 75) << step;
  }
}

TEST_F(Homing, OnJammingHasNoNotch) {
  range.add({0, 0, -8000}, 0, 250);
  const PlayerId enemy =
      range.add({6000, 0, -6000}, kPi / 2, 250, Side::red);  // on the beam, below
  Missile m = missile(range, kMedium, track_of(enemy));
  EXPECT_FALSE(look_once(m)) << "clutter hides it";
  range.row(range.aircraft().emission, enemy).jamming = 1e3 / 500e6;
  Missile again = missile(range, kMedium, track_of(enemy));
  EXPECT_TRUE(look_once(again));
}

TEST_F(Homing, KeepsWhomItRestsOn) {
  range.add({0, 0, -8000}, 0, 250);
  const PlayerId enemy = range.add({9000, 0, -8050}, kPi, 250, Side::red);
  Missile m = missile(range, kMedium, track_of(enemy));
  ASSERT_TRUE(look_once(m));
  // somebody else is now exactly where it expects the enemy
  range.add({8995, 1, -8050}, kPi, 250, Side::blue);
  EXPECT_FALSE(look_once(m, 0.02));
  EXPECT_EQ(m.state.seen, enemy);
  EXPECT_EQ(m.state.locked, 1);
}

TEST_F(Homing, LosesATargetInTheNotchAndFindsItAgain) {
  range.add({0, 0, -8000}, 0, 250);
  const PlayerId enemy = range.add({9000, 0, -6000}, kPi, 250, Side::red);
  Missile m = missile(range, kMedium, track_of(enemy));
  ASSERT_TRUE(look_once(m));
  Kinematics& target = range.row(range.aircraft().kinematics, enemy);
  const Vec3 coming = target.velocity;
  target.velocity = {0, 250, 0};
  EXPECT_FALSE(look_once(m, 0.02));
  EXPECT_EQ(m.state.locked, 0);
  target.velocity = coming;
  EXPECT_FALSE(look_once(m, 0.04)) << "the same one again is no news";
  EXPECT_EQ(m.state.locked, 1);
}

TEST_F(Homing, SeesNobodyOutsideItsFieldOfView) {
  range.add({0, 0, -8000}, 0, 250);
  const PlayerId enemy = range.add({9000, 0, -8050}, kPi, 250, Side::red);
  Track track = track_of(enemy);
  track.position = {9000, 2500, -8050};  // 15 degrees off; the field of view is 12 wide
  Missile m = missile(range, kMedium, track);
  EXPECT_FALSE(look_once(m));
  EXPECT_EQ(m.state.locked, 0);
}

TEST_F(Homing, SwitchesOnNearTheTargetOnlyAndOnce) {
  const MissileType& type = range.library().missiles[kMedium];
  range.add({0, 0, -8000}, 0, 250);
  Missile m = missile(range, kMedium, {.position = {20e3, 0, -8000}, .velocity = {-250, 0, 0}});
  m.state.active = 0;
  EXPECT_FALSE(switch_on(type, m.k, 0, m.state));
  m.state.target_position = {13e3, 0, -8000};
  EXPECT_TRUE(switch_on(type, m.k, 0, m.state));
  EXPECT_FALSE(switch_on(type, m.k, 0.02, m.state));
}

TEST_F(Homing, ListensToNewerTracksUntilItSeesForItself) {
  MissileState state;
  state.target_time = 5;
  hear({.position = {1, 0, 0}, .time = 4}, state);
  EXPECT_EQ(state.target_position, Vec3{});
  hear({.position = {2, 0, 0}, .time = 6}, state);
  EXPECT_EQ(state.target_position, (Vec3{2, 0, 0}));
  state.locked = 1;
  hear({.position = {3, 0, 0}, .time = 7}, state);
  EXPECT_EQ(state.target_position, (Vec3{2, 0, 0}));
}

TEST_F(Homing, ExtrapolatesWithoutLink) {
  MissileState state;
  state.target_position = {1000, 0, 0};
  state.target_velocity = {-100, 20, 0};
  state.target_time = 3;
  EXPECT_EQ(believed_position(state, 8), (Vec3{500, 100, 0}));
}

TEST_F(Homing, NeverTurnsBeforeItIsClear) {
  const MissileType& type = range.library().missiles[kShort];
  Missile m = missile(range, kShort, {.position = {0, 4000, -8000}, .velocity = {0, -250, 0}});
  m.state.launch_time = 10;
  EXPECT_EQ(guide(type, m.k, 10 + type.guidance.separation_time - 0.02, m.state), Vec3{});
  EXPECT_NE(guide(type, m.k, 10 + type.guidance.separation_time + 0.02, m.state), Vec3{});
}

TEST_F(Homing, OfAnInfraredMissilePrefersHeat) {
  range.add({0, 0, -8000}, 0, 250);
  const PlayerId ahead = range.add({6000, 0, -8000}, kPi, 250, Side::red);
  Missile m = missile(range, kShort, track_of(ahead));
  EXPECT_FALSE(look_once(m)) << "too faint from the front at 6 km";
  range.row(range.aircraft().propulsion, ahead).throttle = 2;
  EXPECT_TRUE(look_once(m)) << "afterburner";
}

}  // namespace
}  // namespace eyrie::model::weapon
