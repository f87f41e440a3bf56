// SPDX-License-Identifier: MIT
#include "sql/database.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "disk/file_system.hpp"
#include "support/program.hpp"

namespace eyrie::sql {
namespace {

using Access = Database::Access;

TEST(Database, GivesBackWhatWasPutIn) {
  const test::TempFolder folder;
  Database database(folder / "x.db", Access::create);
  database.run("CREATE TABLE t (i INTEGER, x REAL, s TEXT)");
  Statement put = database.prepare("INSERT INTO t VALUES (?, ?, ?)");
  put.with(std::int64_t{-7}, 0.1, "a'b\"").step();
  put.with(std::uint64_t{8}, std::nan(""), "").step();
  Statement all = Database(folder / "x.db", Access::read).prepare("SELECT * FROM t ORDER BY i");
  ASSERT_TRUE(all.step());
  EXPECT_EQ(all.integer(0), -7);
  EXPECT_EQ(all.number(1), 0.1);
  EXPECT_EQ(all.text(2), "a'b\"");
  ASSERT_TRUE(all.step());
  EXPECT_TRUE(all.is_null(1));
  EXPECT_TRUE(std::isnan(all.number(1)));
  EXPECT_FALSE(all.step());
}

TEST(Database, NamesWhatIsMeant) {
  const test::TempFolder folder;
  Database database(folder / "x.db", Access::create);
  database.run("CREATE TABLE cells (cell INTEGER, command TEXT)");
  const auto refused = [&](const char* sql) -> std::string {
    try {
      static_cast<void>(database.prepare(sql));
    } catch (const disk::Refused& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_TRUE(
      refused("SELECT * FROM cels").ends_with("no such table: cels; did you mean 'cells'?"));
  EXPECT_TRUE(refused("SELECT comand FROM cells")
                  .ends_with("no such column: comand; did you mean 'command'?"));
  EXPECT_TRUE(refused("SELECT * FROM xyz").ends_with("no such table: xyz, only cells"));
}

TEST(Database, ThatIsNotThereIsNotMade) {
  const test::TempFolder folder;
  for (const Access access : {Access::read, Access::write})
    EXPECT_THROW(Database(folder / "none.db", access), disk::Failed);
  EXPECT_TRUE(folder.everything().empty());
}

TEST(Database, ThatIsFullSaysSo) {
  const test::TempFolder folder;
  Database database(folder / "x.db", Access::create);
  database.run("CREATE TABLE t (s TEXT); PRAGMA max_page_count=4");
  Statement put = database.prepare("INSERT INTO t VALUES (?)");
  try {
    put.with(std::string(100'000, 'x')).step();
    FAIL() << "there was room";
  } catch (const disk::Failed& e) {
    EXPECT_NE(std::string(e.what()).find("No space left on device"), std::string::npos) << e.what();
  }
  put.with("small").step();
}

/// As somebody whom nothing is allowed: what is done as root is.
TEST(Database, SaysWhatMayNotBeWritten) {
  const test::TempFolder folder;
  const std::string file = folder / "x.db";
  Database(file, Access::create).run("CREATE TABLE t (s TEXT); PRAGMA journal_mode=DELETE");
  const auto write = [&] {
    if (::geteuid() == 0 && ::setuid(65534) != 0)
      std::_Exit(1);
    try {
      Database(file, Access::write).run("DELETE FROM t");
    } catch (const disk::Refused& refused) {
      std::fputs(refused.what(), stderr);
      std::_Exit(2);
    }
    std::_Exit(0);
  };
  ASSERT_EQ(::chmod((folder / ".").c_str(), 0555), 0);
  ASSERT_EQ(::chmod(file.c_str(), 0666), 0);
  EXPECT_EXIT(write(), testing::ExitedWithCode(2),
              "cannot write '" + folder.path().string() + "': Permission denied");
  ASSERT_EQ(::chmod(file.c_str(), 0444), 0);
  EXPECT_EXIT(write(), testing::ExitedWithCode(2),
              "cannot write '" + file + "': Permission denied");
  ASSERT_EQ(::chmod((folder / ".").c_str(), 0755), 0);
}

TEST(Database, NamesColumnsWhateverTheyAreCalled) {
  const test::TempFolder folder;
  Database database(folder / "x.db", Access::create);
  for (const std::string name : {"select", "a\"b", "trees.bvr/x.vote", "a); DROP TABLE t; --"}) {
    database.run("DROP TABLE IF EXISTS t; CREATE TABLE t (" + sql_name(name) + " REAL)");
    EXPECT_EQ(database.prepare("SELECT * FROM t").column_name(0), name);
  }
}

TEST(Database, PreparesOneStatement) {
  const test::TempFolder folder;
  Database database(folder / "x.db", Access::create);
  EXPECT_TRUE(database.prepare("SELECT 1;  -- one\n ; ").step());
  for (const char* text : {"", ";", "-- nothing", "SELECT 1; SELECT 2", "SELECT 1; nonsense"})
    EXPECT_THROW(static_cast<void>(database.prepare(text)), disk::Refused) << text;
}

TEST(Database, StopsAStatementWhenAsked) {
  Database database(":memory:", Access::create);
  static int asked = 0;
  database.stop_if(*[](void*) { return ++asked == 3 ? 1 : 0; });
  Statement endless = database.prepare(
      "WITH RECURSIVE r(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM r) SELECT sum(i) FROM r");
  EXPECT_TRUE(endless.reads_only());
  EXPECT_FALSE(endless.step());
  EXPECT_EQ(asked, 3);
}

TEST(Database, ThatIsAStrangersHasNoViewsAndTriggers) {
  const test::TempFolder folder;
  Database(folder / "x.db", Access::create)
      .run(
          "CREATE TABLE t (i); CREATE VIEW v AS SELECT 1; "
          "CREATE TRIGGER more AFTER INSERT ON t BEGIN INSERT INTO t VALUES (7); END");
  Database database(folder / "x.db", Access::write);
  database.distrust();
  EXPECT_THROW(static_cast<void>(database.prepare("SELECT * FROM v")), disk::Refused);
  database.run("INSERT INTO t VALUES (1)");
  Statement count = database.prepare("SELECT count(*) FROM t");
  ASSERT_TRUE(count.step());
  EXPECT_EQ(count.integer(0), 1);
}

TEST(Database, OfARelativePathIsNoUri) {
  const test::TempFolder folder;
  std::filesystem::create_directory(folder / "file:a");
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(folder.path());
  Database("file:a/x.db", Access::create).run("CREATE TABLE t (i)");
  std::filesystem::current_path(before);
  EXPECT_TRUE(std::filesystem::exists(folder / "file:a/x.db"));
}

/// As of a copy without `-shm` on a read-only disk: its place is taken by a link, which SQLite does
/// not follow.
TEST(Database, ReadsWhatAKilledProcessLeftWhereNothingCanBeMade) {
  const test::TempFolder folder;
  {
    Database left(folder / "left.db", Access::create);
    left.run("CREATE TABLE t (i); INSERT INTO t VALUES (7)");
    std::filesystem::copy(folder / "left.db", folder / "copy.db");
    std::filesystem::copy(folder / "left.db-wal", folder / "copy.db-wal");
  }
  std::filesystem::create_symlink("nowhere", folder / "copy.db-shm");
  const std::string log = test::read_text(folder / "copy.db-wal");
  {
    Database copy(folder / "copy.db", Access::read);
    Statement row = copy.prepare("SELECT i FROM t");
    ASSERT_TRUE(row.step());
    EXPECT_EQ(row.integer(0), 7);
  }
  EXPECT_EQ(test::read_text(folder / "copy.db-wal"), log);
}

}  // namespace
}  // namespace eyrie::sql
