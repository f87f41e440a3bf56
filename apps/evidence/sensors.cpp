// SPDX-License-Identifier: MIT
/// \file  The radars of data/, jammed and not, the infrared search, and the tracker behind a radar.

#include <algorithm>

#include "core/draw.hpp"
#include "evidence.hpp"
#include "load.hpp"
#include "model/jamming.hpp"
#include "model/sensor/infrared.hpp"
#include "model/sensor/radar.hpp"
#include "model/track/filter.hpp"

namespace eyrie::evidence {

using namespace model;

namespace {

constexpr double kMile = si(1, "nmi");

Plot radar_detection(const sensor::Radar& radar, const Jammer& jammer) {
  Plot plot{.file = "radar_detection",
            .title = "APG-63, chance of detection in one frame",
            .x = "nmi",
            .y = "Pd"};
  const sensor::Detector detector(radar);
  for (const auto& [name, rcs, jams] : {std::tuple{"3.2 m²", 3.2, false},
                                        {"10 m²", 10.0, false},
                                        {"10 m², 1 kW of noise", 10.0, true}}) {
    Series series{name, {}};
    for (double nmi = 2; nmi <= 160; nmi += 2) {
      const double range2 = nmi * kMile * nmi * kMile;
      const double noise = jams ? jamming_to_noise(jammer.density(), radar.beam_width, range2) : 0;
      series.points.push_back(
          {nmi, detector.probability(detector.signal_to_noise(range2, rcs) / (1 + noise))});
    }
    plot.series.push_back(series);
  }
  plot.series.push_back({"OPRF: even odds read at 80 nmi", {{80, 0.5}}, true});
  return plot;
}

Plot radar_errors(const sensor::Radar& radar) {
  Plot plot{.file = "radar_errors",
            .title = "APG-63, error of one look at 5 m², 1-sigma",
            .x = "nmi",
            .y = "m",
            .series = {{"across the line", {}}, {"range", {}}}};
  const sensor::Detector detector(radar);
  for (double nmi = 5; nmi <= 100; nmi += 2.5) {
    const double range = nmi * kMile;
    const auto e =
        errors_of(radar, sensor::RadarMode::search, detector.signal_to_noise(range * range, 5));
    plot.series[0].points.push_back({nmi, e.angle * range});
    plot.series[1].points.push_back({nmi, e.range});
  }
  return plot;
}

/// Median velocity errors and mean NEES of a target of 5 m² that comes straight from 90 nmi at 236
/// m/s, seen every 4 s by an aircraft that flies towards it at 250 m/s, by range.
std::pair<Plot, Plot> tracker_by_range(const track::Tracker& tracker, const sensor::Radar& radar) {
  constexpr std::size_t kBins = 8;
  std::array<std::vector<double>, kBins> across, along, nees;
  const sensor::Detector detector(radar);
  const Vec3 north{1, 0, 0}, east{0, 1, 0}, down{0, 0, 1};
  for (std::uint32_t run = 0; run < 200; ++run) {
    const double aside = si(5, "deg") * (run % 19) - si(45, "deg");
    const auto [s, c] = math::sin_cos(aside);
    const Vec3 velocity = 236.0 * Vec3{-c, s, 0};
    Track held;
    for (std::uint32_t frame = 0; frame < 90; ++frame) {
      const double time = 4.0 * frame;
      Kinematics own{.position = {250 * time, 0, -9000},
                     .velocity = {250, 0, 0},
                     .north = north,
                     .east = east,
                     .down = down,
                     .altitude = 9000};
      Kinematics other = own;
      other.position = Vec3{90 * kMile, 0, -8000} + time * velocity;
      other.velocity = velocity;
      const Vec3 sight = other.position - own.position;
      const double range = norm(sight);
      const auto bin = static_cast<std::size_t>(range / (10 * kMile));
      if (sight.x < 0 || bin >= kBins + 1)
        continue;
      Draw noise(1, PlayerId{run + 1}, Stream::radar_noise, frame, 2);
      const double mean = detector.signal_to_noise(range * range, 5);
      const double echo = *detector.echo(mean, 1 - noise.uniform() * detector.probability(mean));
      const Contact contact = measure(errors_of(radar, sensor::RadarMode::search, echo), own,
                                      level_axes(own, 0), other, PlayerId{2}, noise);
      const Ownship ownship{own.position, own.velocity};
      if (held.time == 0 && held.hits == 0)
        held = track::first_track(tracker, contact, time);
      else
        track::filter(held, track::predict(held, tracker, ownship, time), contact, time);
      if (held.hits < 6 || bin >= kBins)
        continue;
      const track::Prediction now = track::predict(held, tracker, ownship, time);
      const Vec3 line = sight / range, wrong = now.velocity - velocity,
                 off = now.position - other.position;
      const double v = dot(wrong, line), p = dot(off, line);
      along[bin].push_back(std::fabs(v));
      across[bin].push_back(norm(wrong - v * line));
      const auto normalized = [](const track::AxisState& a, double pp, double pv, double vv) {
        return (a.velocity * pp - 2 * a.cross * pv + a.position * vv) /
               (a.position * a.velocity - a.cross * a.cross);
      };
      const track::Covariance claimed = covariance_of(now);
      nees[bin].push_back(normalized(claimed.along, p * p, p * v, v * v) +
                          normalized(claimed.across, norm2(off) - p * p, dot(off, wrong) - p * v,
                                     norm2(wrong) - v * v));
    }
  }
  Plot errors{.file = "track_velocity",
              .title = "Tracker behind the APG-63: error of the velocity, median",
              .x = "nmi",
              .y = "m/s",
              .series = {{"across the line", {}}, {"along it", {}}}};
  Plot sure{
      .file = "track_nees",
      .title = "NEES of position and velocity of straight targets (6: as sure as it should be)",
      .x = "nmi",
      .y = "NEES",
      .series = {{"as shipped", {}}, {"consistent", {}, true}}};
  const auto median = [](std::vector<double> values) {
    std::ranges::sort(values);
    return values[values.size() / 2];
  };
  for (std::size_t i = 0; i < kBins; ++i) {
    if (across[i].size() < 20)
      continue;
    const double middle = 10.0 * static_cast<double>(i) + 5;
    errors.series[0].points.push_back({middle, median(across[i])});
    errors.series[1].points.push_back({middle, median(along[i])});
    double sum = 0;
    for (const double n : nees[i])
      sum += n / static_cast<double>(nees[i].size());
    sure.series[0].points.push_back({middle, sum});
    sure.series[1].points.push_back({middle, 6});
  }
  return {errors, sure};
}

}  // namespace

Evidence of_sensors(const std::string& home) {
  const auto apg63 = load<sensor::Radar>(home, "data/radars/apg63.yaml");
  const auto jammer = load<Jammer>(home, "data/jammers/fighter_noise.yaml");
  const auto tracker = load<track::Tracker>(home, "data/trackers/mission_computer.yaml");
  const auto ols27 = load<sensor::Irst>(home, "data/irsts/ols27.yaml");
  Evidence out;
  const auto [errors, sure] = tracker_by_range(tracker, apg63);
  out.plots = {radar_detection(apg63, jammer), radar_errors(apg63), errors, sure};

  const sensor::Detector detector(apg63);
  const double range2 = 94 * kMile * 94 * kMile;
  out.rows.push_back({.model = "radar, APG-63",
                      .page = "radar.md",
                      .claim = "even odds against 6 m² at 94 nmi",
                      .here = detector.probability(detector.signal_to_noise(range2, 6)),
                      .published = 0.5,
                      .source = "FlightGear OPRF list, 80 nmi at 3.2 m² (seen), fourth root",
                      .test = "SensorData.TheBestRadarSeesTheOthersWhereTheFactsSaySo",
                      .plot = "radar_detection"});
  const InfraredSignature fighter;
  for (const auto& [where, cos_aspect, published, tolerance] :
       {std::tuple{"behind", -1.0, 50.0, 0.1}, {"ahead", 1.0, 15.0, 0.2}})
    out.rows.push_back(
        {.model = "irst, OLS-27",
         .page = "radar.md",
         .claim = fmt::format("range from {}, military power, km", where),
         .here = ols27.reference_range / 1e3 *
                 std::sqrt(radiant_intensity(fighter, cos_aspect, 1) / ols27.reference_intensity),
         .published = published,
         .tolerance = tolerance,
         .source = "as commonly published (not seen)",
         .test = "Infrared.SeesATailFourTimesAsFarAsANoseAndAnAfterburnerFarther"});
  out.rows.push_back({.model = "tracks",
                      .page = "tracks.md",
                      .claim = "velocity error by range",
                      .source = "definition",
                      .test = "Tracking.KnowsTheVelocityOfATargetAsWellAsTheDocsSay",
                      .plot = "track_velocity"});
  out.rows.push_back({.model = "tracks",
                      .page = "tracks.md",
                      .claim = "not too sure of a straight flight that might turn",
                      .source = "chi-square; Bar-Shalom et al. (2001), 5.4 (seen as quoted)",
                      .test = "Consistency.IsNotTooSureOfAStraightFlightThatMightTurn",
                      .plot = "track_nees"});
  return out;
}

}  // namespace eyrie::evidence
