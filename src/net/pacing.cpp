// SPDX-License-Identifier: MIT
#include "net/pacing.hpp"

#include <algorithm>
#include <cmath>

namespace eyrie::net {

void Histogram::add(Clock::duration duration) {
  const std::int64_t signed_ns =
      std::chrono::duration_cast<std::chrono::nanoseconds>(duration).count();
  const std::uint64_t ns = signed_ns > 0 ? static_cast<std::uint64_t>(signed_ns) : 0;
  const int shift = std::max(0, static_cast<int>(std::bit_width(ns / kParts)) - 1);
  ++buckets_[kParts * static_cast<std::uint64_t>(shift) + (ns >> shift)];
  ++count_;
  sum_ += ns;
  max_ = std::max(max_, ns);
}

double Histogram::percentile(double part) const {
  const auto wanted = static_cast<std::uint64_t>(std::ceil(part * static_cast<double>(count_)));
  std::uint64_t seen = 0;
  for (std::uint64_t i = 0; i < buckets_.size(); ++i) {
    seen += buckets_[i];
    if (seen == 0 || seen < wanted)
      continue;
    const std::uint64_t shift = i < 2 * kParts ? 0 : i / kParts - 1;
    const std::uint64_t above = (i - kParts * shift + 1) << shift;
    return seconds(std::min(max_, above - 1));
  }
  return 0;
}

Pacing::Pacing(double frame, Clock::time_point start, Clock::duration behind)
    : frame_(frame), start_(start), behind_(behind) {}

Clock::time_point Pacing::due(std::uint64_t frame) const {
  const std::chrono::duration<double> since(frame_ * static_cast<double>(frame));
  return start_ + std::chrono::duration_cast<Clock::duration>(since);
}

void Pacing::go_on(double frame, Clock::time_point start) {
  is_of_one_frame_ = is_of_one_frame_ && (frames() == 0 || frame == frame_);
  frame_ = frame;
  start_ = start;
  start_ -= due() - start;
}

void Pacing::made(Clock::time_point begun, Clock::time_point done) {
  const Clock::duration late = begun - due();
  late_.add(late);
  if (late > behind_) {
    ++stalls_;
    given_up_ += std::chrono::duration<double>(late - behind_).count();
    start_ += late - behind_;
  }
  work_.add(done - begun);
  paced_ += frame_;
  greatest_load_ =
      std::max(greatest_load_, std::chrono::duration<double>(done - begun).count() / frame_);
  if (done > due())  // which is that of the next frame now
    ++missed_;
}

}  // namespace eyrie::net
