// SPDX-License-Identifier: MIT
#pragma once
/// \file  Infrared search and track: a passive sensor in the nose that measures directions, and
/// ranges only where its laser reaches. docs/models/radar.md has the equations.
#include "core/draw.hpp"
#include "model/kinematics.hpp"
#include "model/signature.hpp"
#include "model/track.hpp"

namespace eyrie::model::sensor {

/// Const and shared by every aircraft that carries it.
struct Irst {
  double reference_range = 15e3;        ///< m
  double reference_intensity = 1000;    ///< W/sr
  double greatest_range = 30e3;         ///< m
  double rate = 0.5;                    ///< Hz
  double half_azimuth = si(30, "deg");  ///< rad
  double low = si(15, "deg");           ///< rad
  double high = si(30, "deg");          ///< rad
  double sigma_angle = 2e-3;            ///< rad
  double laser_range = 0;               ///< m
  double sigma_laser = 5;               ///< m

  static constexpr std::string_view type_name = "irst";
  static constexpr std::string_view help = "infrared search and track: directions without ranges";
  static constexpr auto params() {
    return Lines{
        param("reference_range", &Irst::reference_range, "m", range(100, 1e6),
              "range at which the reference intensity is found with even odds in one frame")
            .required(),
        param("reference_intensity", &Irst::reference_intensity, positive(1e6), "W/sr in its band")
            .required(),
        param("greatest_range", &Irst::greatest_range, "m", range(100, 1e6),
              "nothing is found beyond, however bright: the air absorbs it"),
        param("rate", &Irst::rate, "Hz", range(0.01, 50), "search frames per second"),
        param("half_azimuth", &Irst::half_azimuth, "rad", range(0.5, 85, "deg"),
              "half width of its field of regard, from the nose"),
        param("low", &Irst::low, "rad", range(0, 85, "deg"), "how far it sees down from the nose"),
        param("high", &Irst::high, "rad", range(0, 85, "deg"), "how far it sees up from the nose"),
        param("sigma_angle", &Irst::sigma_angle, "rad", range(1e-6, 0.1),
              "error of a direction, 1-sigma per axis"),
        param("laser_range", &Irst::laser_range, "m", range(0, 1e5),
              "its laser measures the range of the nearest target within; 0: it has none"),
        param("sigma_laser", &Irst::sigma_laser, "m", range(0.1, 1e3),
              "error of that range, 1-sigma")};
  }
};

/// Whether a line of sight (m) lies within what it can see at all.
[[nodiscard]] bool covers(const Irst& irst, const Axes& body, const Vec3& sight);

/// Whether one frame finds something of that intensity (W/sr, towards the sensor) at `range` (m): a
/// steady signal that falls with the square of the range, in Gaussian noise, with a threshold for a
/// false alarm rate of 1e-6. `noise`: a normal number.
[[nodiscard]] bool finds(const Irst& irst, double intensity, double range, double noise);

/// The measurement of what was found: a direction, and the range if the laser `fires`. Without it
/// the range is anywhere within greatest_range. The error across is counted outwards from the
/// nose, so that a mirrored scene gives the mirrored contact.
[[nodiscard]] Contact measure(const Irst& irst, bool fires, const Kinematics& own, const Axes& body,
                              const Vec3& place, PlayerId truth, Draw noise);

}  // namespace eyrie::model::sensor
