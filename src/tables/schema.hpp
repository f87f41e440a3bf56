// SPDX-License-Identifier: MIT
#pragma once
/// \file  The tables and views of run.sqlite, described once: for SQL, for its table `units` and
/// for docs/tables.md.
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

}  // namespace eyrie::tables
