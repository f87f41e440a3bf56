// SPDX-License-Identifier: MIT
#include "stats/share.hpp"

#include <algorithm>
#include <cmath>

#include "stats/distributions.hpp"

namespace eyrie::stats {

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

}  // namespace eyrie::stats
