// SPDX-License-Identifier: MIT
#pragma once
/// \file  How sure means and ratios of numbers are, and how they are spread. No number may be NaN.
#include <optional>
#include <span>
#include <vector>

#include "stats/share.hpp"

namespace eyrie::stats {

/// Mean and variance of numbers that come one by one (Welford, Technometrics 4 (1962) 419). The
/// same numbers in the same order give the same bits.
class Moments {
 public:
  void add(double x);

  [[nodiscard]] std::uint64_t n() const { return n_; }
  [[nodiscard]] double mean() const { return mean_; }
  /// Of the population that they are drawn from; 0 of fewer than two.
  [[nodiscard]] double variance() const {
    return n_ > 1 ? squares_ / static_cast<double>(n_ - 1) : 0;
  }
  [[nodiscard]] double error() const;  ///< of the mean, standard
  /// Whether all are the same but for rounding, so that they do not say how far others may lie.
  [[nodiscard]] bool constant() const { return variance() <= 1e-24 * mean_ * mean_; }

 private:
  std::uint64_t n_ = 0;
  double mean_ = 0, squares_ = 0;  ///< about the mean
};

/// Student's interval of a mean; of paired differences, if those were added. Nothing if it has no
/// bounds: of fewer than two numbers, or if all are the same.
[[nodiscard]] std::optional<Interval> t_interval(const Moments& moments, double confidence = 0.95);
/// Student's test: how likely a mean at least as far from 0 is if the true one is 0. 1 of fewer
/// than two numbers; numbers that are all the same but not 0 give what the sign test gives.
[[nodiscard]] double t_test(const Moments& moments);

/// A sum over another one of the same runs, such as kills over losses.
class Ratio {
 public:
  void add(double over, double under);

  [[nodiscard]] std::uint64_t n() const { return over_.n(); }
  /// Nothing if what it is divided by is 0.
  [[nodiscard]] std::optional<double> value() const;
  [[nodiscard]] const Moments& under() const { return under_; }
  /// Whether Student's test says that the sum below is not 0.
  [[nodiscard]] bool divides(double confidence = 0.95) const;
  /// Fieller's interval (Journal of the Royal Statistical Society B 16 (1954) 175). Nothing if it
  /// has no bounds: the sum below may as well be 0, or each number is the same multiple of that
  /// below it.
  [[nodiscard]] std::optional<Interval> fieller(double confidence = 0.95) const;

 private:
  Moments over_, under_;
  double products_ = 0;  ///< about both means
};

/// Holm's correction for many comparisons (Scandinavian Journal of Statistics 6 (1979) 65): each p
/// raised so that those below 5 % hold, all of them, in 95 % of such families. In the order given.
[[nodiscard]] std::vector<double> holm(std::span<const double> p);

}  // namespace eyrie::stats
