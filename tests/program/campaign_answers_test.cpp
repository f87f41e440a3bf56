// SPDX-License-Identifier: MIT
/// \file  What a campaign says when it is asked: its report, SQL, and replicates flown again.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <nlohmann/json.hpp>

#include "sql/database.hpp"
#include "support/campaign/two_speeds.hpp"
#include "support/plugin.hpp"

namespace eyrie::test {
namespace {

TEST_F(Campaign, ReportsOnAPageThatNoNameCanBreak) {
  folder.write("c.yaml", R"y(eyrie: 1
name: "</script><script>alert(1)"
scenario: small.yaml
factors:
  speed: {path: blue.flights.eagle.start.speed, values: {"<b>": 400 kt, "@DATA@": 480 kt}}
replicates: 3
measures:
  end: {what: end_time}
)y");
  ASSERT_EQ(run("out").code, 0);
  const Ran ran = run_program(folder, {"report", "out"});
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(ran.out.find("cells against each other"), std::string::npos) << ran.out;
  const std::string page = read_text(folder / "out/report.html");
  const std::string begin = R"(id="data">)";
  const auto at = page.find(begin) + begin.size(), end = page.find("</script>", at);
  const auto data = nlohmann::json::parse(page.substr(at, end - at), nullptr, false);
  ASSERT_FALSE(data.is_discarded()) << page.substr(at, end - at);
  EXPECT_EQ(data["name"], "</script><script>alert(1)");
  EXPECT_EQ(data["cells"][1]["values"][0], "@DATA@");
  EXPECT_EQ(data["replicates"].size(), 6U);
  EXPECT_EQ(page.find("alert(1)", end), page.npos);
  for (const char* source : {"out/results.db", "out/results.csv"}) {
    const std::string before = read_text(folder / source);
    const Ran over = run_program(folder, {"report", "out", "--out", source, "--force"});
    EXPECT_EQ(over.code, 2);
    EXPECT_NE(over.err.find("is what it would be made from"), std::string::npos) << over.err;
    EXPECT_TRUE(read_text(folder / source) == before);
  }
  const Ran of_one = run_program(folder, {"report", "out", "--of", "edn"});
  EXPECT_EQ(of_one.code, 2);
  EXPECT_NE(of_one.err.find("there is no measure 'edn'; did you mean 'end'?"), std::string::npos)
      << of_one.err;
}

TEST_F(Campaign, ReportsWithTheEngineOrSaysWhyNot) {
  folder.write("c.yaml", changed({"replicates: 40", "replicates: 2"}));
  folder.write("shell.html",
               "<script type=\"application/x-eyrie-engine\">x</script><!--%PARTS%-->");
  ASSERT_EQ(run("out").code, 0);
  ASSERT_EQ(run("with", {"--plugin", plugin("faulty")}).code, 0);
  /// why no replicate can be flown in the page, and the page that would
  const auto debrief = [&](std::vector<std::string> command, const std::string& viewer) {
    command.insert(command.begin(), "report");
    const Ran ran = run_program(folder, command, {.viewer = viewer});
    EXPECT_EQ(ran.code, 0) << ran.err;
    const std::string page = read_text(folder / command[1] + "/report.html");
    const auto element = [&](const std::string& id) {
      const std::string mark = fmt::format("id=\"{}\">", id);
      const auto at = page.find(mark) + mark.size();
      return page.substr(at, page.find("</script>", at) - at);
    };
    return std::pair{nlohmann::json::parse(element("data"))["debrief"].get<std::string>(),
                     element("debrief")};
  };
  const auto [why, page] = debrief({"out"}, folder / "shell.html");
  EXPECT_EQ(why, "");
  EXPECT_GT(page.size(), 1000U);
  using Pair = std::pair<std::string, std::string>;
  EXPECT_EQ(debrief({"out"}, folder / "none.html"), Pair("the debrief page was not built", ""));
  EXPECT_EQ(debrief({"out"}, RunOptions{}.viewer),
            Pair("the debrief page was built without its engine", ""));
  EXPECT_EQ(debrief({"with", "--plugin", plugin("faulty")}, folder / "shell.html"),
            Pair("it needs plug-ins, which a page cannot open", ""));
}

// what DuckDB writes is compared by tools/check-parquet
TEST_F(Campaign, SaysWhatParquetNeeds) {
  folder.write("c.yaml", changed({"replicates: 40", "replicates: 1"}));
  ASSERT_EQ(run("out").code, 0);
  folder.write("libduckdb.so", "none");
  const Ran ran = run_program(folder, {"report", "out", "--parquet"});
  EXPECT_EQ(ran.code, 2);
  EXPECT_NE(ran.err.find("libduckdb.so: file too short. 'npm install @duckdb/node-bindings-linux-"),
            ran.err.npos)
      << ran.err;
  EXPECT_FALSE(std::filesystem::exists(folder / "out/report.html"));
}

TEST_F(Campaign, SaysWhatIsDamaged) {
  undisturbed();
  // by somebody who takes away what would tell him
  const auto spoiled = [&](const std::string& sql) {
    const std::string out = "spoiled";
    std::filesystem::remove_all(folder / out);
    std::filesystem::copy(folder / "undisturbed", folder / out);
    sql::Database(folder / out + "/results.db", sql::Database::Access::write)
        .run("DELETE FROM campaign WHERE name IN ('hash', 'design'); " + sql);
    std::string said;
    for (const std::vector<std::string>& command :
         {std::vector<std::string>{"report", out}, {"query", out, "--decisions", "1 s"}}) {
      const Ran ran = run_program(folder, command);
      EXPECT_TRUE(ran.code == 0 || ran.code == 2) << sql << ran.code << ran.err;
      EXPECT_EQ(ran.err.find("please report"), ran.err.npos) << ran.err;
      said += ran.err;
    }
    return said;
  };
  EXPECT_NE(spoiled("UPDATE measures SET of = 'none'").find("damaged: there is no column 'none'"),
            std::string::npos);
  EXPECT_NE(spoiled("UPDATE replicates SET cell = 7 WHERE cell = 1").find("there is no cell 7"),
            std::string::npos);
  EXPECT_NE(spoiled("UPDATE replicates SET hash = 'x' WHERE seed = 3").find("ends otherwise"),
            std::string::npos);
  EXPECT_NE(spoiled("DROP TABLE cells").find("no such table: cells"), std::string::npos);
  EXPECT_NE(spoiled("DELETE FROM origin"), "");
  // a table that never ends
  EXPECT_NE(
      spoiled("PRAGMA foreign_keys = 0; DROP TABLE cells; CREATE VIEW cells AS WITH RECURSIVE "
              "r(cell) AS (SELECT 0 UNION ALL SELECT cell + 1 FROM r) SELECT cell, 'x' AS "
              "command FROM r")
          .find("no such table"),
      std::string::npos);
  spoiled("UPDATE replicates SET \"end\" = 'x', outcome = NULL, seed = 'y'");
  spoiled("DELETE FROM measures");
  spoiled("DELETE FROM cells");
}

TEST_F(Campaign, AnswersSqlAndIsChangedByNone) {
  undisturbed();
  const auto asked = [&](const std::string& sql) {
    return run_program(folder, {"query", "undisturbed", sql});
  };
  EXPECT_EQ(asked("SELECT c.speed, count(*) AS n, avg(\"end\") AS \"end\" FROM replicates r "
                  "JOIN cells c USING (cell) GROUP BY cell")
                .out,
            "speed,n,end\n400 kt,40,60\n480 kt,40,60\n");
  const Ran wrong = asked("SELECT speed FROM replicates");
  EXPECT_EQ(wrong.code, 2);
  EXPECT_NE(wrong.err.find("no such column: speed"), std::string::npos) << wrong.err;
  for (const char* none : {"DELETE FROM replicates", "SELECT 1; SELECT 2", ";", "-- nothing",
                           "PRAGMA user_version = 1", "SELECT abs(-9223372036854775808)",
                           "INSERT INTO campaign VALUES ('x', 1) RETURNING name"}) {
    const Ran refused = asked(none);
    EXPECT_EQ(refused.code, 2) << none;
    EXPECT_EQ(refused.out, "") << none;
    EXPECT_NE(refused.err, "") << none;
  }
  EXPECT_EQ(asked("SELECT count(*) FROM replicates").out, "count(*)\n80\n");
  EXPECT_EQ(asked("SELECT x'1b5b410a', 7, 0.5, NULL, '=1' AS t").out,
            "x'1b5b410a',7,0.5,NULL,t\n\\x1b[A\\x0a,7,0.5,,'=1\n");
  EXPECT_EQ(asked("SELECT 1e300*1e300 AS x").err,
            "eyrie: the result is infinite in the column 'x'\n");
  EXPECT_EQ(run_program(folder, {"query", "nowhere", "SELECT 1"}).code, 2);
  EXPECT_EQ(asked("SELECT count(*) FROM losses").err,
            "eyrie: there is no table 'losses' yet; --decisions '10 s' adds it\n");
  EXPECT_EQ(asked("SELECT count(*) FROM lossesx").err.find("--decisions"), std::string::npos);
}

TEST_F(Campaign, StopsAnAnswerThatNobodyWaitsFor) {
  folder.write("c.yaml", changed({"replicates: 40", "replicates: 1"}));
  ASSERT_EQ(run("out").code, 0);
  const Ran ran = run_line(folder, R"sh(
    ulimit -t 60
    all="WITH RECURSIVE r(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM r) SELECT i FROM r"
    "$EYRIE" query out --decisions '1 s' "$all" >said & asked=$!
    until [ -s said ]; do sleep 0.02; done
    kill -TERM $asked; wait $asked; echo $?
    { "$EYRIE" query out --decisions '1 s' "$all"; echo $? >code; } | head -n 1; cat code)sh");
  EXPECT_EQ(ran.out, "143\ni\n141\n") << ran.err;
}

TEST_F(Campaign, LeavesResultsThatItRefusesAsTheyAre) {
  folder.write("c.yaml", changed({"replicates: 40", "replicates: 1"}));
  ASSERT_EQ(run("out").code, 0);
  const std::string file = folder / "out/results.db", before = read_text(file);
  folder.write("c.yaml", changed({"replicates: 40", "replicates: 1\nset: [until=9 s]"}));
  EXPECT_EQ(run("out", {"--resume"}).code, 2);
  EXPECT_EQ(read_text(file), before);
  for (const char* sql : {"DELETE FROM origin", "UPDATE replicates SET hash = 'x'"}) {
    sql::Database(file, sql::Database::Access::write)
        .run(std::string(sql) + "; PRAGMA journal_mode=DELETE");
    EXPECT_EQ(run_program(folder, {"query", "out", "--decisions", "1 s"}).code, 2) << sql;
    EXPECT_EQ(read_text(file).substr(18, 2), before.substr(18, 2)) << "in WAL mode";
    folder.write("out/results.db", before);
  }
}

TEST_F(Campaign, RefusesResultsThatAreNone) {
  std::filesystem::create_directory(folder / "out");
  const std::string file = folder / "out/results.db";
  for (const bool foreign : {false, true}) {
    folder.write("out/results.db", foreign ? "" : std::string(5000, 'x'));
    if (foreign)
      sql::Database(file, sql::Database::Access::write).run("CREATE TABLE campaign (x)");
    for (const std::vector<std::string>& command :
         {std::vector<std::string>{"report", "out"},
          {"campaign", "c.yaml", "--out", "out", "--resume"},
          {"query", "out", "SELECT * FROM replicates"},
          {"query", "out", "--decisions", "1 s"}}) {
      const Ran ran = run_program(folder, command);
      EXPECT_EQ(ran.code, 2) << command[0] << foreign << ran.err;
      EXPECT_EQ(ran.out, "");
    }
  }
}

TEST_F(Campaign, WaitsForNoPipeInThePlaceOfResults) {
  std::filesystem::create_directory(folder / "out");
  ASSERT_EQ(::mkfifo((folder / "out/results.db").c_str(), 0600), 0);
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"report", "out"},
        {"campaign", "c.yaml", "--out", "out", "--resume"},
        {"query", "out", "SELECT * FROM replicates"},
        {"query", "out", "--decisions", "1 s"}}) {
    const Ran ran = run_program(folder, command);
    EXPECT_EQ(ran.code, 2) << command[0];
    EXPECT_EQ(ran.err, "eyrie: 'out/results.db' is a pipe, not a file\n");
  }
}

TEST_F(Campaign, RefusesAPageThatIsThereBeforeItReports) {
  folder.write("c.yaml", changed({"replicates: 40", "replicates: 1"}));
  folder.write("page.html", "kept");
  ASSERT_EQ(run("out").code, 0);
  const Ran ran = run_program(folder, {"report", "out", "--out", "page.html"});
  EXPECT_EQ(ran.code, 2);
  EXPECT_EQ(ran.out, "");
}

/// As of results in a folder that only others may write, or that is mounted read-only.
TEST_F(Campaign, ReportsElsewhereWithoutWritingIntoTheResults) {
  folder.write("c.yaml", changed({"replicates: 40", "replicates: 1"}));
  ASSERT_EQ(run("out").code, 0);
  folder.write("out/results.csv", "nobody writes here");
  EXPECT_EQ(run_program(folder, {"report", "out", "--out", "page.html"}).code, 0);
  EXPECT_EQ(table("out"), "nobody writes here");
  EXPECT_EQ(run_program(folder, {"report", "out"}).code, 0);
  EXPECT_NE(table("out"), "nobody writes here") << "beside the page";
}

TEST_F(Campaign, TellsWhatTheLostDecidedBefore) {
  folder.write("c.yaml", R"(eyrie: 1
name: lost
scenario: merge
replicates: 5
measures:
  blue: {what: losses, who: blue}
  red: {what: losses, who: red}
)");
  ASSERT_EQ(run("out").code, 0);
  const auto asked = [&](const std::string& sql) {
    const Ran ran = run_program(folder, {"query", "out", sql, "--decisions", "5 s"});
    EXPECT_EQ(ran.code, 0) << ran.err;
    return ran.out.substr(ran.out.find('\n') + 1);
  };
  const std::string lost = asked("SELECT sum(blue + red) FROM replicates");
  EXPECT_GE(std::stod(lost), 1);
  EXPECT_EQ(std::stod(asked("SELECT count(*) FROM losses")), std::stod(lost));
  // ten decisions a second, of each somebody decided something
  EXPECT_EQ(asked("SELECT count(*) FROM losses l WHERE (SELECT count(DISTINCT time_s) FROM "
                  "decisions d WHERE (d.cell, d.replicate, d.loss) = (l.cell, l.replicate, l.loss) "
                  "AND before_s BETWEEN 0 AND 5) NOT BETWEEN 45 AND 51"),
            "0\n");
  EXPECT_EQ(asked("SELECT count(*) FROM losses WHERE time_s <> round(time_s * 50) * 0.02"), "0\n")
      << "as the steps of the clock, without rounding";
  EXPECT_EQ(asked("SELECT count(*) FROM decisions WHERE before_s NOT BETWEEN 0 AND 5"), "0\n");

  sql::Database(folder / "out/results.db", sql::Database::Access::write)
      .run("DELETE FROM looked_at WHERE replicate > 1; PRAGMA journal_mode=DELETE");
  EXPECT_EQ(run_program(folder, {"query", "out", "SELECT count(*) > 0 FROM Losses"}).err,
            "eyrie: losses and decisions of the last 5 s are there of 2 of 5 replicates; "
            "--decisions adds the others\n");

  // and every query of the page
  const std::string page = read_text(source_root() + "/docs/campaigns.md");
  const std::string begin = "```sql\n";
  int queries = 0;
  for (auto at = page.find(begin); at != page.npos; at = page.find(begin, at), ++queries) {
    at += begin.size();
    const std::string sql = page.substr(at, page.find("```", at) - at);
    EXPECT_NE(asked(sql), "") << sql;
  }
  EXPECT_GE(queries, 5);
}

TEST_F(Campaign, DrawsTheWaysFlown) {
  ASSERT_EQ(run("out").code, 0);
  const auto ways = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"report", "out"});
    const Ran ran = run_program(folder, more);
    EXPECT_EQ(ran.code, 0) << ran.err;
    const std::string page = read_text(folder / "out/report.html"), mark = "id=\"data\">";
    const auto at = page.find(mark) + mark.size();
    return nlohmann::json::parse(page.substr(at, page.find("</script>", at) - at))["ways"];
  };
  EXPECT_TRUE(ways({"--ways", "0"}).empty());
  EXPECT_EQ(ways({"--ways", "3", "--workers", "2"}).size(), 2U * 3 * 2)
      << "two cells, two aircraft";
  const auto all = ways({});
  ASSERT_EQ(all.size(), 2U * 5 * 2);
  for (const auto& way : all) {
    ASSERT_GE(way.size(), 5U + 2 * 2) << "the beginning and the end";
    EXPECT_LT(way.size(), 5U + 2 * 10) << "of 31 looks at who flies straight on";
    EXPECT_EQ(way[3], "blue");
    EXPECT_EQ(way[4], false);
  }
  // eagle1 at 400 kt, eastwards from the reference point: six to seven miles in a minute
  EXPECT_EQ(all[0][2], "eagle1");
  EXPECT_EQ(all[0][5], 0);
  EXPECT_NEAR(all[0][all[0].size() - 2].get<int>(), 700, 80);
  EXPECT_NEAR(all[0].back().get<int>(), 0, 10);
}

TEST_F(Campaign, NamesTheFoldersThatMayBeIncludedInItsCommands) {
  folder.write("others/base.yaml", read_text(folder / "small.yaml"));
  folder.write("mine/own.yaml", "extends: ../others/base.yaml\nname: own\n");
  folder.write("c.yaml", R"(eyrie: 1
name: above
scenario: mine/own.yaml
factors: {seed: {path: blue.flights.eagle.start.speed, values: [400 kt, 480 kt]}}
replicates: 1
measures: {seed: {what: end_time}}
)");
  ASSERT_EQ(run("out", {"--allow-include", "others"}).code, 0);
  const Ran said = run_program(folder, {"query", "out", "SELECT command FROM cells"});
  const std::string command = said.out.substr(said.out.find('\n') + 1);
  EXPECT_NE(command.find("--allow-include others"), std::string::npos) << said.out << said.err;
  const std::string table = read_text(folder / "out/results.csv");
  EXPECT_TRUE(table.starts_with("cell,seed_,replicate,seed,outcome,time_s,steps,hash,seed__\n"))
      << table;
}

TEST_F(Campaign, LeavesOutOfTheCommandOfACellWhatTheCellSetsOtherwise) {
  folder.write("c.yaml", R"(eyrie: 1
name: ends
scenario: small.yaml
set: ['"until"=5 s']
factors: {end: {levels: {set: blue.flights.eagle.start.speed=400 kt, own: until=3 s}}}
replicates: 1
measures: {ended: {what: end_time}}
)");
  ASSERT_EQ(run("out").code, 0);
  const Ran said = run_program(folder, {"query", "out", "SELECT command FROM cells"});
  EXPECT_EQ(said.out,
            "command\n\"eyrie fly small.yaml --set '\"\"until\"\"=5 s' "
            "--set 'blue.flights.eagle.start.speed=400 kt'\"\n"
            "eyrie fly small.yaml --set 'until=3 s'\n");
  EXPECT_EQ(run_program(folder, {"query", "out", "SELECT ended FROM replicates"}).out,
            "ended\n5\n3\n");
}

TEST_F(Campaign, FliesAgainWhatIncludesFilesAboveItsFolder) {
  folder.write("c.yaml", fmt::format(R"(eyrie: 1
name: above
scenario: {}/studies/architectures/mission.yaml
set: [until=9 min]
replicates: 2
measures: {{end: {{what: end_time}}}}
)",
                                     source_root()));
  ASSERT_EQ(run("out").code, 0);
  const Ran ran = run_program(
      folder, {"query", "out", "SELECT count(*) > 0 FROM losses", "--decisions", "1 s"});
  EXPECT_EQ(ran.out, "count(*) > 0\n1\n") << ran.err;
}

}  // namespace
}  // namespace eyrie::test
