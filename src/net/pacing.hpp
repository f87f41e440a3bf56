// SPDX-License-Identifier: MIT
#pragma once
/// \file  Real time: when each frame may begin, and how well the clock was kept.
#include <array>
#include <bit>
#include <chrono>
#include <cstdint>

namespace eyrie::net {

using Clock = std::chrono::steady_clock;

/// Durations, counted in buckets no wider than a 32nd of what they hold. Of a fixed size.
class Histogram {
 public:
  /// A negative duration counts as none.
  void add(Clock::duration duration);

  [[nodiscard]] std::uint64_t count() const { return count_; }
  /// Seconds.
  [[nodiscard]] double max() const { return seconds(max_); }
  [[nodiscard]] double mean() const { return count_ ? seconds(sum_) / double(count_) : 0; }
  /// Seconds that so large a `part` of them, 0 to 1, does not exceed: too large by a 32nd at most.
  [[nodiscard]] double percentile(double part) const;

 private:
  static constexpr std::uint64_t kParts = 32;
  [[nodiscard]] static double seconds(std::uint64_t ns) { return double(ns) * 1e-9; }

  // one for each ns below 64; then 32 for each power of two
  std::array<std::uint64_t, kParts*(64 - std::bit_width(kParts) + 2)> buckets_{};
  std::uint64_t count_ = 0, sum_ = 0, max_ = 0;  // ns
};

/// Paces frames against absolute deadlines, so that errors do not add up: frame k may begin at
/// start + k * frame and has to be done when the next one may begin. Late frames are caught up, but
/// never more than `behind`: what is beyond that is given up, the deadlines are put back, and it is
/// counted. So a stall of the machine is no hurry of minutes afterwards. Knows no clock: whoever
/// asks tells the time.
class Pacing {
 public:
  /// `frame`: seconds between two frames.
  Pacing(double frame, Clock::time_point start,
         Clock::duration behind = std::chrono::milliseconds(200));

  /// From now on frames are as long as that, and the next one may begin at `start`: after a pause,
  /// or at another rate. What was counted stays.
  void go_on(double frame, Clock::time_point start);

  /// When the next frame may begin.
  [[nodiscard]] Clock::time_point due() const { return due(frames()); }
  /// Whether what is to be caught up is less than half of `behind`.
  [[nodiscard]] bool is_kept(Clock::time_point now) const { return now < due() + behind_ / 2; }
  /// The next frame began and was done then.
  void made(Clock::time_point begun, Clock::time_point done);

  [[nodiscard]] double frame() const { return frame_; }
  [[nodiscard]] std::uint64_t frames() const { return work_.count(); }
  /// Frames that were not done in time.
  [[nodiscard]] std::uint64_t missed() const { return missed_; }
  /// How late frames began.
  [[nodiscard]] const Histogram& late() const { return late_; }
  /// How long they took.
  [[nodiscard]] const Histogram& work() const { return work_; }
  /// The share of its frames that the work took.
  [[nodiscard]] double load() const {
    return paced_ > 0 ? work_.mean() * double(frames()) / paced_ : 0;
  }
  /// The largest of these shares of a single frame.
  [[nodiscard]] double greatest_load() const { return greatest_load_; }
  /// Whether all frames were as long as frame().
  [[nodiscard]] bool is_of_one_frame() const { return is_of_one_frame_; }
  /// How often the deadlines were put back, and by how many seconds in all.
  [[nodiscard]] std::uint64_t stalls() const { return stalls_; }
  [[nodiscard]] double given_up() const { return given_up_; }

 private:
  [[nodiscard]] Clock::time_point due(std::uint64_t frame) const;

  double frame_;
  Clock::time_point start_;  ///< of frame 0, if all were as long as this one
  Clock::duration behind_;
  Histogram late_, work_;
  std::uint64_t missed_ = 0, stalls_ = 0;
  double given_up_ = 0, paced_ = 0;  // s
  double greatest_load_ = 0;
  bool is_of_one_frame_ = true;
};

}  // namespace eyrie::net
