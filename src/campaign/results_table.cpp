// SPDX-License-Identifier: MIT
/// \file  The table of the results as CSV, as are the rows of other statements, and as Parquet.
#include <dlfcn.h>
#include <fmt/ranges.h>

#include <cstdio>

#include "campaign/store.hpp"
#include "record/event_table.hpp"

namespace eyrie::campaign {
namespace {

/// Each replicate with the factors of its cell: cell, factors, and the columns of `replicates`.
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

/// Numbers as they are, and what `quoted` makes of texts.
template <class Quoted>
std::string csv_line(const Statement& row, Quoted quoted) {
  std::string line;
  for (int i = 0; i < row.columns(); ++i)
    line += (i ? "," : "") + (row.is_number(i)  ? fmt::format("{}", row.number(i))
                              : row.is_whole(i) ? row.text(i)
                              : row.is_null(i)  ? ""
                                                : quoted(row.text(i)));
  return line + '\n';
}

}  // namespace

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

void write_table(Database& database, const std::string& folder) {
  Statement rows = replicate_rows(database);
  disk::OutputFile table = table_in(folder);
  write_csv(rows, [&](const std::string& line) { table.sink().write(line); });
  table.commit();
}

void write_csv(Statement& rows, const std::function<void(const std::string&)>& use) {
  std::string names;
  for (int i = 0; i < rows.columns(); ++i)
    names += (i ? "," : "") + record::csv_text(rows.column_name(i));
  bool more = rows.step();  // what fails at once writes nothing
  for (use(names + '\n'); more; more = rows.step())
    use(csv_line(rows, record::csv_text));
}

namespace {

/// "'name': 'TYPE'" in DuckDB's words for each column of a table from the one numbered `first` on.
void add_columns(Database& database, const char* table, int first, std::vector<std::string>& all) {
  Statement columns = database.prepare(
      "SELECT name, CASE type WHEN 'INTEGER' THEN 'BIGINT' WHEN 'TEXT' THEN 'VARCHAR' ELSE "
      "'DOUBLE' END FROM pragma_table_info(?) WHERE cid >= ?");
  columns.with(std::string_view(table), std::int64_t{first});
  while (columns.step())
    all.push_back(fmt::format("{}: '{}'", sql_name(columns.text(0), '\''), columns.text(1)));
}

/// Every text in quotation marks, so that one of no letters is not nothing. False if it fails.
bool write_rows(Database& database, std::FILE* file) {
  Statement rows = replicate_rows(database);
  while (rows.step()) {
    const std::string line = csv_line(rows, [](const auto& text) { return sql_name(text); });
    std::fwrite(line.data(), 1, line.size(), file);
  }
  return std::fflush(file) == 0 && std::ferror(file) == 0;
}

/// A database of DuckDB by its C interface, which keeps it
/// (https://duckdb.org/docs/stable/clients/c/api).
class DuckDb {
 public:
  explicit DuckDb(const std::string& library) {
    const auto refuse = [](const std::string& why) {
      throw disk::Refused(
          "Parquet is written by DuckDB's library: {}. 'npm install "
          "@duckdb/node-bindings-linux-x64' (or -arm64) gets it; then say EYRIE_DUCKDB="
          "node_modules/@duckdb/node-bindings-linux-x64/libduckdb.so",
          why);
    };
    void* const opened = ::dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!opened)
      refuse(::dlerror());
    const auto find = [&]<class Call>(Call& call, const char* name) {
      call = reinterpret_cast<Call>(::dlsym(opened, name));
      if (!call)
        refuse(fmt::format("{} has no {}", library, name));
    };
    find(open_, "duckdb_open");
    find(connect_, "duckdb_connect");
    find(query_, "duckdb_query");
    find(error_, "duckdb_result_error");
    find(destroy_, "duckdb_destroy_result");
    find(disconnect_, "duckdb_disconnect");
    find(close_, "duckdb_close");
    if (open_(nullptr, &database_) || connect_(database_, &connection_))
      refuse(library + " does not open a database");
  }
  ~DuckDb() {
    disconnect_(&connection_);
    close_(&database_);
  }
  void run(const std::string& sql) {
    QueryResult result{};
    const bool failed = query_(connection_, sql.c_str(), &result) != 0;
    const char* const words = error_(&result);
    const std::string why = words ? words : "DuckDB does not say why";
    destroy_(&result);
    if (failed)
      throw disk::Failed("no {}: {}", kParquetName, why);
  }

 private:
  struct QueryResult {
    std::uint64_t columns, rows, changed;
    void* column_data;
    char* error;
    void* internal;
  };
  int (*open_)(const char* file, void** database);
  int (*connect_)(void* database, void** connection);
  int (*query_)(void* connection, const char* sql, QueryResult* result);
  const char* (*error_)(QueryResult* result);
  void (*destroy_)(QueryResult* result);
  void (*disconnect_)(void** connection);
  void (*close_)(void** database);
  void* database_ = nullptr;
  void* connection_ = nullptr;
};

}  // namespace

WriteParquet open_parquet(const std::string& library) {
  return [duckdb = std::make_shared<DuckDb>(library)](Database& database, disk::OutputFile& file) {
    std::vector<std::string> columns{"'cell': 'BIGINT'"};
    add_columns(database, "cells", 2, columns);
    add_columns(database, "replicates", 1, columns);
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> table(std::tmpfile(), std::fclose);
    if (!table || !write_rows(database, table.get()))
      throw disk::Failed("no {}: no room for the table it is made of", kParquetName);
    duckdb->run("SET autoinstall_known_extensions = false");
    duckdb->run(fmt::format(
        "COPY (FROM read_csv('/proc/self/fd/{}', auto_detect = false, header = false, delim = ',', "
        "quote = '\"', escape = '\"', nullstr = '', allow_quoted_nulls = false, columns = {{{}}})) "
        "TO '/proc/self/fd/{}' (FORMAT PARQUET, USE_TMP_FILE false)",
        ::fileno(table.get()), fmt::join(columns, ", "), file.handle()));
    file.commit();
  };
}

}  // namespace eyrie::campaign
