// SPDX-License-Identifier: MIT
#pragma once
/// \file  Jammers: noise that hides an echo, false echoes that take a gate along, and what a radar
/// makes of them. docs/models/radar.md has the equations and what they are worth.
#include "core/describe.hpp"
#include "core/math.hpp"

namespace eyrie::model {

/// m/s^2, 9 g: gates leave room for a target that turns like that between two looks, and follow
/// nothing that leaves faster.
inline constexpr double kTurnInGate = 88;

/// m: all radars here work at 10 GHz.
inline constexpr double kRadarWavelength = 0.03;

/// Which gates of a radar a false echo pulls off.
enum class Gates : std::uint8_t { range, speed, both };
constexpr auto names_of(Gates) {
  return names_from_zero<Gates>("range", "speed", "both");
}

/// Where a false echo is beside the true one.
struct FalseEcho {
  double range = 0;  ///< m, farther
  double speed = 0;  ///< m/s, slower to come
};

/// A repeater that gives back, later and lower in frequency, what a beam sends that rests on it:
/// range-gate and velocity-gate pull-off (Neri, Introduction to Electronic Defense Systems (1991),
/// ch. 5; not seen). Its false echo begins on the true one, which it outshines, moves away with a
/// constant acceleration, and is switched off where the gates are far from the aircraft. The
/// program begins anew every walk_time + pause_time from the start of the simulation.
struct PullOff {
  double gain = 60;  ///< dB
  Gates gates = Gates::both;
  double acceleration = 20;  ///< m/s^2
  double walk_time = 8;      ///< s
  double pause_time = 4;     ///< s

  static constexpr std::string_view type_name = "pull_off";
  static constexpr std::string_view help =
      "a repeater whose false echo takes a radar's gates along";
  static constexpr auto params() {
    return Lines{
        param("gain", &PullOff::gain, "dB", range(0, 150),
              "of what is sent over what is received, with both antennas")
            .required(),
        param("gates", &PullOff::gates, "what is pulled off: range, speed or both").required(),
        param("acceleration", &PullOff::acceleration, "m/s2", positive(1e4),
              "with which the false echo moves away")
            .required(),
        param("walk_time", &PullOff::walk_time, "s", positive(600), "how long it moves away")
            .required(),
        param("pause_time", &PullOff::pause_time, "s", positive(600),
              "how long it is silent afterwards")
            .required()};
  }

  /// m^2, of a target with so strong an echo: what comes back is G lambda^2 / (4 pi) of what falls
  /// in, at any range, so J/S is that over the cross section. It is never saturated.
  [[nodiscard]] double section() const {
    return math::pow(10, gain / 10) * kRadarWavelength * kRadarWavelength / (4 * kPi);
  }
  /// s since it began to move away; none while it is silent.
  [[nodiscard]] std::optional<double> phase(double time) const {
    const double period = walk_time + pause_time;
    const double phase = time - period * std::floor(time / period);
    return phase < walk_time ? std::optional(phase) : std::nullopt;
  }
  [[nodiscard]] FalseEcho at(double phase) const {
    return {.range = gates == Gates::speed ? 0 : acceleration * phase * phase / 2,
            .speed = gates == Gates::range ? 0 : acceleration * phase};
  }
};

/// Const and shared by every aircraft that carries it. It radiates noise at everybody's radars but
/// those of the own side, whose frequencies it keeps free, and answers their beams with false
/// echoes.
struct Jammer {
  double power = 0;          ///< W
  double bandwidth = 500e6;  ///< Hz
  bool when_tracked = false;
  std::optional<PullOff> pull_off;

  static constexpr std::string_view type_name = "jammer";
  static constexpr std::string_view help = "a jammer: noise in the band of radars, false echoes";
  static constexpr auto params() {
    return Lines{
        param("power", &Jammer::power, "W", range(0, 1e9),
              "effective radiated power of its noise: of the transmitter times the gain of its "
              "antenna"),
        param("bandwidth", &Jammer::bandwidth, "Hz", range(1e3, 1e11),
              "that the power is spread over"),
        param("when_tracked", &Jammer::when_tracked,
              "radiates noise only while the own warning receiver hears a radar that tracks, or a "
              "missile's seeker"),
        param("pull_off", &Jammer::pull_off, "null: no false echoes")};
  }
  /// W/Hz, as Emission::jamming.
  [[nodiscard]] double density() const { return power / bandwidth; }
};

/// Gain of an antenna with a round beam of that width (rad): 26,000 over its square degrees, an
/// antenna of usual efficiency (Stutzman & Thiele, Antenna Theory and Design, sec. 7.3; not seen).
[[nodiscard]] constexpr double antenna_gain(double beam_width) {
  constexpr double kSquareDegrees = 26e3 * (kPi / 180) * (kPi / 180);
  return kSquareDegrees / (beam_width * beam_width);
}

/// Noise of a jammer in a receiver over the receiver's own, where its main beam points at the
/// jammer: the one-way range equation over the noise of the receiver, both per Hz, so it does not
/// depend on what the receiver does with its echoes. `density`: W/Hz; `range_squared`: m^2. All
/// radars here have a noise figure of 4 dB (usual value).
[[nodiscard]] constexpr double jamming_to_noise(double density, double beam_width,
                                                double range_squared) {
  constexpr double kNoise = 1.380649e-23 * 290 * 2.511886431509580;  // W/Hz
  constexpr double kArea = kRadarWavelength * kRadarWavelength / (16 * kPi * kPi);
  return density * antenna_gain(beam_width) * kArea / (kNoise * range_squared);
}

/// Gain of an antenna aside of its middle over that in its middle, one way: a Gaussian beam (half
/// of the power half a beam width aside), and its side lobes (dB below the middle). `cos_off`:
/// cosine of the angle.
[[nodiscard]] inline double off_beam(double beam_width, double side_lobes, double cos_off) {
  const double off2 = 2 * (1 - std::fmin(cos_off, 1.0));  // the angle squared, where it is small
  return std::fmax(math::exp2(-4 * off2 / (beam_width * beam_width)),
                   math::pow(10, -side_lobes / 10));
}

/// Jamming that much over the receiver's own noise (-ln of a false alarm rate of 1e-6) shows as a
/// strobe: a direction without a range.
inline constexpr double kStrobe = 13.815510557964274;

/// The range (m) at which a target that jams is seen as well as one that does not is at `range`:
/// where R^4 (1 + J/N(R)) is range^4, J/N falling with R^2. `jamming_at_1_m`: jamming_to_noise() at
/// 1 m. Beyond, the echo drowns.
[[nodiscard]] inline double burn_through(double range, double jamming_at_1_m) {
  const double c = jamming_at_1_m / 2, range2 = range * range;
  // the root of R^4 + 2 c R^2 = range^4, without the difference of two large numbers
  return std::sqrt(range2 * range2 / (c + std::sqrt(c * c + range2 * range2)));
}

}  // namespace eyrie::model
