// SPDX-License-Identifier: MIT
/// \file  Cells against each other.
#include <algorithm>

#include "campaign/store.hpp"
#include "campaign/summary.hpp"

namespace eyrie::campaign {
namespace {

/// Of each replicate that both cells have.
void each_pair(Database& database, std::size_t one, std::size_t other, const TakePair& use) {
  Statement pairs = database.prepare(
      "SELECT a.*, b.* FROM replicates a JOIN replicates b ON b.replicate = a.replicate WHERE "
      "a.cell = ? AND b.cell = ? AND a.outcome <> 'fault' AND b.outcome <> 'fault' "
      "ORDER BY a.replicate");
  pairs.with(one, other);
  const int width = pairs.columns() / 2;
  std::vector<double> a, b;
  while (pairs.step()) {
    read_values(pairs, kFirstColumn, width, a);
    read_values(pairs, width + kFirstColumn, 2 * width, b);
    use(a, b);
  }
}

/// The paired differences of a measure.
struct Pairs {
  stats::Moments differences{};
  std::uint64_t both = 0, only_one = 0, only_other = 0;  // of shares
  std::array<stats::Ratio, 2> ratios{};                  // of both cells
};

/// A measure of a cell by itself.
struct Alone {
  Estimator sums;
  stats::Moments numbers{};  // of a ratio: of its linearization
};

/// A replicate's part in a ratio, in the difference of which it stands for itself.
double part_of(const stats::Ratio& ratio, const Measure& m, std::span<const double> values) {
  const double value = *ratio.value();
  return value + (values[m.column] - value * values[m.per]) / ratio.under().mean();
}

/// Every measure of a cell, faults left out.
std::vector<Alone> alone(Database& database, const std::vector<Measure>& measures,
                         std::size_t cell) {
  std::vector<Alone> all;
  for (const Measure& m : measures)
    all.push_back({Estimator(m)});
  const auto each = [&](const auto& use) {
    Statement replicates = database.prepare(
        "SELECT * FROM replicates WHERE cell = ? AND outcome <> 'fault' ORDER BY replicate");
    replicates.with(cell);
    std::vector<double> values;
    while (replicates.step()) {
      read_values(replicates, kFirstColumn, replicates.columns(), values);
      for (std::size_t i = 0; i < measures.size(); ++i)
        if (measures[i].applies(values))
          use(measures[i], all[i], values);
    }
  };
  each([](const Measure&, Alone& of, const auto& values) { of.sums.add(values); });
  each([](const Measure& m, Alone& of, const auto& values) {
    if (m.kind != Measure::ratio)
      of.numbers.add(values[m.column]);
    else if (of.sums.ratio().divides())
      of.numbers.add(part_of(of.sums.ratio(), m, values));
  });
  return all;
}

std::vector<Comparison> compare_alone(std::span<const Measure> measures, std::span<const Alone> one,
                                      std::span<const Alone> other) {
  std::vector<Comparison> all;
  for (std::size_t i = 0; i < measures.size(); ++i) {
    const Alone &a = one[i], &b = other[i];
    if (a.numbers.n() < 2 || b.numbers.n() < 2)
      continue;
    Comparison c{.measure = i, .n = a.numbers.n(), .n_than = b.numbers.n()};
    const bool is_share = measures[i].kind == Measure::share;
    c.value = stats::mean_difference(a.numbers, b.numbers);
    c.interval = is_share ? stats::newcombe(a.sums.share(), b.sums.share())
                          : stats::welch_interval(a.numbers, b.numbers);
    c.p = is_share ? stats::fisher(a.sums.share(), b.sums.share())
                   : stats::welch_test(a.numbers, b.numbers);
    all.push_back(c);
  }
  return all;
}

Comparison compared(const Pairs& pairs, Comparison c, Measure::Kind kind) {
  c.n = pairs.differences.n();
  c.value = stats::mean_difference(pairs.differences);
  if (kind == Measure::share) {
    c.interval = stats::newcombe_paired(pairs.both, pairs.only_one, pairs.only_other, c.n);
    c.p = stats::mcnemar(pairs.only_one, pairs.only_other);
  } else {
    c.interval = stats::t_interval(pairs.differences);
    c.p = stats::t_test(pairs.differences);
  }
  return c;
}

void correct(std::vector<Comparison>& comparisons, std::size_t measures) {
  for (std::size_t m = 0; m < measures; ++m) {
    std::vector<Comparison*> family;
    std::vector<double> p;
    for (Comparison& c : comparisons)
      if (c.measure == m) {
        family.push_back(&c);
        p.push_back(c.p);
      }
    const auto corrected = stats::holm(p);
    for (std::size_t i = 0; i < family.size(); ++i)
      family[i]->holm = corrected[i];
  }
}

}  // namespace

std::vector<Comparison> compare_pairs(std::span<const Measure> measures,
                                      const std::function<void(const TakePair&)>& each) {
  std::vector<Pairs> all(measures.size());
  each([&](const auto& a, const auto& b) {
    for (std::size_t i = 0; i < measures.size(); ++i) {
      const Measure& m = measures[i];
      if (!m.applies(a) || !m.applies(b))
        continue;
      Pairs& pairs = all[i];
      if (m.kind == Measure::ratio) {
        pairs.ratios[0].add(a[m.column], a[m.per]);
        pairs.ratios[1].add(b[m.column], b[m.per]);
        continue;
      }
      pairs.differences.add(a[m.column] - b[m.column]);
      pairs.both += a[m.column] != 0 && b[m.column] != 0;
      pairs.only_one += a[m.column] != 0 && b[m.column] == 0;
      pairs.only_other += a[m.column] == 0 && b[m.column] != 0;
    }
  });
  std::vector<std::size_t> ratios;
  for (std::size_t i = 0; i < measures.size(); ++i)
    if (measures[i].kind == Measure::ratio &&
        std::ranges::all_of(all[i].ratios, [](const stats::Ratio& r) { return r.divides(); }))
      ratios.push_back(i);
  if (!ratios.empty())  // now that both ratios are known, each replicate's part in their difference
    each([&](const auto& a, const auto& b) {
      for (const std::size_t i : ratios) {
        const Measure& m = measures[i];
        if (!m.applies(a) || !m.applies(b))
          continue;
        Pairs& pairs = all[i];
        pairs.differences.add(part_of(pairs.ratios[0], m, a) - part_of(pairs.ratios[1], m, b));
      }
    });
  std::vector<Comparison> comparisons;
  for (std::size_t i = 0; i < measures.size(); ++i)
    if (all[i].differences.n() > 1)
      comparisons.push_back(compared(all[i], {.measure = i}, measures[i].kind));
  return comparisons;
}

std::vector<Comparison> compare(const std::string& folder, const Summary& summary,
                                std::optional<std::size_t> measure) {
  constexpr std::size_t kAllPairs = 6;
  Database database = open_results(folder);
  std::vector<Comparison> all;
  const std::size_t n = summary.cells.size();
  std::vector<std::vector<Alone>> cells;
  for (std::size_t cell = 0; cell < (summary.paired ? 0 : n); ++cell)
    cells.push_back(alone(database, summary.measures, cell));
  const auto comparisons = [&](std::size_t cell, std::size_t than) {
    if (!summary.paired)
      return compare_alone(summary.measures, cells[cell], cells[than]);
    return compare_pairs(summary.measures,
                         [&](const TakePair& use) { each_pair(database, cell, than, use); });
  };
  for (std::size_t than = 0; than < (measure || n <= kAllPairs ? n : 1); ++than)
    for (std::size_t cell = than + 1; cell < n; ++cell)
      for (Comparison& c : comparisons(cell, than))
        if (!measure || c.measure == *measure) {
          c.cell = cell;
          c.than = than;
          all.push_back(c);
        }
  correct(all, summary.measures.size());
  return all;
}

}  // namespace eyrie::campaign
