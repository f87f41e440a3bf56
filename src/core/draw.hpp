// SPDX-License-Identifier: MIT
#pragma once
#include <array>

#include "core/id.hpp"

namespace eyrie {

/// What a draw is for. The numbers are part of every recorded run: a new purpose takes a new
/// number, an old one keeps its own for ever. At most 255.
enum class Stream : std::uint8_t {
  radar = 0,            ///< is the target detected in this look?
  radar_noise = 1,      ///< error of a measurement
  seeker = 2,           ///< a missile's own sensor
  lethality = 4,        ///< does the warhead kill?
  iff = 5,              ///< is the interrogation answered?
  visual = 6,           ///< is it seen by eye?
  gun = 7,              ///< dispersion and hits of a burst
  behavior = 8,         ///< choices of a pilot
  rwr = 9,              ///< error of a bearing
  datalink = 10,        ///< is the message lost?
  visual_noise = 16,    ///< error of a pilot's estimate
  decoy = 17,           ///< does a seeker go for a decoy?
  infrared = 18,        ///< is it found by infrared search?
  infrared_noise = 19,  ///< error of such a direction
  design = 20,          ///< of the cells of a campaign
  search = 21,          ///< of the candidates of a search
  start = 22,           ///< where and how a player begins
  episode = 23,         ///< which episode comes next in training, and against whom
  test = 255,           ///< for tests and examples
};

/// Random numbers for one purpose of one player in one step: a pure function of its arguments, so
/// nothing is stored between steps and no consumer can shift another's numbers. Philox4x32-10
/// (Salmon et al., "Parallel random numbers: as easy as 1, 2, 3", SC 2011, Random123). A Draw
/// delivers up to 131072 uniform numbers.
class Draw {
 public:
  /// `index` tells several draws of one purpose in one step apart (for example one per target): its
  /// numbers share none with those of another index. step < 2^48, index < 2^24.
  Draw(std::uint64_t seed, PlayerId who, Stream stream, std::uint64_t step,
       std::uint32_t index = 0);

  /// In [0, 1), a multiple of 2^-53.
  [[nodiscard]] double uniform();
  /// In [low, high).
  [[nodiscard]] double uniform(double low, double high) {
    const double drawn = low + (high - low) * uniform();
    return drawn < high ? drawn : low;  // not where rounding leads
  }
  /// Mean 0, standard deviation 1 (Box-Muller with our own log and sin_cos); never beyond 8.6.
  [[nodiscard]] double normal();
  /// True with probability p; p <= 0 and NaN never, p >= 1 always.
  [[nodiscard]] bool chance(double p) { return uniform() < p; }
  /// 64 random bits.
  [[nodiscard]] std::uint64_t bits();

 private:
  std::array<std::uint32_t, 4> counter_;
  std::array<std::uint32_t, 2> key_;
  std::array<std::uint64_t, 2> block_{};
  std::uint32_t left_ = 0;  ///< unused words of block_
  bool used_up_ = false;    ///< there is no block behind it
  bool has_spare_ = false;
  double spare_ = 0;  ///< the second normal number of a Box-Muller pair
};

}  // namespace eyrie
