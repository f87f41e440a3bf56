// SPDX-License-Identifier: MIT
#include "model/weapon/gun.hpp"

#include <gtest/gtest.h>

#include "core/draw.hpp"
#include "model/environment.hpp"
#include "support/data_file.hpp"
#include "support/model/flying.hpp"

namespace eyrie::model::weapon {
namespace {

using test::flying;

const GunType& m61() {
  static const auto gun = eyrie::test::load<GunType>("data/guns/m61.yaml");
  return gun;
}
constexpr double kSeaLevel = 1.225;

TEST(TimeOfFlight, IsDistanceOverSpeedWithoutAir) {
  EXPECT_NEAR(time_of_flight(m61(), 0, 1030, 515), 0.5, 1e-12);
}

TEST(TimeOfFlight, SolvesTheEquationOfMotion) {
  // dv/dt = -k v^2, integrated in small steps
  const double k = kSeaLevel * m61().drag / 2;
  double x = 0, v = 1030, t = 0;
  for (; x < 800; t += 1e-5) {
    x += v * 1e-5;
    v -= k * v * v * 1e-5;
  }
  EXPECT_NEAR(time_of_flight(m61(), kSeaLevel, 1030, 800), t, 1e-3);
}

TEST(Lead, PointsAheadOfACrossingTarget) {
  const Kinematics own = flying({0, 0, -3000}, 0, 250);
  const Kinematics target = flying({600, 0, -3000}, kPi / 2, 200);
  const Lead lead = lead_on(m61(), 0.9, own, {1, 0, 0}, target);
  EXPECT_DOUBLE_EQ(lead.range, 600);
  // the shooter's own speed carries the round along
  EXPECT_NEAR(lead.flight_time, 600 / 1280.0, 0.1);
  const double deflection = 200 * lead.flight_time;
  EXPECT_NEAR(lead.direction.y / lead.direction.x, deflection / (600 - 250 * lead.flight_time),
              0.01);
  EXPECT_LT(lead.direction.z, 0);  // above: the round drops
  EXPECT_GT(lead.off_bore, radians(9));
}

TEST(Lead, IsStraightAtATargetAheadAtTheSameSpeed) {
  const Kinematics own = flying({0, 0, -3000}, 0, 250);
  const Kinematics target = flying({400, 0, -3000}, 0, 250);
  const Lead lead = lead_on(m61(), 0.9, own, {1, 0, 0}, target);
  EXPECT_LT(lead.off_bore, radians(0.2));  // the drop
}

/// Chance per round in a tail chase at `range` against a target with `load_factor`.
double chance(double range, double load_factor = 1) {
  const Kinematics own = flying({0, 0, -3000}, 0, 250);
  Kinematics target = flying({range, 0, -3000}, 0, 250);
  target.load_factor = load_factor;
  const Lead lead = lead_on(m61(), 0.9, own, {1, 0, 0}, target);
  return hit_probability(m61(), lead, Signature{}, target);
}

TEST(HitProbability, IsTheRayleighFormOfAreaRangeAndErrors) {
  const double sigma2 = m61().dispersion * m61().dispersion + m61().aim_error * m61().aim_error;
  EXPECT_NEAR(chance(500), 1 - std::exp(-8.0 / (2 * kPi * sigma2 * 500 * 500)), 0.01);
  EXPECT_GT(chance(300), chance(500));
  EXPECT_GT(chance(500), chance(600));
  EXPECT_GT(chance(200), 0.7);
  EXPECT_LT(chance(600), 0.4);
}

TEST(HitProbability, FallsWhenTheTargetManeuvers) {
  EXPECT_LT(chance(600, 7), 0.6 * chance(600));
  EXPECT_GT(chance(600, 7), 0);
}

TEST(HitProbability, IsZeroOutOfRangeAndOutsideTheAimCone) {
  EXPECT_EQ(chance(611), 0);
  const Kinematics own = flying({0, 0, -3000}, 0, 250);
  const Kinematics target = flying({500, 0, -3000}, 0, 250);
  const auto with_nose = [&](double off) {
    const Lead lead = lead_on(m61(), 0.9, own, {std::cos(off), std::sin(off), 0}, target);
    return hit_probability(m61(), lead, Signature{}, target);
  };
  EXPECT_GT(with_nose(radians(1)), 0);
  EXPECT_EQ(with_nose(radians(2)), 0);
}

TEST(HitProbability, IsLargerAgainstALargerSilhouette) {
  const Kinematics own = flying({0, 0, -3000}, 0, 250);
  const Kinematics ahead = flying({500, 0, -3000}, 0, 250);
  // banked by 90 degrees and crossing slowly, it shows its whole planform from the side
  const Kinematics banked = flying({500, 0, -3000}, 0, 250, 0, kPi / 2);
  const auto p = [&](const Kinematics& target, const Signature& size) {
    return hit_probability(m61(), lead_on(m61(), 0.9, own, {1, 0, 0}, target), size, target);
  };
  EXPECT_GT(p(ahead, {.area_front = 16}), p(ahead, {.area_front = 8}));
  EXPECT_NEAR(p(banked, {}), p(ahead, {}), 1e-3);  // from behind, bank shows nothing more
}

TEST(HitProbability, IsMetByDraws) {
  const double expected = chance(500);
  int hits = 0;
  constexpr int kRounds = 20000;
  Draw draw(11, PlayerId{3}, Stream::gun, 40);
  for (int i = 0; i < kRounds; ++i)
    hits += draw.chance(expected);
  EXPECT_NEAR(double(hits) / kRounds, expected, 4 * std::sqrt(expected * (1 - expected) / kRounds));
}

TEST(Fire, DeliversTheRate) {
  GunType gun = m61();
  gun.rate = 33;
  GunState state = loaded(gun);
  std::uint32_t fired = 0;
  for (int i = 0; i < 500; ++i)
    fired += fire(gun, 0.02, state);
  EXPECT_EQ(fired, 330u);
  EXPECT_EQ(state.rounds, gun.rounds - 330);
  EXPECT_EQ(state.burst_rounds, 330u);
}

TEST(Fire, StopsWhenTheDrumIsEmpty) {
  GunState state{.rounds = 3};
  EXPECT_EQ(fire(m61(), 0.02, state), 2u);
  EXPECT_EQ(fire(m61(), 0.02, state), 1u);
  EXPECT_EQ(fire(m61(), 0.02, state), 0u);
  EXPECT_EQ(state.rounds, 0u);
}

TEST(GunData, IsReadableAndOrdered) {
  const auto gsh = eyrie::test::load<GunType>("data/guns/gsh301.yaml");
  EXPECT_LT(gsh.rate, m61().rate);
  EXPECT_GT(gsh.damage, m61().damage);
  // 80 % of the rounds within 4 mrad
  EXPECT_NEAR(1 - std::exp(-4e-3 * 4e-3 / (2 * m61().dispersion * m61().dispersion)), 0.8, 0.002);
}

}  // namespace
}  // namespace eyrie::model::weapon
