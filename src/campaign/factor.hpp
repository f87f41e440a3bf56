// SPDX-License-Identifier: MIT
#pragma once
/// \file  A factor of a campaign: something of the scenario that differs between its cells.
/// docs/campaigns.md has the format.
#include <cstdint>
#include <optional>
#include <set>

#include "core/value.hpp"

namespace eyrie::campaign {

/// What the values of a factor are drawn from. Numbers are in `unit`, as the file writes them.
struct Distribution {
  enum class Kind : std::uint8_t { uniform, log_uniform, normal };
  Kind kind = Kind::uniform;
  double first = 0;   ///< low, or the mean
  double second = 0;  ///< high, or the standard deviation
  std::string unit;

  /// The value below which a share `u`, in (0, 1), of all lies.
  [[nodiscard]] double quantile(double u) const;
  /// Of what most values lie in.
  [[nodiscard]] double width() const { return kind == Kind::normal ? second : second - first; }
};

/// Of a normal distribution with mean 0 and deviation 1; `u` in (0, 1). Relative error below 1e-14
/// (Wichura, algorithm AS 241, Applied Statistics 37 (1988) 477).
[[nodiscard]] double normal_quantile(double u);

struct Level {
  std::string name;               ///< what is written into the cell
  std::vector<std::string> sets;  ///< `path=value`
  Location where = {};
};

/// It has levels or a distribution.
struct Factor {
  std::string name;
  Location where;
  std::vector<std::string> paths;  ///< into the scenario, as `--set` takes them
  std::vector<Level> levels;
  std::optional<Distribution> distribution;

  /// The level, or the value in six digits (more in a narrow distribution) with its unit, for a
  /// number in (0, 1).
  [[nodiscard]] std::string value_at(double u) const;
  /// Those that any of its values sets, each as it is written.
  [[nodiscard]] std::set<std::string> all_paths() const;
  /// What a value of value_at() sets.
  [[nodiscard]] std::vector<std::string> sets_of(const std::string& value) const;
};

[[nodiscard]] std::vector<Factor> read_factors(const Value& map, Diagnostics& diagnostics);

/// A value on one line, as a file would write it.
[[nodiscard]] std::string yaml_text(const Value& value);

}  // namespace eyrie::campaign
