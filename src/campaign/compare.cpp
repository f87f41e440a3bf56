// SPDX-License-Identifier: MIT
#include "campaign/compare.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "campaign/store.hpp"

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
    a.clear();
    b.clear();
    for (int i = kFirstColumn; i < width; ++i) {
      a.push_back(pairs.number(i));
      b.push_back(pairs.number(width + i));
    }
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
  stats::Moments numbers{};  // of a ratio: of its linearization
  stats::Share share{};
  stats::Ratio ratio{};
};

bool is_known(const Measure& m, std::span<const double> values) {
  return !std::isnan(values[m.column]) && (m.kind != Measure::ratio || !std::isnan(values[m.per]));
}
/// A replicate's part in a ratio, in the difference of which it stands for itself.
double part_of(const stats::Ratio& ratio, const Measure& m, std::span<const double> values) {
  const double value = *ratio.value();
  return value + (values[m.column] - value * values[m.per]) / ratio.under().mean();
}

/// Every measure of a cell, faults left out.
std::vector<Alone> alone(Database& database, const std::vector<Measure>& measures, std::size_t cell,
                         double confidence) {
  std::vector<Alone> all(measures.size());
  const auto each = [&](const auto& use) {
    Statement replicates = database.prepare(
        "SELECT * FROM replicates WHERE cell = ? AND outcome <> 'fault' ORDER BY replicate");
    replicates.with(cell);
    std::vector<double> values;
    while (replicates.step()) {
      values.clear();
      for (int i = kFirstColumn; i < replicates.columns(); ++i)
        values.push_back(replicates.number(i));
      for (std::size_t i = 0; i < measures.size(); ++i)
        if (is_known(measures[i], values))
          use(measures[i], all[i], values);
    }
  };
  each([](const Measure& m, Alone& of, std::span<const double> values) {
    if (m.kind == Measure::ratio)
      return of.ratio.add(values[m.column], values[m.per]);
    of.numbers.add(values[m.column]);
    of.share = {of.share.count + (values[m.column] != 0), of.share.n + 1};
  });
  each([&](const Measure& m, Alone& of, std::span<const double> values) {
    if (m.kind == Measure::ratio && of.ratio.divides(confidence))
      of.numbers.add(part_of(of.ratio, m, values));
  });
  return all;
}

std::vector<Comparison> compare_alone(std::span<const Measure> measures, std::span<const Alone> one,
                                      std::span<const Alone> other, double confidence) {
  std::vector<Comparison> all;
  for (std::size_t i = 0; i < measures.size(); ++i) {
    const Alone &a = one[i], &b = other[i];
    if (a.numbers.n() < 2 || b.numbers.n() < 2)
      continue;
    Comparison c{.measure = i, .n = a.numbers.n(), .n_than = b.numbers.n()};
    const bool is_share = measures[i].kind == Measure::share;
    c.value = stats::mean_difference(a.numbers, b.numbers);
    c.interval = is_share ? stats::newcombe(a.share, b.share, confidence)
                          : stats::welch_interval(a.numbers, b.numbers, confidence);
    c.p = is_share ? stats::fisher(a.share, b.share) : stats::welch_test(a.numbers, b.numbers);
    all.push_back(c);
  }
  return all;
}

Comparison compared(const Pairs& pairs, Comparison c, Measure::Kind kind, double confidence) {
  c.n = pairs.differences.n();
  c.value = stats::mean_difference(pairs.differences);
  if (kind == Measure::share) {
    c.interval =
        stats::newcombe_paired(pairs.both, pairs.only_one, pairs.only_other, c.n, confidence);
    c.p = stats::mcnemar(pairs.only_one, pairs.only_other);
  } else {
    c.interval = stats::t_interval(pairs.differences, confidence);
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

/// The number that a value begins with: "2200 kg".
std::optional<double> number_of(const std::string& text) {
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  return end != text.c_str() && std::isfinite(number) ? std::optional(number) : std::nullopt;
}

/// What is behind it: " kg".
std::string unit_of(const std::string& text) {
  char* end = nullptr;
  std::strtod(text.c_str(), &end);
  return end;
}

/// The level of each cell: what the factor is there, or a bin of numbers that were drawn.
std::vector<std::string> levels_of(const Summary& summary, std::size_t factor) {
  constexpr std::size_t kMostLevels = 10, kBins = 8;
  std::vector<std::string> levels;
  std::map<double, std::string> bins;  // by number, each once, so that none cuts through equal ones
  bool all_numbers = true;
  for (const auto& cell : summary.cells) {
    levels.push_back(cell.values[factor]);
    const auto number = number_of(levels.back());
    all_numbers &= number.has_value() && unit_of(levels.back()) == unit_of(levels.front());
    bins.emplace(number.value_or(0), levels.back());
  }
  // levels come again with those of other factors; of those that do not each would explain its cell
  if (!all_numbers || bins.size() <= kMostLevels || 2 * bins.size() <= levels.size())
    return levels;
  const std::size_t n = bins.size();
  auto end = bins.begin();
  for (std::size_t bin = 0; bin < kBins; ++bin) {
    const auto begin = std::exchange(
        end, std::next(end, static_cast<std::ptrdiff_t>((bin + 1) * n / kBins - bin * n / kBins)));
    const std::string name = begin->second + " to " + std::prev(end)->second;
    std::for_each(begin, end, [&](auto& number) { number.second = name; });
  }
  for (std::string& level : levels)
    level = bins.at(*number_of(level));
  return levels;
}

std::vector<std::vector<std::string>> all_levels(const Summary& summary) {
  std::vector<std::vector<std::string>> levels;
  for (std::size_t f = 0; f < summary.factors.size(); ++f)
    levels.push_back(levels_of(summary, f));
  return levels;
}

/// Between cells, of a measure: what their levels explain.
struct Variance {
  std::map<std::string, stats::Moments> by_level{};
  double part = 0, total = 0;        ///< of the squares about the mean
  std::uint64_t n = 0;               ///< cells
  std::vector<std::string> order{};  ///< levels by first appearance
};
Variance variance(const Summary& summary, std::size_t measure,
                  const std::vector<std::string>& levels) {
  Variance v;
  stats::Moments all;
  for (std::size_t c = 0; c < summary.cells.size(); ++c)
    if (const auto& value = summary.cells[c].estimates[measure].value) {
      if (!v.by_level.contains(levels[c]))
        v.order.push_back(levels[c]);
      v.by_level[levels[c]].add(*value);
      all.add(*value);
    }
  double between = 0;
  for (const auto& [level, moments] : v.by_level) {
    const double off = moments.mean() - all.mean();
    between += static_cast<double>(moments.n()) * off * off;
  }
  v.n = all.n();
  v.total = all.variance() * static_cast<double>(all.n() > 0 ? all.n() - 1 : 0);
  v.part = v.total > 0 ? between / v.total : 0;
  return v;
}

/// What both factors explain together, if every combination of their levels is in as many cells.
std::optional<Variance> crossed(const Summary& summary, std::size_t measure,
                                const std::vector<std::string>& one,
                                const std::vector<std::string>& other) {
  std::vector<std::string> both = one;
  for (std::size_t c = 0; c < both.size(); ++c)
    both[c] += '\n' + other[c];
  Variance v = variance(summary, measure, both);
  const auto count = [&](const auto& levels) {
    return variance(summary, measure, levels).by_level.size();
  };
  const bool balanced = v.by_level.size() == count(one) * count(other) &&
                        std::ranges::all_of(v.by_level, [&](const auto& level) {
                          return level.second.n() == v.by_level.begin()->second.n();
                        });
  return balanced ? std::optional(std::move(v)) : std::nullopt;
}

/// What chance has in the mean of a cell's square, by the standard errors of all; nothing if they
/// are not known.
std::optional<double> noise(const Summary& summary, std::size_t measure) {
  stats::Moments squares;
  for (const auto& cell : summary.cells)
    if (const Estimate& of = cell.estimates[measure]; of.value) {
      if (!of.error)
        return {};
      squares.add(*of.error * *of.error);
    }
  return squares.mean();
}

/// Takes from the part of each factor what its levels would have by chance: as many times their
/// degrees of freedom as each one has that nothing explains. Crossed factors do not take from each
/// other, so that what is left is what all of them leave.
void subtract_chance(std::vector<Variance>& factors, bool all_crossed) {
  double left = 1, free = -1;
  for (const Variance& v : factors) {
    left -= v.part;
    free += 1 - static_cast<double>(v.by_level.size());
  }
  for (Variance& v : factors) {
    if (v.n == 0)  // no cell has a value, so there is nothing to explain
      continue;
    const double levels = static_cast<double>(v.by_level.size()), n = static_cast<double>(v.n);
    const double unexplained = all_crossed ? left : 1 - v.part;
    const double freedom = all_crossed ? n + free : n - levels;
    v.part = freedom > 0 ? std::max(v.part - (levels - 1) * unexplained / freedom, 0.0) : 0;
  }
}

}  // namespace

std::vector<Comparison> compare_pairs(std::span<const Measure> measures,
                                      const std::function<void(const TakePair&)>& each,
                                      double confidence) {
  std::vector<Pairs> all(measures.size());
  each([&](const auto& a, const auto& b) {
    for (std::size_t i = 0; i < measures.size(); ++i) {
      const Measure& m = measures[i];
      if (!is_known(m, a) || !is_known(m, b))
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
  const auto has_ratio = [&](std::size_t i) {
    return measures[i].kind == Measure::ratio && all[i].ratios[0].divides(confidence) &&
           all[i].ratios[1].divides(confidence);
  };
  std::vector<std::size_t> ratios;
  for (std::size_t i = 0; i < measures.size(); ++i)
    if (has_ratio(i))
      ratios.push_back(i);
  if (!ratios.empty())  // now that both ratios are known, each replicate's part in their difference
    each([&](const auto& a, const auto& b) {
      for (const std::size_t i : ratios) {
        const Measure& m = measures[i];
        if (!is_known(m, a) || !is_known(m, b))
          continue;
        Pairs& pairs = all[i];
        pairs.differences.add(part_of(pairs.ratios[0], m, a) - part_of(pairs.ratios[1], m, b));
      }
    });
  std::vector<Comparison> comparisons;
  for (std::size_t i = 0; i < measures.size(); ++i)
    if (all[i].differences.n() > 1)
      comparisons.push_back(compared(all[i], {.measure = i}, measures[i].kind, confidence));
  return comparisons;
}

std::vector<Comparison> compare(const std::string& folder, const Summary& summary,
                                std::optional<std::size_t> measure, double confidence) {
  constexpr std::size_t kAllPairs = 6;
  Database database = open_results(folder);
  std::vector<Comparison> all;
  const std::size_t n = summary.cells.size();
  std::vector<std::vector<Alone>> cells;
  for (std::size_t cell = 0; cell < (summary.paired ? 0 : n); ++cell)
    cells.push_back(alone(database, summary.measures, cell, confidence));
  const auto comparisons = [&](std::size_t cell, std::size_t than) {
    if (!summary.paired)
      return compare_alone(summary.measures, cells[cell], cells[than], confidence);
    return compare_pairs(
        summary.measures, [&](const TakePair& use) { each_pair(database, cell, than, use); },
        confidence);
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

std::vector<Effect> effects(const Summary& summary) {
  std::vector<Effect> all;
  const auto levels = all_levels(summary);
  for (std::size_t m = 0; m < summary.measures.size(); ++m) {
    std::vector<Variance> factors;
    bool all_crossed = true;
    for (std::size_t f = 0; f < levels.size(); ++f) {
      factors.push_back(variance(summary, m, levels[f]));
      for (std::size_t other = 0; other < f; ++other)
        all_crossed = all_crossed && crossed(summary, m, levels[f], levels[other]);
    }
    subtract_chance(factors, all_crossed);
    std::vector<Effect> some;
    for (std::size_t f = 0; f < levels.size(); ++f) {
      const Variance& v = factors[f];
      Effect effect{.measure = m, .factor = f, .part = v.part};
      for (const std::string& level : v.order) {
        const stats::Moments& moments = v.by_level.at(level);
        effect.levels.push_back({level, static_cast<std::size_t>(moments.n()), moments.mean()});
      }
      std::ranges::stable_sort(
          effect.levels, {}, [](const Effect::Level& l) { return number_of(l.name).value_or(0); });
      if (v.part > 1e-12)  // more than rounding
        some.push_back(std::move(effect));
    }
    std::ranges::stable_sort(some, std::ranges::greater(), &Effect::part);
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

std::vector<Interaction> interactions(const Summary& summary) {
  std::vector<Interaction> all;
  const auto levels = all_levels(summary);
  for (std::size_t m = 0; m < summary.measures.size(); ++m) {
    std::vector<Variance> alone;
    for (const auto& of_factor : levels)
      alone.push_back(variance(summary, m, of_factor));
    const auto freedom = [&](std::size_t f) {
      return static_cast<double>(alone[f].by_level.size()) - 1;
    };
    std::vector<Interaction> some;
    std::vector<bool> takes_part(levels.size());
    double left = 1, free = -1;  // what nothing explains, and its degrees of freedom
    for (std::size_t a = 0; a < levels.size(); ++a)
      for (std::size_t b = a + 1; b < levels.size(); ++b)
        if (const auto both = crossed(summary, m, levels[a], levels[b])) {
          some.push_back({m, a, b, both->part - alone[a].part - alone[b].part});
          takes_part[a] = takes_part[b] = true;
          left -= some.back().part;
          free -= freedom(a) * freedom(b);
        }
    for (std::size_t f = 0; f < levels.size(); ++f)
      if (takes_part[f]) {
        left -= alone[f].part;
        free -= freedom(f);
      }
    if (!alone.empty())
      free += static_cast<double>(alone[0].n);
    if (free < 0)  // more together than there are cells: each would explain what the others do
      continue;
    // what is left tells chance; where nothing is, the replicates in the cells do
    const auto chance = free > 0 ? std::optional(std::max(left, 0.0) / free) : noise(summary, m);
    if (!chance)
      continue;
    for (Interaction& i : some) {
      const double of_total = free > 0 ? 1 : 1 / alone[i.one].total;
      i.part -= freedom(i.one) * freedom(i.other) * *chance * of_total;
      if (i.part > 1e-12)  // more than rounding
        all.push_back(i);
    }
  }
  return all;
}

}  // namespace eyrie::campaign
