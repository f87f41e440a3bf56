// SPDX-License-Identifier: MIT
#pragma once
/// \file  Which values are large and which are small in a run, so that many runs tell of each.
#include <bit>
#include <cstddef>

namespace eyrie::sensitivity {

/// Plackett & Burman, The Design of Optimum Multifactorial Experiments, Biometrika 33 (1946) 305:
/// p values in p + 1 rows, p = 4 m - 1 a prime, by the quadratic residues of p. Some values are
/// costly to change: they have these rows for themselves, as plots; within each plot the others
/// change, by the product with a Hadamard matrix of 2^k rows (a split-plot design). Every row is
/// there with all signs turned, too: the effect of one value is free of what two others do
/// together (Box & Wilson, 1951). Every column has as many + as -, and any two agree as often as
/// they differ.
class Design {
 public:
  Design(std::size_t costly, std::size_t others) : costly_(costly) {
    while (prime_ < costly || !is_prime(prime_))
      prime_ += 4;
    while ((rows_ - 1) * (prime_ + 1) < others)
      rows_ *= 2;
  }
  [[nodiscard]] std::size_t plots() const { return 2 * (prime_ + 1); }
  [[nodiscard]] std::size_t rows_in_plot() const { return rows_; }
  /// 1 or -1. The costly values come first: theirs do not depend on the row.
  [[nodiscard]] int sign(std::size_t plot, std::size_t row, std::size_t value) const {
    const bool turned = plot % 2 != 0;
    if (value < costly_)
      return plus(plot / 2, value) != turned ? 1 : -1;
    const std::size_t other = value - costly_;
    const bool within = std::popcount((1 + other / (prime_ + 1)) & row) % 2 == 0;
    return (plus(plot / 2, other % (prime_ + 1)) == within) != turned ? 1 : -1;
  }

 private:
  static bool is_prime(std::size_t n) {
    for (std::size_t d = 2; d * d <= n; ++d)
      if (n % d == 0)
        return false;
    return true;
  }
  /// Of p + 1 columns; the last is + everywhere.
  [[nodiscard]] bool plus(std::size_t i, std::size_t column) const {
    if (column == prime_ || i == prime_)
      return column == prime_;
    for (std::size_t root = 0; root < prime_; ++root)
      if (root * root % prime_ == (column + prime_ - i) % prime_)
        return true;
    return false;
  }
  std::size_t costly_, prime_ = 3, rows_ = 1;
};

}  // namespace eyrie::sensitivity
