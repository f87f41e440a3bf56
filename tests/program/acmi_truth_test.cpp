// SPDX-License-Identifier: MIT
/// \file  The places of a Tacview file against the truth, and how much of it is written.
#include <gtest/gtest.h>

#include <filesystem>
#include <map>

#include "core/angle.hpp"
#include "record/acmi.hpp"
#include "support/acmi_reader.hpp"
#include "support/flight.hpp"
#include "support/program.hpp"

namespace eyrie::test {
namespace {

/// Everybody's samples, as often as the writer takes them.
class Truth final : public sim::Observer {
 public:
  struct At {
    double time = 0;
    model::Kinematics k;
  };
  explicit Truth(const scenario::Scenario& scenario) : scenario_(scenario) {}

  void observe(const sim::World& world, const sim::StepInfo& info,
               std::span<const sim::Event>) override {
    const double time = info.time() + info.dt;
    if (world.step() % 10 == 0) {
      look(world, time, scenario_.aircraft.table, scenario_.aircraft.kinematics);
      if (scenario_.vehicles)
        look(world, time, scenario_.vehicles->table, scenario_.vehicles->kinematics);
    }
    if (world.step() % 5 == 0)
      look(world, time, scenario_.missiles.table, scenario_.missiles.kinematics);
  }
  [[nodiscard]] const std::map<std::uint32_t, std::vector<At>>& all() const { return all_; }

 private:
  template <class Column>
  void look(const sim::World& world, double time, TableId table, Column column) {
    for (std::size_t i = 0; i < world.rows(table); ++i)
      all_[world.ids(table)[i].value].push_back({time, world.rows(column)[i]});
  }
  const scenario::Scenario& scenario_;
  std::map<std::uint32_t, std::vector<At>> all_;
};

struct Recording {
  std::shared_ptr<const scenario::Scenario> scenario;
  Truth truth;
  std::string text;
  Acmi file;

  explicit Recording(std::shared_ptr<const scenario::Scenario> what, double until)
      : scenario(std::move(what)), truth(*scenario), text(fly(until)), file(text) {}

 private:
  std::string fly(double until) {
    const TempFolder folder;
    disk::Sink sink(folder / "flight.acmi");
    record::AcmiWriter writer(*scenario, sink);
    scenario::Mission mission(scenario, scenario->spec.seed, until);
    mission.run().attach(writer);
    mission.run().attach(truth);
    mission.fly();
    EXPECT_TRUE(sink.close());
    return read_text(folder / "flight.acmi");
  }
};

/// The tolerances of the writer and half of the last decimal that is written.
constexpr double kMeters = 3 + 0.02, kDegrees = 1.5 + 0.05 + 1e-6;

void expect_true(const Recording& r) {
  const Reference& reference = r.scenario->library->reference;
  const double longitude = acmi_number(r.file.globals.at("ReferenceLongitude"));
  const double latitude = acmi_number(r.file.globals.at("ReferenceLatitude"));
  std::size_t compared = 0;
  for (const auto& [id, samples] : r.truth.all()) {
    const auto object = r.file.objects.find(id);
    ASSERT_NE(object, r.file.objects.end()) << id;
    for (const Truth::At& truth : samples) {
      const auto read = object->second.at(truth.time).fields;
      const Vec3 place = reference.to_local({.latitude = radians(read[1] + latitude),
                                             .longitude = radians(read[0] + longitude),
                                             .altitude = read[2]});
      ASSERT_LE(norm(place - truth.k.position), kMeters) << id << " at " << truth.time;
      const double angles[] = {truth.k.roll, truth.k.pitch, truth.k.heading};
      for (std::size_t i = 0; i < 3; ++i)
        ASSERT_LE(std::fabs(std::remainder(read[3 + i] - degrees(angles[i]), 360)), kDegrees)
            << id << " at " << truth.time << ", angle " << i;
      ++compared;
    }
  }
  EXPECT_GT(compared, 500u);
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
  EXPECT_GT(missiles, 3u);
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
