// SPDX-License-Identifier: MIT
/// \file  Which factors go with the differences between cells, alone and two together.
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "campaign/summary.hpp"

namespace eyrie::campaign {
namespace {

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
