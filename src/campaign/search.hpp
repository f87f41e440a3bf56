// SPDX-License-Identifier: MIT
#pragma once
/// \file  A search for the values of a campaign's factors with which a measure is best: in its file
/// `optimize` stands in the place of `design` and `stop`, and `replicates` is how many flights each
/// candidate makes.
#include "campaign/cma_es.hpp"
#include "campaign/engine.hpp"
#include "campaign/summary.hpp"

namespace eyrie::campaign {

enum class Goal : std::uint8_t { maximize, minimize };
constexpr auto names_of(Goal) {
  return names_from_zero<Goal>("maximize", "minimize");
}

struct Search {
  static constexpr std::string_view type_name = "optimize";
  static constexpr std::string_view help = "a search for the values with which a measure is best";
  static constexpr auto params() {
    using S = Search;
    return Lines{
        param("measure", &S::measure, "name of the measure").required(),
        param("goal", &S::goal, "what is better").required(),
        param("generations", &S::generations, range(1, 100'000), "how many are flown"),
        param("population", &S::population, range(4, 10'000),
              "candidates of a generation; without it 4 + 3 ln(factors)"),
        param("proof", &S::proof, range(2, 1'000'000), "flights that show whether it is better"),
        param("seed", &S::seed, "of the draws of candidates")};
  }
  std::string measure;
  Goal goal = Goal::maximize;
  std::uint32_t generations = 40;
  std::optional<std::uint32_t> population;
  std::uint64_t proof = 500, seed = 1;

  Spec spec;                      ///< everything else that the file says
  const Measure* best = nullptr;  ///< of spec

  /// Candidates of a generation fly the same seeds, every generation others, and the proof again
  /// others.
  [[nodiscard]] std::uint64_t seed_of_generation(std::uint64_t generation) const {
    return spec.seeds.first + generation * spec.replicates;
  }
};

/// Throws ConfigError with every mistake that was found.
[[nodiscard]] std::unique_ptr<const Search> parse_search(std::string text, const std::string& file);

/// A campaign that tries the least and the greatest values of each factor, for check().
[[nodiscard]] Spec probe_of(const Search& search);

/// The values of all factors at a point of the search, which has a place for each: half the factor
/// lies below 0.5. Beyond [0, 1] it is reflected (1.1 is 0.9), so that the search knows no bounds.
[[nodiscard]] Cell cell_at(const Search& search, std::span<const double> point);

/// What a search has seen: a line for each candidate, from which it is gone on with.
class SearchLog {
 public:
  /// `origin` is what the search is flown with (its file, the scenario, the program), in any words
  /// of one line. `text` is that of an earlier log, or empty. Throws ConfigError for `file` if it
  /// is of another search.
  SearchLog(const Search& search, std::string_view origin, const std::string& text,
            const std::string& file);

  /// The score of the next candidate if it is in the earlier log. Throws ConfigError if that has
  /// other values, or a score that no flights have.
  struct Seen {
    bool known = false;
    std::optional<double> score{};
  };
  [[nodiscard]] Seen next(std::uint64_t generation, std::size_t candidate, const Cell& cell);
  void add(std::uint64_t generation, std::size_t candidate, const Cell& cell,
           std::optional<double> score);
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::vector<std::string> earlier_;
  std::size_t at_ = 0;  ///< line of `earlier_`
  bool share_;          ///< so is the measure: no score is below 0 or above 1
  std::string file_, text_;
};

/// How a generation went. Of a ratio a score is (sum + 1) / (per + 1): without a loss it is not
/// infinitely good.
struct Generation {
  std::uint64_t number = 0;
  std::size_t best = 0;     ///< candidate
  std::vector<Cell> cells;  ///< of the candidates
  /// Nothing if the scenario refused one, or if none of its flights has the measure.
  std::vector<std::optional<double>> scores;
  double sigma = 0;  ///< with which the next one is drawn
};

struct SearchRun {
  unsigned workers = 1;
  bool (*given_up)() = nullptr;
  /// After each generation that was flown, and not read from the log.
  std::function<void(const Generation&, const SearchLog&)> tell;
  /// For each flight that ended with a fault, which counts for nothing: what happened, and the
  /// command that shows it.
  std::function<void(const std::string& what, const std::string& command)> fault{};
};
struct Winner {
  Cell cell;
  /// Whose best candidate it is, if the scenario refuses the middle of the last one.
  std::optional<std::uint64_t> generation{};
  std::string refusal{};  ///< what the scenario says of the middle
  bool operator==(const Winner&) const = default;
};
/// Flies the generations that the log does not know. Gives the values in the middle of the last
/// one: the best guess, as every score has noise. If the scenario refuses them, the best candidate
/// of the last generation that has one. Nothing if it was given up. Throws ConfigError if no
/// candidate of any generation has a score.
[[nodiscard]] std::optional<Winner> optimize(const Search& search, const Load& load, SearchLog& log,
                                             const SearchRun& run);

/// A measure without and with what was found, on fresh seeds, the same for both.
struct Evidence {
  Measure measure;
  Estimate before, after;
  std::optional<Comparison> difference{};  ///< of after less before, seed by seed
};
/// Of all measures; nothing if it was given up.
[[nodiscard]] std::optional<std::vector<Evidence>> prove(const Search& search, const Cell& found,
                                                         const Load& load, const SearchRun& run);

}  // namespace eyrie::campaign
