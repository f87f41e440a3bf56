// SPDX-License-Identifier: MIT
#include "core/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace eyrie {
namespace {

constexpr std::size_t kMostBuckets = 1024;

std::optional<std::string> not_finite(std::span<const double> values) {
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!std::isfinite(values[i]))
      return fmt::format("value {} is {}", i + 1, values[i]);
  return std::nullopt;
}

void refuse(const std::optional<std::string>& problem) {
  EYRIE_THROW_UNLESS(!problem, problem->c_str());
}

}  // namespace

std::optional<std::string> Axis::problem(std::span<const double> breakpoints) {
  if (breakpoints.empty())
    return "there is no breakpoint";
  for (std::size_t i = 0; i < breakpoints.size(); ++i) {
    if (!std::isfinite(breakpoints[i]))
      return fmt::format("breakpoint {} is {}", i + 1, breakpoints[i]);
    if (i > 0 && breakpoints[i] <= breakpoints[i - 1])
      return fmt::format("breakpoints must increase: number {} ({}) is not above number {} ({})",
                         i + 1, breakpoints[i], i, breakpoints[i - 1]);
  }
  const double range = breakpoints.back() - breakpoints.front();
  if (breakpoints.size() > 1 && !(range > 1e-200 && range < 1e200))
    return "the breakpoints are too close together or too far apart";
  return std::nullopt;
}

Axis::Axis(std::vector<double> breakpoints) : breakpoints_(std::move(breakpoints)) {
  refuse(problem(breakpoints_));
  if (size() < 2)
    return;
  // equal buckets, so narrow that each holds one breakpoint at most
  double narrowest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < size(); ++i)
    narrowest = std::min(narrowest, breakpoints_[i] - breakpoints_[i - 1]);
  const double range = breakpoints_.back() - breakpoints_.front();
  const double wanted = std::min(std::ceil(range / narrowest), static_cast<double>(kMostBuckets));
  per_bucket_ = wanted / range;
  // bucket() never falls as x rises, so all of a bucket lies above the breakpoints of earlier ones
  first_cell_.assign(bucket(breakpoints_.back()) + 1, 0);
  for (std::size_t i = 0; i + 1 < size(); ++i)
    for (std::size_t b = bucket(breakpoints_[i]) + 1; b < first_cell_.size(); ++b)
      first_cell_[b] = static_cast<std::uint32_t>(i);
}

std::optional<std::string> Table1::problem(std::span<const double> breakpoints,
                                           std::span<const double> values) {
  if (auto wrong = Axis::problem(breakpoints))
    return wrong;
  if (values.size() != breakpoints.size())
    return fmt::format("{} breakpoints need as many values, not {}", breakpoints.size(),
                       values.size());
  return not_finite(values);
}

Table1::Table1(std::vector<double> breakpoints, std::vector<double> values) {
  refuse(problem(breakpoints, values));
  axis_ = Axis(std::move(breakpoints));
  values_ = std::move(values);
}

std::optional<std::string> Table2::problem(std::span<const double> rows,
                                           std::span<const double> columns,
                                           std::span<const double> values) {
  if (auto wrong = Axis::problem(rows))
    return "rows: " + *wrong;
  if (auto wrong = Axis::problem(columns))
    return "columns: " + *wrong;
  if (values.size() != rows.size() * columns.size())
    return fmt::format("{} by {} breakpoints need {} values, not {}", rows.size(), columns.size(),
                       rows.size() * columns.size(), values.size());
  return not_finite(values);
}

Table2::Table2(std::vector<double> rows, std::vector<double> columns, std::vector<double> values) {
  refuse(problem(rows, columns, values));
  rows_ = Axis(std::move(rows));
  columns_ = Axis(std::move(columns));
  values_ = std::move(values);
}

double Table2::operator()(double row, double column) const {
  const TableCell r = rows_.cell(row), c = columns_.cell(column);
  const double* const low = &values_[r.index * columns_.size()];
  const double* const high = &values_[std::min(r.index + 1, rows_.size() - 1) * columns_.size()];
  const std::size_t next = std::min(c.index + 1, columns_.size() - 1);
  return detail::mix(detail::mix(low[c.index], low[next], c.fraction),
                     detail::mix(high[c.index], high[next], c.fraction), r.fraction);
}

}  // namespace eyrie
