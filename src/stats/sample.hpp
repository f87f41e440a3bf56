// SPDX-License-Identifier: MIT
#pragma once
/// \file  How sure shares, and means and ratios of numbers are, and how these are spread. No number
/// may be NaN.
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace eyrie::stats {

struct Interval {
  double low = 0, high = 1;
  [[nodiscard]] double width() const { return high - low; }
};

/// So many of so many.
struct Share {
  std::uint64_t count = 0, n = 0;
  [[nodiscard]] double value() const {
    return n ? static_cast<double>(count) / static_cast<double>(n) : 0;
  }
  [[nodiscard]] double error() const;  ///< standard, of more than one
};

/// Wilson's score interval (Journal of the American Statistical Association 22 (1927) 209): covers
/// the truth as often as it says in the mean over truths. [0, 1] of nothing.
[[nodiscard]] Interval wilson(const Share& share, double confidence = 0.95);
/// Of what a share is more than another, independent one (Newcombe, Statistics in Medicine 17
/// (1998) 873, method 10): from -1 to 1.
[[nodiscard]] Interval newcombe(const Share& one, const Share& other, double confidence = 0.95);

/// The same of two shares of the same pairs (Newcombe, Statistics in Medicine 17 (1998) 2635,
/// method 10): `both` have it, or only the first, or only the second, of `n`.
[[nodiscard]] Interval newcombe_paired(std::uint64_t both, std::uint64_t only_one,
                                       std::uint64_t only_other, std::uint64_t n,
                                       double confidence = 0.95);

/// McNemar's exact test of two shares of the same pairs (Psychometrika 12 (1947) 153): how likely
/// pairs that differ are split as unevenly as this if both shares are the same. In `only_one` pairs
/// the first alone has it, in `only_other` the second. 1 if none differs.
[[nodiscard]] double mcnemar(std::uint64_t only_one, std::uint64_t only_other);

/// Fisher's exact test of two independent shares (Journal of the Royal Statistical Society 85
/// (1922) 87): how likely outcomes at most as likely as this one are, with as many of both
/// together, if both shares are the same.
[[nodiscard]] double fisher(const Share& one, const Share& other);

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

/// The mean of paired differences; 0 if it is rounding.
[[nodiscard]] double mean_difference(const Moments& differences);
/// Of what one mean is more than another, independent one; 0 if it is rounding.
[[nodiscard]] double mean_difference(const Moments& one, const Moments& than);

/// Student's interval of a mean; of paired differences, if those were added. Nothing if it has no
/// bounds: of fewer than two numbers, or if all are the same.
[[nodiscard]] std::optional<Interval> t_interval(const Moments& moments, double confidence = 0.95);
/// Student's test: how likely a mean at least as far from 0 is if the true one is 0. 1 of fewer
/// than two numbers; numbers that are all the same but not 0 give what the sign test gives.
[[nodiscard]] double t_test(const Moments& moments);

/// Of what one mean is more than another, independent one (Welch, Biometrika 34 (1947) 28). Nothing
/// if it has no bounds: of fewer than two numbers, or if all of both are the same.
[[nodiscard]] std::optional<Interval> welch_interval(const Moments& one, const Moments& other,
                                                     double confidence = 0.95);
/// Welch's test: how likely means at least as far apart are if the true ones are the same. 1 of
/// fewer than two numbers; of two numbers alone what a test of ranks gives.
[[nodiscard]] double welch_test(const Moments& one, const Moments& other);

/// A sum over another one of the same runs, such as kills over losses.
class Ratio {
 public:
  void add(double over, double under);

  [[nodiscard]] std::uint64_t n() const { return over_.n(); }
  /// Nothing if what it is divided by is 0.
  [[nodiscard]] std::optional<double> value() const;
  [[nodiscard]] const Moments& under() const { return under_; }
  /// Standard, by linearization, of more than one: if there is a value.
  [[nodiscard]] double error() const;
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
