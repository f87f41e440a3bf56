// SPDX-License-Identifier: MIT
// The radar at work: where it points, what it finds in a frame, how it follows one target.
#include <algorithm>

#include "model/sensor/scene.hpp"
#include "model/track/filter.hpp"

namespace eyrie::model::sensor {
namespace {

/// A lock that nobody asked for is kept until the target is this much beyond lock_range.
constexpr double kLockHysteresis = 1.2;

/// Half of the range gate in which a lock is searched (m), besides the track's own uncertainty.
constexpr double kRangeGate = 500;

/// The measurement of row `j`, whose echo had that S/N, with the interrogation that goes along.
Contact contact_with(const Scene& scene, const Self& self, std::size_t j, RadarMode mode,
                     double signal_to_noise, const Axes& level) {
  const PlayerId other = scene.ids[j];
  Contact contact =
      measure(errors_of(*self.suite.radar, mode, signal_to_noise), self.kinematics, level,
              scene.kinematics[j], other, scene.draw(self.id, Stream::radar_noise, other));
  if (const Iff* iff = self.suite.iff; iff != nullptr && contact.range <= iff->range) {
    contact.interrogated = true;
    if (answers(*iff, self.fit.side, scene.fit[j].side, scene.draw(self.id, Stream::iff, other)))
      contact.identity = Identity::friendly;
  }
  return contact;
}

/// Who jams a radar, and how loud.
struct Jam {
  Vec3 sight;    ///< m, from the antenna
  Vec3 unit;     ///< along it
  double noise;  ///< in the middle of the beam, over the receiver's own
  std::uint32_t row;
};

/// All of them, as one radar hears them now; the 32 loudest if there are more.
class Jamming {
 public:
  Jamming(const Scene& scene, const Self& self) : radar_(*self.suite.radar) {
    if (scene.library.jammers.size() == 0)
      return;
    const Kinematics& own = self.kinematics;
    const auto emissions = scene.world.rows(scene.aircraft.emission);
    for (std::uint32_t j = 0; j < emissions.size(); ++j) {
      const Emission& emission = emissions[j];
      if (emission.jamming <= 0 || emission.side == self.fit.side || j == self.row)
        continue;
      const Vec3 sight = scene.kinematics[j].position - own.position;
      const double range2 = std::max(norm2(sight), 1.0), range = std::sqrt(range2);
      if (range <= horizon_range(own.altitude, scene.kinematics[j].altitude, kRadioEarth))
        add({sight, sight / range, jamming_to_noise(emission.jamming, radar_.beam_width, range2),
             j});
    }
  }
  /// Noise over the receiver's own while the beam points along `sight` (m).
  [[nodiscard]] double noise_along(const Vec3& sight) const {
    double noise = 1;
    for (const Jam& jam : items())
      noise += jam.noise * off_beam(radar_.beam_width, radar_.side_lobes,
                                    dot(normalized(sight, jam.unit), jam.unit));
    return noise;
  }
  [[nodiscard]] std::span<const Jam> items() const { return {items_.data(), count_}; }
  /// What the jammer of row `j` is heard with, if it gives a strobe.
  [[nodiscard]] std::optional<double> strobe_of(std::size_t j) const {
    for (const Jam& jam : items())
      if (jam.row == j && jam.noise > kStrobe)
        return jam.noise;
    return std::nullopt;
  }

 private:
  void add(const Jam& jam) {
    if (count_ == items_.size()) {
      const auto quietest = std::ranges::min_element(items_, {}, &Jam::noise);
      if (jam.noise <= quietest->noise)
        return;
      std::move(quietest + 1, items_.end(), quietest);
      --count_;
    }
    items_[count_++] = jam;
  }

  union {  // not of zeros: mostly nobody jams
    std::array<Jam, 32> items_;
  };
  std::size_t count_ = 0;
  const Radar& radar_;
};

/// What one look needs to know.
struct Looking {
  const Detector& detector;
  Jamming jamming;
  const Wind& wind;
  Looking(const Scene& scene, const Self& self)
      : detector(*self.suite.detector),
        jamming(scene, self),
        wind(scene.library.environment.wind) {}
};

/// Mean S/N of an echo in one look, with what jams.
double mean_of(const Self& self, const Looking& looking, const Signature& signature,
               const Kinematics& other) {
  const double mean = mean_echo(*self.suite.radar, looking.detector, self.kinematics, signature,
                                other, looking.wind);
  return mean <= 0 || looking.jamming.items().empty()
             ? mean
             : mean / looking.jamming.noise_along(other.position - self.kinematics.position);
}

/// The S/N of row `j` in this look, if it is detected; `mean` is that of its echo, or of a false
/// one.
std::optional<double> detected(const Scene& scene, const Self& self, const Looking& looking,
                               std::size_t j, double mean) {
  if (mean <= 0)
    return std::nullopt;
  return looking.detector.echo(mean, scene.draw(self.id, Stream::radar, scene.ids[j]).uniform());
}
std::optional<double> detected(const Scene& scene, const Self& self, const Looking& looking,
                               std::size_t j) {
  return detected(scene, self, looking, j,
                  mean_of(self, looking, *scene.suite(j).signature, scene.kinematics[j]));
}

/// The echo nearest to where the designated track is believed to be, among what is detected in one
/// beam width around it.
void acquire(const Scene& scene, Self& self, const Looking& looking, const Gimbal& gimbal) {
  const Track* track = find(self.tracks, self.radar.designated);
  if (track == nullptr)
    return;
  const Vec3 expected = position_at(*track, scene.time) - self.kinematics.position;
  const double range = norm(expected), sigma = static_cast<double>(track->position_sigma);
  const double half_width = range * self.suite.radar->beam_width + 2 * sigma;
  const double half_depth = kRangeGate + 2 * sigma;
  const Vec3 unit = normalized(expected, gimbal.nose);

  Nearest<1> best(1);
  for (std::size_t j = 0; j < scene.kinematics.size(); ++j) {
    const Vec3 sight = scene.kinematics[j].position - self.kinematics.position;
    const Vec3 off = sight - expected;
    const double along = dot(off, unit), distance2 = norm2(off);
    if (j == self.row || std::fabs(along) > half_depth ||
        distance2 - along * along > half_width * half_width || !best.wants(distance2) ||
        !within_gimbal(gimbal, sight, norm2(sight)) || !detected(scene, self, looking, j))
      continue;
    best.offer({distance2, static_cast<std::uint32_t>(j)});
  }
  if (!best.items().empty())
    self.radar.locked = scene.ids[best.items()[0].row];
  self.radar.pulled = 0;
}

/// What the gates of a lock rest on in this look: the echo of row `j`, or, if that is stronger or
/// alone in them, the false one of its jammer. The gates stay where they are while they are empty.
std::optional<double> in_gates(const Scene& scene, Self& self, const Looking& looking,
                               std::size_t j, FalseEcho& off) {
  const Jammer* jammer = scene.suite(j).jammer;
  if (jammer == nullptr || !jammer->pull_off || scene.fit[j].side == self.fit.side)
    return detected(scene, self, looking, j);
  const Radar& radar = *self.suite.radar;
  const PullOff& pull = *jammer->pull_off;
  const double dt = 1 / radar.track_rate;
  const FalseEcho gates = pull.at(static_cast<double>(self.radar.pulled));
  const auto inside = [&](const FalseEcho& echo) {
    return std::fabs(echo.range - gates.range) <= radar.range_cell + kTurnInGate * dt * dt / 2 &&
           std::fabs(echo.speed - gates.speed) <= radar.speed_cell + kTurnInGate * dt;
  };
  const Kinematics& target = scene.kinematics[j];
  const double mean = inside({}) ? mean_of(self, looking, *scene.suite(j).signature, target) : 0.0;
  if (const auto phase = pull.phase(scene.time); phase && inside(pull.at(*phase))) {
    const FalseEcho echo = pull.at(*phase);
    const double section = pull.section();
    Kinematics there = target;
    there.velocity +=
        echo.speed * normalized(target.position - self.kinematics.position, self.kinematics.north);
    const double stronger = mean_of(
        self, looking, {.rcs_front = section, .rcs_side = section, .rcs_rear = section}, there);
    if (stronger > mean) {
      const auto seen = detected(scene, self, looking, j, stronger);
      if (seen) {
        self.radar.pulled = static_cast<float>(*phase);
        off = echo;
      }
      return seen;
    }
  }
  const auto seen = detected(scene, self, looking, j, mean);
  if (seen)
    self.radar.pulled = 0;
  return seen;
}

}  // namespace

void steer_radar(const Scene& scene, Self& self) {
  RadarState& radar = self.radar;
  const Radar& model = *self.suite.radar;
  if (self.request.radar_off != 0) {
    radar = {};
    return;
  }

  // the scan follows the target, as far as its edge stays inside the gimbal, or the nose
  const Track* target = find(self.tracks, self.request.target);
  if (target == nullptr || !target->named(radar.designated))
    radar.locked = {};
  radar.designated = target != nullptr ? target->id : TrackId{};
  radar.scan_azimuth = radar.scan_elevation = 0;
  if (radar.mode == RadarMode::off)
    radar.mode = RadarMode::search;
  if (target == nullptr) {
    radar.mode = RadarMode::search;
    return;
  }
  const Vec3 sight = position_at(*target, scene.time) - self.kinematics.position;
  const Bearing bearing = bearing_of(self.kinematics, normalized(sight, self.kinematics.north));
  const double reach = std::max(model.gimbal - model.scan_half_azimuth, 0.0);
  radar.scan_azimuth =
      std::clamp(angle_between(self.kinematics.heading, bearing.azimuth), -reach, reach);
  radar.scan_elevation = std::clamp(bearing.elevation, -model.gimbal, model.gimbal);

  // track it alone if that was asked for, or if it is near
  const bool tracking = radar.mode == RadarMode::track;
  const double near = model.lock_range * (tracking ? kLockHysteresis : 1.0);
  const bool wanted = self.request.radar_lock != 0 || norm2(sight) <= near * near;
  if (!wanted || scene.time < radar.search_until) {
    radar.mode = RadarMode::search;
    radar.locked = {};
  } else if (!tracking) {
    radar.mode = RadarMode::track;
    radar.lock_time = scene.time;
  }
}

void scan(const Scene& scene, Self& self) {
  const Radar& radar = *self.suite.radar;
  const Looking looking(scene, self);
  const Antenna antenna = aim(radar, self.radar, self.kinematics);

  // the nearest detections in the scan volume
  Nearest<track::kMaxContacts> found(radar.max_contacts);
  for (std::size_t j = 0; j < scene.kinematics.size(); ++j) {
    const Vec3 sight = scene.kinematics[j].position - antenna.position;
    const double range2 = norm2(sight);
    if (!covers(antenna, sight, range2) || !found.wants(range2) || j == self.row)
      continue;
    if (const auto signal_to_noise = detected(scene, self, looking, j))
      found.offer({range2, static_cast<std::uint32_t>(j), *signal_to_noise});
  }
  if (found.items().empty() && looking.jamming.items().empty())
    return;

  std::array<Contact, track::kMaxContacts> contacts;
  std::size_t count = 0;
  const Axes level = level_axes(self.kinematics, self.kinematics.heading);
  for (const Candidate& c : found.items())
    contacts[count++] = contact_with(scene, self, c.row, RadarMode::search, c.strength, level);

  // who jams within the scale and was not seen through his noise gives a direction
  for (const Jam& jam : looking.jamming.items()) {
    if (jam.noise > kStrobe && count < contacts.size() &&
        covers(antenna, jam.sight, norm2(jam.sight)) &&
        std::ranges::find(found.items(), jam.row, &Candidate::row) == found.items().end())
      contacts[count++] =
          strobe(contact_with(scene, self, jam.row, RadarMode::search, jam.noise, level),
                 self.kinematics.position, radar.instrumented_range);
  }
  track::update(self.tracks, self.context(scene.time), std::span(contacts).first(count));
}

void track_target(const Scene& scene, Self& self) {
  const Radar& radar = *self.suite.radar;
  const Looking looking(scene, self);
  const Gimbal gimbal = gimbal_of(radar, self.kinematics);
  if (!self.radar.locked)
    acquire(scene, self, looking, gimbal);

  // the range gate rests on one echo; it is there, or the lock lives on memory for a while
  std::optional<double> signal_to_noise, jam;
  FalseEcho off;
  const auto row = scene.row(self.radar.locked);
  if (row) {
    const Vec3 sight = scene.kinematics[*row].position - self.kinematics.position;
    if (within_gimbal(gimbal, sight, norm2(sight))) {
      signal_to_noise = in_gates(scene, self, looking, *row, off);
      jam = looking.jamming.strobe_of(*row);
    }
  }
  if (signal_to_noise || jam) {
    self.radar.lock_time = scene.time;
    const Axes level = level_axes(self.kinematics, self.kinematics.heading);
    Contact contact = contact_with(scene, self, *row, RadarMode::track,
                                   signal_to_noise.value_or(jam.value_or(0)), level);
    contact.sigma_across *= 1 + off.range / contact.range;
    contact.range += off.range;
    contact.position += off.range * contact.line;
    contact.speed_along += off.speed;
    if (!signal_to_noise)
      contact = strobe(contact, self.kinematics.position, radar.instrumented_range);
    track::update(self.tracks, self.context(scene.time), std::span(&contact, 1));
  } else if (scene.time - self.radar.lock_time > radar.lock_memory) {
    self.radar.mode = RadarMode::search;
    self.radar.locked = {};
    self.radar.search_until = scene.time + 1 / radar.scan_rate;
  }
}

namespace {

/// W/Hz that the jammer of an aircraft radiates.
double jamming_of(const SensorSuite& suite, const RwrState& rwr) {
  if (suite.jammer == nullptr)
    return 0;
  const auto tracks = [](const RwrWarning& w) { return w.kind != EmissionKind::search; };
  if (suite.jammer->when_tracked &&
      std::ranges::none_of(std::span(rwr.warnings).first(rwr.count), tracks))
    return 0;
  return suite.jammer->density();
}

}  // namespace

void radiate(const Scene& scene, std::size_t row, const RadarState& state, const TrackFile& tracks,
             const RwrState& rwr, Emission& emission) {
  const SensorSuite& suite = scene.suite(row);
  const Kinematics& own = scene.kinematics[row];
  emission = {};
  emission.position = own.position;
  emission.boresight = own.north;
  emission.type = suite.radar_index;
  emission.side = scene.fit[row].side;
  emission.jamming = jamming_of(suite, rwr);
  if (suite.radar == nullptr || state.mode == RadarMode::off)
    return;

  const Radar& radar = *suite.radar;
  emission.figure = emission_figure(radar.reference_range, radar.reference_rcs);
  if (state.mode == RadarMode::search) {
    const auto [up, aside] = math::sin_cos(state.scan_elevation, own.heading + state.scan_azimuth);
    emission.kind = EmissionKind::search;
    emission.boresight = up.cos * from_ned(own, {aside.cos, aside.sin, 0}) - up.sin * own.down;
    emission.cos_half_angle = suite.cos_half_azimuth;
    sweep(radar, own.down, emission);
    return;
  }

  // the beam rests on the locked echo, or on the track while the echo is looked for
  emission.kind = EmissionKind::track;
  emission.cos_half_angle = suite.cos_half_beam;
  if (const auto locked = scene.row(state.locked)) {
    emission.dwell = state.locked;
    emission.boresight = normalized(scene.kinematics[*locked].position - own.position, own.north);
  } else if (const Track* track = find(tracks, state.designated)) {
    emission.boresight = normalized(position_at(*track, scene.time) - own.position, own.north);
  }
}

}  // namespace eyrie::model::sensor
