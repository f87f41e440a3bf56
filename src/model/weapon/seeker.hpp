// SPDX-License-Identifier: MIT
#pragma once
/// \file  What a missile's seeker sees and how it follows it.
#include "core/draw.hpp"
#include "model/weapon/flyout.hpp"
#include "model/weapon/missile.hpp"
#include "model/weapon/seeker_type.hpp"

namespace eyrie::model::weapon {

/// Where a seeker is and where its missile points.
struct SeekerView {
  Vec3 position;           ///< m
  Vec3 velocity;           ///< m/s
  Vec3 axis{1, 0, 0};      ///< unit vector: nose of the missile
  Vec3 down{0, 0, 1};      ///< unit vector
  double altitude = 0;     ///< m; 0: nothing is seen through the ground's echo
  Side side = Side::none;  ///< whose jammers leave it alone
};

/// How far it sees a signature (m^2 or W/sr), m: the fourth root for an active radar (two-way range
/// equation), the square root for an infrared seeker (irradiance falls with the square of range).
[[nodiscard]] double acquisition_range(const SeekerType& seeker, double signature);

/// Whether the seeker can rest on something at `los` that moves with `velocity` and shows
/// `signature`: range, gimbal, rate of the line of sight and, for a radar that looks down, the
/// notch: what is in it has to stand out of the ground's echo by 13 dB, as of noise (clutter.hpp).
/// A missile looks down when the line of sight points below the horizontal.
[[nodiscard]] bool visible(const SeekerType& seeker, const SeekerView& view, const LineOfSight& los,
                           const Vec3& velocity, double signature);

/// One look's measurement of what is at `los`, with errors. The error to the side is counted
/// outwards from the nose, so that a mirrored scene gives the mirrored measurement for the same
/// draw. An infrared seeker takes its own speed for the closing speed; its range is not to be used.
///
/// Angles err with one over the root of S/N (Barton; docs/models/missile.md), which falls with R^-4
/// from what it is at `reach` (m, acquisition_range() of what is looked at), and no less than
/// stated; range and closing speed, which rest on the pulse and the filter bank, as stated. `glint`
/// (m, across the line of sight) is where the apparent center was `dt` s ago and goes on to where
/// it is: a Gauss-Markov process of first order.
struct SeekerLook {
  Vec3 direction{1, 0, 0};  ///< unit vector
  double range = 0;         ///< m
  double closing = 0;       ///< m/s
  double faint = 1;         ///< by how much its angles err more than those of a bright target
};
[[nodiscard]] SeekerLook measure(const SeekerType& seeker, const SeekerView& view,
                                 const LineOfSight& los, double reach, double dt, Vec3& glint,
                                 Draw noise);

/// Begins to follow: the filter starts at the measurement and at the line-of-sight rate that was
/// expected (rad/s).
void start_following(MissileState& state, const SeekerLook& look, const Vec3& expected_rate,
                     double time);

/// Brings a measurement into the line-of-sight filter, a critically damped alpha-beta filter on the
/// unit vector (Brookner, Tracking and Kalman Filtering Made Easy, sec. 1.2.6), and a
/// radar's range and closing speed into the believed place of the target.
/// The filter's time constant is that of a Kalman filter of constant velocity: it grows with the
/// root of the errors (range squared) over how fast a maneuver turns the line of sight (one over
/// range), from filter_time on (Kalata, The tracking index, IEEE Trans. AES 20 (1984) 174, not
/// seen).
void follow(const SeekerType& seeker, const SeekerView& view, const SeekerLook& look, double time,
            MissileState& state);

/// The filtered line of sight carried on to `time` (s).
[[nodiscard]] Vec3 sight_at(const MissileState& state, double time);

}  // namespace eyrie::model::weapon
