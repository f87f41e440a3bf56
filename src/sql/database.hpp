// SPDX-License-Identifier: MIT
#pragma once
/// \file  SQLite, with nothing added but ownership and exceptions.
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace eyrie::sql {

/// A prepared statement. What fails throws disk::Failed; SQL that is wrong, or asked of a file that
/// is damaged or has other tables, throws disk::Refused.
class Statement {
 public:
  /// Fills in every parameter, and begins anew.
  template <class... T>
  Statement& with(const T&... values) {
    reset();
    int index = 0;
    (bind(++index, values), ...);
    return *this;
  }
  /// As many as a row of another statement has.
  Statement& with_row(const Statement& row);
  void reset();
  /// Parameters count from 1. NaN is NULL.
  void bind(int index, double value);
  void bind(int index, std::int64_t value);
  void bind(int index, std::uint64_t value) { bind(index, static_cast<std::int64_t>(value)); }
  void bind(int index, std::string_view text);
  /// False without a further row, or if it was stopped; the statement can be used again then.
  bool step();
  /// Whether it writes nothing.
  [[nodiscard]] bool reads_only() const;

  // of the row; columns count from 0
  [[nodiscard]] std::int64_t integer(int column) const;
  [[nodiscard]] double number(int column) const;  ///< NaN for NULL
  [[nodiscard]] std::string text(int column) const;
  [[nodiscard]] bool is_null(int column) const;
  [[nodiscard]] bool is_whole(int column) const;
  [[nodiscard]] bool is_number(int column) const;  ///< and no whole one
  [[nodiscard]] int columns() const;
  [[nodiscard]] std::string column_name(int column) const;

 private:
  friend class Database;
  explicit Statement(sqlite3_stmt* statement) : statement_(statement) {}
  struct Finalize {
    void operator()(sqlite3_stmt* statement) const;
  };
  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
};

class Database {
 public:
  enum class Access { create, write, read };
  /// ":memory:" is no file. Throws disk::Failed if there is none, or none can be made, and
  /// disk::Refused if it is a pipe, a folder or a device. One that is being written is read as it
  /// was at the last commit.
  Database(const std::string& path, Access access);

  /// From now on no view, trigger or function of the file itself is used: a stranger may have put
  /// them where tables should be.
  void distrust();
  /// While a statement runs, `stop` is asked now and then, with null: not 0 ends it.
  void stop_if(int (&stop)(void*));
  /// One statement; more of them, or none, throw disk::Refused.
  [[nodiscard]] Statement prepare(std::string_view sql);
  /// Statements without a result.
  void run(const std::string& sql);
  /// Into the file goes what stands beside it, unless somebody else has it open: a later call does
  /// so then.
  void leave_one_file() noexcept;
  /// The whole file that it is or would be, also of one in memory.
  [[nodiscard]] std::string bytes() const;

 private:
  struct Close {
    void operator()(sqlite3* database) const;
  };
  std::unique_ptr<sqlite3, Close> database_;
};

/// A name as SQL writes it, whatever stands in it; with the mark ' a text.
[[nodiscard]] std::string sql_name(std::string_view name, char mark = '"');

}  // namespace eyrie::sql
