// SPDX-License-Identifier: MIT
/// \file  results.csv, and the rows of other statements as CSV.
#include "campaign/store.hpp"
#include "record/csv.hpp"

namespace eyrie::campaign {

disk::OutputFile table_in(const std::string& folder) {
  return {fmt::format("{}/{}", folder, kTableName), true};
}

std::vector<std::string> columns_of(Database& database, std::string_view table, int first) {
  const Statement all = database.prepare(fmt::format("SELECT * FROM {}", table));
  std::vector<std::string> names;
  for (int i = first; i < all.columns(); ++i)
    names.push_back(all.column_name(i));
  return names;
}

void read_values(const Statement& row, int first, int end, std::vector<double>& values) {
  values.clear();
  for (int i = first; i < end; ++i)
    values.push_back(row.number(i));
}

Statement replicate_rows(Database& database) {
  std::string columns = "r.cell";
  for (const std::string& name : columns_of(database, "cells", 2))
    columns += ", c." + sql_name(name);
  for (const std::string& name : columns_of(database, "replicates", 1))
    columns += ", r." + sql_name(name);
  return database.prepare(fmt::format(
      "SELECT {} FROM replicates r JOIN cells c USING (cell) ORDER BY r.cell, r.replicate",
      columns));
}

void write_table(Database& database, const std::string& folder) {
  Statement rows = replicate_rows(database);
  disk::OutputFile table = table_in(folder);
  write_csv(rows, [&](const std::string& line) { table.sink().write(line); });
  table.commit();
}

void write_csv(Statement& rows, const std::function<void(const std::string&)>& use) {
  std::string line;
  for (int i = 0; i < rows.columns(); ++i)
    line += (i ? "," : "") + record::csv_text(rows.column_name(i));
  bool more = rows.step();  // what fails at once writes nothing
  for (use(line + '\n'); more; more = rows.step()) {
    line.clear();
    for (int i = 0; i < rows.columns(); ++i)
      line += (i ? "," : "") + (rows.is_number(i)  ? fmt::format("{}", rows.number(i))
                                : rows.is_whole(i) ? rows.text(i)
                                                   : record::csv_text(rows.text(i)));
    use(line + '\n');
  }
}

}  // namespace eyrie::campaign
