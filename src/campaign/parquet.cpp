// SPDX-License-Identifier: MIT
#include "campaign/parquet.hpp"

#include <dlfcn.h>
#include <fmt/ranges.h>

#include <cstdio>
#include <memory>

namespace eyrie::campaign {
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
  std::string line;
  while (rows.step()) {
    line.clear();
    for (int i = 0; i < rows.columns(); ++i) {
      line += i ? "," : "";
      if (rows.is_number(i))
        line += fmt::format("{}", rows.number(i));
      else if (rows.is_whole(i))
        line += rows.text(i);
      else if (!rows.is_null(i))
        line += sql_name(rows.text(i));
    }
    line += '\n';
    std::fwrite(line.data(), 1, line.size(), file);
  }
  return std::fflush(file) == 0 && std::ferror(file) == 0;
}

}  // namespace

/// Of DuckDB's C interface, which keeps it (https://duckdb.org/docs/stable/clients/c/api).
struct Parquet::Calls {
  struct QueryResult {
    std::uint64_t columns, rows, changed;
    void* column_data;
    char* error;
    void* internal;
  };
  int (*open)(const char* file, void** database);
  int (*connect)(void* database, void** connection);
  int (*query)(void* connection, const char* sql, QueryResult* result);
  const char* (*error)(QueryResult* result);
  void (*destroy)(QueryResult* result);
  void (*disconnect)(void** connection);
  void (*close)(void** database);
  void* database = nullptr;
  void* connection = nullptr;
};

Parquet::Parquet(const std::string& library) : calls_(std::make_unique<Calls>()) {
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
  find(calls_->open, "duckdb_open");
  find(calls_->connect, "duckdb_connect");
  find(calls_->query, "duckdb_query");
  find(calls_->error, "duckdb_result_error");
  find(calls_->destroy, "duckdb_destroy_result");
  find(calls_->disconnect, "duckdb_disconnect");
  find(calls_->close, "duckdb_close");
  if (calls_->open(nullptr, &calls_->database) ||
      calls_->connect(calls_->database, &calls_->connection))
    refuse(library + " does not open a database");
}

Parquet::~Parquet() {
  calls_->disconnect(&calls_->connection);
  calls_->close(&calls_->database);
}

void Parquet::run(const std::string& sql) {
  Calls::QueryResult result{};
  const bool failed = calls_->query(calls_->connection, sql.c_str(), &result) != 0;
  const char* const words = calls_->error(&result);
  const std::string why = words ? words : "DuckDB does not say why";
  calls_->destroy(&result);
  if (failed)
    throw disk::Failed("no {}: {}", kParquetName, why);
}

void Parquet::write(Database& database, disk::OutputFile& file) {
  std::vector<std::string> columns{"'cell': 'BIGINT'"};
  add_columns(database, "cells", 2, columns);
  add_columns(database, "replicates", 1, columns);
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> table(std::tmpfile(), std::fclose);
  if (!table || !write_rows(database, table.get()))
    throw disk::Failed("no {}: no room for the table it is made of", kParquetName);
  run("SET autoinstall_known_extensions = false");
  run(fmt::format(
      "COPY (FROM read_csv('/proc/self/fd/{}', auto_detect = false, header = false, delim = ',', "
      "quote = '\"', escape = '\"', nullstr = '', allow_quoted_nulls = false, columns = {{{}}})) "
      "TO '/proc/self/fd/{}' (FORMAT PARQUET, USE_TMP_FILE false)",
      ::fileno(table.get()), fmt::join(columns, ", "), file.handle()));
  file.commit();
}

}  // namespace eyrie::campaign
