// SPDX-License-Identifier: MIT
#pragma once
/// \file  The results of a campaign in a folder: a database that loses no replicate which was put
/// into it when the process is killed. docs/campaigns.md has its tables.
#include <chrono>
#include <functional>
#include <map>

#include "campaign/replicate.hpp"
#include "campaign/spec.hpp"
#include "disk/output.hpp"
#include "sql/database.hpp"

namespace eyrie::campaign {

using sql::Database, sql::Statement, sql::sql_name;

inline constexpr const char* kStoreName = "results.db";
inline constexpr const char* kTableName = "results.csv";
inline constexpr const char* kParquetName = "results.parquet";
inline constexpr const char* kPartName = "part_";  ///< so begin the folders of parts
/// In the table `replicates`: the first column of what is measured.
inline constexpr int kFirstColumn = 7;

/// What a campaign is flown with: every file by its name, with its text or what stands for it.
using Origin = std::map<std::string, std::string>;
inline constexpr const char* kCampaignText = "the campaign";  ///< name of its file in there
inline constexpr const char* kProgramText = "the program";    ///< and of its version
/// That of a part of a campaign.
[[nodiscard]] Origin origin_of(Origin whole, const Part& part);
/// Throws disk::Refused with the differences if the campaign in `folder` was begun with another
/// origin: one of which what was flown is not the beginning. More replicates of each cell, or a
/// larger budget, are no difference.
void demand_the_same(Database& database, const Origin& origin, const std::string& folder);

/// Whether a database has results; who was killed before it was begun has left no tables.
[[nodiscard]] bool begun(Database& database);

/// What came of a replicate. It depends on the campaign, the cell and the replicate alone.
struct Result {
  std::uint64_t cell = 0, replicate = 0;
  Flown flown;
  std::vector<double> values{};  ///< by column; NaN where it does not apply; none after a fault
};

/// The command that flies a cell by itself, or one seed of it.
[[nodiscard]] std::string command_of(const Spec& spec, const Cell& cell,
                                     std::optional<std::uint64_t> seed = {});

/// Makes the folder, or takes one of a campaign if it is to be gone on with; nobody else writes its
/// results as long as this is there.
[[nodiscard]] disk::Handle lock_results(const std::string& folder, bool resume);

/// One process writes it at a time. What fails throws disk::Failed; what was committed stays.
class Store {
 public:
  /// Makes the folder, or with `resume` goes on with what is in it, if anything is. `spec` and
  /// `cells` must outlive it. Throws disk::Refused if there is something already, somebody else is
  /// writing it, or another `origin` began it: with the differences.
  Store(const std::string& folder, const Spec& spec, std::span<const Cell> cells,
        const Origin& origin, bool resume);
  ~Store();

  /// Keeps a result; it is committed with others after a second at most, if others come.
  void put(const Result& result);
  void flush();
  /// Takes over what parts have flown into these folders, or nothing of it.
  void join(std::span<const std::string> folders);

  /// How many replicates of each cell are there: the first ones of this part.
  [[nodiscard]] const std::vector<std::uint64_t>& counts() const { return counts_; }
  /// By cell and replicate.
  void each(const std::function<void(const Result&)>& use);
  /// s, for which it has been worked on until now.
  [[nodiscard]] double seconds() const;
  /// Of all results, by cell and replicate.
  [[nodiscard]] std::uint64_t hash();

  /// Writes all results as a table beside the database, and leaves that in one file.
  void finish(const std::string& ended);

 private:
  using Clock = std::chrono::steady_clock;
  void make_tables(const Origin& origin);
  void count();
  void set(std::string_view name, const std::string& value);

  const Spec& spec_;
  std::span<const Cell> cells_;
  std::string folder_;
  disk::Handle lock_;
  std::optional<Database> database_;
  std::optional<Statement> put_, put_fault_;
  std::vector<std::uint64_t> counts_;
  std::size_t waiting_ = 0;  ///< results that are not committed
  double before_ = 0;        ///< s, of earlier processes
  Clock::time_point begun_ = Clock::now(), committed_ = begun_;
};

/// These are the results that were there when their hash was, if they have one; else throws
/// disk::Refused. `file` is what they are in.
void demand_unchanged(Database& database, const std::string& file);

/// Opens the database in a folder, which may be a stranger's; throws disk::Refused if there is
/// none, or one that another version wrote.
[[nodiscard]] Database open_results(const std::string& folder,
                                    Database::Access access = Database::Access::read);
/// The same, once for a command: throws disk::Refused also if somebody has changed the results.
void check_results(const std::string& folder);

// A campaign is also flown in parts, each into a folder of its own by a process that knows nothing
// of the others, until they are joined.

/// "DIR/part_3_of_16"
[[nodiscard]] std::string part_folder(const std::string& folder, const Part& part);
/// Of how many parts there are some in this folder; 0: there is none. Throws disk::Refused if they
/// are of different numbers.
[[nodiscard]] std::uint64_t parts_in(const std::string& folder);
/// The folders of all parts, for Store::join. Throws disk::Refused that names those which have not
/// flown all, or if one was begun with another origin.
[[nodiscard]] std::vector<std::string> whole_parts(const std::string& folder, const Spec& spec,
                                                   std::size_t cells, const Origin& origin);

/// The columns of a table from the one numbered `first` on.
[[nodiscard]] std::vector<std::string> columns_of(Database& database, std::string_view table,
                                                  int first);

/// The numbers in the columns [first, end) of a row.
void read_values(const Statement& row, int first, int end, std::vector<double>& values);

/// results.csv in a folder, to be written; throws if it cannot be.
[[nodiscard]] disk::OutputFile table_in(const std::string& folder);
/// results.csv in the folder of the database: a row per replicate with the values of its cell.
void write_table(Database& database, const std::string& folder);
/// What a statement gives, as CSV: lines with their ends, the names of the columns first.
void write_csv(Statement& rows, const std::function<void(const std::string&)>& use);

/// Writes the rows and columns of results.csv as Parquet, by DuckDB's library: cell, replicate,
/// seed and steps are integers, outcome, hash and factors that are no numbers texts, everything
/// else doubles; NULL where nothing applies. Throws disk::Failed. `library` is a file, or a name
/// that the system looks for: throws disk::Refused if it cannot be opened, and says how to get it.
using WriteParquet = std::function<void(Database& database, disk::OutputFile& file)>;
[[nodiscard]] WriteParquet open_parquet(const std::string& library);

}  // namespace eyrie::campaign
