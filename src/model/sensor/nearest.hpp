// SPDX-License-Identifier: MIT
#pragma once
/// \file  The nearest few of many, without an allocation.
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace eyrie::model::sensor {

/// One of many, by its row, with its distance squared (m^2) or any other figure of merit.
struct Candidate {
  double distance2 = 0;
  std::uint32_t row = 0;
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

}  // namespace eyrie::model::sensor
