// SPDX-License-Identifier: MIT
// The sensors of data/: they bind, their rates fit the step, and the numbers agree with each other.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "core/bind.hpp"
#include "core/yaml.hpp"
#include "model/datalink/datalink.hpp"
#include "model/sensor/radar.hpp"
#include "model/sensor/rwr.hpp"
#include "model/sensor/visual.hpp"
#include "model/track/filter.hpp"
#include "sim/system.hpp"

namespace eyrie::model::sensor {
namespace {

Value read(const std::filesystem::path& path, Diagnostics& diagnostics) {
  std::ifstream file(path);
  EXPECT_TRUE(file) << path;
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  Value value = parse_yaml(text, path.string(), diagnostics);
  if (!value.find("base"))
    return value;
  const std::filesystem::path below = path.parent_path() / (value.find("base")->text + ".yaml");
  std::erase_if(value.entries, [](const Value::Entry& e) { return e.key == "base"; });
  return merged(read(below, diagnostics), value);
}

template <class Model>
std::vector<Model> all(const std::string& kind) {
  std::vector<Model> models;
  std::vector<std::filesystem::path> paths;
  for (const auto& file : std::filesystem::directory_iterator(std::string("data/") + kind))
    paths.push_back(file.path());
  std::sort(paths.begin(), paths.end());
  for (const auto& path : paths) {
    Diagnostics diagnostics;
    Model model;
    EXPECT_TRUE(bind(model, read(path, diagnostics), diagnostics)) << diagnostics.text();
    models.push_back(model);
  }
  EXPECT_FALSE(models.empty()) << kind;
  return models;
}

bool fits(double rate) {
  return static_cast<bool>(sim::period_steps(rate, 0.02));
}

TEST(SensorData, RadarsAreWholeAndTheirScansCanBeFlown) {
  for (const Radar& radar : all<Radar>("radars")) {
    EXPECT_TRUE(fits(radar.scan_rate) && fits(radar.track_rate));
    EXPECT_LE(radar.scan_half_azimuth, radar.gimbal);
    EXPECT_LE(radar.track_angle_floor, radar.angle_floor);
    EXPECT_LE(radar.bar_spacing, 1.5 * radar.beam_width) << "no gaps between the rows";
    // a mechanical antenna of that time does not turn faster than 80 deg/s
    const double speed = 2 * radar.scan_half_azimuth * radar.scan_bars * radar.scan_rate;
    EXPECT_LE(speed, radians(80));
    EXPECT_GE(radar.instrumented_range, radar.reference_range);
  }
}

TEST(SensorData, TheBestRadarSeesTheOthersWhereTheFactsSaySo) {
  // 80 nmi at 3.2 m^2 is 94 nmi for the 6 m^2 of a MiG-29 (docs/models/radar.md)
  Diagnostics diagnostics;
  Radar apg63;
  ASSERT_TRUE(bind(apg63, read("data/radars/apg63.yaml", diagnostics), diagnostics));
  const Detector detector(apg63);
  const double range = si(94, "nmi");
  EXPECT_NEAR(detector.probability(detector.signal_to_noise(range * range, 6)), 0.5, 0.01);
}

TEST(SensorData, TheRestIsWholeToo) {
  for (const Rwr& rwr : all<Rwr>("rwr"))
    EXPECT_TRUE(fits(rwr.search_rate) && fits(rwr.seeker_rate));
  for (const Visual& visual : all<Visual>("visual")) {
    EXPECT_TRUE(fits(visual.rate));
    EXPECT_GT(visual.cued_search, visual.search);
    EXPECT_NEAR(visual.identify_angle / visual.least_angle, 6.4, 0.1) << "Johnson 1958";
  }
  for (const Iff& iff : all<Iff>("iff"))
    EXPECT_GT(iff.tries, 1u) << "one lost reply must not make a hostile of a friend";
  for (const datalink::Datalink& link : all<datalink::Datalink>("datalinks")) {
    EXPECT_TRUE(fits(link.rate));
    EXPECT_EQ(link.problem(), "");
    EXPECT_GT(link.timeout, 2 / link.rate + link.delay);
  }
  for (const track::Tracker& tracker : all<track::Tracker>("trackers"))
    EXPECT_TRUE(fits(tracker.rate));
}

TEST(SensorData, AMissileSeekerIsHeardBeforeItArrives) {
  for (const Rwr& rwr : all<Rwr>("rwr")) {
    // a 15 km seeker against 5 m^2, the class of data/missiles
    const double heard = emission_figure(15e3, 5) * std::pow(10, -rwr.insensitivity / 20);
    EXPECT_GT(heard, 15e3);
    EXPECT_LT(heard, 60e3);
  }
}

}  // namespace
}  // namespace eyrie::model::sensor
