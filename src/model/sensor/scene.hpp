// SPDX-License-Identifier: MIT
#pragma once
/// \file  What one step of sensing looks at.
#include "model/columns.hpp"
#include "model/library.hpp"
#include "model/row_boxes.hpp"
#include "model/track/track_file.hpp"
#include "sim/system.hpp"

namespace eyrie::model::sensor {

/// One of many, by its row, with its distance squared (m^2) or any other figure of merit.
struct Candidate {
  double distance2 = 0;
  std::uint32_t row = 0;
  double strength = 0;  ///< of a radar's echo, S/N
};

/// Keeps the `limit` candidates with the smallest figure, smallest first; of equal ones the one
/// that was offered first.
template <std::size_t Capacity>
class Nearest {
 public:
  explicit Nearest(std::size_t limit) : limit_(limit < Capacity ? limit : Capacity) {}

  /// Whether a candidate this far would be kept; cheap, ask it before anything expensive.
  [[nodiscard]] bool wants(double distance2) const {
    return count_ < limit_ || (limit_ != 0 && distance2 < items_[limit_ - 1].distance2);
  }
  void offer(const Candidate& candidate) {
    if (!wants(candidate.distance2))
      return;
    std::size_t at = count_ < limit_ ? count_++ : limit_ - 1;
    for (; at > 0 && candidate.distance2 < items_[at - 1].distance2; --at)
      items_[at] = items_[at - 1];
    items_[at] = candidate;
  }
  [[nodiscard]] std::span<const Candidate> items() const { return {items_.data(), count_}; }

 private:
  std::array<Candidate, Capacity> items_;
  std::size_t count_ = 0, limit_;
};

/// The sensors of one type of aircraft, looked up once, with their rates in whole steps. What is
/// null is not on board.
struct SensorSuite {
  const Signature* signature = nullptr;
  const Radar* radar = nullptr;
  const Irst* irst = nullptr;
  const Rwr* rwr = nullptr;
  const Visual* visual = nullptr;
  const Iff* iff = nullptr;
  const datalink::Datalink* datalink = nullptr;
  const Jammer* jammer = nullptr;
  const track::Tracker* tracker = nullptr;  ///< always there
  std::optional<Detector> detector;         ///< of the radar
  std::uint16_t radar_index = 0;            ///< in the Library: the type of its emissions
  double cos_half_azimuth = 1;              ///< of the radar's scan
  double cos_half_beam = 1;                 ///< of the radar
  sim::Every scan_steps, track_steps, rwr_steps, seeker_steps;
  sim::Every irst_steps, visual_steps, upkeep_steps, datalink_steps;
  sim::Every any_steps;  ///< divides all of these: nothing is due in between
};

/// What everybody may read in perceive and act: the truth as the last move left it. Columns that
/// few ask for are looked up by who does.
struct Scene {
  const Library& library;
  std::span<const SensorSuite> suites;  ///< by Fit::type
  const AircraftColumns& aircraft;
  const MissileColumns& missiles;
  const sim::World& world;
  std::span<const PlayerId> ids;
  std::span<const Fit> fit;
  std::span<const Kinematics> kinematics;
  std::uint64_t step = 0;
  std::uint64_t seed = 0;
  double time = 0;                  ///< s
  const RowBoxes* boxes = nullptr;  ///< of `kinematics`, in perceive

  [[nodiscard]] const SensorSuite& suite(std::size_t row) const { return suites[fit[row].type]; }
  /// Whether some sensor of a row is due.
  [[nodiscard]] bool senses(std::size_t row) const {
    return fit[row].remote == 0 && sim::due(step, ids[row], suite(row).any_steps);
  }
  /// The row of an aircraft.
  [[nodiscard]] std::optional<std::uint32_t> row(PlayerId who) const {
    return world.row(aircraft.table, who);
  }
  [[nodiscard]] Draw draw(PlayerId who, Stream stream, PlayerId about) const {
    return Draw(seed, who, stream, step, about.value);
  }
};

/// One aircraft at work: the rows that it may write in perceive.
struct Self {
  std::size_t row = 0;
  PlayerId id{};
  const SensorSuite& suite;
  const Fit& fit;
  const Kinematics& kinematics;
  const Request& request;
  RadarState& radar;
  TrackFile& tracks;
  RwrState& rwr;
  Threats& threats;
  datalink::DatalinkState& datalink;
  track::TrackNewsList& news;
  sim::Outbox& out;

  [[nodiscard]] track::TrackContext context(double time) const {
    return {.tracker = *suite.tracker,
            .ownship = {kinematics.position, kinematics.velocity},
            .time = time,
            .iff_tries = suite.iff != nullptr ? suite.iff->tries : 0,
            .news = news};
  }
};

/// Who stands where a mate says he is will be the mate: of all pairs within the gate the nearest
/// first, if the sensor can see that place (`sees`, by line of sight and range). `misfit` is how
/// far a contact is from it, in standard deviations, squared, or anything not below `best`. (Of
/// tracks, which know their errors along and across, datalink::recognize_mate() says the same.)
void find_mates(const Scene& scene, const Self& self, std::span<Contact> contacts, const auto& sees,
                const auto& misfit) {
  std::array<Vec3, kMaxFlight> sights;
  std::size_t count = 0;
  datalink::any_mate(self.datalink, [&](const datalink::Mate& mate) {
    const Vec3 sight = datalink::position_at(mate, scene.time) - self.kinematics.position;
    if (const double range = norm(sight); range > 0 && sees(sight, range))
      sights[count++] = sight;
    return false;
  });
  while (count > 0) {
    double best = self.suite.tracker->gate * self.suite.tracker->gate;
    Contact* found = nullptr;
    std::size_t whom = 0;
    for (std::size_t i = 0; i < count; ++i)
      for (Contact& contact : contacts) {
        if (contact.mate)
          continue;
        if (const double m = misfit(contact, sights[i], best); m < best) {
          best = m;
          found = &contact;
          whom = i;
        }
      }
    if (found == nullptr)
      return;
    found->mate = true;
    found->identity = Identity::friendly;
    sights[whom] = sights[--count];
  }
}

/// Points the radar and decides between search and track; reads what the pilot asked for.
void steer_radar(const Scene& scene, Self& self);
/// One frame of the search, or one look at the locked target.
void scan(const Scene& scene, Self& self);
void track_target(const Scene& scene, Self& self);

/// The eyes: aircraft become tracks, missiles become threats.
void look_around(const Scene& scene, Self& self);

/// One frame of the infrared search.
void search_infrared(const Scene& scene, Self& self);

/// The warning receiver: radars, then missile seekers.
void listen_for_radars(const Scene& scene, Self& self);
void listen_for_seekers(const Scene& scene, Self& self);

/// What the mates said has arrived.
void read_datalink(const Scene& scene, Self& self);

/// The truth instead of all of the above, for privileged players.
void perceive_truth(const Scene& scene, Self& self);

/// What the radar and the jammer radiate now; an emission of no kind if the radar is silent.
void radiate(const Scene& scene, std::size_t row, const RadarState& radar, const TrackFile& tracks,
             const RwrState& rwr, Emission& emission);

/// Tells that a missile was perceived for the first time.
void tell_missile(const Self& self, const Sighting& sighting);

}  // namespace eyrie::model::sensor
