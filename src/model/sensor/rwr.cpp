// SPDX-License-Identifier: MIT
#include "model/sensor/rwr.hpp"

#include <algorithm>

namespace eyrie::model::sensor {
namespace {

/// Order on the display: the more urgent kind, then who has been it longest, then by fingerprint.
bool goes_before(const RwrWarning& a, const RwrWarning& b) {
  return std::tie(b.kind, a.kind_time, a.emitter) < std::tie(a.kind, b.kind_time, b.emitter);
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

double hear(const Rwr& rwr, const RwrAntenna& antenna, const Emission& emission) {
  if (emission.kind == EmissionKind::none || (rwr.hides_friends && emission.side == antenna.side))
    return 0;
  const Vec3 path = antenna.position - emission.position;
  const double range2 = norm2(path);
  const double reach2 = emission.figure * emission.figure * antenna.sensitivity;
  if (range2 > reach2 || range2 <= 0)
    return 0;

  // inside the cone of the beam, or the sector, whose width is measured on the level?
  const double along = dot(path, emission.boresight), edge = emission.cos_half_angle;
  const double up = -dot(path, emission.down), rise = -dot(emission.boresight, emission.down);
  const double ahead = along - rise * up;
  const double least2 = edge * edge * (1 - rise * rise) * (range2 - up * up);
  if (ahead < 0 ? edge > 0 || ahead * ahead > least2 : edge > 0 && ahead * ahead < least2)
    return 0;
  const double range = std::sqrt(range2);
  if (up < emission.sin_low * range || up > emission.sin_high * range)
    return 0;

  // inside the coverage of the antennas, which turn with the wings?
  const double off_plane = dot(path, antenna.body.down);
  if (off_plane * off_plane > antenna.sin_coverage * antenna.sin_coverage * range2)
    return 0;

  // down by 3 dB at the edge of a beam that rests
  double strength = reach2 / range2;
  if (emission.kind != EmissionKind::search && edge < 1)
    strength *= math::exp2(-(1 - std::min(along / range, 1.0)) / (1 - edge));
  return strength < 1 ? 0 : strength;
}

namespace {

/// From here on the weights stay: the filter forgets what was before, 3 s at 5 looks a second.
constexpr int kRememberedLooks = 15;

/// A level so far off the line, as a share, begins a new one: either of the two has turned. Five
/// times the error of a look of 0.3 dB.
constexpr double kSurprise = 0.17;

/// One look more: a straight line by least squares through all looks so far, which is an alpha-beta
/// filter with these weights (Brookner, Tracking and Kalman Filtering Made Easy, sec. 1.2.10).
void filter_level(RwrWarning& known, const RwrWarning& look) {
  const double dt = look.time - known.time;
  if (known.looks == 0 || dt <= 0) {
    known.faintness = look.faintness;
    known.looks = look.looks;
    return;
  }
  const double n = std::min<int>(known.looks, kRememberedLooks);
  const double g = 2 * (2 * n + 1) / ((n + 1) * (n + 2)), h = 6 / ((n + 1) * (n + 2));
  const double expected = known.faintness + dt * known.faintness_rate;
  const double residual = look.faintness - expected;
  if (std::fabs(residual) > kSurprise * look.faintness) {
    known.faintness = look.faintness;
    known.faintness_rate = 0;
    known.looks = 1;
    return;
  }
  known.faintness = expected + g * residual;
  known.faintness_rate += h / dt * residual;
  known.looks = static_cast<std::uint8_t>(std::min<int>(known.looks + 1, 255));
}

}  // namespace

bool has_line(const RwrWarning& warning) {
  return warning.looks >= kRememberedLooks;
}

std::optional<double> time_to_go(const RwrWarning& warning, const Rwr& rwr) {
  constexpr double kTolerated = 0.1;
  constexpr double kNepersPerDecibel = 0.1151292546497023;  // ln(10) / 20
  constexpr double n = kRememberedLooks;
  if (warning.kind != EmissionKind::missile_seeker || !has_line(warning) ||
      warning.faintness_rate >= 0)
    return std::nullopt;
  const double left = std::max(warning.faintness, 0.0) / -warning.faintness_rate;
  // the slope of a straight line through n points with equal errors, one look apart
  const double sigma_slope =
      kNepersPerDecibel * rwr.sigma_level * rwr.seeker_rate * std::sqrt(12 / (n * (n * n - 1)));
  if (sigma_slope * left > kTolerated)
    return std::nullopt;
  return left;
}

namespace {

/// s: what was heard longer ago than this is no level to compare.
constexpr double kFresh = 1;

bool comparable(const RwrWarning& w, double time) {
  return w.kind == EmissionKind::missile_seeker && w.looks >= 5 && time - w.time <= kFresh;
}

double carried_on(const RwrWarning& w, double time) {
  return w.faintness + (time - w.time) * w.faintness_rate;
}

}  // namespace

std::size_t share(const RwrState& state, double time,
                  std::array<datalink::SharedSeeker, datalink::kSharedSeekers>& seekers) {
  std::size_t count = 0;
  for (std::uint32_t i = 0; i < state.count && count < seekers.size(); ++i)
    if (const RwrWarning& w = state.warnings[i]; comparable(w, time))
      seekers[count++] = {.emitter = w.emitter,
                          .faintness = static_cast<float>(carried_on(w, time)),
                          .faintness_rate = static_cast<float>(w.faintness_rate)};
  return count;
}

bool rests_on_mate(const RwrWarning& own, const datalink::SharedSeeker& theirs, double age,
                   const Vec3& offset, double time) {
  // 0.3 dB: twice the error of the difference of two such lines there, and some for the distance
  constexpr double kLouder = 1.035;
  // s: of a signal that says nothing of the kind, and of one that just begins
  constexpr double kLeast = 4, kMost = 15;
  const double mine = carried_on(own, time - kLevelAge);
  const double mates = static_cast<double>(theirs.faintness) +
                       (age - kLevelAge) * static_cast<double>(theirs.faintness_rate);
  if (!comparable(own, time) || mine <= 0 || mates <= 0)
    return false;
  const double left =
      own.faintness_rate < 0 ? std::clamp(mine / -own.faintness_rate, kLeast, kMost) : kMost;
  const double range = kMissileClosing * left;
  const auto [sine, cosine] = math::sin_cos(own.bearing);
  const double mates_range = norm(range * Vec3{cosine, sine, 0} - offset);
  return mine * mates_range > kLouder * mates * range;
}

RwrWarning warn(const Rwr& rwr, const RwrAntenna& antenna, const Kinematics& own,
                const Emission& emission, double strength, PlayerId emitter, double time,
                Draw draw) {
  const Vec3 sight = emission.position - antenna.position;
  const double bearing = math::atan2(dot(sight, own.east), dot(sight, own.north));
  const double relative = angle_between(own.heading, bearing);
  const double error = rwr.sigma_bearing * draw.normal();
  const double measured = relative + std::copysign(1.0, relative) * error;
  const double shown = rwr.bearing_step * std::nearbyint(measured / rwr.bearing_step);
  const double decibels = rwr.sigma_level * draw.normal();
  return {.bearing = wrap_pi(own.heading + shown),
          .time = time,
          .first_time = time,
          .kind_time = time,
          .faintness = math::pow(10, -decibels / 20) / std::sqrt(strength),
          .emitter = emitter,
          .type = emission.type,
          .kind = emission.kind,
          .looks = 1};
}

/// s, over which the receiver averages bearings, once it has heard so long.
constexpr double kBearingTime = 1;

bool show(RwrState& state, const RwrWarning& warning) {
  for (std::uint32_t i = 0; i < state.count; ++i) {
    RwrWarning& known = state.warnings[i];
    if (known.emitter != warning.emitter)
      continue;
    const bool more_urgent = warning.kind > known.kind;
    const double weight = std::max(1 / (known.looks + 1.0),
                                   1 - math::exp((known.time - warning.time) / kBearingTime));
    known.bearing = wrap_pi(known.bearing + weight * angle_between(known.bearing, warning.bearing));
    filter_level(known, warning);
    known.time = warning.time;
    known.type = warning.type;
    if (warning.kind != known.kind)
      known.kind_time = warning.time;
    known.kind = warning.kind;
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

const RwrWarning* find(const RwrState& state, PlayerId emitter) {
  const auto shown = std::span(state.warnings).first(state.count);
  const auto found = std::ranges::find(shown, emitter, &RwrWarning::emitter);
  return found == shown.end() ? nullptr : &*found;
}

void forget(RwrState& state, const Rwr& rwr, double time) {
  drop_if(state.warnings, state.count,
          [&](const RwrWarning& warning) { return time - warning.time > rwr.memory; });
}

}  // namespace eyrie::model::sensor
