// SPDX-License-Identifier: MIT
#pragma once
/// \file  A run as one SQLite file: its tables and views, described once for SQL, for its table
/// `units` and for docs/tables.md.
#include "tables/decision_rows.hpp"

namespace eyrie::tables {

struct TableColumn {
  std::string name;  ///< "altitude_m"
  std::string type;  ///< of SQL; "" in a view
  std::string unit;  ///< "" for none
  std::string help;
};
struct Table {
  std::string name;
  std::string help;
  std::vector<TableColumn> columns;
  std::string keys = ")";  ///< what stands behind the columns, and after them
  std::string query{};     ///< of a view; "": a table
};

/// In the order in which they are made. `step` (s) is that of the simulation.
[[nodiscard]] std::vector<Table> tables_of(std::span<const ActionColumn> columns, double step);
[[nodiscard]] std::string create(const Table& table);
/// "INSERT INTO players VALUES (?, nullif(?, ''), ...)": no text is NULL.
[[nodiscard]] std::string insert(const Table& table);

/// docs/tables.md, with the actions of aircraft and vehicles.
[[nodiscard]] std::string tables_markdown();

/// Flies the run again and gives the bytes of a database with everything in it, docs/tables.md.
/// Nothing if `stop`, which is asked in every step, ended the work. The same run gives the same
/// bytes with the same version of SQLite. Text is as on a terminal, so it is UTF-8 whatever the
/// run's names are.
[[nodiscard]] std::optional<std::string> run_database(const debrief::Recorded& recorded,
                                                      const Selection& selection,
                                                      const std::function<bool()>& stop);

}  // namespace eyrie::tables
