// SPDX-License-Identifier: MIT
/// \file  What holds for every behavior in every situation: sane numbers, nobody shot at who is not
/// known to be hostile, one shooter first, and no preference for left or right.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <string>

#include "pilot/policy/observation.hpp"
#include "support/pilot/testing.hpp"

namespace eyrie::pilot {
namespace {

using namespace pilot::testing;

constexpr const char* kBehaviors[] = {"navigate",
                                      "follow_lead",
                                      "{pursue: {mode: intercept, crank: 50 deg}}",
                                      "{pursue: {mode: follow}}",
                                      "{pursue: {mode: lead, overtake: 40 m/s}}",
                                      "{release_weapon: {zone: 5, off_boresight: 2 rad}}",
                                      "{shoot_gun: {range: 5 km, tolerance: 0.5 rad}}",
                                      "break_turn",
                                      "egress",
                                      "{avoid_ground: {floor: 1500 m}}"};

double between(int least, int most) {
  return *rc::gen::inRange(least, most + 1);
}
/// rad, never a multiple of a right angle, where left and right are the same.
double any_heading() {
  return between(-1799, 1799) * 1.745e-3 + 1e-4;
}

/// Up to ten tracks of any identity, near and far.
void see_anybody(Desk& s) {
  for (int i = *rc::gen::inRange(0, 10); i > 0; --i) {
    const double scale = *rc::gen::element(1.0, 0.3, 0.02);
    model::Track& track = s.track(
        scale *
            Vec3{between(-40'000, 40'000), between(-40'000, 40'000) + 0.5, between(-4000, 4000)},
        any_heading(), between(0, 500), static_cast<model::Identity>(*rc::gen::inRange(0, 3)));
    track.confirmed = *rc::gen::element<std::uint8_t>(0, 1, 1, 1);
    track.time -= between(0, 80) / 10;
    track.targeted_by = *rc::gen::arbitrary<std::uint8_t>();
    track.shot_by = *rc::gen::element<std::uint8_t>(0, 0, 0, 2, 255);
  }
}

/// Anything a pilot may know, at any height, speed and attitude.
Desk anything() {
  Desk s;
  // home and route lie on the line y = 0
  const Vec3 place{between(-99, 99) * 1e3, between(-99, 99) * 1e3 + 1, -between(0, 15'000)};
  s.own = model::test::flying(place, any_heading(), between(80, 500), between(-12, 12) / 10);
  see_anybody(s);
  s.agent.target = TrackId{*rc::gen::inRange(0U, 10U)};
  s.agent.shots[0] = {.until = s.time + between(-5, 20), .track = TrackId{1}, .store = kMedium};
  for (int i = *rc::gen::inRange(0, 4); i > 0; --i)
    if (*rc::gen::arbitrary<bool>())
      s.threat(any_heading(), between(100, 20'000));
    else
      s.threat(any_heading()).first_time -= between(0, 20);
  s.flying.nav.leg = *rc::gen::inRange<std::uint16_t>(0, 3);
  if (*rc::gen::arbitrary<bool>())
    s.in_flight(*rc::gen::inRange(4U, 9U), *rc::gen::inRange(1U, 5U));
  for (std::uint32_t i = 0; i < s.datalink.count; ++i)
    if (i != s.datalink.self)
      s.datalink.members[i].alive = *rc::gen::element<std::uint8_t>(0, 1, 1);
  return s;
}

RC_GTEST_PROP(EveryBehavior, RecommendsNumbersThatCanBeFlown, ()) {
  const Desk s = anything();
  for (const std::string behavior : kBehaviors) {
    const Decided answer = decide(behavior, s);
    const Action& a = answer.action();
    RC_LOG() << behavior << '\n';
    if ((answer.status == kFailure)) {
      RC_ASSERT(answer.proposal.is_empty());
      continue;
    }
    RC_ASSERT(answer.proposal.vote > 0);
    if (a.heading)
      RC_ASSERT(*a.heading >= 0 && *a.heading < kTau);
    if (a.altitude)
      RC_ASSERT(std::isfinite(*a.altitude) && *a.altitude >= 0);
    if (a.speed)
      RC_ASSERT(std::isfinite(*a.speed) && *a.speed > 50);
    if (a.load_factor)
      RC_ASSERT(*a.load_factor >= 1 && *a.load_factor <= 12);
    if (a.follow)
      RC_ASSERT(std::isfinite(norm(a.follow->position) + norm(a.follow->velocity)));
    // whoever says where to fly also says by which mode
    RC_ASSERT(!(a.heading || a.altitude) || a.mode);
    RC_ASSERT(a.mode != model::AutopilotMode::follow || a.follow);
  }
}

RC_GTEST_PROP(EveryBehavior, AttacksNobodyWhoIsNotConfirmedAndHostile, ()) {
  const Desk s = anything();
  const auto hostile = [&](TrackId id) {
    const model::Track* track = model::find(s.tracks, id);
    return track && track->confirmed && track->identity == model::Identity::hostile;
  };
  for (const std::string behavior : kBehaviors) {
    const Action a = decide(behavior, s).action();
    RC_LOG() << behavior << '\n';
    RC_CLASSIFY(a.release.has_value(), "shoots");
    RC_CLASSIFY(a.trigger.value_or(false), "fires");
    if (a.release)
      RC_ASSERT(hostile(a.release->track));
    if (a.trigger.value_or(false))
      RC_ASSERT(a.target && hostile(*a.target));
    if (a.target && *a.target)
      RC_ASSERT(hostile(*a.target));
  }
}

RC_GTEST_PROP(EveryField, IsAFeatureWithinItsBounds, ()) {
  Desk s = anything();
  s.own.roll = any_heading();
  std::string text;
  for (const auto& field : ubf::StateFields<State>::all()) {
    const Dimension unit = field.info.unit.dimension;
    text += fmt::format("{0} present\n{0} linear {1} {2}\n", field.info.name,
                        exact_quantity(-3.0, unit), exact_quantity(1000.0, unit));
    if (unit == Dimension::angle)
      text += fmt::format("{0} sine\n{0} cosine\n", field.info.name);
  }
  const Observation all(text);
  std::vector<float> numbers(all.size(), 99);
  all.write(s.state(), numbers.data());
  RC_ASSERT(std::all_of(numbers.begin(), numbers.end(), [](float x) { return x >= -1 && x <= 1; }));
}

/// The same with east and west exchanged.
Desk mirrored(Desk s) {
  using model::test::mirrored;
  s.own = mirrored(s.own);
  for (std::uint32_t i = 0; i < s.tracks.count; ++i) {
    s.tracks.tracks[i].position = mirrored(s.tracks.tracks[i].position);
    s.tracks.tracks[i].velocity = mirrored(s.tracks.tracks[i].velocity);
  }
  for (std::uint32_t i = 0; i < s.threats.count; ++i)
    s.threats.missiles[i].bearing = -s.threats.missiles[i].bearing;
  for (std::uint32_t i = 0; i < s.datalink.count; ++i) {
    model::Mate& mate = s.datalink.members[i];
    mate.position = mirrored(mate.position);
    mate.velocity[1] = -mate.velocity[1];
  }
  return s;
}

/// A missile straight ahead or astern is on neither side: one has to be chosen.
bool has_threat_on_the_axis(const Desk& desk) {
  for (std::uint32_t i = 0; i < desk.threats.count; ++i) {
    const double off = angle_between(desk.own.heading, desk.threats.missiles[i].bearing);
    if (std::fabs(off) < 1e-9 || std::fabs(off) > kPi - 1e-9)
      return true;
  }
  return false;
}

RC_GTEST_PROP(EveryBehavior, PrefersNeitherLeftNorRight, ()) {
  const Desk s = anything(), other = mirrored(s);
  for (const std::string behavior : kBehaviors) {
    // the wall has a left and a right; a circle over home is flown clockwise
    if (behavior == "follow_lead" || (behavior == "break_turn" && has_threat_on_the_axis(s)))
      continue;
    RC_LOG() << behavior << '\n';
    const Decided here = decide(behavior, s), there = decide(behavior, other);
    const Action &a = here.action(), &b = there.action();
    RC_ASSERT(here.status == there.status);
    RC_ASSERT(here.proposal.vote == there.proposal.vote);
    RC_ASSERT(a.heading.has_value() == b.heading.has_value());
    if (a.heading && !(behavior == "navigate" && s.flying.nav.leg >= 2))
      RC_ASSERT(std::fabs(angle_between(*a.heading, -*b.heading)) < 1e-6);
    if (a.altitude)
      RC_ASSERT(std::fabs(*a.altitude - *b.altitude) < 1e-6);
    RC_ASSERT(a.target == b.target);
    RC_ASSERT(a.release == b.release);
    RC_ASSERT(a.trigger == b.trigger);
    RC_ASSERT(a.call == b.call);
  }
}

RC_GTEST_PROP(BreakTurn, NeverTurnsTowardsTheSideThatANearMissileComesFrom, ()) {
  const double off = between(1, 179) * si(1, "deg");
  const double heading = any_heading();
  for (const double side : {-1.0, 1.0}) {
    Desk s;
    s.own = model::test::flying(s.own.position, heading, 250);
    s.threat(heading + side * off, 3000);
    const double turn = angle_between(heading, *decide("break_turn", s).action().heading);
    RC_ASSERT(side * turn <= 1e-9);
  }
}

RC_GTEST_PROP(ReleaseWeapon, LetsOneOfAFlightShootFirst, ()) {
  // all of them see one hostile and each other, and know that it is everybody's target
  const auto count = *rc::gen::inRange(2U, 9U);
  std::array<Vec3, model::kMaxFlight> places;
  for (Vec3& place : places)
    place = {between(-4, 4) * 1000, between(-4, 4) * 1000, -8000};
  int shooters = 0;
  for (std::uint32_t rank = 1; rank <= count; ++rank) {
    Desk s;
    s.own = model::test::flying(places[rank - 1], 0, 250);
    s.in_flight(count, rank);
    for (std::uint32_t i = 0; i < count; ++i)
      s.datalink.members[i].position = places[i];
    s.track(Vec3{35e3, 0, -8000} - s.own.position).targeted_by =
        static_cast<std::uint8_t>(((1U << count) - 1) & ~(1U << (rank - 1)));
    shooters += decide("{release_weapon: {zone: 5, off_boresight: 1 rad}}", s).status != kFailure;
  }
  RC_ASSERT(shooters == 1);
}

RC_GTEST_PROP(TheSort, SpreadsAFlightEvenlyOverItsTargets, ()) {
  // every member hears of the choice of those before it
  const auto members = *rc::gen::inRange(1U, 9U);
  const auto hostiles = *rc::gen::inRange(1U, 5U);
  std::array<Vec3, 4> places;
  for (std::size_t i = 0; i < places.size(); ++i)
    places[i] = {between(20, 60) * 1000, double(i) * 5000 - 7500, 0};
  std::array<std::uint8_t, 4> taken{};
  for (std::uint32_t rank = 1; rank <= members; ++rank) {
    Desk s;
    s.in_flight(members, rank);
    for (std::uint32_t i = 0; i < hostiles; ++i)
      s.track(places[i]).targeted_by = taken[i];
    const State state = s.state();
    RC_ASSERT(state.target() != nullptr);
    taken[static_cast<std::size_t>(state.target_index)] |=
        static_cast<std::uint8_t>(1U << (rank - 1));
  }
  int most = 0, least = 99;
  for (std::uint32_t i = 0; i < hostiles; ++i) {
    most = std::max(most, std::popcount(taken[i]));
    least = std::min(least, std::popcount(taken[i]));
  }
  RC_ASSERT(most - least <= 1);
}

}  // namespace
}  // namespace eyrie::pilot
