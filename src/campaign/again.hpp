// SPDX-License-Identifier: MIT
#pragma once
/// \file  Replicates of a campaign flown again, from what is in its database alone: the ways flown,
/// to be drawn, and what those who were lost decided before, as tables for SQL.
#include <array>

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

/// Of one player.
struct Way {
  std::uint64_t cell = 0, replicate = 0;
  std::string player, side;
  bool lost = false;
  /// m north and east of the reference point; lines between them leave out what is near them.
  std::vector<std::array<double, 2>> places;
};

/// Of the first `count` replicates of each cell, flown again on so many threads. `tell` gets how
/// many of how many, and stops it by false. Throws as Again does.
[[nodiscard]] std::vector<Way> ways_flown(
    const std::string& folder, std::uint64_t count, unsigned workers,
    const std::vector<std::string>& plugins,
    const std::function<bool(std::uint64_t, std::uint64_t)>& tell);

/// A player that was lost.
struct Loss {
  PlayerId who, by{};  ///< by: nobody if it crashed
  double time = 0;     ///< s
};
/// A field of a decision, and somebody who proposed it and did not get it.
struct Contest {
  std::size_t loss = 0;  ///< index
  double time = 0;       ///< s
  std::string field, value, winner;
  bool blended = false;  ///< the winner made it of what it and its rivals said
  std::string rival{};   ///< "" if nobody else proposed it
  float votes = 0, rival_votes = 0;
};
struct LastDecisions {
  std::uint64_t hash = 0;  ///< of the last world
  std::vector<Loss> losses;
  std::vector<Contest> contests;  ///< by loss and time within each step
};
/// Of all players of one flight who were lost: every decision of their last `window` (s).
[[nodiscard]] LastDecisions last_decisions(
    const std::shared_ptr<const scenario::Scenario>& scenario, std::uint64_t seed, double window);

/// Of how many of all replicates without a fault the tables `losses` and `decisions` tell, with the
/// longest window that was asked for; nothing without such tables.
struct LookedAt {
  std::uint64_t replicates, of;
  double window;  ///< s; NaN if none was looked at
};
[[nodiscard]] std::optional<LookedAt> looked_at(Database& database);

/// Fills the tables `losses` and `decisions` of a campaign with those of every replicate, flown
/// again on so many threads from what is in the database; what is there already stays. `tell` gets
/// how many of how many, and stops it by false. Throws disk::Refused if a replicate is another one
/// now.
void add_last_decisions(const std::string& folder, double window, unsigned workers,
                        const std::vector<std::string>& plugins,
                        const std::function<bool(std::uint64_t, std::uint64_t)>& tell);

}  // namespace eyrie::campaign
