// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/assert.hpp"
#include "core/lanes.hpp"

namespace eyrie {

/// A place between two breakpoints: the lower one, and how far towards the next, in [0, 1].
struct TableCell {
  std::size_t index = 0;
  double fraction = 0;
};
/// That of each of several numbers side by side.
template <class Real>
struct TableCells {
  std::array<std::size_t, math::kLanes<Real>> index;
  Real fraction;
};

/// Strictly increasing breakpoints. Looking up takes constant time (a table of equal buckets leads
/// to the right breakpoint) and allocates nothing.
class Axis {
 public:
  /// One breakpoint, 0.
  Axis() = default;
  /// What is wrong with these breakpoints, in words, if anything: there must be at least one, all
  /// finite and strictly increasing.
  [[nodiscard]] static std::optional<std::string> problem(std::span<const double> breakpoints);
  /// std::logic_error if there is a problem.
  explicit Axis(std::vector<double> breakpoints);

  /// Where `x` lies, clamped to the first and last breakpoint. NaN is in the first cell at fraction
  /// NaN, so that it shows in the result.
  [[nodiscard]] TableCell cell(double x) const {
    if (!(x > breakpoints_.front()) || size() < 2)
      return {0, x != x ? x : 0.0};
    if (x >= breakpoints_.back())
      return {size() - 2, 1};
    const std::size_t i = below(x);
    return {i, (x - breakpoints_[i]) / (breakpoints_[i + 1] - breakpoints_[i])};
  }
  /// The same of each lane. There are two breakpoints at least.
  template <std::size_t N>
  [[nodiscard]] TableCells<math::Lanes<N>> cell(const math::Lanes<N>& x) const {
    using Real = math::Lanes<N>;
    EYRIE_ASSERT(size() >= 2);
    const auto buckets =
        math::whole_part((math::min(x, breakpoints_.back()) - breakpoints_.front()) * per_bucket_);
    const auto index = math::each_of<N>([&](std::size_t i) {
      std::size_t at = first_cell_[math::lane(buckets, i)];
      while (math::lane(x, i) >= breakpoints_[at + 1] && at + 2 < size())
        ++at;
      return at;
    });
    const auto low = math::each_lane<Real>([&](std::size_t i) { return breakpoints_[index[i]]; });
    const auto high =
        math::each_lane<Real>([&](std::size_t i) { return breakpoints_[index[i] + 1]; });
    return {.index = index, .fraction = math::clamp((x - low) / (high - low), 0, 1)};
  }
  /// The last breakpoint not above `x`, which lies between the first and the last one.
  [[nodiscard]] std::size_t below(double x) const {
    std::size_t i = first_cell_[bucket(x)];
    while (x >= breakpoints_[i + 1])
      ++i;
    return i;
  }
  [[nodiscard]] std::span<const double> breakpoints() const { return breakpoints_; }
  [[nodiscard]] std::size_t size() const { return breakpoints_.size(); }

  friend bool operator==(const Axis& a, const Axis& b) { return a.breakpoints_ == b.breakpoints_; }

 private:
  [[nodiscard]] std::size_t bucket(double x) const {
    return math::whole_part((x - breakpoints_.front()) * per_bucket_);
  }

  std::vector<double> breakpoints_{0.0};
  std::vector<std::uint32_t> first_cell_;  ///< per bucket: a breakpoint not above any of it
  double per_bucket_ = 0;
};

namespace detail {

template <class Real>
Real mix(const Real& a, const Real& b, const Real& fraction) {
  return math::select(fraction >= 1, b, a + fraction * (b - a));  // exactly b at the end
}

}  // namespace detail

/// A function of one variable, linear between breakpoints and constant beyond them. The default is
/// 0 everywhere.
class Table1 {
 public:
  Table1() = default;
  /// What is wrong, in words, if anything: problems of the axis, as many values as breakpoints, all
  /// finite.
  [[nodiscard]] static std::optional<std::string> problem(std::span<const double> breakpoints,
                                                          std::span<const double> values);
  /// std::logic_error if there is a problem.
  Table1(std::vector<double> breakpoints, std::vector<double> values);
  /// The same value everywhere.
  [[nodiscard]] static Table1 constant(double value) { return Table1({0.0}, {value}); }

  [[nodiscard]] double operator()(double x) const {
    const TableCell cell = axis_.cell(x);
    const std::size_t next = std::min(cell.index + 1, values_.size() - 1);
    return detail::mix(values_[cell.index], values_[next], cell.fraction);
  }
  [[nodiscard]] std::span<const double> breakpoints() const { return axis_.breakpoints(); }
  [[nodiscard]] std::span<const double> values() const { return values_; }

  friend bool operator==(const Table1&, const Table1&) = default;

 private:
  Axis axis_;
  std::vector<double> values_{0.0};
};

/// A function of two variables, bilinear inside a cell and constant beyond the borders. The default
/// is 0 everywhere.
class Table2 {
 public:
  Table2() = default;
  /// What is wrong, in words, if anything. `values` is row by row: for the first row breakpoint the
  /// value at each column breakpoint, then the next row.
  [[nodiscard]] static std::optional<std::string> problem(std::span<const double> rows,
                                                          std::span<const double> columns,
                                                          std::span<const double> values);
  /// std::logic_error if there is a problem.
  Table2(std::vector<double> rows, std::vector<double> columns, std::vector<double> values);
  [[nodiscard]] static Table2 constant(double value) { return Table2({0.0}, {0.0}, {value}); }

  [[nodiscard]] double operator()(double row, double column) const;
  [[nodiscard]] const Axis& rows() const { return rows_; }
  [[nodiscard]] const Axis& columns() const { return columns_; }
  [[nodiscard]] std::span<const double> values() const { return values_; }

  friend bool operator==(const Table2&, const Table2&) = default;

 private:
  Axis rows_, columns_;
  std::vector<double> values_{0.0};
};

}  // namespace eyrie
