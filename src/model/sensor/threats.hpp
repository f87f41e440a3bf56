// SPDX-License-Identifier: MIT
#pragma once
/// \file  Missiles that one aircraft believes are coming for it.
#include "model/track.hpp"

namespace eyrie::model::sensor {

/// What told of the missile, as bits.
enum ThreatSource : std::uint8_t {
  kThreatFromRwr = 1,    ///< its seeker was heard: bearing only
  kThreatFromSight = 2,  ///< it was seen: bearing, elevation and a rough range
  kThreatFromTruth = 4,  ///< privileged state
};

/// One inbound missile as it is perceived.
struct InboundMissile {
  double bearing = 0;             ///< rad, true, in (-pi, pi]
  double elevation = 0;           ///< rad above the horizontal; 0 unless has_position
  double range = 0;               ///< m; 0 unless has_position
  double time = 0;                ///< s, last perceived
  double first_time = 0;          ///< s, first perceived
  double position_time = 0;       ///< s, when elevation and range were taken; needs has_position
  double arrival = 0;             ///< s, when it will be here as its signal grows; 0: not known
  double at_mate = 0;             ///< s, when a mate was last found to be whom it rests on; or 0
  PlayerId truth{};               ///< for scoring and debrief only
  PlayerId emitter{};             ///< fingerprint of its seeker; none if it was not heard yet
  std::uint8_t has_position = 0;  ///< 1: elevation and range are known
  std::uint8_t closing = 0;       ///< 1: seen to come closer
  std::uint8_t sources = 0;       ///< bits of ThreatSource, ever
  std::uint8_t reserved[5] = {};

  static constexpr auto fields() {
    using I = InboundMissile;
    return field_list(field("bearing", &I::bearing, "rad"),
                      field("elevation", &I::elevation, "rad"), field("range", &I::range, "m"),
                      field("time", &I::time, "s"), field("first_time", &I::first_time, "s"),
                      field("position_time", &I::position_time, "s"),
                      field("arrival", &I::arrival, "s"), field("at_mate", &I::at_mate, "s"),
                      field("truth", &I::truth), field("emitter", &I::emitter),
                      field("has_position", &I::has_position), field("closing", &I::closing),
                      field("sources", &I::sources), field("reserved", &I::reserved));
  }
};

inline constexpr std::size_t kMaxThreats = 4;

/// The inbound missiles of one aircraft, in the order in which they were first perceived.
struct Threats {
  std::array<InboundMissile, kMaxThreats> missiles{};
  std::uint32_t count = 0;
  std::uint8_t reserved[4] = {};

  static constexpr auto fields() {
    return field_list(field("missiles", &Threats::missiles), field("count", &Threats::count),
                      field("reserved", &Threats::reserved));
  }
};

/// One sensor's word about one inbound missile.
struct Sighting {
  double bearing = 0;    ///< rad, true
  double elevation = 0;  ///< rad; with has_position
  double range = 0;      ///< m; with has_position
  double arrival = 0;    ///< s, when it will be here; 0: not known
  PlayerId truth{};      ///< written down, never compared
  PlayerId emitter{};    ///< fingerprint of its seeker, if it was heard
  ThreatSource source = kThreatFromRwr;
  bool has_position = false;
  bool closing = false;
  /// The line through its levels has begun anew, and says nothing of its arrival yet.
  bool begins_anew = false;
};

/// The threats of one look of one sensor: each threat takes at most one sighting of it, so two
/// missiles on one bearing stay two. Missiles are told apart by the fingerprints of their seekers,
/// and else by direction alone.
class ThreatUpdate {
 public:
  ThreatUpdate(Threats& threats, double time) : threats_(threats), time_(time) {}

  /// True if the missile was not known before. When all places are taken the sighting is dropped.
  bool note(const Sighting& sighting);

 private:
  Threats& threats_;
  double time_;
  std::uint32_t used_ = 0;  ///< bit i: threat i has had its sighting
};

/// Drops what nobody has perceived for 4 s.
void forget(Threats& threats, double time);

}  // namespace eyrie::model::sensor
