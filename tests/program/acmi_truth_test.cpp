// SPDX-License-Identifier: MIT
/// \file  The places of a Tacview file against the truth, and how much of it is written.
#include <gtest/gtest.h>

#include <filesystem>

#include "core/angle.hpp"
#include "record/acmi.hpp"
#include "support/acmi_reader.hpp"
#include "support/flight.hpp"
#include "support/program.hpp"
#include "support/truth.hpp"
#include "support/wgs84.hpp"

namespace eyrie::test {
namespace {

struct Recording {
  std::shared_ptr<const scenario::Scenario> scenario;
  Truth truth;
  std::string text;
  Acmi file;

  explicit Recording(std::shared_ptr<const scenario::Scenario> what, double until)
      : scenario(std::move(what)), truth(*scenario), text(fly(until)), file(text) {}

 private:
  std::string fly(double until) {
    std::string written;
    record::AcmiWriter writer(*scenario, [&](std::string_view lines) { written += lines; });
    scenario::Mission mission(scenario, scenario->spec.seed, until);
    mission.run().attach(writer);
    mission.run().attach(truth);
    mission.fly();
    return written;
  }
};

/// The tolerances of the writer and half of the last decimal that is written.
constexpr double kMeters = 3 + 0.03, kDegrees = 1.5 + 0.05 + 1e-6;

/// Longitude and latitude in the file are relative to its reference.
Place place_of(const AcmiSample& sample, const Place& reference) {
  return {sample.fields[0] + reference.longitude, sample.fields[1] + reference.latitude,
          sample.fields[2]};
}
Place reference_of(const Acmi& file) {
  return {acmi_number(file.globals.at("ReferenceLongitude")),
          acmi_number(file.globals.at("ReferenceLatitude")), 0};
}

void expect_true(const Recording& r) {
  const Place reference = reference_of(r.file);
  std::size_t compared = 0;
  for (const auto& [id, samples] : r.truth.all()) {
    const auto object = r.file.objects.find(id);
    ASSERT_NE(object, r.file.objects.end()) << id;
    for (const Truth::At& truth : samples) {
      const AcmiSample read = object->second.at(truth.time);
      const auto [north, east, down] = ned_between(reference, place_of(read, reference));
      ASSERT_LE(norm(Vec3{north, east, down} - truth.k.position), kMeters)
          << id << " at " << truth.time;
      const double angles[] = {truth.k.roll, truth.k.pitch, truth.k.heading};
      for (std::size_t i = 0; i < 3; ++i)
        ASSERT_LE(std::fabs(std::remainder(read.fields[3 + i] - degrees(angles[i]), 360)), kDegrees)
            << id << " at " << truth.time << ", angle " << i;
      ++compared;
    }
  }
  EXPECT_GT(compared, 500u);
}

/// Where it goes at a moment: degrees from north to the right, and upward.
struct Course {
  double heading = 0, climb = 0;
};
Course course_of(const AcmiObject& object, const Place& reference, double time) {
  const auto [north, east, down] = ned_between(place_of(object.at(time - 0.5), reference),
                                               place_of(object.at(time + 0.5), reference));
  return {degrees(std::atan2(east, north)), degrees(std::atan2(-down, std::hypot(north, east)))};
}

/// An aircraft flies nose first, and turns towards the wing that is down. So a sign that is wrong
/// in the file, in the state or in both shows. One goes round to the right, the other to the left,
/// both up and down.
TEST(AcmiTruth, PointsWhereItFliesAndBanksIntoTheTurn) {
  constexpr double kUntil = 600;
  const TempFolder folder;
  const std::string file = folder.write("round.yaml", R"(eyrie: 1
name: round
reference: {latitude: 60 deg, longitude: 179.9 deg}
until: 10 min
trees: {around: navigate}
blue:
  flights:
    right:
      aircraft: f15c
      tree: around
      players: [right1]
      start: {north: 0 nmi, east: 0 nmi, altitude: 10000 ft, heading: 90 deg, speed: 450 kt}
      route:
        - {north: 0 nmi, east: 8 nmi, altitude: 10000 ft, speed: 450 kt}
        - {north: -8 nmi, east: 8 nmi, altitude: 30000 ft}
        - {north: -8 nmi, east: 0 nmi, altitude: 10000 ft}
        - {north: 0 nmi, east: 0 nmi, altitude: 30000 ft}
        - {north: 0 nmi, east: 8 nmi, altitude: 10000 ft}
    left:
      aircraft: f15c
      tree: around
      players: [left1]
      start: {north: 20 nmi, east: 0 nmi, altitude: 10000 ft, heading: 90 deg, speed: 450 kt}
      route:
        - {north: 20 nmi, east: 8 nmi, altitude: 10000 ft, speed: 450 kt}
        - {north: 28 nmi, east: 8 nmi, altitude: 30000 ft}
        - {north: 28 nmi, east: 0 nmi, altitude: 10000 ft}
        - {north: 20 nmi, east: 0 nmi, altitude: 30000 ft}
        - {north: 20 nmi, east: 8 nmi, altitude: 10000 ft}
)");
  const Recording r(scenario::load({file}, scenario::Source::disk(".")), kUntil);
  std::size_t looked = 0, turning = 0, banked_into_it = 0, climbing = 0, nose_follows = 0;
  const Place reference = reference_of(r.file);
  for (const auto& [id, object] : r.file.objects) {
    if (object.last("Type") != "Air+FixedWing")
      continue;
    const double end = object.removed.value_or(kUntil) - 2;
    for (double time = 2; time < end; ++time) {
      const auto fields = object.at(time).fields;
      const double roll = std::remainder(fields[3], 360), pitch = fields[4];
      const Course course = course_of(object, reference, time);
      if (std::fabs(course.climb) < 45) {
        ++looked;
        ASSERT_LT(std::fabs(std::remainder(fields[5] - course.heading, 360)), 3)
            << object.last("CallSign") << " at " << time;
      }
      if (std::fabs(course.climb) > 15) {
        ++climbing;
        nose_follows += pitch * course.climb > 0;
      }
      const double turn = std::remainder(course_of(object, reference, time + 1).heading -
                                             course_of(object, reference, time - 1).heading,
                                         360);
      if (std::fabs(turn) < 2 || std::fabs(roll) < 20 || std::fabs(roll) > 80 ||
          std::fabs(course.climb) > 30)
        continue;
      ++turning;
      banked_into_it += turn * roll > 0;
    }
  }
  EXPECT_GT(looked, 1000u);
  EXPECT_GT(turning, 400u);
  EXPECT_EQ(banked_into_it, turning);
  EXPECT_GT(climbing, 50u);
  EXPECT_EQ(nose_follows, climbing);
}

TEST(AcmiTruth, HoldsInAFightWithMissiles) {
  const Recording r(load_scenario("sweep"), 14 * 60);
  expect_true(r);
  std::size_t missiles = 0;
  for (const auto& [id, object] : r.file.objects) {
    missiles += object.last("Type") == "Weapon+Missile";
    for (std::size_t i = 1; i < object.samples.size(); ++i)
      ASSERT_LE(object.samples[i].time - object.samples[i - 1].time, 5 + 1e-9) << id;
    if (object.removed) {
      EXPECT_NEAR(object.samples.back().time, *object.removed, 0.02 + 1e-9)
          << id << " is shown to its end";
    }
  }
  EXPECT_GT(missiles, 2u);
}

TEST(AcmiTruth, HoldsInATurningFight) {
  const Recording r(load_scenario("merge"), 120);
  expect_true(r);
}

TEST(AcmiTruth, HoldsForVehiclesAndWhoeverStandsStill) {
  const Recording r(load_scenario("convoy"), 20 * 60);
  expect_true(r);
}

/// So 24 hours of six aircraft that have no fuel to burn stay below 15 MB.
TEST(AcmiTruth, WritesLittleOfACruiseAndOfCircles) {
  const TempFolder folder;
  const std::string file = folder.write("six.yaml", R"(eyrie: 1
name: six
reference: {latitude: 60 deg, longitude: 179.9 deg}
until: 1 h
trees:
  around: {winner_takes_all: [{follow_lead: {vote: 20}}, {navigate: {vote: 10}}]}
blue:
  flights:
    eagle:
      aircraft: laero_fighter
      tree: around
      players: [eagle1, eagle2, eagle3, eagle4, eagle5, eagle6]
      start: {north: 0 nmi, east: 0 nmi, altitude: 25000 ft, heading: 90 deg, speed: 400 kt}
      route:
        - {north: 0 nmi, east: 40 nmi, altitude: 25000 ft, speed: 400 kt}
        - {north: 30 nmi, east: 40 nmi, altitude: 28000 ft}
        - {north: 30 nmi, east: -40 nmi}
        - {north: 0 nmi, east: -40 nmi, altitude: 25000 ft}
)");
  const Recording r(scenario::load({file}, scenario::Source::disk(".")), 3600);
  expect_true(r);
  EXPECT_LT(static_cast<double>(r.text.size()) * 24, 15e6);
  std::size_t written = 0, taken = 0;
  for (const auto& [id, samples] : r.truth.all()) {
    taken += samples.size();
    written += r.file.objects.at(id).samples.size();
  }
  EXPECT_LT(written * 6, taken);
}

}  // namespace
}  // namespace eyrie::test
