// SPDX-License-Identifier: MIT
#include "model/sensor/threats.hpp"

#include <algorithm>

namespace eyrie::model::sensor {
namespace {

constexpr double kGate = radians(30);  // rad, bearings closer than this may be the same missile
constexpr double kMemory = 4;          // s, a threat that nobody has perceived for so long is gone
constexpr double kLate = 1;            // s, a missile may come so much later than its signal told

}  // namespace

bool ThreatUpdate::note(const Sighting& sighting) {
  // the same seeker, or the nearest bearing that is free; the one known longest wins a tie
  std::uint32_t best = kMaxThreats;
  double best_turn = kGate;
  for (std::uint32_t i = 0; i < threats_.count; ++i) {
    const InboundMissile& known = threats_.missiles[i];
    if (sighting.emitter && known.emitter) {
      if (known.emitter == sighting.emitter && (used_ >> i & 1) == 0) {
        best = i;
        break;
      }
      continue;
    }
    const double turn = std::fabs(angle_between(known.bearing, sighting.bearing));
    if ((used_ >> i & 1) == 0 && turn <= best_turn && (best == kMaxThreats || turn < best_turn)) {
      best = i;
      best_turn = turn;
    }
  }

  const bool is_new = best == kMaxThreats;
  if (is_new) {
    if (threats_.count == kMaxThreats)
      return false;
    best = threats_.count++;
    threats_.missiles[best] = {};
    threats_.missiles[best].first_time = time_;
  }
  used_ |= 1u << best;

  InboundMissile& missile = threats_.missiles[best];
  missile.time = time_;
  missile.truth = sighting.truth;
  missile.sources = static_cast<std::uint8_t>(missile.sources | sighting.source);
  if (sighting.emitter) {
    missile.emitter = sighting.emitter;
    if (!sighting.begins_anew || time_ > missile.arrival + kLate)
      missile.arrival = sighting.arrival;
  }

  // the eye's bearing is the better one for as long as it is fresh
  if (sighting.has_position) {
    missile.bearing = sighting.bearing;
    missile.elevation = sighting.elevation;
    missile.range = sighting.range;
    missile.closing = sighting.closing;
    missile.position_time = time_;
    missile.has_position = 1;
  } else if (!missile.has_position) {
    missile.bearing = sighting.bearing;
  }
  return is_new;
}

void forget(Threats& threats, double time) {
  drop_if(threats.missiles, threats.count, [&](InboundMissile& missile) {
    if (missile.has_position && time - missile.position_time > kMemory) {
      missile.has_position = 0;
      missile.elevation = missile.range = missile.position_time = 0;
      missile.closing = 0;
    }
    return time - missile.time > kMemory;
  });
}

}  // namespace eyrie::model::sensor
