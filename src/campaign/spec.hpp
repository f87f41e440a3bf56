// SPDX-License-Identifier: MIT
#pragma once
/// \file  A campaign: what its file says. docs/campaigns.md has the format.
#include "campaign/design.hpp"
#include "campaign/measure.hpp"
#include "core/version.hpp"

namespace eyrie::campaign {

/// Each cell is flown until the interval of a measure is narrow enough.
struct Stopping {
  std::size_t measure = 0;  ///< index into Spec::measures.estimates
  double width = 0;         ///< of the whole interval, in SI
  double confidence = 0.95;
  std::uint64_t least = 100;   ///< replicates of a cell before it is looked at
  std::uint64_t most = 10000;  ///< of a cell
  std::uint64_t every = 50;    ///< replicates from one look to the next
};

/// After which nothing more is begun.
struct Budget {
  static constexpr std::string_view type_name = "budget";
  static constexpr std::string_view help = "when the campaign ends though it is not complete";
  static constexpr auto params() {
    return Lines{param("time", &Budget::time, "s", positive(1e9), "on the clock, of all sessions"),
                 param("replicates", &Budget::replicates, range(1, 1e12), "of all cells")};
  }
  std::optional<double> time;
  std::optional<std::uint64_t> replicates;
};

struct Seeds {
  static constexpr std::string_view type_name = "seeds";
  static constexpr std::string_view help = "which seeds are flown";
  static constexpr auto params() {
    return Lines{
        param("first", &Seeds::first, range(0, 1e15), "of the first replicate; then one by one"),
        param("paired", &Seeds::paired,
              "true: every cell flies the same seeds, so that differences have less noise")};
  }
  std::uint64_t first = 1;
  bool paired = true;
};

/// "1..500" with ".." between them; nothing if it is anything else.
[[nodiscard]] std::optional<std::pair<std::uint64_t, std::uint64_t>> two_numbers(
    std::string_view text, std::string_view between);

/// One of several parts of a campaign that are flown by themselves: one replicate in `of`.
struct Part {
  static constexpr std::uint64_t kMost = 1'000'000;
  std::uint64_t index = 0, of = 1;

  /// Of a cell. The cells begin in turn at parts that lie far from each other (Fibonacci hashing:
  /// Knuth, The Art of Computer Programming 3, 6.4), so that all parts fly about as many.
  [[nodiscard]] std::uint64_t first(std::uint64_t cell) const {
    return (index + of - ((cell * 0x9e3779b9 & 0xffffffff) * of >> 32)) % of;
  }
  /// How many of the first `most` replicates of a cell.
  [[nodiscard]] std::uint64_t count(std::uint64_t cell, std::uint64_t most) const {
    return (most + of - 1 - first(cell)) / of;
  }
  /// "3 of 16"
  [[nodiscard]] std::string text() const {
    return std::to_string(index + 1) + " of " + std::to_string(of);
  }
};

struct Spec {
  static constexpr std::string_view type_name = "campaign";
  static constexpr std::string_view help =
      "many flights of one scenario, and what is asked of them";
  static constexpr std::uint64_t kMostReplicates = 1'000'000'000;  ///< of a cell
  static constexpr auto params() {
    return Lines{
        param("eyrie", &Spec::eyrie, range(kFileFormat, kFileFormat), "version of the file format")
            .required(),
        param("name", &Spec::name, "what the campaign is called").items(1, 100).required(),
        param("help", &Spec::help_text, "one line on what it is for").items(0, 500),
        param("scenario", &Spec::scenario,
              "a scenario of Eyrie by name, or a file *.yaml beside this one")
            .required(),
        param("set", &Spec::sets, "`path=value` for all cells, as `fly --set` takes it"),
        param("plugins", &Spec::plugins, "files of plug-ins, beside this one"),
        param("seeds", &Spec::seeds, "which seeds are flown"),
        param("replicates", &Spec::replicates, range(1, kMostReplicates),
              "of each cell, if `stop` does not say it"),
        param("budget", &Spec::budget, "when it ends though it is not complete")};
  }
  std::string file, text;
  int eyrie = kFileFormat;
  std::string name, help_text, scenario;
  std::vector<std::string> sets, plugins;
  Location scenario_where;  ///< where the file says it
  std::vector<Location> sets_where, plugins_where;
  std::vector<std::string> includes{};  ///< folders that the scenario may include from
  std::vector<Factor> factors;
  Design design;
  Seeds seeds;
  std::uint64_t replicates = 100;
  std::optional<Stopping> stop;
  Measures measures;
  Budget budget;
  Part part;  ///< of the campaign: that is flown
};

/// Throws ConfigError with every mistake that was found.
[[nodiscard]] Spec read_spec(const std::string& file);
/// The same of a text that comes from that file.
[[nodiscard]] Spec parse_spec(std::string text, const std::string& file);

// for other files that hold most of what a campaign does

/// The text of a file; throws ConfigError if there is none.
[[nodiscard]] std::string read_text(const std::string& file);
/// All but `design` and `stop`; the keys `also` are for somebody else. Reports mistakes.
[[nodiscard]] Spec bind_spec(const Value& document, const std::string& file,
                             std::span<const std::string_view> also, Diagnostics& diagnostics);
/// The one that `measure` in a map names; null after reporting that there is none.
[[nodiscard]] const Measure* find_measure(const Measures& measures, const Value& map,
                                          std::string_view owner, Diagnostics& diagnostics);

/// Throws ConfigError if it cannot be flown in parts, as none knows what the others have flown.
void check_parts(const Spec& spec);

[[nodiscard]] std::vector<Cell> cells_of(const Spec& spec);
/// Every override of a cell, those of all cells first, but for what the cell itself sets.
[[nodiscard]] std::vector<std::string> sets_of(const Spec& spec, const Cell& cell);
/// "zone 1.2, crank 44 deg"
[[nodiscard]] std::string cell_text(const Spec& spec, const Cell& cell);
/// How many replicates a cell has at most.
[[nodiscard]] inline std::uint64_t most_replicates(const Spec& spec) {
  return spec.stop ? spec.stop->most : spec.replicates;
}
/// How many replicates the part of a cell has at most.
[[nodiscard]] inline std::uint64_t most_of_part(const Spec& spec, std::uint64_t cell) {
  return spec.part.count(cell, most_replicates(spec));
}
/// Paired: the same over all cells; else no seed is flown twice.
[[nodiscard]] inline std::uint64_t seed_of(const Spec& spec, std::uint64_t cell,
                                           std::uint64_t replicate) {
  return spec.seeds.first + replicate + (spec.seeds.paired ? 0 : cell * most_replicates(spec));
}

using Load =
    std::function<std::shared_ptr<const scenario::Scenario>(const std::vector<std::string>& sets)>;
/// Loads the first cell, and for every factor each of its levels, or its least and greatest value,
/// in place of that of the first cell; the measures are looked for in each. Throws ConfigError that
/// says which level it was.
void check(const Spec& spec, const Load& load);
/// Loads each of the first 2,000 cells, as levels that are right by themselves may not go together.
/// Throws ConfigError that says which cell it was. A cell beyond them that is refused has faults.
void check_cells(const Spec& spec, std::span<const Cell> cells, const Load& load);

}  // namespace eyrie::campaign
