// SPDX-License-Identifier: MIT
#include "stats/sample.hpp"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <numeric>

namespace eyrie::stats {
namespace {

// Boost's distributions, reckoned in double. As they come they reckon in long double, which has
// other digits on another CPU, and some that valgrind does not know.
using InDouble = boost::math::policies::policy<boost::math::policies::promote_double<false>>;
using Binomial = boost::math::binomial_distribution<double, InDouble>;
using Normal = boost::math::normal_distribution<double, InDouble>;
using StudentsT = boost::math::students_t_distribution<double, InDouble>;

/// What the difference of two independent means has: its standard error and degrees of freedom.
struct Welch {
  Welch(const Moments& one, const Moments& other) {
    const auto part = [](const Moments& m) { return m.error() * m.error(); };
    const auto freedom = [](const Moments& m) { return static_cast<double>(m.n()) - 1; };
    const double a = part(one), b = part(other);
    error = std::sqrt(a + b);
    free = (a + b) * (a + b) / (a * a / freedom(one) + b * b / freedom(other));
    is_known = one.n() > 1 && other.n() > 1 && !(one.constant() && other.constant());
  }
  double error = 0, free = 1;
  bool is_known = false;
};

double t_of(std::uint64_t n, double confidence) {
  const StudentsT student(static_cast<double>(n - 1));
  return boost::math::quantile(student, (1 + confidence) / 2);
}

}  // namespace

Interval wilson(const Share& share, double confidence) {
  if (!share.n)
    return {};
  const double z = quantile(Normal(), (1 + confidence) / 2);
  const auto n = static_cast<double>(share.n);
  const double p = share.value(), spread = z * z / n;
  const double middle = (p + spread / 2) / (1 + spread);
  const double half = z / (1 + spread) * std::sqrt(p * (1 - p) / n + spread / n / 4);
  return {share.count == 0 ? 0 : std::max(middle - half, 0.0),
          share.count == share.n ? 1 : std::min(middle + half, 1.0)};
}

Interval newcombe(const Share& one, const Share& other, double confidence) {
  const Interval a = wilson(one, confidence), b = wilson(other, confidence);
  const double p = one.value(), q = other.value();
  return {p - q - std::hypot(p - a.low, b.high - q), p - q + std::hypot(a.high - p, q - b.low)};
}

Interval newcombe_paired(std::uint64_t both, std::uint64_t only_one, std::uint64_t only_other,
                         std::uint64_t n, double confidence) {
  if (n == 0)
    return {-1, 1};
  const Share one{both + only_one, n}, other{both + only_other, n};
  const Interval a = wilson(one, confidence), b = wilson(other, confidence);
  const double p = one.value(), q = other.value();
  // how far the two go together, with a correction for continuity where they do
  const double margins = p * (1 - p) * q * (1 - q), pairs = static_cast<double>(n);
  double together = static_cast<double>(both) / pairs - p * q;
  if (together > 0)
    together = std::max(together - 0.5 / pairs, 0.0);
  const double phi = margins > 0 ? together / std::sqrt(margins) : 0;
  const auto reach = [&](double x, double y) {
    return std::sqrt(std::max(x * x - 2 * phi * x * y + y * y, 0.0));
  };
  return {std::max(p - q - reach(p - a.low, b.high - q), -1.0),
          std::min(p - q + reach(a.high - p, q - b.low), 1.0)};
}

double mcnemar(std::uint64_t only_one, std::uint64_t only_other) {
  const Binomial fair(static_cast<double>(only_one + only_other), 0.5);
  return std::min(1.0, 2 * cdf(fair, static_cast<double>(std::min(only_one, only_other))));
}

double fisher(const Share& one, const Share& other) {
  const auto n = static_cast<double>(one.n), m = static_cast<double>(other.n);
  const auto both = static_cast<double>(one.count + other.count);
  const auto seen = static_cast<double>(one.count);
  constexpr double kAlike = 1 + 1e-7;  // as likely but for rounding
  double all = 1, rare = 1;            // in units of how likely what was seen is
  const auto walk = [&](double step) {
    double weight = 1;
    for (double k = seen;; k += step) {
      const double more = step > 0 ? k : k - 1;  // of the first from `more` to one more
      const double up = (n - more) * (both - more) / ((more + 1) * (m - both + more + 1));
      if (!(up > 0) || std::isinf(up))
        return;
      weight *= step > 0 ? up : 1 / up;
      all += weight;
      rare += weight <= kAlike ? weight : 0;
    }
  };
  walk(1);
  walk(-1);
  return std::min(1.0, rare / all);
}

void Moments::add(double x) {
  const double before = x - mean_;
  mean_ += before / static_cast<double>(++n_);
  squares_ += before * (x - mean_);
}

double Share::error() const {
  return std::sqrt(value() * (1 - value()) / static_cast<double>(n - 1));
}

double Moments::error() const {
  return n_ ? std::sqrt(variance() / static_cast<double>(n_)) : 0;
}

double mean_difference(const Moments& differences) {
  const double mean = differences.mean();
  return std::abs(mean) > 1e-12 * differences.error() ? mean : 0;
}

double mean_difference(const Moments& one, const Moments& than) {
  const double difference = one.mean() - than.mean();
  return std::abs(difference) > 1e-12 * std::abs(one.mean()) ? difference : 0;
}

std::optional<Interval> t_interval(const Moments& moments, double confidence) {
  if (moments.n() < 2 || moments.constant())
    return std::nullopt;
  const double half = t_of(moments.n(), confidence) * moments.error();
  return Interval{moments.mean() - half, moments.mean() + half};
}

double t_test(const Moments& moments) {
  if (moments.n() < 2 || moments.mean() == 0)
    return 1;
  if (moments.constant())
    return std::ldexp(2.0, -static_cast<int>(std::min<std::uint64_t>(moments.n(), 2000)));
  const StudentsT student(static_cast<double>(moments.n() - 1));
  return 2 * cdf(complement(student, std::abs(moments.mean()) / moments.error()));
}

std::optional<Interval> welch_interval(const Moments& one, const Moments& other,
                                       double confidence) {
  const Welch both(one, other);
  if (!both.is_known)
    return std::nullopt;
  const double half = both.error * quantile(StudentsT(both.free), (1 + confidence) / 2);
  const double difference = one.mean() - other.mean();
  return Interval{difference - half, difference + half};
}

double welch_test(const Moments& one, const Moments& other) {
  const double difference = std::abs(one.mean() - other.mean());
  if (one.n() < 2 || other.n() < 2 || difference == 0)
    return 1;
  const Welch both(one, other);
  if (!both.is_known)  // all of one above all of the other
    return fisher({one.n(), one.n()}, {0, other.n()});
  return 2 * cdf(complement(StudentsT(both.free), difference / both.error));
}

void Ratio::add(double over, double under) {
  const double before = over - over_.mean();
  over_.add(over);
  under_.add(under);
  products_ += before * (under - under_.mean());
}

std::optional<double> Ratio::value() const {
  return under_.mean() == 0 ? std::nullopt : std::optional(over_.mean() / under_.mean());
}

bool Ratio::divides(double confidence) const {
  return n() > 1 && std::abs(under_.mean()) > t_of(n(), confidence) * under_.error();
}

double Ratio::error() const {
  const double count = static_cast<double>(n()), r = over_.mean() / under_.mean();
  const double covariance = products_ / (count - 1);
  const double variance =
      over_.variance() - 2 * r * covariance + r * r * under_.variance();  // of over - r under
  return std::sqrt(std::max(variance, 0.0) / count) / std::fabs(under_.mean());
}

std::optional<Interval> Ratio::fieller(double confidence) const {
  if (!divides(confidence))
    return std::nullopt;
  // every r for which Student's test of over - r under does not reject 0: a r^2 - 2 b r + c <= 0
  const double t = t_of(n(), confidence), scale = t * t / static_cast<double>(n());
  const double covariance = products_ / static_cast<double>(n() - 1);
  const double y = over_.mean(), x = under_.mean();
  const double a = x * x - scale * under_.variance(), b = x * y - scale * covariance,
               c = y * y - scale * over_.variance();
  const double square = b * b - a * c;
  if (a <= 0 || square <= 1e-14 * b * b)  // or what rounding leaves of 0
    return std::nullopt;
  const double root = std::sqrt(square);
  return Interval{(b - root) / a, (b + root) / a};
}

std::vector<double> holm(std::span<const double> p) {
  std::vector<std::size_t> order(p.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, [&](auto a, auto b) { return p[a] < p[b]; });
  std::vector<double> corrected(p.size());
  double least = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    least = std::max(least, std::min(1.0, p[order[i]] * static_cast<double>(p.size() - i)));
    corrected[order[i]] = least;
  }
  return corrected;
}

}  // namespace eyrie::stats
