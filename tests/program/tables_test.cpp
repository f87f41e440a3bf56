// SPDX-License-Identifier: MIT
/// \file  A run as tables: nothing of the engine's decisions is lost, and others can read them.
#include <gtest/gtest.h>
#include <sqlite3.h>
#include <zlib.h>

#include <set>

#include "disk/file_system.hpp"
#include "sql/database.hpp"
#include "support/acmi_reader.hpp"
#include "support/program.hpp"
#include "support/recorded.hpp"
#include "tables/csv_files.hpp"
#include "tables/schema.hpp"

namespace eyrie::test {
namespace {
using debrief::Decision;
using sql::Database, sql::Statement;

bool not_stopped() {
  return false;
}

/// A recorded run and its database in a file.
struct TabledRun {
  TempFolder folder;
  debrief::Recorded recorded;
  Database database;

  TabledRun(const std::string& scenario, double until, const tables::Selection& selection = {})
      : recorded(recorded_flight(scenario, until)),
        database(
            folder.write("run.sqlite", *tables::run_database(recorded, selection, not_stopped)),
            Database::Access::read) {}

  [[nodiscard]] std::int64_t number(const std::string& sql) {
    Statement one = database.prepare(sql);
    return one.step() ? one.integer(0) : -1;
  }
};

/// What the engine decided, asked of itself.
std::vector<Decision> decided_in(const debrief::Recorded& recorded) {
  std::vector<Decision> all;
  debrief::Reflight flight(recorded);
  while (flight.step())
    for (std::uint32_t id = 1; id <= recorded.scenario->roster.players.size(); ++id)
      if (auto d = debrief::explain(*recorded.scenario, flight.before(), flight.after(),
                                    PlayerId{id}, flight.orders()))
        all.push_back(std::move(*d));
  return all;
}

/// Columns of a row from `first` on, against what a node or the root asked for.
void expect_same_action(const Statement& row, int first, const std::vector<debrief::Value>& action,
                        std::span<const tables::ActionColumn> columns) {
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const int at = first + static_cast<int>(i);
    const auto value = std::find_if(action.begin(), action.end(),
                                    [&](const auto& v) { return v.name == columns[i].name; });
    if (value == action.end()) {
      ASSERT_TRUE(row.is_null(at)) << columns[i].name;
    } else if (columns[i].is_words) {
      ASSERT_EQ(row.text(at), value->text) << columns[i].name;
    } else {
      ASSERT_EQ(row.number(at), *value->number) << columns[i].name;
    }
  }
}

void expect_lossless(const std::string& scenario, double until) {
  TabledRun run(scenario, until);
  const auto columns = tables::action_columns(*run.recorded.scenario);
  const std::vector<Decision> decisions = decided_in(run.recorded);
  ASSERT_GT(decisions.size(), 100u);
  const auto& roster = run.recorded.scenario->roster;
  std::map<std::pair<std::string, std::int64_t>, const Decision*> by_name;
  std::size_t asked = 0;
  for (const Decision& d : decisions) {
    by_name[{roster.name(d.player), static_cast<std::int64_t>(d.step)}] = &d;
    for (const debrief::Answer& node : d.nodes)
      asked += node.asked;
  }

  Statement row = run.database.prepare("SELECT * FROM decisions");
  std::size_t rows = 0, somebody = 0, nobody = 0;
  for (; row.step(); ++rows) {
    const std::string who = row.text(2);
    const auto at = by_name.find({who, row.integer(1)});
    ASSERT_NE(at, by_name.end()) << who << " decided nothing in step " << row.integer(1);
    const Decision& d = *at->second;
    // hundreds of thousands of rows: words only for one that is wrong
    const auto what = [&] { return fmt::format("{} at {}", who, d.time); };
    ASSERT_EQ(row.number(0), d.time) << what();
    ASSERT_EQ(row.text(3), d.tree) << what();
    ASSERT_EQ(row.text(4), ubf::to_text(d.status)) << what();
    ASSERT_EQ(row.number(5), static_cast<double>(d.nodes[0].vote)) << what();
    ASSERT_EQ(row.is_null(7) ? "" : row.text(7),
              d.leader == ubf::kNone ? "" : d.nodes[d.leader].path)
        << what();
    ASSERT_NO_FATAL_FAILURE(expect_same_action(row, 9, d.nodes[0].action, columns)) << what();
    for (const debrief::Value& order : d.nodes[0].action)
      if (order.name == "target") {
        std::string attacked;
        for (const debrief::Perceived& one : d.perceived)
          if ((one.kind == "target" || one.kind == "track") && one.number == *order.number)
            attacked = roster.name(one.truth);
        ASSERT_EQ(row.is_null(8) ? "" : row.text(8), attacked) << what();
        (attacked.empty() ? nobody : somebody) += 1;
      }
  }
  EXPECT_EQ(rows, decisions.size());
  EXPECT_GT(somebody + nobody, scenario == "convoy" ? 0U : 100U);

  std::map<std::string, std::size_t> place;  // of a node, by tree and path
  for (const Decision& d : decisions)
    for (std::size_t i = 0; i < d.nodes.size(); ++i)
      place.emplace(d.tree + ":" + d.nodes[i].path, i);
  Statement answer = run.database.prepare("SELECT * FROM answers");
  rows = 0;
  for (; answer.step(); ++rows) {
    const Decision& d = *by_name.at({answer.text(2), answer.integer(1)});
    const std::string path = answer.text(4);
    const debrief::Answer& node = d.nodes[place.at(answer.text(3) + ":" + path)];
    const auto what = [&] { return fmt::format("{} of {} at {}", path, answer.text(2), d.time); };
    ASSERT_TRUE(node.asked) << what();
    ASSERT_EQ(answer.text(5), node.label) << what();
    ASSERT_EQ(answer.text(6), ubf::to_text(node.status)) << what();
    ASSERT_EQ(answer.number(7), static_cast<double>(node.vote)) << what();
    ASSERT_EQ(answer.integer(8), node.halts) << what();
    ASSERT_EQ(answer.is_null(9) ? "" : answer.text(9), node.why) << what();
    ASSERT_NO_FATAL_FAILURE(expect_same_action(answer, 10, node.action, columns)) << what();
  }
  EXPECT_EQ(rows, asked) << "each answer once, and no other";
}

TEST(RunDatabase, LosesNothingOfTheDecisionsOfAFight) {
  expect_lossless("sweep", 9.5 * 60);
}
TEST(RunDatabase, LosesNothingOfADogfight) {
  expect_lossless("merge", 90);
}
TEST(RunDatabase, LosesNothingOfVehiclesUnderAttack) {
  expect_lossless("convoy", 5 * 60);
}

TEST(RunDatabase, IsSoundAndSaysWhatEachOfItsColumnsHolds) {
  TabledRun run("sweep", 9 * 60);
  Statement check = run.database.prepare("PRAGMA integrity_check");
  ASSERT_TRUE(check.step());
  EXPECT_EQ(check.text(0), "ok");
  EXPECT_FALSE(run.database.prepare("PRAGMA foreign_key_check").step());
  EXPECT_EQ(run.number("SELECT count(*) FROM sqlite_schema s, pragma_table_info(s.name) c "
                       "LEFT JOIN units u ON u.table_name = s.name AND u.column_name = c.name "
                       "WHERE u.meaning IS NULL"),
            0);
  EXPECT_GT(run.number("SELECT count(*) FROM units"), 100);
  EXPECT_EQ(run.number("SELECT count(*) FROM players WHERE kind = 'aircraft'"), 6);
  EXPECT_GT(
      run.number("SELECT count(*) FROM players WHERE kind = 'missile' AND shooter_id <= 6 AND "
                 "name = type || ' #' || player_id || ' of ' || (SELECT name FROM players s "
                 "WHERE s.player_id = players.shooter_id)"),
      0);
  EXPECT_EQ(run.number("SELECT count(*) FROM events WHERE event = 'launch'"),
            run.number("SELECT count(*) FROM players WHERE kind = 'missile'"));
  EXPECT_EQ(run.number("SELECT count(*) FROM players WHERE (gone_s IS NULL) <> (fate IS NULL)"), 0);
  EXPECT_EQ(run.number("SELECT count(*) FROM tracks WHERE player_id = 1"), 9 * 60 + 1);
}

TEST(RunDatabase, UsesNoWordThatSqlKeepsForItself) {
  // those of PostgreSQL 16, MySQL 8 and SQL:2016 that SQLite does not know
  std::set<std::string> reserved{"range",    "rank",    "lead",    "lag",     "value", "system",
                                 "call",     "user",    "start",   "time",    "row",   "condition",
                                 "function", "trigger", "release", "position"};
  const TabledRun run("convoy", 5);
  std::vector<tables::ActionColumn> columns = tables::action_columns(*run.recorded.scenario);
  for (const tables::Table& table : tables::tables_of(columns, 0.02)) {
    std::vector<std::string> names{table.name};
    for (const tables::TableColumn& column : table.columns)
      names.push_back(column.name);
    for (const std::string& name : names) {
      EXPECT_EQ(sqlite3_keyword_check(name.data(), static_cast<int>(name.size())), 0) << name;
      EXPECT_FALSE(reserved.contains(name)) << name;
    }
  }
}

TEST(RunDatabase, TakesFewerDecisionsIfThatIsWanted) {
  const double until = 9 * 60;
  TabledRun second("sweep", until, {.every = 1});
  const std::int64_t players = 6;
  EXPECT_NEAR(static_cast<double>(second.number("SELECT count(*) FROM decisions")),
              static_cast<double>(players) * until, players * 6.0);
  EXPECT_EQ(second.number("SELECT count(*) FROM (SELECT 1 FROM decisions GROUP BY player, "
                          "CAST(time_s + 1e-9 AS INTEGER) HAVING count(*) > 1)"),
            0);
  TabledRun changes("sweep", until, {.who = PlayerId{1}, .changes_only = true});
  const std::int64_t changed = changes.number("SELECT count(*) FROM decisions");
  EXPECT_GT(changed, 5);
  EXPECT_LT(changed, 200);
  EXPECT_EQ(changes.number("SELECT count(*) FROM decisions WHERE player <> 'eagle1'"), 0);
  EXPECT_EQ(
      changes.number(
          "SELECT count(*) FROM (SELECT leader_path AS now, lag(leader_path) OVER w AS then_, "
          "mode_order AS m, lag(mode_order) OVER w AS n, target_order AS t, lag(target_order) "
          "OVER w AS u, call_order AS c, lag(call_order) OVER w AS d, dispense_order AS e, "
          "lag(dispense_order) OVER w AS f, release_order AS r, lag(release_order) OVER w AS s,"
          " load_factor IS NULL AS l, lag(load_factor IS NULL) OVER w AS k, climb_rad IS NULL "
          "AS a, lag(climb_rad IS NULL) OVER w AS b, heading_rad IS NULL AS h, "
          "lag(heading_rad IS NULL) OVER w AS g, altitude_m IS NULL AS o, "
          "lag(altitude_m IS NULL) OVER w AS p, row_number() OVER w AS i FROM decisions "
          "WINDOW w AS (ORDER BY step)) WHERE i > 1 AND now IS then_ AND m IS n AND t IS u AND "
          "c IS d AND e IS f AND r IS s AND l IS k AND a IS b AND h IS g AND o IS p"),
      0)
      << "each differs from the one before";
}

TEST(RunDatabase, EndsWithoutAWordWhenItIsStopped) {
  const debrief::Recorded recorded = recorded_flight("merge", 20);
  int asked = 0;
  EXPECT_FALSE(tables::run_database(recorded, {}, [&] { return ++asked > 100; }));
  EXPECT_EQ(asked, 101);
}

std::string unzipped(const std::string& bytes) {
  z_stream z{};
  EXPECT_EQ(inflateInit2(&z, 15 + 16), Z_OK);
  std::string text(std::size_t{64} << 20, '\0');
  z.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  z.avail_in = static_cast<uInt>(bytes.size());
  z.next_out = reinterpret_cast<Bytef*>(text.data());
  z.avail_out = static_cast<uInt>(text.size());
  EXPECT_EQ(inflate(&z, Z_FINISH), Z_STREAM_END);
  text.resize(z.total_out);
  inflateEnd(&z);
  return text;
}

/// The decisions of a whole sweep, which took 164 MB as one field a row.
TEST(TablesProgram, WritesASweepAtFullRateInLessThanFiveMegabytes) {
  const TempFolder folder;
  ASSERT_EQ(run_program(folder, {"fly", "sweep", "--no-debrief", "--quiet", "--out", "run"}).code,
            0);
  for (const char* format : {"sqlite", "decisions", "answers"})
    ASSERT_EQ(run_program(folder, {"export", "run", "--to", format}).code, 0) << format;
  for (const char* name : {"run.sqlite", "decisions.csv.gz", "answers.csv.gz"}) {
    const auto size = std::filesystem::file_size(folder.path() / "run" / name);
    EXPECT_LT(size, 5'000'000u) << name;
    EXPECT_GT(size, 500'000u) << name;
  }
  Database database(folder / "run/run.sqlite", Database::Access::read);
  Statement count = database.prepare("SELECT count(*), total(heading_rad) FROM decisions");
  ASSERT_TRUE(count.step());
  const std::string text = unzipped(read_text(folder / "run/decisions.csv.gz"));
  const auto lines = split(text, '\n');
  EXPECT_EQ(static_cast<std::int64_t>(lines.size()), count.integer(0) + 2) << "a head, an end";
  double sum = 0;
  for (std::size_t i = 1; i + 1 < lines.size(); ++i)
    if (const auto cells = split(lines[i], ','); !cells.at(9).empty())
      sum += std::stod(cells[9]);
  EXPECT_NEAR(sum, count.number(1), 1e-4);
}

TEST(TablesProgram, WritesTheSameEveryTimeAndRefusesWhatIsNoSelection) {
  const TempFolder folder;
  ASSERT_EQ(run_program(folder, {"fly", "merge", "--until", "5 s", "--no-debrief", "--quiet",
                                 "--out", "run"})
                .code,
            0);
  for (const char* format : {"sqlite", "decisions", "answers", "pcap"}) {
    for (const char* out : {"a", "b"})
      ASSERT_EQ(
          run_program(folder, {"export", "run", "--to", format, "--out", out, "--force"}).code, 0);
    EXPECT_EQ(read_text(folder / "a"), read_text(folder / "b")) << format;
  }
  const auto before = folder.everything();
  for (const std::vector<std::string>& wrong :
       std::vector<std::vector<std::string>>{{"--to", "sqlite", "--every", "often"},
                                             {"--to", "sqlite", "--every", "-1 s"},
                                             {"--to", "sqlite", "--every", "1"},
                                             {"--to", "sqlite", "--every", "1:30"},
                                             {"--to", "decisions", "--out", "folder/"},
                                             {"--to", "answers", "--player", "eagle9"},
                                             {"--to", "czml", "--changes-only"},
                                             {"--to", "geojson", "--every", "1 s"},
                                             {"--to", "sqlite", "--out", "x.gz"},
                                             {"--to", "pcap", "--out", "x.GZ"},
                                             {"--to", "decisions", "--out", "X.CSV.GZ"},
                                             {"--to", "pcap", "--out", "run/run.eyrie", "--force"},
                                             {"--to", "pcap", "--player", "eagle1"}}) {
    std::vector<std::string> command{"export", "run"};
    command.insert(command.end(), wrong.begin(), wrong.end());
    const Ran ran = run_program(folder, command);
    EXPECT_EQ(ran.code, 2) << wrong[1] << " " << wrong[2] << ran.err;
  }
  EXPECT_EQ(folder.everything(), before);
}

/// While it lives, SQLite can make no temporary file.
class NoTemporaries {
 public:
  NoTemporaries() {
    full_.zName = "no temporaries";
    full_.xOpen = [](sqlite3_vfs*, const char* name, sqlite3_file* file, int flags, int* out) {
      file->pMethods = nullptr;
      return name ? real_->xOpen(real_, name, file, flags, out) : SQLITE_FULL;
    };
    sqlite3_vfs_register(&full_, 1);
  }
  ~NoTemporaries() {
    sqlite3_vfs_unregister(&full_);
    sqlite3_vfs_register(real_, 1);
  }
  NoTemporaries(const NoTemporaries&) = delete;
  NoTemporaries& operator=(const NoTemporaries&) = delete;

 private:
  inline static sqlite3_vfs* const real_ = sqlite3_vfs_find(nullptr);
  sqlite3_vfs full_ = *real_;
};

TEST(Tables, NeedNoTemporaryFiles) {
  const debrief::Recorded run = recorded_flight("sweep", 600);
  const NoTemporaries full;
  const auto bytes = tables::run_database(run, {}, not_stopped);
  EXPECT_GT(bytes->size(), 2'500'000U) << "more than SQLite keeps in memory unasked";
  Database unasked(":memory:", Database::Access::create);
  try {
    unasked.run(
        "PRAGMA temp_store=FILE; CREATE TEMP TABLE t (x); INSERT INTO t WITH RECURSIVE r(i) AS "
        "(SELECT 1 UNION ALL SELECT i + 1 FROM r LIMIT 10000) SELECT randomblob(1000) FROM r");
    FAIL() << "there was room";
  } catch (const disk::Failed& e) {
    EXPECT_STREQ(e.what(), "a temporary file of SQLite: No space left on device");
  }
}

TEST(TablesPage, IsWhatTheProgramSays) {
  EXPECT_EQ(read_text("docs/tables.md"), tables::tables_markdown())
      << "eyrie catalog --tables > docs/tables.md";
}

/// The blocks of a language on a page.
std::vector<std::string> code_blocks(const std::string& page, const std::string& language) {
  std::vector<std::string> all;
  const std::string begin = "```" + language + "\n";
  for (std::size_t at = page.find(begin); at != page.npos; at = page.find(begin, at)) {
    at += begin.size();
    all.push_back(page.substr(at, page.find("```", at) - at));
  }
  return all;
}

/// Each of them answers something about a whole sweep; those for pandas where it is installed.
TEST(TablesPage, HasQueriesThatAnswer) {
  const TempFolder folder;
  ASSERT_EQ(
      run_program(folder, {"fly", "sweep", "--no-debrief", "--quiet", "--out", "runs/mine"}).code,
      0);
  ASSERT_EQ(run_program(folder, {"export", "runs/mine", "--to", "sqlite"}).code, 0);
  ASSERT_EQ(run_program(folder, {"export", "runs/mine", "--to", "decisions"}).code, 0);
  const std::string page = read_text("docs/formats.md");
  Database database(folder / "runs/mine/run.sqlite", Database::Access::read);
  const auto queries = code_blocks(page, "sql");
  EXPECT_GE(queries.size(), 3u);
  for (const std::string& sql : queries) {
    Statement query = database.prepare(sql);
    EXPECT_TRUE(query.step()) << sql;
  }
  const auto programs = code_blocks(page, "python");
  ASSERT_FALSE(programs.empty());
  const std::string python = "cd '" + folder.path().string() + "' && python3 ";
  if (std::system((python + "-c 'import pandas' 2>/dev/null").c_str()) != 0)
    GTEST_SKIP() << "pandas is not installed";
  for (const std::string& program : programs) {
    folder.write("query.py", program);
    EXPECT_EQ(std::system((python + "query.py > said.txt").c_str()), 0) << program;
    EXPECT_GT(read_text(folder / "said.txt").size(), 20u) << program;
  }
}

}  // namespace
}  // namespace eyrie::test
