// SPDX-License-Identifier: MIT
#include "campaign/store.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>
#include <filesystem>

#include "core/hash.hpp"
#include "core/text.hpp"
#include "disk/output.hpp"

namespace eyrie::campaign {
namespace {

constexpr int kFormat = 1;  ///< of the tables

constexpr const char* kTables = R"(
CREATE TABLE campaign (name TEXT PRIMARY KEY, value) WITHOUT ROWID;
CREATE TABLE origin (name TEXT PRIMARY KEY, text TEXT) WITHOUT ROWID;
CREATE TABLE factors (factor INTEGER PRIMARY KEY, name TEXT);
CREATE TABLE columns (name TEXT PRIMARY KEY, unit TEXT) WITHOUT ROWID;
CREATE TABLE measures (measure INTEGER PRIMARY KEY, name TEXT, kind TEXT, of TEXT, per TEXT);
CREATE TABLE faults (cell INTEGER, replicate INTEGER, seed INTEGER, what TEXT, command TEXT,
                     PRIMARY KEY (cell, replicate)) WITHOUT ROWID;
)";

/// Before results are added, of which the hash is another one.
constexpr const char* kBegin = "BEGIN; DELETE FROM campaign WHERE name IN ('hash', 'ended')";

constexpr std::array kOfReplicates{"cell",   "replicate", "seed", "outcome",
                                   "time_s", "steps",     "hash"};

/// Names of columns beside those of `replicates` and `taken` ones, as in results.csv and joins:
/// another one where SQL would not tell them apart.
std::vector<std::string> distinct(std::vector<std::string> names, std::vector<std::string> taken) {
  taken.insert(taken.end(), kOfReplicates.begin(), kOfReplicates.end());
  for (std::string& name : names) {
    while (std::ranges::any_of(taken,
                               [&](const std::string& t) { return to_small(t) == to_small(name); }))
      name += '_';
    taken.push_back(name);
  }
  return names;
}

std::vector<std::string> factor_names(const Spec& spec) {
  return distinct(listed(spec.factors, &Factor::name), {"command"});
}
std::vector<std::string> column_names(const Spec& spec) {
  return distinct(listed(spec.measures.columns, &Column::name), factor_names(spec));
}

/// ", \"a\" REAL, \"b\" TEXT"
template <class TypeOf>
std::string declared(const std::vector<std::string>& names, const TypeOf& type_of) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += fmt::format(", {} {}", sql_name(names[i]), type_of(i));
  return text;
}
/// NUMERIC if each value of a factor is a number that reads back as it is written; "1.10" is none.
std::string_view type_of_factor(Database& database, std::span<const Cell> cells, std::size_t f) {
  Statement same = database.prepare("SELECT CAST(CAST(?1 AS NUMERIC) AS TEXT) = ?1");
  for (const Cell& cell : cells)
    if (!same.with(cell.values[f]).step() || same.integer(0) == 0)
      return "TEXT";
  return "NUMERIC";
}
/// Takes rows of `n` values; `how` may be "INSERT OR IGNORE".
Statement insert_into(Database& database, std::string_view table, std::size_t n,
                      std::string_view how = "INSERT") {
  return database.prepare(fmt::format("{} INTO {} VALUES ({})", how, table,
                                      fmt::join(std::vector<std::string_view>(n, "?"), ", ")));
}

std::uint64_t hash_of(const std::string& text) {
  return text.starts_with("0x") ? std::strtoull(text.c_str(), nullptr, 16) : 0;
}

/// Every result, by cell and replicate.
void each_of(Database& database, const std::function<void(const Result&)>& use) {
  Statement all = database.prepare(
      "SELECT r.*, f.what FROM replicates r LEFT JOIN faults f USING (cell, replicate) "
      "ORDER BY r.cell, r.replicate");
  const auto whole = [&](int column) { return static_cast<std::uint64_t>(all.integer(column)); };
  const int what = all.columns() - 1;
  while (all.step()) {
    Result result{
        whole(0),
        whole(1),
        {.seed = whole(2),
         .steps = whole(5),
         .hash = hash_of(all.text(6)),
         .outcome = enum_named<scenario::Outcome>(all.text(3)).value_or(scenario::Outcome::fault),
         .time = all.number(4),
         .fault = all.text(what)}};
    for (int i = kFirstColumn; i < what && all.is_null(what); ++i)
      result.values.push_back(all.number(i));
    use(result);
  }
}

/// Of all results.
std::uint64_t hash_of(Database& database) {
  Hasher hasher;
  const auto number = [&](double x) {
    hasher.word(x == x ? std::bit_cast<std::uint64_t>(x) : ~std::uint64_t{0});
  };
  each_of(database, [&](const Result& r) {
    for (const std::uint64_t word : {r.cell, r.replicate, r.flown.seed, r.flown.steps, r.flown.hash,
                                     static_cast<std::uint64_t>(r.flown.outcome),
                                     static_cast<std::uint64_t>(r.flown.fault.size())})
      hasher.word(word);
    hasher.bytes(r.flown.fault.data(), r.flown.fault.size());
    number(r.flown.time);
    for (const double value : r.values)
      number(value);
  });
  return hasher.value();
}

/// Of the tables that say what the results are of, and stay as they were begun.
std::uint64_t hash_of_design(Database& database) {
  Hasher hasher;
  for (const char* table : {"factors", "cells", "columns", "measures"}) {
    Statement all = database.prepare(fmt::format("SELECT * FROM {} ORDER BY 1", table));
    while (all.step())
      for (int i = 0; i < all.columns(); ++i) {
        const bool is_real = all.is_number(i);
        const std::string text = is_real || all.is_null(i) ? std::string() : all.text(i);
        hasher.word(is_real ? std::bit_cast<std::uint64_t>(all.number(i)) : 0);
        hasher.word(text.size());
        hasher.bytes(text.data(), text.size());
      }
  }
  return hasher.value();
}

/// s, for which it has been worked on.
double seconds_in(Database& database) {
  Statement seconds = database.prepare("SELECT value FROM campaign WHERE name = 'seconds'");
  return seconds.step() ? seconds.number(0) : 0;
}

/// These are tables of a campaign, and such as this program writes.
void demand_format(Database& database, const std::string& file) {
  if (!begun(database))
    throw disk::Refused("{} is no campaign", quote_path(file));
  Statement format = database.prepare("SELECT value FROM campaign WHERE name = 'format'");
  if (const std::string said = format.step() ? format.text(0) : "none";
      said != std::to_string(kFormat))
    throw disk::Refused("{} was written by another version of Eyrie: its format is {}, not {}",
                        quote_path(file), quote(said), kFormat);
}

/// Before anything is written: somebody else's database may have that name, or another origin, or
/// somebody has changed it.
void demand_ours(const std::string& file, const Origin& own, const std::string& folder) {
  if (::access(file.c_str(), F_OK) != 0)
    return;
  Database there(file, Database::Access::read);
  there.distrust();
  if (begun(there)) {
    demand_format(there, file);
    campaign::demand_the_same(there, own, folder);
    demand_unchanged(there, file);
  } else if (there.prepare("SELECT 1 FROM sqlite_master").step())
    throw disk::Refused("{} is there already, and is no campaign", quote_path(file));
}

bool is_of_campaign(const std::string& name) {
  return name == kStoreName || name.starts_with(kPartName);
}

}  // namespace

std::string command_of(const Spec& spec, const Cell& cell, std::optional<std::uint64_t> seed) {
  std::string command = fly_command(spec.scenario, {{"--set", sets_of(spec, cell)},
                                                    {"--plugin", spec.plugins},
                                                    {"--allow-include", spec.includes}});
  return seed ? fmt::format("{} --seed {}", command, *seed) : command;
}

void demand_unchanged(Database& database, const std::string& file) {
  const auto demand = [&](const char* name, const char* what, auto hash) {
    Statement stored = database.prepare("SELECT value FROM campaign WHERE name = ?");
    if (!stored.with(name).step())
      return;
    if (const std::string now = hash_text(hash(database)); now != stored.text(0))
      throw disk::Refused("{} was changed after it was {}: the hash of what is there is {}, was {}",
                          quote_path(file), what, now, stored.text(0));
  };
  demand("design", "begun", hash_of_design);
  demand("hash", "flown", [](Database& results) { return hash_of(results); });
}

disk::Handle lock_results(const std::string& folder, bool resume) {
  return disk::work_folder(folder, "campaign", is_of_campaign, resume);
}

Store::Store(const std::string& folder, const Spec& spec, std::span<const Cell> cells,
             const Origin& origin, bool resume)
    : spec_(spec),
      cells_(cells),
      folder_(folder),
      lock_(lock_results(folder, resume)),
      counts_(cells.size()) {
  const std::string file = fmt::format("{}/{}", folder_, kStoreName);
  const Origin own = origin_of(origin, spec.part);
  demand_ours(file, own, folder_);
  // in a new folder its temporary file would be taken for somebody else's after a kill
  if (std::filesystem::exists(std::filesystem::symlink_status(folder_ + "/" + kTableName)))
    static_cast<void>(table_in(folder_));
  database_.emplace(file, Database::Access::create);
  database_->distrust();
  if (begun(*database_)) {
    database_->prepare("UPDATE origin SET text = ? WHERE name = ?")
        .with(spec.text, kCampaignText)
        .step();
  } else {
    make_tables(own);
  }
  before_ = seconds_in(*database_);
  count();
  put_ = insert_into(*database_, "replicates", kFirstColumn + spec_.measures.columns.size());
  put_fault_ = insert_into(*database_, "faults", 5);
}

Store::~Store() {
  try {
    flush();
  } catch (const std::runtime_error&) {  // whoever could hear it has called flush()
  }
}

void Store::make_tables(const Origin& origin) {
  Database& db = *database_;
  const auto factors = factor_names(spec_), columns = column_names(spec_);
  db.run("BEGIN");
  db.run(kTables);
  db.run(
      fmt::format("CREATE TABLE cells (cell INTEGER PRIMARY KEY, command TEXT{})",
                  declared(factors, [&](std::size_t f) { return type_of_factor(db, cells_, f); })));
  db.run(
      fmt::format("CREATE TABLE replicates (cell INTEGER, replicate INTEGER, seed INTEGER, "
                  "outcome TEXT, time_s REAL, steps INTEGER, hash TEXT{}, "
                  "PRIMARY KEY (cell, replicate)) WITHOUT ROWID",
                  declared(columns, [](std::size_t) { return "REAL"; })));
  set("format", std::to_string(kFormat));
  set("name", spec_.name);
  set("scenario", spec_.scenario);
  set("seconds", "0");
  Statement put = insert_into(db, "origin", 2);
  for (const auto& [name, text] : origin)
    put.with(name, text).step();
  put = insert_into(db, "factors", 2);
  for (std::size_t i = 0; i < factors.size(); ++i)
    put.with(i, factors[i]).step();
  put = insert_into(db, "columns", 2);
  for (std::size_t i = 0; i < columns.size(); ++i)
    put.with(columns[i], spec_.measures.columns[i].unit).step();
  put = insert_into(db, "measures", 5);
  for (std::size_t i = 0; i < spec_.measures.estimates.size(); ++i) {
    const Measure& m = spec_.measures.estimates[i];
    put.with(i, m.name, enum_name(m.kind), columns[m.column],
             m.kind == Measure::ratio ? columns[m.per] : "")
        .step();
  }
  put = insert_into(db, "cells", 2 + factors.size());
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    put.with(i, command_of(spec_, cells_[i]));
    for (std::size_t f = 0; f < factors.size(); ++f)
      put.bind(static_cast<int>(3 + f), cells_[i].values[f]);
    put.step();
  }
  set("design", hash_text(hash_of_design(db)));
  db.run("COMMIT");
}

void Store::count() {
  Statement counted = database_->prepare("SELECT cell, count(*) FROM replicates GROUP BY cell");
  while (counted.step()) {
    const auto cell = static_cast<std::size_t>(counted.integer(0));
    if (cell >= counts_.size())
      throw disk::Refused("{} is damaged: there is no cell {}", quote_path(folder_), cell);
    counts_[cell] = static_cast<std::uint64_t>(counted.integer(1));
  }
}

void Store::join(std::span<const std::string> folders) {
  if (folders.empty())
    return;
  database_->run(kBegin);
  before_ = 0;
  for (const std::string& folder : folders) {
    Database part = open_results(folder);
    before_ += seconds_in(part);
    for (const char* table : {"replicates", "faults"}) {
      Statement rows = part.prepare(fmt::format("SELECT * FROM {}", table));
      Statement copy = insert_into(*database_, table, static_cast<std::size_t>(rows.columns()),
                                   "INSERT OR IGNORE");
      while (rows.step())
        copy.with_row(rows).step();
    }
  }
  database_->run("COMMIT");
  count();
}

void Store::set(std::string_view name, const std::string& value) {
  database_->prepare("INSERT OR REPLACE INTO campaign VALUES (?, ?)").with(name, value).step();
}

void Store::put(const Result& result) {
  constexpr std::size_t kMostWaiting = 1000;
  constexpr std::chrono::seconds kLongest(1);
  if (waiting_++ == 0)
    database_->run(kBegin);
  const Flown& flown = result.flown;
  if (!flown.fault.empty())
    put_fault_
        ->with(result.cell, result.replicate, flown.seed, flown.fault,
               command_of(spec_, cells_[result.cell], flown.seed))
        .step();
  put_->with(result.cell, result.replicate, flown.seed, enum_name(flown.outcome), flown.time,
             flown.steps, hash_text(flown.hash));
  for (std::size_t i = 0; i < spec_.measures.columns.size(); ++i)
    put_->bind(static_cast<int>(i) + kFirstColumn + 1,
               result.values.empty() ? std::numeric_limits<double>::quiet_NaN() : result.values[i]);
  put_->step();
  ++counts_[result.cell];
  if (waiting_ >= kMostWaiting || Clock::now() - committed_ > kLongest)
    flush();
}

void Store::flush() {
  if (std::exchange(waiting_, 0) == 0)
    return;
  set("seconds", std::to_string(seconds()));
  database_->run("COMMIT");
  committed_ = Clock::now();
}

double Store::seconds() const {
  return before_ + std::chrono::duration<double>(Clock::now() - begun_).count();
}

void Store::each(const std::function<void(const Result&)>& use) {
  flush();
  each_of(*database_, use);
}

std::uint64_t Store::hash() {
  flush();
  return hash_of(*database_);
}

void Store::finish(const std::string& ended) {
  flush();
  set("hash", hash_text(hash()));
  set("ended", ended);
  write_table(*database_, folder_);
  put_.reset();
  put_fault_.reset();
  database_->leave_one_file();
}

Database open_results(const std::string& folder, Database::Access access) {
  const std::string file = fmt::format("{}/{}", folder, kStoreName);
  if (::access(file.c_str(), F_OK) != 0)
    throw disk::Refused("there is no campaign in {}", quote_path(folder));
  Database database(file, access);
  database.distrust();
  demand_format(database, file);
  return database;
}

void check_results(const std::string& folder) {
  Database database = open_results(folder);
  demand_unchanged(database, fmt::format("{}/{}", folder, kStoreName));
}

}  // namespace eyrie::campaign
