// SPDX-License-Identifier: MIT
#pragma once
/// \file  Boxes around rows that follow each other, so that who looks for what is near passes by
/// the rest: rows of a flight follow each other, and fly together.
#include <algorithm>
#include <array>
#include <span>

#include "model/kinematics.hpp"

namespace eyrie::model {

class RowBoxes {
 public:
  /// Of few rows there are no boxes: they are asked one by one.
  explicit RowBoxes(std::span<const Kinematics> rows)
      : rows_(rows), size_(std::max(kLeast, (rows.size() + kMost - 1) / kMost)) {
    if (!bounded())
      return;
    for (std::size_t row = 0; row < rows.size(); ++row) {
      Box& box = boxes_[row / size_];
      const Box own(rows[row].position);
      if (row % size_ == 0)
        box = own;
      box.x.take(own.x);
      box.y.take(own.y);
      box.z.take(own.z);
    }
  }

  /// Calls `use(row, distance2)`, m^2, in the order of rows for all with `distance2 <= reach2`.
  template <class Use>
  void each_within(const Vec3& place, double reach2, const Use& use) const {
    for (std::size_t box = 0; box < count(); ++box)
      if (!bounded() || boxes_[box].distance2(Box(place)) <= reach2)
        each_of(box, place, reach2, use);
  }

  /// The same of each of the rows `first` to `last`: `use(row, other, distance2)`.
  template <class Use>
  void each_pair_within(std::size_t first, std::size_t last, double reach2, const Use& use) const {
    std::array<std::uint8_t, kMost> near;
    for (std::size_t begin = first, end; begin < last; begin = end) {
      end = std::min(last, (begin / size_ + 1) * size_);
      std::size_t found = 0;
      for (std::size_t box = 0; box < count(); ++box)
        if (!bounded() || boxes_[box].distance2(boxes_[begin / size_]) <= reach2)
          near[found++] = static_cast<std::uint8_t>(box);
      for (std::size_t row = begin; row < end; ++row)
        for (std::size_t n = 0; n < found; ++n)
          each_of(near[n], rows_[row].position, reach2,
                  [&](std::size_t other, double distance2) { use(row, other, distance2); });
    }
  }

 private:
  static constexpr std::size_t kMost = 64, kLeast = 8, kFew = 32;
  struct Range {
    double least, most;
    void take(const Range& b) {
      least = std::min(least, b.least);
      most = std::max(most, b.most);
    }
    [[nodiscard]] double gap(const Range& b) const {
      return std::max({least - b.most, b.least - most, 0.0});
    }
  };
  struct Box {
    Box() = default;  // not of zeros: most are never used
    explicit Box(const Vec3& p) : x{p.x, p.x}, y{p.y, p.y}, z{p.z, p.z} {}
    /// Never more than between a place in one and a place in the other, rounding included.
    [[nodiscard]] double distance2(const Box& b) const {
      return norm2({x.gap(b.x), y.gap(b.y), z.gap(b.z)});
    }
    Range x, y, z;
  };

  [[nodiscard]] std::size_t count() const { return (rows_.size() + size_ - 1) / size_; }
  [[nodiscard]] bool bounded() const { return rows_.size() > kFew; }
  template <class Use>
  void each_of(std::size_t box, const Vec3& place, double reach2, const Use& use) const {
    const std::size_t end = std::min((box + 1) * size_, rows_.size());
    for (std::size_t row = box * size_; row < end; ++row)
      if (const double distance2 = norm2(rows_[row].position - place); distance2 <= reach2)
        use(row, distance2);
  }

  std::span<const Kinematics> rows_;
  std::size_t size_;  ///< rows of a box
  std::array<Box, kMost> boxes_;
};

}  // namespace eyrie::model
