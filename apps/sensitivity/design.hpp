// SPDX-License-Identifier: MIT
#pragma once
/// \file  Which values are large and which are small in a run, so that many runs tell of each.
#include <cstddef>

namespace eyrie::sensitivity {

/// Plackett & Burman, The Design of Optimum Multifactorial Experiments, Biometrika 33 (1946) 305:
/// p values in p + 1 rows, p = 4 m - 1 a prime, by the quadratic residues of p. Every row is there
/// with all signs turned, too: the effect of one value is free of what two others do together (Box
/// & Wilson, 1951). Every column has as many + as -, and any two agree as often as they differ.
class Design {
 public:
  explicit Design(std::size_t values) {
    while (prime_ < values || !is_prime(prime_))
      prime_ += 4;
  }
  [[nodiscard]] std::size_t rows() const { return 2 * (prime_ + 1); }
  [[nodiscard]] int sign(std::size_t row, std::size_t value) const {
    const std::size_t i = row / 2;
    const bool plus = i < prime_ && is_square((value + prime_ - i) % prime_);
    return plus == (row % 2 == 0) ? 1 : -1;
  }

 private:
  static bool is_prime(std::size_t n) {
    for (std::size_t d = 2; d * d <= n; ++d)
      if (n % d == 0)
        return false;
    return true;
  }
  [[nodiscard]] bool is_square(std::size_t n) const {
    for (std::size_t root = 0; root < prime_; ++root)
      if (root * root % prime_ == n)
        return true;
    return false;
  }
  std::size_t prime_ = 3;
};

}  // namespace eyrie::sensitivity
