// SPDX-License-Identifier: MIT
#include "model/sensor/rwr.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "support/model/flying.hpp"

namespace eyrie::model::sensor {
namespace {

using test::flying;
using test::mirrored;

// A warning has no place for a range: this does not compile the day somebody adds one.
template <class T>
concept TellsRange = requires(T t) {
  t.range;
}
|| requires(T t) {
  t.distance;
}
|| requires(T t) {
  t.position;
}
|| requires(T t) {
  t.strength;
};
static_assert(!TellsRange<RwrWarning>);
static_assert(TellsRange<Emission>);

constexpr double kFighterFigure = 4.34e10;  // emission_figure(148 km, 3.2 m^2)

Emission beam(const Vec3& from, const Vec3& at, double half_angle,
              EmissionKind kind = EmissionKind::search) {
  return {.position = from,
          .boresight = normalized(at - from, {1, 0, 0}),
          .cos_half_angle = std::cos(half_angle),
          .figure = kFighterFigure,
          .type = 3,
          .kind = kind,
          .side = Side::red};
}

TEST(EmissionFigure, IsTheOneWayRangeOfTheRadarsOwnReceiver) {
  EXPECT_NEAR(emission_figure(148160, 3.2), kFighterFigure, 0.01 * kFighterFigure);
  // twice the two-way range is four times the one-way range
  EXPECT_NEAR(emission_figure(2e5, 1) / emission_figure(1e5, 1), 4, 1e-12);
}

TEST(Hear, ReachesFartherThanTheRadarThatIsHeard) {
  const Rwr rwr{.insensitivity = 95};
  const auto heard_at = [&](double range) {
    const Kinematics own = flying({range, 0, -9000}, kPi, 250);
    return hear(rwr, aim(rwr, own, Side::blue), beam({0, 0, -9000}, own.position, 0.5));
  };
  EXPECT_GE(heard_at(300e3), 1) << "twice the radar's range";
  EXPECT_EQ(heard_at(900e3), 0);
  // power falls with the square of range
  EXPECT_NEAR(heard_at(100e3) / heard_at(200e3), 4, 1e-9);
}

TEST(Hear, HearsNothingOutsideTheBeam) {
  const Rwr rwr;
  const Kinematics own = flying({50e3, 0, -9000}, kPi, 250);
  const RwrAntenna antenna = aim(rwr, own, Side::blue);
  const auto off_axis = [&](double degrees) {
    const double a = radians(degrees);
    Emission e = beam({0, 0, -9000}, own.position, radians(30));
    e.boresight = {std::cos(a), std::sin(a), 0};
    return hear(rwr, antenna, e) > 0;
  };
  EXPECT_TRUE(off_axis(29.9));
  EXPECT_TRUE(off_axis(-29.9));
  EXPECT_FALSE(off_axis(30.1));
  EXPECT_FALSE(off_axis(180));
}

TEST(Hear, HearsNothingFromASilentRadarOrAFriend) {
  const Rwr rwr;
  const Kinematics own = flying({50e3, 0, -9000}, kPi, 250);
  const Emission e = beam({0, 0, -9000}, own.position, 0.5);
  EXPECT_EQ(hear(rwr, aim(rwr, own, Side::red), e), 0);
  EXPECT_GE(hear(Rwr{.hides_friends = false}, aim(rwr, own, Side::red), e), 1);
  Emission silent = e;
  silent.kind = EmissionKind::none;
  EXPECT_EQ(hear(rwr, aim(rwr, own, Side::blue), silent), 0);
}

TEST(Hear, IsDeafAboveAndBelowTheWings) {
  const Rwr rwr{.elevation_coverage = radians(45)};
  const auto rolled = [&](double degrees) {
    const Kinematics own = flying({50e3, 0, -9000}, kPi / 2, 250, 0, radians(degrees));
    return hear(rwr, aim(rwr, own, Side::blue), beam({0, 0, -9000}, own.position, 0.5)) > 0;
  };
  EXPECT_TRUE(rolled(0));
  EXPECT_TRUE(rolled(44));
  EXPECT_FALSE(rolled(46));
  EXPECT_FALSE(rolled(-80));
}

TEST(Warn, GivesBearingsInStepsFromTheNoseWithTheErrorItSays) {
  const Rwr rwr{.sigma_bearing = radians(10), .bearing_step = radians(5)};
  const Kinematics own = flying({}, radians(33), 250);
  const Emission e = beam({20e3, 20e3, 0}, {}, 0.5);
  double mean = 0, square = 0;
  constexpr int kLooks = 20000;
  for (int i = 0; i < kLooks; ++i) {
    const RwrWarning w = warn(rwr, aim(rwr, own, Side::blue), own, e, 1, PlayerId{9}, 1,
                              Draw(1, PlayerId{1}, Stream::rwr, static_cast<std::uint64_t>(i)));
    const double steps = angle_between(own.heading, w.bearing) / radians(5);
    ASSERT_NEAR(steps, std::nearbyint(steps), 1e-9);
    const double error = angle_between(radians(45), w.bearing);
    mean += error / kLooks;
    square += error * error / kLooks;
  }
  EXPECT_NEAR(degrees(mean), 0, 0.4);
  const double expected = std::sqrt(10.0 * 10 + 5.0 * 5 / 12);  // and the steps' own error
  EXPECT_NEAR(degrees(std::sqrt(square)), expected, 0.3);
}

RC_GTEST_PROP(Warn, OfAMirroredSceneIsTheMirroredWarning, ()) {
  const auto in = [](int low, int high) { return double(*rc::gen::inRange(low, high)); };
  const Rwr rwr;
  const Kinematics own = flying({}, radians(in(-179, 180)), 250);
  const Vec3 from{in(-9000, 9000), in(1, 9000), in(-500, 500)};
  const Draw draw(1, PlayerId{1}, Stream::rwr, static_cast<std::uint64_t>(in(0, 1000)));
  const RwrWarning w =
      warn(rwr, aim(rwr, own, Side::blue), own, beam(from, {}, 1), 4, PlayerId{2}, 0, draw);
  const Kinematics image = mirrored(own);
  const RwrWarning m = warn(rwr, aim(rwr, image, Side::blue), image, beam(mirrored(from), {}, 1), 4,
                            PlayerId{2}, 0, draw);
  RC_ASSERT(std::fabs(wrap_pi(w.bearing + m.bearing)) < 1e-9);
  RC_ASSERT(w.faintness == m.faintness);
}

RwrWarning warning(std::uint32_t emitter, EmissionKind kind, double time) {
  return {.time = time,
          .first_time = time,
          .kind_time = time,
          .emitter = PlayerId{emitter},
          .kind = kind};
}

TEST(Show, TellsOncePerEmitterAndAgainWhenItGetsWorse) {
  RwrState state;
  EXPECT_TRUE(show(state, warning(5, EmissionKind::search, 1)));
  EXPECT_FALSE(show(state, warning(5, EmissionKind::search, 2)));
  EXPECT_TRUE(show(state, warning(5, EmissionKind::track, 3)));
  EXPECT_FALSE(show(state, warning(5, EmissionKind::search, 4)));
  ASSERT_EQ(state.count, 1u);
  EXPECT_EQ(state.warnings[0].time, 4);
  EXPECT_EQ(state.warnings[0].first_time, 1);
  EXPECT_EQ(state.warnings[0].kind_time, 4) << "since it searches again";
}

TEST(Show, SmoothsTheBearing) {
  const auto error_after = [](int looks) {
    double square = 0;
    for (int run = 0; run < 400; ++run) {
      RwrState state;
      for (int i = 0; i < looks; ++i) {
        RwrWarning w = warning(5, EmissionKind::missile_seeker, 0.2 * i);
        w.bearing = wrap_pi(kPi + radians(10) * Draw(1, PlayerId{static_cast<std::uint32_t>(run)},
                                                     Stream::test, std::uint64_t(i))
                                                    .normal());
        w.looks = 1;
        show(state, w);
      }
      const double error = degrees(angle_between(kPi, state.warnings[0].bearing));
      square += error * error / 400;
    }
    return std::sqrt(square);
  };
  EXPECT_NEAR(error_after(1), 10, 1);
  EXPECT_NEAR(error_after(4), 5, 0.5) << "the mean of four";
  EXPECT_NEAR(error_after(30), 10 * std::sqrt(0.18127 / (2 - 0.18127)), 0.4);
}

TEST(Show, PutsTheMostUrgentFirst) {
  RwrState state;
  show(state, warning(5, EmissionKind::search, 1));
  show(state, warning(6, EmissionKind::missile_seeker, 2));
  show(state, warning(7, EmissionKind::track, 3));
  show(state, warning(8, EmissionKind::search, 0.5));
  std::vector<std::uint32_t> order;
  for (std::uint32_t i = 0; i < state.count; ++i)
    order.push_back(state.warnings[i].emitter.value);
  EXPECT_EQ(order, (std::vector<std::uint32_t>{6, 7, 8, 5}));
}

TEST(Show, MakesRoomOnAFullDisplayOnlyForWhatIsMoreUrgent) {
  RwrState state;
  for (std::uint32_t i = 1; i <= kMaxWarnings; ++i)
    show(state, warning(i, EmissionKind::search, i == 3 ? 0 : 1));
  EXPECT_FALSE(show(state, warning(20, EmissionKind::search, 2)));
  EXPECT_TRUE(show(state, warning(21, EmissionKind::missile_seeker, 2)));
  EXPECT_EQ(state.count, kMaxWarnings);
  EXPECT_EQ(state.warnings[0].emitter, PlayerId{21});
  for (const RwrWarning& w : state.warnings)
    EXPECT_NE(w.emitter, PlayerId{3}) << "the one unheard longest makes room";
}

TEST(Hear, HasTheBeamOfASeekerAtHalfItsPowerAtTheEdge) {
  const Rwr rwr;
  const Kinematics own = flying({9e3, 0, -9000}, kPi, 250);
  const auto strength = [&](double degrees, EmissionKind kind) {
    Emission e = beam({0, 0, -9000}, own.position, radians(6), kind);
    e.boresight = {std::cos(radians(degrees)), std::sin(radians(degrees)), 0};
    return hear(rwr, aim(rwr, own, Side::blue), e);
  };
  const double middle = strength(0, EmissionKind::missile_seeker);
  EXPECT_NEAR(strength(5.999, EmissionKind::missile_seeker) / middle, 0.5, 1e-3);
  EXPECT_NEAR(10 * std::log10(middle / strength(3, EmissionKind::missile_seeker)), 0.75, 5e-3);
  EXPECT_EQ(strength(5.9, EmissionKind::search), middle)
      << "one that sweeps passes with its middle";
}

/// A missile that comes from the north at 950 m/s, its seeker on who flies towards it at 250 m/s.
struct Approach {
  static constexpr double kClosing = 1200;
  Rwr rwr;
  double from = 14e3;  ///< m, when the seeker is switched on
  double aside = 0;    ///< m, of who listens from its target, to the east
  double behind = 0;   ///< m
  std::uint64_t seed = 1;

  /// The least time to go (s) that who listens ever reckons with, and when (s to go) he first
  /// reckons with no more than `limit`; 0 for what never was.
  struct Reckoned {
    double least = 0, first = 0, worst = 0;
  };
  [[nodiscard]] Reckoned listen(double limit) const {
    RwrState state;
    return listen(limit, 0, state);
  }
  /// Until it is so many s to go; `state` is the display then.
  Reckoned listen(double limit, double until, RwrState& state) const {
    Reckoned reckoned;
    for (int look = 0; (look * 0.2 + until) * kClosing < from; ++look) {
      const double time = 0.2 * look, left = from / kClosing - time;
      const Vec3 target{-250 * time, 0, -9000};
      const Kinematics own = flying(target + Vec3{-behind, aside, 0}, 0, 250);
      const Emission e = beam(target + Vec3{left * kClosing, 0, 0}, target, radians(6),
                              EmissionKind::missile_seeker);
      const RwrAntenna antenna = aim(rwr, own, Side::blue);
      Emission seeker = e;
      seeker.figure = emission_figure(14e3, 5);
      const double strength = hear(rwr, antenna, seeker);
      if (strength == 0)
        continue;
      show(state, warn(rwr, antenna, own, seeker, strength, PlayerId{9}, time,
                       Draw(seed, PlayerId{1}, Stream::rwr, static_cast<std::uint64_t>(look))));
      if (const auto to_go = time_to_go(state.warnings[0], rwr)) {
        if (reckoned.least == 0 || *to_go < reckoned.least)
          reckoned.least = *to_go;
        if (reckoned.first == 0 && *to_go <= limit)
          reckoned.first = left;
        reckoned.worst = std::max(reckoned.worst, std::fabs(*to_go / left - 1));
      }
    }
    return reckoned;
  }
};

TEST(TimeToGo, IsRightWithoutErrorsForWhomTheSeekerRestsOn) {
  const Approach approach{.rwr = {.sigma_level = 0}};
  EXPECT_LT(approach.listen(8).worst, 1e-6);
}

TEST(TimeToGo, IsNotToldBeforeTheLineHasAllItsLooks) {
  const double from = 9 * Approach::kClosing;
  EXPECT_NEAR(Approach({.rwr = {.sigma_level = 0}, .from = from}).listen(20).first, 9 - 2.8, 1e-6)
      << "the first of 15 looks at 5 Hz counts";
}

TEST(TimeToGo, OfAMatesMissileNeverFallsBelowItsLaw) {
  for (const double aside : {500.0, 800.0, 1100.0}) {
    const Approach approach{.rwr = {.sigma_level = 0}, .aside = aside};
    const double law = 4.32 * aside / (radians(12) * Approach::kClosing);
    // the straight line through 3 s of looks lags behind a curve
    EXPECT_GT(approach.listen(8).least, 0.8 * law) << aside;
  }
}

TEST(TimeToGo, IsKnownInTimeAndTellsOnesOwnMissileFromAMates) {
  constexpr std::uint64_t kDraws = 2000;
  int own = 0, mates = 0, trailing = 0;
  double alarm = 0;
  for (std::uint64_t seed = 1; seed <= kDraws; ++seed) {
    const auto mine = Approach{.seed = seed}.listen(8);
    own += mine.first >= 5;
    alarm += mine.first / kDraws;
    // mates fly 2500 ft to 6000 ft aside of him, or 1.5 nmi behind
    const double aside = si(2500, "ft") + static_cast<double>(seed) / kDraws * si(3500, "ft");
    mates += Approach{.aside = aside, .seed = seed}.listen(8).first > 0;
    trailing += Approach{.aside = si(2500, "ft"), .behind = 1.5 * si(1, "nmi"), .seed = seed}
                    .listen(8)
                    .first > 0;
  }
  EXPECT_GE(own, 0.99 * kDraws) << "alarms with 5 s to go or more";
  EXPECT_NEAR(alarm, 8, 0.5) << "s to go, in the mean";
  EXPECT_LE(mates, 0.01 * kDraws);
  EXPECT_LE(trailing, 0.02 * kDraws);
  RecordProperty("missed", static_cast<int>(kDraws) - own);
  RecordProperty("false", mates);
  RecordProperty("false_behind", trailing);
}

/// Two mates abreast, the seeker on the first: whether each finds that it rests on the other, so
/// many s before it is there.
struct Doubts {
  bool target = false, mate = false;
};
Doubts doubts(double aside, double left, std::uint64_t seed) {
  RwrState targets, mates;
  (void)Approach{.seed = 2 * seed}.listen(8, left, targets);
  (void)Approach{.aside = aside, .seed = 2 * seed + 1}.listen(8, left, mates);
  const double time = targets.warnings[0].time;
  std::array<datalink::SharedSeeker, datalink::kSharedSeekers> said;
  Doubts found;
  if (share(mates, time, said) == 1)
    found.target = rests_on_mate(targets.warnings[0], said[0], 0, {0, aside, 0}, time);
  if (mates.count == 1 && share(targets, time, said) == 1)
    found.mate = rests_on_mate(mates.warnings[0], said[0], 0, {0, -aside, 0}, time);
  return found;
}

TEST(RestsOnMate, FollowsFromTheLevelsOfBoth) {
  constexpr std::uint64_t kDraws = 1000;
  for (const double aside : {300.0, 450.0, 600.0}) {
    int wrong = 0, right = 0, both = 0;
    for (std::uint64_t seed = 1; seed <= kDraws; ++seed) {
      const Doubts found = doubts(aside, 7, seed);
      wrong += found.target;
      right += found.mate;
      both += found.target && found.mate;
    }
    EXPECT_LE(wrong, 0.01 * kDraws) << aside;
    EXPECT_GE(right, (aside < 400 ? 0.35 : 0.97) * kDraws) << aside;
    EXPECT_EQ(both, 0);
    RecordProperty("right_at_" + std::to_string(static_cast<int>(aside)), right);
    RecordProperty("wrong_at_" + std::to_string(static_cast<int>(aside)), wrong);
  }
}

TEST(RestsOnMate, AllowsForWhoIsNearerAndLeavesMatesSideBySideInDoubt) {
  const auto heard = [](double faintness) {
    return RwrWarning{.bearing = 0,
                      .faintness = faintness,
                      .faintness_rate = -faintness / 8,
                      .kind = EmissionKind::missile_seeker,
                      .looks = 15};
  };
  const auto said = [](double faintness) {
    return datalink::SharedSeeker{.faintness = static_cast<float>(faintness),
                                  .faintness_rate = -0.05F};
  };
  // 8 s to go are 8 km: a mate 2 km nearer hears it by 3 in 4 as faint, whoever it rests on
  EXPECT_FALSE(rests_on_mate(heard(0.4), said(0.3), 0, {2000, 0, 0}, 0));
  EXPECT_TRUE(rests_on_mate(heard(0.4), said(0.28), 0, {2000, 0, 0}, 0));
  EXPECT_FALSE(rests_on_mate(heard(0.4), said(0.39), 0, {0, 100, 0}, 0)) << "within the errors";
  RwrWarning old = heard(0.4);
  old.time = -2;
  EXPECT_FALSE(rests_on_mate(old, said(0.28), 0, {2000, 0, 0}, 0)) << "heard too long ago";
}

TEST(Forget, TakesOldWarningsOffTheDisplayAndLeavesNoTrace) {
  const Rwr rwr{.memory = 5};
  RwrState state;
  show(state, warning(1, EmissionKind::search, 0));
  show(state, warning(2, EmissionKind::search, 3));
  forget(state, rwr, 5);
  EXPECT_EQ(state.count, 2u);
  forget(state, rwr, 5.1);
  ASSERT_EQ(state.count, 1u);
  EXPECT_EQ(state.warnings[0].emitter, PlayerId{2});
  EXPECT_EQ(state.warnings[1].emitter, PlayerId{});
}

}  // namespace
}  // namespace eyrie::model::sensor
