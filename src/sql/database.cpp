// SPDX-License-Identifier: MIT
#include "sql/database.hpp"

#include <sqlite3.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cmath>
#include <filesystem>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "core/diagnostics.hpp"
#include "disk/file_system.hpp"

namespace eyrie::sql {
namespace {

/// Why a file that is there cannot be written: it or its folder, in which SQLite keeps a journal.
std::optional<std::string> unwritable(const std::string& path) {
  for (const std::string& place : {path, std::filesystem::path(path).parent_path().string()})
    if (::access(place.c_str(), W_OK) != 0)
      return fmt::format("cannot write {}: {}", quote_path(place), disk::words_of(errno));
  return {};
}

/// Which table or column may be meant by one that there is not.
std::string names_meant(sqlite3* database, std::string_view message) {
  constexpr std::array<std::pair<std::string_view, const char*>, 2> kKinds{{
      {"no such table: ", "SELECT name FROM sqlite_master WHERE type = 'table'"},
      {"no such column: ",
       "SELECT c.name FROM sqlite_master t, pragma_table_info(t.name) c WHERE t.type = 'table'"},
  }};
  for (const auto& [begin, sql] : kKinds) {
    sqlite3_stmt* all = nullptr;
    if (!message.starts_with(begin) ||
        sqlite3_prepare_v2(database, sql, -1, &all, nullptr) != SQLITE_OK)
      continue;
    std::vector<std::string> names;
    while (sqlite3_step(all) == SQLITE_ROW)
      names.emplace_back(reinterpret_cast<const char*>(sqlite3_column_text(all, 0)));
    sqlite3_finalize(all);
    return nearest_or_all(message.substr(begin.size()), names);
  }
  return "";
}

/// To be called right after what has failed: SQLite keeps no errno of a write.
[[noreturn]] void fail(sqlite3* database) {
  const int call = errno, code = sqlite3_errcode(database);
  const std::string message = sqlite3_errmsg(database);
  const char* path = sqlite3_db_filename(database, nullptr);
  if (code == SQLITE_READONLY && path)
    if (const auto why = unwritable(path))
      throw disk::Refused(*why);
  const std::string words =
      fmt::format("{}: {}", path && *path ? quote_path(path) : "a temporary file of SQLite",
                  code == SQLITE_FULL       ? disk::words_of(ENOSPC)
                  : code == SQLITE_IOERR    ? disk::words_of(call)
                  : code == SQLITE_CANTOPEN ? disk::words_of(sqlite3_system_errno(database))
                  : code == SQLITE_BUSY ? "another program has locked it; wait until it has ended"
                                        : message + names_meant(database, message));
  for (const int mistake : {SQLITE_ERROR, SQLITE_READONLY, SQLITE_CORRUPT, SQLITE_NOTADB,
                            SQLITE_TOOBIG, SQLITE_MISMATCH})
    if (code == mistake)
      throw disk::Refused(words);
  throw disk::Failed(words);
}

}  // namespace

void Statement::Finalize::operator()(sqlite3_stmt* statement) const {
  sqlite3_finalize(statement);
}
void Statement::reset() {
  sqlite3_reset(statement_.get());  // repeats what step() has thrown
}
void Statement::bind(int index, double value) {
  sqlite3_bind_double(statement_.get(), index, value);
}
void Statement::bind(int index, std::int64_t value) {
  sqlite3_bind_int64(statement_.get(), index, value);
}
void Statement::bind(int index, std::string_view text) {
  if (sqlite3_bind_text64(statement_.get(), index, text.data(), text.size(), SQLITE_TRANSIENT,
                          SQLITE_UTF8) != SQLITE_OK)
    fail(sqlite3_db_handle(statement_.get()));
}
Statement& Statement::with_row(const Statement& row) {
  reset();
  for (int i = 0; i < row.columns(); ++i)
    if (sqlite3_bind_value(statement_.get(), i + 1,
                           sqlite3_column_value(row.statement_.get(), i)) != SQLITE_OK)
      fail(sqlite3_db_handle(statement_.get()));
  return *this;
}
bool Statement::step() {
  switch (sqlite3_step(statement_.get())) {
    case SQLITE_ROW:
      return true;
    case SQLITE_DONE:
    case SQLITE_INTERRUPT:
      reset();
      return false;
    default:
      fail(sqlite3_db_handle(statement_.get()));
  }
}
bool Statement::reads_only() const {
  return sqlite3_stmt_readonly(statement_.get()) != 0;
}

std::int64_t Statement::integer(int column) const {
  return sqlite3_column_int64(statement_.get(), column);
}
double Statement::number(int column) const {
  if (is_null(column))
    return std::numeric_limits<double>::quiet_NaN();
  const double x = sqlite3_column_double(statement_.get(), column);
  if (std::isinf(x))  // nobody here writes one, but a query may make one
    throw disk::Refused("the result is infinite in the column {}", quote(column_name(column)));
  return x;
}
std::string Statement::text(int column) const {
  const auto* text = sqlite3_column_text(statement_.get(), column);
  return {reinterpret_cast<const char*>(text),
          static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column))};
}
bool Statement::is_null(int column) const {
  return sqlite3_column_type(statement_.get(), column) == SQLITE_NULL;
}
bool Statement::is_whole(int column) const {
  return sqlite3_column_type(statement_.get(), column) == SQLITE_INTEGER;
}
bool Statement::is_number(int column) const {
  return sqlite3_column_type(statement_.get(), column) == SQLITE_FLOAT;
}
int Statement::columns() const {
  return sqlite3_column_count(statement_.get());
}
std::string Statement::column_name(int column) const {
  return sqlite3_column_name(statement_.get(), column);
}

void Database::Close::operator()(sqlite3* database) const {
  sqlite3_close_v2(database);  // statements may live on
}

Database::Database(const std::string& path, Access access) {
  constexpr int kWait = 10'000;  // ms, for another process
  const int flags = access == Access::read    ? SQLITE_OPEN_READONLY
                    : access == Access::write ? SQLITE_OPEN_READWRITE
                                              : SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE;
  // a relative path may begin with "file:", which is no URI here
  const bool relative = path != ":memory:" && !path.starts_with('/');
  // of a pipe SQLite would wait for a writer; what is written to is what has that name
  const int follow = access == Access::read ? 0 : AT_SYMLINK_NOFOLLOW;
  for (const char* part : {"", "-journal", "-wal", "-shm"})
    if (struct stat found{};
        disk::files().status(AT_FDCWD, (path + part).c_str(), found, follow) == 0 &&
        !S_ISREG(found.st_mode))
      throw disk::Refused("{} is {}, not a file", quote_path(path + part),
                          disk::kind_text(found.st_mode));
  const auto open = [&](const char* system) {
    sqlite3* opened = nullptr;
    const int result =
        sqlite3_open_v2((relative ? "./" + path : path).c_str(), &opened, flags, system);
    database_.reset(opened);
    if (!opened)
      throw std::bad_alloc();
    if (result != SQLITE_OK)
      throw disk::Failed("cannot open {}: {}", quote_path(path), sqlite3_errmsg(opened));
    sqlite3_busy_timeout(opened, kWait);
  };
  open(nullptr);
  if (access != Access::read) {
    // a process that is killed loses nothing that was committed; readers and the writer do not wait
    run("PRAGMA journal_mode=WAL; PRAGMA synchronous=NORMAL; PRAGMA foreign_keys=ON");
  } else if (sqlite3_exec(database_.get(), "SELECT 1 FROM sqlite_master", nullptr, nullptr,
                          nullptr) == SQLITE_CANTOPEN) {
    // what a killed process left, where nothing can be made beside it: its index is kept in memory,
    // and nothing is locked, as nobody writes there (https://sqlite.org/wal.html#noshm)
    open("unix-none");
    run("PRAGMA locking_mode=EXCLUSIVE");
  }
}

void Database::distrust() {
  for (const auto& [option, on] : {std::pair{SQLITE_DBCONFIG_ENABLE_VIEW, 0},
                                   {SQLITE_DBCONFIG_ENABLE_TRIGGER, 0},
                                   {SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0},
                                   {SQLITE_DBCONFIG_DEFENSIVE, 1}})
    sqlite3_db_config(database_.get(), option, on, nullptr);
}

void Database::stop_if(int (&stop)(void*)) {
  sqlite3_progress_handler(database_.get(), 10'000, &stop, nullptr);  // instructions of SQLite
}

Statement Database::prepare(std::string_view sql) {
  const char* rest = sql.data();
  const auto next = [&] {
    sqlite3_stmt* statement = nullptr;
    const auto size = static_cast<int>(sql.data() + sql.size() - rest);
    if (sqlite3_prepare_v2(database_.get(), rest, size, &statement, &rest) != SQLITE_OK)
      fail(database_.get());
    return Statement(statement);
  };
  Statement first = next();
  if (!first.statement_)
    throw disk::Refused("there is no statement in {}", quote(sql));
  const std::string_view more(rest, static_cast<std::size_t>(sql.data() + sql.size() - rest));
  if (next().statement_)
    throw disk::Refused("one statement at a time, not also {}", quote(more));
  return first;
}

void Database::run(const std::string& sql) {
  if (sqlite3_exec(database_.get(), sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK)
    fail(database_.get());
}

void Database::leave_one_file() noexcept {
  sqlite3_exec(database_.get(), "PRAGMA journal_mode=DELETE", nullptr, nullptr, nullptr);
}

std::string Database::bytes() const {
  sqlite3_int64 size = 0;
  const std::unique_ptr<unsigned char, decltype(&sqlite3_free)> bytes(
      sqlite3_serialize(database_.get(), "main", &size, 0), sqlite3_free);
  if (!bytes)
    throw std::bad_alloc();
  return {reinterpret_cast<const char*>(bytes.get()), static_cast<std::size_t>(size)};
}

std::string sql_name(std::string_view name, char mark) {
  std::string text(1, mark);
  for (const char c : name)
    text.append(c == mark ? 2 : 1, c);
  return text + mark;
}

}  // namespace eyrie::sql
