// SPDX-License-Identifier: MIT
// The eyes at work: aircraft become tracks, missiles become threats.
#include <algorithm>

#include "model/events.hpp"
#include "model/sensor/scene.hpp"

namespace eyrie::model::sensor {
namespace {

/// A pilot keeps track of no more aircraft than this at a time.
constexpr std::size_t kWatched = 8;

/// What the pilot's eyes rested on or were told to look for.
enum class About : std::uint8_t { aircraft, missile };

/// The directions in which the pilot knows of something. A look at a place close to one is cued; it
/// goes to what is held already if that was seen just now and is about as far.
class KnownDirections {
 public:
  KnownDirections(const Visual& visual, const Eyes& eyes)
      : cos_cue_(math::cos(visual.cue_angle)), hold_time_(visual.hold_time), eyes_(eyes) {}

  void add(const Track& track, double time) {
    const Vec3 sight = position_at(track, time) - eyes_.position;
    const bool held = time - track.seen_time <= hold_time_;
    known_[count_++] = {normalized(sight, {1, 0, 0}), held ? norm(sight) : 0, About::aircraft};
  }
  void add(const InboundMissile& missile, const Kinematics& own, double time) {
    const auto [se, ce] = math::sin_cos(missile.elevation);
    const auto [sa, ca] = math::sin_cos(missile.bearing);
    const bool held = missile.has_position != 0 && time - missile.position_time <= hold_time_;
    known_[count_++] = {ce * ca * own.north + ce * sa * own.east - se * own.down,
                        held ? missile.range : 0, About::missile};
  }
  [[nodiscard]] Cue cue(About about, const Vec3& sight, double range) const {
    Cue best = Cue::none;
    for (std::size_t i = 0; i < count_; ++i) {
      const Known& known = known_[i];
      if (dot(sight, known.unit) < cos_cue_ * range)
        continue;
      const bool same = known.held_range > 0 && known.about == about &&
                        range < 2 * known.held_range && known.held_range < 2 * range;
      best = std::max(best, same ? Cue::held : Cue::cued);
    }
    return best;
  }

 private:
  struct Known {
    Vec3 unit{};
    double held_range = 0;  ///< m; 0 if it is not held
    About about = About::aircraft;
  };
  union {  // not of zeros: most are never used
    std::array<Known, kMaxTracks + kMaxThreats> known_;
  };
  std::size_t count_ = 0;
  double cos_cue_, hold_time_;
  const Eyes& eyes_;
};

/// Whether the target in row `j` is seen in this look.
bool sees(const Scene& scene, const Self& self, const Eyes& eyes, const KnownDirections& known,
          std::size_t j, double range) {
  const Kinematics& other = scene.kinematics[j];
  const Cue cue = known.cue(About::aircraft, other.position - eyes.position, range);
  return glimpsed(*self.suite.visual, eyes, other, *scene.suite(j).signature, range, cue,
                  scene.draw(self.id, Stream::visual, scene.ids[j]).uniform());
}

/// How far what was seen is from a place, in standard deviations, squared; an eye errs by a share
/// of the range. Infinity if it is not below `best` anyway.
double misfit(const Visual& visual, const Contact& seen, const Vec3& sight, double best) {
  const double range = norm(sight);
  const double aside = norm(sight / range - seen.line) / visual.sigma_angle;
  if (aside * aside >= best)
    return math::kInfinity;
  const double farther = math::log(range / seen.range) / visual.sigma_range;
  return farther * farther + aside * aside;
}

void look_for_aircraft(const Scene& scene, Self& self, const Eyes& eyes,
                       const KnownDirections& known) {
  const Visual& visual = *self.suite.visual;
  const double reach2 = visual.range * visual.range;
  Nearest<kWatched> seen(kWatched);
  scene.boxes->each_within(eyes.position, reach2, [&](std::size_t j, double range2) {
    if (range2 > 0 && j != self.row && seen.wants(range2) &&
        sees(scene, self, eyes, known, j, std::sqrt(range2)))
      seen.offer({range2, static_cast<std::uint32_t>(j)});
  });
  if (seen.items().empty())
    return;

  std::array<Contact, kWatched> contacts;
  std::size_t count = 0;
  for (const Candidate& c : seen.items()) {
    const PlayerId other = scene.ids[c.row];
    Contact& contact = contacts[count++];
    contact = estimate(visual, eyes, scene.kinematics[c.row].position, other,
                       scene.draw(self.id, Stream::visual_noise, other));
    contact.identity =
        recognized(visual, eyes, scene.kinematics[c.row], *scene.suite(c.row).signature,
                   std::sqrt(c.distance2), self.fit.side, scene.fit[c.row].side);
  }
  find_mates(
      scene, self, std::span(contacts).first(count),
      [&](const Vec3& sight, double range) { return in_view(visual, eyes, sight / range); },
      [&](const Contact& contact, const Vec3& sight, double best) {
        return misfit(visual, contact, sight, best);
      });
  track::update(self.tracks, self.context(scene.time), std::span(contacts).first(count));
}

void look_for_missiles(const Scene& scene, Self& self, const Eyes& eyes,
                       const KnownDirections& known) {
  const Visual& visual = *self.suite.visual;
  const auto ids = scene.world.ids(scene.missiles.table);
  const auto kinematics = scene.world.rows(scene.missiles.kinematics);
  const auto states = scene.world.rows(scene.missiles.state);
  ThreatUpdate threats(self.threats, scene.time);
  for (std::size_t m = 0; m < ids.size(); ++m) {
    const weapon::MissileState& state = states[m];
    const Kinematics& missile = kinematics[m];
    const Vec3 sight = missile.position - eyes.position;
    const double range = norm(sight);
    // shots of the own side are called on the radio
    if (state.side == self.fit.side || range > visual.range || range <= 0 ||
        !in_view(visual, eyes, sight / range) ||
        range > horizon_range(eyes.altitude, missile.altitude, 1))
      continue;

    const bool burning =
        scene.time - state.launch_time < scene.library.missiles[state.type].motor.burn_time();
    const double area = burning ? visual.plume_area : visual.missile_area;
    const Cue cue = known.cue(About::missile, sight, range);
    const double search = cue == Cue::none ? visual.search : visual.cued_search;
    const double p = cue == Cue::held ? hold_probability(visual, area, range)
                                      : acquisition_probability(visual, search, area, range);
    const PlayerId id = ids[m];
    if (!scene.draw(self.id, Stream::visual, id).chance(p) ||
        !looks_dangerous(visual, sight, missile.velocity - eyes.velocity))
      continue;

    const Contact contact =
        estimate(visual, eyes, missile.position, id, scene.draw(self.id, Stream::visual_noise, id));
    const Bearing bearing = bearing_of(self.kinematics, contact.line);
    const Sighting sighting{.bearing = bearing.azimuth,
                            .elevation = bearing.elevation,
                            .range = contact.range,
                            .truth = id,
                            .source = kThreatFromSight,
                            .has_position = true,
                            .closing = true};
    if (threats.note(sighting))
      tell_missile(self, sighting);
  }
}

}  // namespace

void tell_missile(const Self& self, const Sighting& sighting) {
  self.out.emit({.kind = EventKind::missile_warning,
                 .who = self.id,
                 .whom = sighting.truth,
                 .place = self.kinematics.position,
                 .values = {static_cast<float>(sighting.bearing)}});
}

void look_around(const Scene& scene, Self& self) {
  const Visual& visual = *self.suite.visual;
  const Eyes eyes = eyes_of(self.kinematics);
  KnownDirections known(visual, eyes);
  for (std::uint32_t i = 0; i < self.tracks.count; ++i)
    known.add(self.tracks.tracks[i], scene.time);
  for (std::uint32_t i = 0; i < self.threats.count; ++i)
    known.add(self.threats.missiles[i], self.kinematics, scene.time);
  look_for_aircraft(scene, self, eyes, known);
  if (scene.world.rows(scene.missiles.table) != 0)
    look_for_missiles(scene, self, eyes, known);
}

}  // namespace eyrie::model::sensor
