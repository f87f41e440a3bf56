// SPDX-License-Identifier: MIT
#pragma once
/// \file  What the results in a folder say: cell by cell, and one cell against another.
#include "campaign/measure.hpp"
#include "sql/database.hpp"

namespace eyrie::campaign {

using sql::Database, sql::Statement, sql::sql_name;

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
  std::string hash;    ///< of all results; "" while it is being flown
  std::string ended;   ///< "complete", "part 1/3, interrupted", as Store::finish() was told
  double seconds = 0;  ///< on the clock
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

}  // namespace eyrie::campaign
