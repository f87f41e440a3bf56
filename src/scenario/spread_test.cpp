// SPDX-License-Identifier: MIT
#include "scenario/spread.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/angle.hpp"
#include "pilot/geometry.hpp"
#include "scenario/scenario.hpp"

namespace eyrie::scenario {
namespace {

/// Two F-15s side by side, `flight` and `second` beside what else is said of them.
std::shared_ptr<const Scenario> pair(const std::string& flight, const std::string& second = "",
                                     const std::string& altitude = "5000 m",
                                     const std::string& first = "") {
  auto source = Source::disk(".");
  source.add("pair.yaml",
             "eyrie: 1\nname: pair\nreference: {latitude: 33 deg, longitude: -68 deg}\n"
             "trees: {on: {navigate: {vote: 1}}}\n"
             "blue:\n  flights:\n    eagle:\n      aircraft: f15c\n      tree: on\n"
             "      formation: {abreast: 1000 m, behind: 0 m, below: 100 m}\n"
             "      start: {north: 0 km, east: 10 km, altitude: " +
                 altitude + ", heading: 0 deg, speed: 200 m/s}\n" + flight +
                 "      players:\n        - eagle1: {" + first + "}\n        - eagle2: {" + second +
                 "}\n");
  return load({"pair.yaml", {}}, std::move(source));
}
const model::Kinematics& motion(const Scenario& s, const sim::World& world, std::size_t row) {
  return world.rows(s.aircraft.kinematics)[row];
}
std::string mistake(const std::string& flight, const std::string& altitude = "5000 m") {
  try {
    pair(flight, "", altitude);
  } catch (const ConfigError& e) {
    return e.what();
  }
  return "";
}

TEST(Start, OfAWingmanIsAtTheAltitudeThatIsSaidOfHim) {
  const auto with = pair("", "start: {altitude: 3000 m}"), without = pair("");
  const auto own = with->world(1), level = without->world(1);
  EXPECT_NEAR(motion(*with, own, 1).altitude, 3000, 1e-6);
  EXPECT_NEAR(motion(*without, level, 1).altitude, 4900, 1e-6);
  EXPECT_NEAR(motion(*with, own, 1).position.x, motion(*without, level, 1).position.x, 0.1);
  EXPECT_NEAR(motion(*with, own, 1).position.y, motion(*without, level, 1).position.y, 0.5);
}

TEST(Start, OfAWingmanIsBesideWhereverItsLeadIs) {
  const auto apart = [](const std::string& first, const std::string& second) {
    const auto s = pair("", second, "5000 m", first);
    const auto world = s->world(1);
    const model::Kinematics &of_lead = motion(*s, world, 0), &other = motion(*s, world, 1);
    return to_ned(of_lead, other.position - of_lead.position);
  };
  const std::string lead = "start: {north: 20 km, east: 0 km, altitude: 7000 m, heading: 90 deg}";
  const Vec3 beside = apart(lead, "");
  EXPECT_NEAR(beside.x, 1000, 1) << "to the left of who flies east is north";
  EXPECT_NEAR(beside.y, 0, 1);
  EXPECT_NEAR(beside.z, 100, 1);
  const Vec3 turned = apart(lead, "start: {heading: 45 deg}");
  EXPECT_NEAR(norm(turned - beside), 0, 1) << "its own heading does not turn the formation";
  EXPECT_NEAR(norm(apart(lead, "start: {north: 5 km, east: 0 km}")), 15e3, 3000)
      << "a place of its own stays there";
}

TEST(Spread, MovesAStartEvenlyWithinWhatItSays) {
  const auto s =
      pair("      spread: {position: 2 km, altitude: 1000 m, heading: 30 deg, speed: 20 m/s}\n");
  Vec3 least{1e9, 1e9, 1e9}, most{-1e9, -1e9, -1e9}, sum;
  constexpr int kSeeds = 400;
  for (int seed = 0; seed < kSeeds; ++seed) {
    const auto world = s->world(static_cast<std::uint64_t>(seed));
    const auto& k = motion(*s, world, 0);
    const Vec3 moved{k.position.x, k.position.y - 10e3, k.altitude - 5000};
    for (double Vec3::*axis : {&Vec3::x, &Vec3::y, &Vec3::z}) {
      least.*axis = std::min(least.*axis, moved.*axis);
      most.*axis = std::max(most.*axis, moved.*axis);
    }
    sum += moved;
    EXPECT_LE(std::fabs(k.heading), radians(30) + 1e-9);
    EXPECT_NEAR(k.speed, 200, 20 + 1e-9);
    const model::Command& command = world.rows(s->aircraft.command)[0];
    EXPECT_EQ(command.heading, k.heading);
    EXPECT_NEAR(command.speed, k.speed, 1e-9);
  }
  for (double Vec3::*axis : {&Vec3::x, &Vec3::y, &Vec3::z}) {
    const double range = axis == &Vec3::z ? 1000 : 2000;
    EXPECT_GE(least.*axis, -range - 1e-6);
    EXPECT_LT(least.*axis, -0.95 * range);
    EXPECT_LE(most.*axis, range + 1e-6);
    EXPECT_GT(most.*axis, 0.95 * range);
    // the mean of 400 even draws: within four standard deviations
    EXPECT_NEAR((sum / kSeeds).*axis, 0, 4 * range / std::sqrt(3.0 * kSeeds));
  }
}

TEST(Spread, OfAFlightMovesItAsAWhole) {
  const auto s = pair("      spread: {position: 5 km, altitude: 1 km, heading: 180 deg}\n");
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const auto world = s->world(seed);
    const auto &lead = motion(*s, world, 0), &wing = motion(*s, world, 1);
    EXPECT_EQ(lead.heading, wing.heading);
    EXPECT_NEAR(wing.altitude, lead.altitude - 100, 1e-3);
    const Vec3 between = wing.position - lead.position;
    EXPECT_NEAR(dot(between, lead.north) * std::cos(lead.heading) +
                    dot(between, lead.east) * std::sin(lead.heading),
                0, 2)
        << "abreast";
    EXPECT_NEAR(norm(between), std::hypot(1000, 100), 2);
  }
}

TEST(Spread, OfAPlayerMovesHimAlone) {
  const auto s = pair("", "spread: {position: 3 km}");
  const auto a = s->world(1), b = s->world(2);
  EXPECT_EQ(motion(*s, a, 0).position, motion(*s, b, 0).position);
  EXPECT_NE(motion(*s, a, 1).position, motion(*s, b, 1).position);
  EXPECT_NEAR(motion(*s, a, 1).altitude, 4900, 1e-3) << "his place in the formation";
  EXPECT_EQ(s->world(1).hash(), a.hash());
}

TEST(Spread, LeavesWorldsWithoutOneAsTheyWere) {
  const auto with = pair("      spread: {position: 0 m}\n"), without = pair("");
  EXPECT_TRUE(with->spreads.empty());
  EXPECT_EQ(with->world(3).hash(), without->world(3).hash());
}

TEST(Spread, IsRefusedWhereAStartCouldNotBeFlown) {
  EXPECT_EQ(mistake("      spread: {altitude: 6 km}\n"),
            "pair.yaml:12:15: eagle1: spread.altitude: 6 km below a start at 5 km is below the "
            "surface\n"
            "pair.yaml:12:15: eagle2: spread.altitude: 6 km below a start at 4900 m is below the "
            "surface");
  EXPECT_EQ(mistake("      spread: {altitude: 4950 m}\n"),
            "pair.yaml:12:15: eagle2: spread.altitude: 4950 m below a start at 4900 m is below "
            "the surface");
  EXPECT_NE(mistake("      spread: {altitude: 26 km}\n"), "");
  EXPECT_NE(mistake("      spread: {speed: 200 m/s}\n").find("slower than a start at 200 m/s"),
            std::string::npos);
  EXPECT_NE(mistake("      start: {north: 490 km, east: 0 km, altitude: 5 km, heading: 0 deg, "
                    "speed: 200 m/s}\n"),
            "");
  EXPECT_NE(mistake("      spread: {positon: 2 km}\n").find("did you mean 'position'?"),
            std::string::npos);
}

TEST(Spread, OfNothingLeavesNoWingmanBelowTheSurface) {
  EXPECT_EQ(mistake("", "99 m"),
            "pair.yaml:14:11: eagle2: 100 m below its lead, which starts at 99 m, is below the "
            "surface");
  EXPECT_EQ(mistake("", "100 m"), "");
}

}  // namespace
}  // namespace eyrie::scenario
