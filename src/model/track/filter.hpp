// SPDX-License-Identifier: MIT
#pragma once
/// \file  How contacts become tracks: which contact belongs to which track, and the filter.
/// docs/models/tracks.md has the equations.
#include "model/track/motion.hpp"

namespace eyrie::model::track {

/// The tracker in the mission computer: const, shared, one for all sensors of an aircraft.
struct Tracker {
  double rate = 10;  ///< Hz
  double gate = 5;
  double max_gate = si(5, "km");  ///< m
  std::uint32_t confirm_hits = 2;
  Motion motion;
  double initial_speed = 250;  ///< m/s
  double coast_time = 12;      ///< s
  double tentative_time = 6;   ///< s
  double merge_gate = 2;
  double glance_time = 0.2;  ///< s

  static constexpr std::string_view type_name = "tracker";
  static constexpr std::string_view help = "association, filter and life of tracks";
  static constexpr auto params() {
    return Lines{
        param(
            "rate", &Tracker::rate, "Hz", range(0.1, 100),
            "how often the tracks are looked after, the datalink is read and the beam is steered"),
        param("gate", &Tracker::gate, range(1, 10),
              "a contact belongs to a track within so many standard deviations"),
        param("max_gate", &Tracker::max_gate, "m", range(1, 1e5),
              "and, but for the error of its range, never farther away than this"),
        param("confirm_hits", &Tracker::confirm_hits, range(1, 255),
              "contacts after which a track is believed"),
        param("motion", &Tracker::motion, "how targets are expected to move"),
        param("initial_speed", &Tracker::initial_speed, "m/s", range(1, 2000),
              "speed that a new target may have, 1-sigma per axis"),
        param("coast_time", &Tracker::coast_time, "s", range(0.1, 600),
              "a confirmed track is dropped so long after its last update"),
        param("tentative_time", &Tracker::tentative_time, "s", range(0.1, 600),
              "a tentative track is dropped so long after its last update"),
        param("merge_gate", &Tracker::merge_gate, range(0, 10),
              "tracks closer than so many standard deviations are one"),
        param("glance_time", &Tracker::glance_time, "s", range(0, 60),
              "two tracks that the eyes last saw so far apart in time may be one aircraft")};
  }
};

/// What one model of motion makes of a track at some time.
struct Mode {
  Vec3 position{};      ///< m
  Vec3 velocity{};      ///< m/s
  Vec3 acceleration{};  ///< m/s^2
  AxisState along, across;
  double probability = 0;  ///< that the target moves like this
};

/// Where a track is believed to be at some time: the mean over the models, and what each of them
/// says.
struct Prediction {
  Vec3 position{};  ///< m
  Vec3 velocity{};  ///< m/s
  Mode straight, turning;
  Vec3 line{};  ///< of sight, to which the covariances belong
};

/// A covariance along and across the line of sight.
struct Covariance {
  AxisState along, across;
};
/// That of the mean: of both models, and of how far they are apart.
[[nodiscard]] Covariance covariance_of(const Prediction& prediction);

/// Carries a track on to `time` (s): the first half of one cycle of the interacting multiple model
/// estimator (Blom & Bar-Shalom, IEEE Trans. AC-33 (1988) 780; Bar-Shalom et al., sec. 11.6.6).
/// When the line of sight from the ownship has turned meanwhile, the uncertainty along and across
/// it mix: the diagonal of the turned covariance, which keeps its trace. `ownship` is where the
/// owner is at `time`.
[[nodiscard]] Prediction predict(const Track& track, const Tracker& tracker, const Ownship& ownship,
                                 double time);
/// The same; `ahead` is the interval that was needed last. Tracks of one look share it.
[[nodiscard]] Prediction predict(const Track& track, const Tracker& tracker, const Ownship& ownship,
                                 double time, Interval& ahead);

/// How well a model had foretold a contact: the residuals in standard deviations, squared, with the
/// contact's own error in them (Mahalanobis distance), and the product of the variances that they
/// were divided by.
struct Surprise {
  double deviations2 = 0, volume = 1;
};

/// How well a contact fits a prediction.
struct Match {
  Surprise straight, turning;
  /// Of the model that comes nearer: a gate must let a target turn.
  [[nodiscard]] double deviations2() const {
    return std::fmin(straight.deviations2, turning.deviations2);
  }
};
[[nodiscard]] Match match(const Prediction& prediction, const Contact& contact);

/// -2 log of the likelihood but for a constant, by the likelier model: the smaller, the better.
[[nodiscard]] double misfit(const Prediction& prediction, const Match& match);

/// A track after one more contact at `time` (s): the second half of the cycle.
void filter(Track& track, const Prediction& prediction, const Contact& contact, double time);

/// A new track from one contact: no speed but what the contact says, and a covariance that knows
/// it.
[[nodiscard]] Track first_track(const Tracker& tracker, const Contact& contact, double time);

/// The track as it is believed to be at `time` (s); nothing was learned meanwhile. `ahead` as for
/// predict().
[[nodiscard]] Track carried_on(const Track& track, const Tracker& tracker, const Ownship& ownship,
                               double time, Interval& ahead);

/// Sets a track to a prediction for `time` (s), whose mean has that covariance.
void set(Track& track, const Prediction& prediction, const Covariance& covariance, double time);

/// Takes in what somebody else believes about the same target at the same time, as it is seen from
/// here. It may have been made of what was learned from here: covariance intersection, axis by axis
/// and model by model. Returns whether there was anything to be learned; if not, the track stays as
/// it is.
bool take_in(Track& track, const Prediction& own, const Prediction& theirs, const Ownship& ownship,
             double time);

/// A covariance, and those of both models, as they are seen from elsewhere, where the line of sight
/// has turned by an angle with that sine squared: the diagonal of the turned covariance, averaged
/// over the two axes across, so that the trace of along + 2 across stays.
void turn_sight(Prediction& prediction, Covariance& covariance, double sin2);

/// Sets the two sigmas from the covariances, carried on to `time`. `ahead` is the interval that the
/// last track needed; tracks of one look share it.
void refresh_sigmas(Track& track, const Tracker& tracker, double time, Interval& ahead);

/// m^2: no track is farther than that from a contact of its target. An eye judges a direction well
/// and a range badly, so what the contact does not know along its line comes on top.
[[nodiscard]] inline double reach2(const Tracker& tracker, const Contact& contact) {
  const double reach = tracker.max_gate + tracker.gate * contact.sigma_along;
  return reach * reach;
}

inline constexpr std::size_t kMaxContacts = 32;

/// The predictions of a file's tracks, by index, as far as somebody has asked. Its room is not
/// cleared, as std::optional's would be: 7 kB for each look.
class Predictions {
 public:
  [[nodiscard]] const Prediction* operator[](std::size_t i) const {
    return (known_ >> i & 1) != 0 ? &rooms_[i].prediction : nullptr;
  }
  const Prediction& set(std::size_t i, const Prediction& prediction) {
    known_ |= 1u << i;
    return *std::construct_at(&rooms_[i].prediction, prediction);
  }
  void forget(std::size_t i) { known_ &= ~(1u << i); }
  void forget_all() { known_ = 0; }

 private:
  union Room {
    Room() {}  // NOLINT: as it is
    Prediction prediction;
  };
  std::array<Room, kMaxTracks> rooms_;
  std::uint32_t known_ = 0;
};

/// Marks a contact that belongs to no track.
inline constexpr std::uint8_t kNoTrack = 255;

/// For each contact the index of its track, or kNoTrack. A track without a prediction is nowhere
/// near; `hostile` has a bit for each track that is held for one, which no mate can be. A pair must
/// lie within the gates; of all pairs the likeliest is taken first, then the likeliest of the rest,
/// so each contact and each track is used at most once. Of equal pairs the older track and then the
/// earlier contact goes first. This greedy global nearest neighbor is the common choice where
/// targets are farther apart than the errors (Blackman & Popoli, Design and Analysis of Modern
/// Tracking Systems, sec. 6.4). At most kMaxContacts contacts.
[[nodiscard]] std::array<std::uint8_t, kMaxContacts> associate(const Tracker& tracker,
                                                               const Predictions& tracks,
                                                               std::span<const Contact> contacts,
                                                               std::uint32_t hostile = 0);

}  // namespace eyrie::model::track
