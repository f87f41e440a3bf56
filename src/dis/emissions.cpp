// SPDX-License-Identifier: MIT
/// \file  What others hear of radars, seekers and jammers.
#include <algorithm>

#include "dis/announcer.hpp"
#include "model/jamming.hpp"

namespace eyrie::dis {
namespace {

constexpr std::uint8_t kAirIntercept = 19, kMissileHoming = 61, kNoiseJamming = 64;  // UID 76
constexpr double kFrames = 2;  // of the search, in which who is tracked was seen
constexpr double kFrequency = 299792458 / model::kRadarWavelength;  // Hz

/// Towards a direction of the local frame, seen from the nose.
void point(Emission::Beam& beam, const model::Kinematics& k, const Vec3& line) {
  const model::Axes body = model::body_axes(k);
  const double ahead = dot(line, body.forward), aside = dot(line, body.right);
  beam.azimuth = static_cast<float>(math::atan2(aside, ahead));
  beam.elevation = static_cast<float>(
      math::atan2(-dot(line, body.down), std::sqrt(ahead * ahead + aside * aside)));
}

void track(Emission::Beam& beam, std::vector<EntityId> targets) {
  std::ranges::sort(targets);
  beam.crowded = targets.size() > kMostTargets;
  if (!beam.crowded)
    for (const EntityId& who : targets)
      beam.targets.push_back({.who = who});
}

Emission::Beam radar_beam(const model::Radar& radar, const model::Emission& emission,
                          const model::TrackFile& tracks, double time, const IdOf& id_of) {
  Emission::Beam beam{.frequency = static_cast<float>(kFrequency)};
  if (emission.kind == model::EmissionKind::track) {
    beam.function = BeamFunction::tracking;
    if (emission.dwell)
      track(beam, {id_of(emission.dwell)});
    return beam;
  }
  std::vector<EntityId> seen;
  for (std::uint32_t i = 0; i < tracks.count; ++i)
    if (const model::Track& t = tracks.tracks[i]; t.confirmed && t.truth &&
                                                  (t.sources & model::kFromRadar) &&
                                                  time - t.sensed_time < kFrames / radar.scan_rate)
      seen.push_back(id_of(t.truth));
  if (!seen.empty())
    beam.function = BeamFunction::acquisition_and_tracking;
  track(beam, std::move(seen));
  beam.azimuth_sweep = static_cast<float>(radar.scan_half_azimuth);
  beam.elevation_sweep = static_cast<float>(radar.scan_bars * radar.bar_spacing / 2);
  return beam;
}

}  // namespace

std::vector<Emission::System> systems_of(const scenario::Scenario& scenario,
                                         const sim::World& world, std::size_t row,
                                         const IdOf& id_of) {
  const model::Library& library = *scenario.library;
  const double time = static_cast<double>(world.step()) * scenario.simulation->dt();
  const auto& columns = scenario.aircraft;
  const model::Kinematics& k = world.rows(columns.kinematics)[row];
  const model::Emission& emission = world.rows(columns.emission)[row];
  const auto& has = library.aircraft[world.rows(columns.fit)[row].type].index;
  std::vector<Emission::System> systems;
  if (has.radar) {
    const model::Radar& radar = library.radars[*has.radar];
    Emission::System system{.name = *model::emitter_of(radar.emitter), .function = kAirIntercept};
    if (emission.kind != model::EmissionKind::none) {
      system.beams.push_back(
          radar_beam(radar, emission, world.rows(columns.tracks)[row], time, id_of));
      point(system.beams[0], k, emission.boresight);
    }
    systems.push_back(std::move(system));
  }
  if (emission.jamming > 0)
    systems.push_back({.function = kNoiseJamming,
                       .number = 2,
                       .beams = {{.frequency = static_cast<float>(kFrequency),
                                  .azimuth_sweep = static_cast<float>(kPi),
                                  .elevation_sweep = static_cast<float>(kPi / 2),
                                  .function = BeamFunction::jamming}}});
  return systems;
}

std::vector<Emission::System> seeker_of(const scenario::Scenario& scenario, const sim::World& world,
                                        std::size_t row, const IdOf& id_of) {
  const model::Emission& emission = world.rows(scenario.missiles.emission)[row];
  if (emission.kind == model::EmissionKind::none)
    return {};
  Emission::Beam beam{.frequency = static_cast<float>(kFrequency),
                      .function = BeamFunction::missile_seeker};
  point(beam, world.rows(scenario.missiles.kinematics)[row], emission.boresight);
  if (emission.dwell && world.rows(scenario.missiles.state)[row].decoy == 0)
    track(beam, {id_of(emission.dwell)});
  return {{.name = *model::emitter_of(scenario.library->missiles[emission.type].emitter),
           .function = kMissileHoming,
           .beams = {std::move(beam)}}};
}

bool differs(std::span<const Emission::System> a, std::span<const Emission::System> b,
             double angle) {
  const auto turned = [&](float x, float y) { return std::fabs(wrap_pi(double{x} - y)) > angle; };
  const auto other_beam = [&](const Emission::Beam& x, const Emission::Beam& y) {
    return x.function != y.function || x.crowded != y.crowded || x.targets != y.targets ||
           turned(x.azimuth, y.azimuth) || turned(x.elevation, y.elevation);
  };
  return !std::ranges::equal(a, b, [&](const auto& x, const auto& y) {
    return x.number == y.number &&
           std::ranges::equal(x.beams, y.beams,
                              [&](const auto& p, const auto& q) { return !other_beam(p, q); });
  });
}

}  // namespace eyrie::dis
