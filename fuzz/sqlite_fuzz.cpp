// SPDX-License-Identifier: MIT
/// \file  Any texts as names in a run's database: SQLite finds it sound, and every table and view
/// has the same rows whatever they are called, each text as a terminal shows it.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "core/text.hpp"
#include "fuzz/recorded_flight.hpp"
#include "sql/database.hpp"
#include "tables/schema.hpp"

namespace {

using namespace eyrie;
using fuzz::demand, fuzz::demand_same;
using Rows = std::vector<std::vector<std::string>>;

/// A database beside which nothing stays, however this ends.
class Reader {
 public:
  explicit Reader(const std::string& bytes)
      : database_(written(bytes), sql::Database::Access::read) {
    demand(query("PRAGMA integrity_check") == Rows{{"ok"}});  // opens the file
    demand(std::filesystem::remove(path()));
    demand(query("PRAGMA foreign_key_check").empty());
  }

  /// Nothing is an empty text, which no table has.
  [[nodiscard]] Rows query(const std::string& text) {
    Rows rows;
    for (sql::Statement statement = database_.prepare(text); statement.step();) {
      rows.emplace_back();
      for (int i = 0; i < statement.columns(); ++i) {
        rows.back().push_back(statement.is_null(i) ? "" : statement.text(i));
        demand(statement.is_null(i) == rows.back().back().empty());
      }
    }
    return rows;
  }

 private:
  static std::string path() {
    return std::filesystem::temp_directory_path() / fmt::format("eyrie_fuzz.{}.db", ::getpid());
  }
  static std::string written(const std::string& bytes) {
    demand(bool(std::ofstream(path(), std::ios::binary) << bytes << std::flush));
    return path();
  }

  sql::Database database_;
};

/// Tables and views whose rows do not depend on which names are the same.
std::map<std::string, Rows> written_with(fuzz::Texts texts) {
  fuzz::flight().rename(texts);
  const auto bytes = tables::run_database(fuzz::recorded(texts), {}, [] { return false; });
  demand(bytes.has_value());
  Reader reader(*bytes);
  std::map<std::string, Rows> tables;
  for (const char* name : {"about", "units", "players", "nodes", "events", "tracks",
                           "decision_spans", "decisions", "answers"}) {
    tables[name] = reader.query(std::string("SELECT * FROM ") + name);
    demand(!tables[name].empty());
  }
  return tables;
}

/// In whatever order: SQL promises none.
void expect_same(Rows rows, Rows wanted, const fuzz::Texts& texts) {
  demand(rows.size() == wanted.size());
  for (std::vector<std::string>& row : wanted)
    for (std::string& cell : row)
      if (std::string named = texts.in(cell); named != cell)
        cell = fuzz::without_numbers(printable(named));
      else
        cell = fuzz::without_numbers(cell);
  for (std::vector<std::string>& row : rows)
    for (std::string& cell : row)
      cell = fuzz::without_numbers(cell);
  std::sort(rows.begin(), rows.end());
  std::sort(wanted.begin(), wanted.end());
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t cell = 0; cell < wanted[i].size(); ++cell)
      demand_same(rows[i].at(cell), wanted[i][cell]);
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  static_cast<void>(fuzz::flight());
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const auto plain = written_with({});
  const fuzz::Texts texts(data, size);
  const auto tables = written_with(texts);
  for (const auto& [name, rows] : tables)
    expect_same(rows, plain.at(name), texts);
  return 0;
}
