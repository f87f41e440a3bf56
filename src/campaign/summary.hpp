// SPDX-License-Identifier: MIT
#pragma once
/// \file  What the results in a folder say: cell by cell, one cell against another, and which
/// factor matters.
#include "campaign/measure.hpp"

namespace eyrie::campaign {

/// The results of a campaign, read from its database alone.
struct Summary {
  struct OfCell {
    std::vector<std::string> values;  ///< by factor
    std::string command;              ///< that flies it, without the seed
    std::uint64_t replicates = 0, faults = 0;
    std::vector<Estimate> estimates;  ///< by measure
  };
  struct Fault {
    std::uint64_t cell = 0, seed = 0;
    std::string what, command;
  };

  std::string name, scenario;
  std::string hash;   ///< of all results; "" while it is being flown
  std::string ended;  ///< "complete", "part 1/3, interrupted", as Store::finish() was told
  std::vector<std::string> factors;
  std::vector<Measure> measures;
  std::vector<std::string> units;  ///< by measure
  std::vector<OfCell> cells;
  std::vector<Fault> faults;  ///< the first ones
  bool paired = true;         ///< all cells fly the same seeds
};

[[nodiscard]] Summary read_summary(const std::string& folder, double confidence = 0.95);

/// "45.0 % (31.0 to 60.2)", "2.31 (2.1 to 2.52)", "2 (no bounds)", "-" where there is none.
[[nodiscard]] std::string estimate_text(const Estimate& estimate, Measure::Kind kind);

/// A measure of one cell less that of another. Of paired seeds replicate by replicate, which share
/// most of their noise: shares are tested by McNemar's exact test, means and ratios by Student's, a
/// ratio by its linearization (Cochran, Sampling Techniques, 3rd edition, 1977, 6.3). Of others as
/// what they are, independent: by Fisher's exact test and by Welch's. There is none of fewer than
/// two replicates, or where what a ratio is divided by may as well be 0.
struct Comparison {
  std::size_t cell = 0, than = 0, measure = 0;
  std::uint64_t n = 0;       ///< pairs, or replicates of the cell
  std::uint64_t n_than = 0;  ///< replicates of the other one if they are not paired
  double value = 0;
  std::optional<stats::Interval> interval{};  ///< nothing if it has no bounds
  double p = 1;
  double holm = 1;  ///< p, corrected for all comparisons of the measure
};

/// Takes the values of a replicate in one cell and those of the same one in the other, by column.
using TakePair =
    std::function<void(const std::vector<double>& one, const std::vector<double>& other)>;
/// Of all measures that have a comparison, in their order. `each` gives every pair, and is asked
/// again if there are ratios.
[[nodiscard]] std::vector<Comparison> compare_pairs(
    std::span<const Measure> measures, const std::function<void(const TakePair&)>& each);

/// Of one measure for all pairs of cells; of every measure if none is given, and then for all pairs
/// if there are at most 6 cells, else of each cell with the first.
[[nodiscard]] std::vector<Comparison> compare(const std::string& folder, const Summary& summary,
                                              std::optional<std::size_t> measure = {});

/// What the levels of a factor do to a measure, over all cells that have it.
struct Effect {
  std::size_t measure = 0, factor = 0;
  /// The part of the variance between cells that goes with the factor alone (first-order index from
  /// given data: Plischke, Borgonovo, Smith, European Journal of Operational Research 226 (2013)
  /// 536), less what levels that do nothing would have of it in the mean (Kelley's epsilon squared,
  /// Proceedings of the National Academy of Sciences 21 (1935) 554). With few cells still by
  /// chance.
  double part = 0;
  struct Level {
    std::string name;
    std::size_t cells = 0;
    double mean = 0;  ///< over its cells
  };
  std::vector<Level> levels;  ///< of numbers with many values: bins
};
/// By measure, the factor that matters most first. None of a measure that is the same in all cells,
/// nor of a factor of which each cell has another level.
[[nodiscard]] std::vector<Effect> effects(const Summary& summary);

/// What two factors do together beyond what each does alone, as a part of the variance between
/// cells, less what chance would have of it as with effects. Only where every combination of their
/// levels is flown by as many cells, and if all such pairs together have fewer degrees of freedom
/// than there are cells.
struct Interaction {
  std::size_t measure = 0, one = 0, other = 0;
  double part = 0;
};
[[nodiscard]] std::vector<Interaction> interactions(const Summary& summary);

}  // namespace eyrie::campaign
