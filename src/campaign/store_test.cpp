// SPDX-License-Identifier: MIT
#include "campaign/store.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include "support/campaign/made_up.hpp"
#include "support/program.hpp"

namespace eyrie::campaign {
namespace {

const Origin kOrigin{{"sweep.yaml", "a\nb\nc\n"}, {"eyrie", "0.1"}};

struct StoreTest : testing::Test {
  test::TempFolder folder;
  Spec spec = test::made_up_spec();
  std::vector<Cell> cells = cells_of(spec);

  [[nodiscard]] Store open(bool resume = true, const Origin& origin = kOrigin) const {
    return {folder / "out", spec, cells, origin, resume};
  }
  [[nodiscard]] std::string refused(bool resume, const Origin& origin = kOrigin) const {
    try {
      const Store store = open(resume, origin);
    } catch (const disk::Refused& e) {
      return e.what();
    }
    return "";
  }
  void put(Store& store, std::uint64_t cell, std::uint64_t n) const {
    for (std::uint64_t i = 0; i < n; ++i)
      store.put(test::made_up(spec, cell, store.counts()[cell]));
  }
};

TEST_F(StoreTest, GivesBackWhatWasPutInByCellAndReplicate) {
  {
    Store store = open(false);
    put(store, 2, 3);
    put(store, 0, 20);
    store.finish("complete");
  }
  Store store = open();
  EXPECT_EQ(store.counts(), (std::vector<std::uint64_t>{20, 0, 3}));
  std::uint64_t n = 0;
  store.each([&](const Result& r) {
    EXPECT_EQ(r.cell, n < 20 ? 0U : 2U);
    EXPECT_EQ(r.replicate, n < 20 ? n : n - 20);
    const Result expected = test::made_up(spec, r.cell, r.replicate);
    EXPECT_EQ(r.flown.seed, expected.flown.seed);
    EXPECT_EQ(r.flown.steps, expected.flown.steps);
    EXPECT_EQ(r.flown.hash, expected.flown.hash);
    EXPECT_EQ(r.flown.outcome, expected.flown.outcome);
    EXPECT_EQ(r.flown.time, expected.flown.time);
    EXPECT_EQ(r.flown.fault, expected.flown.fault);
    ASSERT_EQ(r.values.size(), expected.values.size());
    for (std::size_t i = 0; i < r.values.size(); ++i)
      EXPECT_TRUE(r.values[i] == expected.values[i] ||
                  (std::isnan(r.values[i]) && std::isnan(expected.values[i])));
    ++n;
  });
  EXPECT_EQ(n, 23U);
}

TEST_F(StoreTest, WritesATableWithARowForEachReplicate) {
  {
    Store store = open(false);
    put(store, 1, 17);
    store.finish("complete");
  }
  EXPECT_EQ(folder.everything(),
            (std::vector<std::string>{"out", "out/results.csv", "out/results.db"}));
  const std::string table = test::read_text(folder / "out/results.csv");
  EXPECT_EQ(table.substr(0, table.find('\n')),
            "cell,bingo,replicate,seed,outcome,time_s,steps,hash,end,kills,Kills_,won");
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 18);
  EXPECT_NE(table.find("\n1,2200 kg,16,17,fault,"), std::string::npos) << table;
}

TEST_F(StoreTest, TellsTheCommandThatFliesAFaultAgain) {
  {
    Store store = open(false);
    put(store, 1, 17);
  }
  Database database(folder / "out/results.db", Database::Access::read);
  Statement fault = database.prepare("SELECT what, command FROM faults");
  ASSERT_TRUE(fault.step());
  EXPECT_EQ(fault.text(0), "threw: no 'fuel'");
  EXPECT_EQ(fault.text(1), "eyrie fly none --set 'blue.flights.eagle.bingo=2200 kg' --seed 17");
  EXPECT_FALSE(fault.step());
}

TEST_F(StoreTest, HashesWhatIsThereWhateverTheOrderInWhichItCame) {
  const auto hash_of = [&](std::vector<std::uint64_t> order) {
    const test::TempFolder other;
    Store store(other / "out", spec, cells, kOrigin, false);
    for (const std::uint64_t cell : order)
      put(store, cell, 1);
    return store.hash();
  };
  EXPECT_EQ(hash_of({0, 0, 1}), hash_of({1, 0, 0}));
  EXPECT_NE(hash_of({0, 0, 1}), hash_of({0, 1, 1}));
  EXPECT_NE(hash_of({0}), hash_of({}));
}

TEST_F(StoreTest, RefusesAnotherOriginWithTheDifference) {
  { const Store store = open(false); }
  EXPECT_EQ(refused(true), "");
  Origin other = kOrigin;
  other["sweep.yaml"] = "a\nB\nc\n";
  EXPECT_NE(refused(true, other).find("\n  'sweep.yaml', line 2, column 1: was 'b', is 'B'"),
            std::string::npos)
      << refused(true, other);
  other = {{"eyrie", "0.1"}, {"merge.yaml", ""}};
  EXPECT_NE(
      refused(true, other).find("\n  'sweep.yaml' is used no more\n  'merge.yaml' was not used"),
      std::string::npos)
      << refused(true, other);
}

TEST_F(StoreTest, RefusesWhatIsThereAndASecondWriter) {
  folder.write("out/thesis.tex", "kept");
  EXPECT_NE(refused(true).find("is there already, and is no campaign"), std::string::npos);
  std::filesystem::remove_all(folder / "out");
  std::filesystem::create_directory(folder / "out");
  Database(folder / "out/results.db", Database::Access::create).run("CREATE TABLE mine (x)");
  const std::string before = test::read_text(folder / "out/results.db");
  EXPECT_NE(refused(true).find("results.db' is there already, and is no campaign"),
            std::string::npos);
  EXPECT_EQ(test::read_text(folder / "out/results.db"), before);
  std::filesystem::remove_all(folder / "out");
  const Store store = open(true);  // there is nothing to go on with
  EXPECT_NE(refused(false).find("--resume goes on with it"), std::string::npos);
  EXPECT_NE(refused(true).find("another process is working on"), std::string::npos);
}

TEST_F(StoreTest, LosesNothingThatWasCommittedWhenItIsKilled) {
  const auto killed = [&](std::uint64_t committed) {
    const pid_t child = ::fork();
    if (child == 0) {
      Store store = open();
      put(store, 0, committed);
      store.flush();
      if (committed)
        put(store, 0, 2);
      ::kill(::getpid(), SIGKILL);
    }
    ::waitpid(child, nullptr, 0);
    return open().counts()[0];
  };
  EXPECT_EQ(killed(0), 0U);
  EXPECT_EQ(killed(5), 5U);
  EXPECT_EQ(killed(3), 8U);
}

TEST_F(StoreTest, IsCompleteThoughSomebodyIsReading) {
  {
    Store store = open(false);
    put(store, 0, 3);
    store.flush();
    Database reader(folder / "out/results.db", Database::Access::read);
    Statement rows = reader.prepare("SELECT * FROM replicates");
    ASSERT_TRUE(rows.step());
    store.finish("complete");
  }
  EXPECT_TRUE(std::filesystem::exists(folder / "out/results.csv"));
  Database results = open_results(folder / "out");
  Statement hash = results.prepare("SELECT value FROM campaign WHERE name = 'hash'");
  EXPECT_TRUE(hash.step());
}

TEST_F(StoreTest, KeepsNamesOfLevelsAsTheyAreWritten) {
  const auto values = [&](std::vector<std::string> names) {
    const test::TempFolder other;
    for (std::size_t i = 0; i < 3; ++i)
      cells[i].values = {names[i]};
    { const Store store(other / "out", spec, cells, kOrigin, false); }
    Database database = open_results(other / "out");
    Statement all = database.prepare("SELECT bingo, typeof(bingo) FROM cells ORDER BY cell");
    std::string said;
    while (all.step())
      said += all.text(0) + " " + all.text(1) + ", ";
    return said;
  };
  EXPECT_EQ(values({"1.1", "1.10", "007"}), "1.1 text, 1.10 text, 007 text, ");
  EXPECT_EQ(values({"1e400", "12345678901234567890", ""}),
            "1e400 text, 12345678901234567890 text,  text, ");
  EXPECT_EQ(values({"9", "2.5", "-10"}), "9 integer, 2.5 real, -10 integer, ") << "to be sorted";
}

TEST_F(StoreTest, HasNoHashWhileResultsAreAdded) {
  {
    Store store = open(false);
    put(store, 0, 3);
    store.finish("complete");
  }
  const auto hashes = [&] {
    Database database = open_results(folder / "out");
    Statement found = database.prepare("SELECT value FROM campaign WHERE name = 'hash'");
    return found.step() ? found.text(0) : "";
  };
  EXPECT_NE(hashes(), "");
  Store store = open();
  EXPECT_NE(hashes(), "");
  put(store, 0, 1);
  store.flush();
  EXPECT_EQ(hashes(), "");
  store.finish("complete");
  EXPECT_EQ(hashes(), hash_text(store.hash()));
}

TEST_F(StoreTest, RefusesTablesOfAnotherVersionAndNone) {
  const auto words = [&] {
    try {
      static_cast<void>(open_results(folder / "out"));
    } catch (const disk::Refused& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  { const Store store = open(false); }
  EXPECT_EQ(words(), "");
  Database(folder / "out/results.db", Database::Access::write)
      .run("UPDATE campaign SET value = '2' WHERE name = 'format'");
  EXPECT_NE(words().find("results.db' was written by another version of Eyrie: its format is '2'"),
            std::string::npos)
      << words();
  EXPECT_EQ(refused(true), words());
  folder.write("out/results.db", "");
  EXPECT_NE(words().find("results.db' is no campaign"), std::string::npos) << words();
  EXPECT_EQ(refused(true), "") << "begun, and killed at once";
}

TEST_F(StoreTest, KeepsEachReplicateOnce) {
  Store store = open(false);
  store.put(test::made_up(spec, 0, 0));
  EXPECT_THROW(store.put(test::made_up(spec, 0, 0)), disk::Failed);
}

}  // namespace
}  // namespace eyrie::campaign
