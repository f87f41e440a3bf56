// SPDX-License-Identifier: MIT
#include "campaign/estimate.hpp"

#include <cmath>

namespace eyrie::campaign {

Estimator::Estimator(const Measure& measure) : column_(measure.column), per_(measure.per) {
  if (measure.kind == Measure::mean)
    sum_ = stats::Moments();
  else if (measure.kind == Measure::ratio)
    sum_ = stats::Ratio();
}

void Estimator::add(std::span<const double> values) {
  if (values.empty() || std::isnan(values[column_]))
    return;
  const double value = values[column_];
  if (auto* share = std::get_if<stats::Share>(&sum_)) {
    share->count += value != 0;
    ++share->n;
  } else if (auto* moments = std::get_if<stats::Moments>(&sum_)) {
    moments->add(value);
  } else if (!std::isnan(values[per_])) {
    std::get<stats::Ratio>(sum_).add(value, values[per_]);
  }
}

Estimate Estimator::estimate(double confidence) const {
  if (const auto* share = std::get_if<stats::Share>(&sum_))
    return {share->n, share->n ? std::optional(share->value()) : std::nullopt,
            stats::wilson(*share, confidence)};
  if (const auto* moments = std::get_if<stats::Moments>(&sum_))
    return {moments->n(), moments->n() ? std::optional(moments->mean()) : std::nullopt,
            stats::t_interval(*moments, confidence)};
  const auto& ratio = std::get<stats::Ratio>(sum_);
  return {ratio.n(), ratio.value(), ratio.fieller(confidence)};
}

}  // namespace eyrie::campaign
