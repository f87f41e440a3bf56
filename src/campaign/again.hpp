// SPDX-License-Identifier: MIT
#pragma once
/// \file  Replicates of a campaign flown again, from what is in its database alone.
#include "campaign/engine.hpp"
#include "campaign/summary.hpp"

namespace eyrie::campaign {

class Again {
 public:
  /// The database must outlive it. Plug-ins are opened where `plugins` says. Throws ConfigError if
  /// the campaign in it cannot be read.
  Again(Database& database, const std::vector<std::string>& plugins, unsigned workers);

  struct Flight {
    std::uint64_t cell, replicate, seed;
    std::string hash;  ///< of the last world
  };
  /// Those that ended without a fault, by cell and replicate; `which` is the rest of a query of
  /// `replicates`, with one parameter. Throws disk::Refused if one is of no cell.
  [[nodiscard]] std::vector<Flight> flights(const std::string& which, double parameter);
  /// From any thread.
  [[nodiscard]] std::shared_ptr<const scenario::Scenario> scenario(std::uint64_t cell) {
    return scenarios_->of(cell);
  }
  /// What a cell is made of: the texts by name, which of them is flown, and the overrides by cell.
  [[nodiscard]] const Origin& files() const { return files_; }
  [[nodiscard]] const std::string& file() const { return file_; }
  [[nodiscard]] std::vector<std::vector<std::string>> sets() const;
  /// Throws disk::Refused if a flight that ended with this world is another one now.
  static void demand_the_same(const Flight& flight, std::uint64_t hash);

 private:
  Database& database_;
  Origin files_;
  Spec spec_;
  std::string file_;
  std::vector<Cell> cells_;
  std::optional<Scenarios> scenarios_;
};

}  // namespace eyrie::campaign
