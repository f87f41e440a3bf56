// SPDX-License-Identifier: MIT
#include "model/sensor/rwr.hpp"

#include <algorithm>

namespace eyrie::model::sensor {
namespace {

/// Order on the display: the more urgent kind, then who was heard first, then by fingerprint.
bool goes_before(const RwrWarning& a, const RwrWarning& b) {
  return std::tie(b.kind, a.first_time, a.emitter) < std::tie(a.kind, b.first_time, b.emitter);
}

void sort(RwrState& state) {
  std::sort(state.warnings.begin(), state.warnings.begin() + state.count, goes_before);
}

}  // namespace

RwrAntenna aim(const Rwr& rwr, const Kinematics& own, Side side) {
  return {.position = own.position,
          .body = body_axes(own),
          .altitude = own.altitude,
          .sensitivity = math::pow(10, -rwr.insensitivity / 10),
          .sin_coverage = math::sin(rwr.elevation_coverage),
          .side = side};
}

std::optional<double> hear(const Rwr& rwr, const RwrAntenna& antenna, const Emission& emission) {
  if (emission.kind == EmissionKind::none || (rwr.hides_friends && emission.side == antenna.side))
    return std::nullopt;
  const Vec3 path = antenna.position - emission.position;
  const double range2 = norm2(path);
  const double reach2 = emission.figure * emission.figure * antenna.sensitivity;
  if (range2 > reach2 || range2 <= 0)
    return std::nullopt;

  // inside the cone of the beam?
  const double along = dot(path, emission.boresight), edge = emission.cos_half_angle;
  if (along < 0 ? edge > 0 || along * along > edge * edge * range2
                : edge > 0 && along * along < edge * edge * range2)
    return std::nullopt;

  // inside the coverage of the antennas, which turn with the wings?
  const double off_plane = dot(path, antenna.body.down);
  if (off_plane * off_plane > antenna.sin_coverage * antenna.sin_coverage * range2)
    return std::nullopt;
  return reach2 / range2;
}

RwrWarning warn(const Rwr& rwr, const RwrAntenna& antenna, const Kinematics& own,
                const Emission& emission, PlayerId emitter, double time, Draw draw) {
  const Vec3 sight = emission.position - antenna.position;
  const double bearing = math::atan2(dot(sight, own.east), dot(sight, own.north));
  const double relative = angle_between(own.heading, bearing);
  const double error = rwr.sigma_bearing * draw.normal();
  const double measured = relative + std::copysign(1.0, relative) * error;
  const double shown = rwr.bearing_step * std::nearbyint(measured / rwr.bearing_step);
  return {.bearing = wrap_pi(own.heading + shown),
          .time = time,
          .first_time = time,
          .emitter = emitter,
          .type = emission.type,
          .kind = emission.kind};
}

bool show(RwrState& state, const RwrWarning& warning) {
  for (std::uint32_t i = 0; i < state.count; ++i) {
    RwrWarning& known = state.warnings[i];
    if (known.emitter != warning.emitter)
      continue;
    const bool more_urgent = warning.kind > known.kind;
    const double first_time = known.first_time;
    known = warning;
    known.first_time = first_time;
    sort(state);
    return more_urgent;
  }

  if (state.count == kMaxWarnings) {
    std::uint32_t least = 0;
    for (std::uint32_t i = 1; i < state.count; ++i) {
      const RwrWarning &a = state.warnings[i], &b = state.warnings[least];
      if (a.kind != b.kind ? a.kind < b.kind : a.time < b.time)
        least = i;
    }
    if (state.warnings[least].kind >= warning.kind)
      return false;
    state.warnings[least] = warning;
  } else {
    state.warnings[state.count++] = warning;
  }
  sort(state);
  return true;
}

void forget(RwrState& state, const Rwr& rwr, double time) {
  std::uint32_t kept = 0;
  for (std::uint32_t i = 0; i < state.count; ++i)
    if (time - state.warnings[i].time <= rwr.memory)
      state.warnings[kept++] = state.warnings[i];
  for (std::uint32_t i = kept; i < state.count; ++i)
    state.warnings[i] = {};
  state.count = kept;
}

}  // namespace eyrie::model::sensor
