// SPDX-License-Identifier: MIT
#pragma once
/// \file  Jammers: noise that hides an echo, and what a radar makes of it. docs/models/radar.md has
/// the equations and what they are worth.
#include "core/describe.hpp"
#include "core/math.hpp"

namespace eyrie::model {

/// Const and shared by every aircraft that carries it. It radiates noise at everybody's radars but
/// those of the own side, whose frequencies it keeps free.
struct Jammer {
  double power = 1e3;        ///< W
  double bandwidth = 500e6;  ///< Hz
  bool when_tracked = false;

  static constexpr std::string_view type_name = "jammer";
  static constexpr std::string_view help = "a jammer: noise in the band of radars";
  static constexpr auto params() {
    return std::tuple{
        param("power", &Jammer::power, "W", range(1e-3, 1e9),
              "effective radiated power: of the transmitter times the gain of its antenna")
            .required(),
        param("bandwidth", &Jammer::bandwidth, "Hz", range(1e3, 1e11),
              "that the power is spread over")
            .required(),
        param("when_tracked", &Jammer::when_tracked,
              "radiates only while the own warning receiver hears a radar that tracks, or a "
              "missile's seeker")};
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
/// radars here work at 10 GHz, with a noise figure of 4 dB (usual value).
[[nodiscard]] constexpr double jamming_to_noise(double density, double beam_width,
                                                double range_squared) {
  constexpr double kWavelength = 0.03;                               // m
  constexpr double kNoise = 1.380649e-23 * 290 * 2.511886431509580;  // W/Hz
  constexpr double kArea = kWavelength * kWavelength / (16 * kPi * kPi);
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
