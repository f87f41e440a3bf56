// SPDX-License-Identifier: MIT
/// \file  Campaigns through the real program: the same table whoever flies, however often it is
/// killed.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "sql/database.hpp"
#include "support/campaign/background.hpp"
#include "support/campaign/two_speeds.hpp"
#include "support/plugin.hpp"

namespace eyrie::test {
namespace {

TEST_F(Campaign, GivesTheSameTableAndHashForAnyNumberOfWorkers) {
  const Ran one = run("one", {"--workers", "1"}), four = run("four", {"--workers", "4"});
  EXPECT_EQ(one.code, 0) << one.err;
  const std::string all = table("one");
  EXPECT_EQ(all, table("four"));
  EXPECT_EQ(std::count(all.begin(), all.end(), '\n'), 81);
  EXPECT_EQ(hash_in(one), hash_in(four));
  EXPECT_NE(one.out.find("0     400 kt  40  60 (no bounds)"), std::string::npos) << one.out;
}

TEST_F(Campaign, KilledAtAnyMomentGoesOnToTheSameTable) {
  const auto before = used_by_processes();
  undisturbed();
  const auto whole = used_by_processes() - before;
  int killed = 0;
  for (int i = 0; i < 20; ++i) {
    const std::string out = fmt::format("killed{}", i);
    for (int times = 0; times < 2; ++times) {
      const Background process(folder,
                               {"campaign", "c.yaml", "--out", out, "--resume", "--workers", "2"},
                               whole * ((i * 7 + times * 3) % 20 + 1) / 21);
      killed += process.end(0) == -SIGPROF;
    }
    const Ran ran = run(out, {"--resume"});
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(table(out), undisturbed()) << i;
  }
  EXPECT_GE(killed, 20);
}

TEST_F(Campaign, InterruptedKeepsWhatWasFlownAndSaysHowToGoOn) {
  folder.write("c.yaml", changed({"replicates: 40", "replicates: 100000"}));
  const Background process(folder, {"campaign", "c.yaml", "--out", "cut"});
  const auto kept = [&] {
    try {
      sql::Database results(folder / "cut/results.db", sql::Database::Access::read);
      sql::Statement rows = results.prepare("SELECT count(*) FROM replicates");
      return rows.step() ? rows.integer(0) : 0;
    } catch (const std::exception&) {  // it is not yet there
      return std::int64_t{0};
    }
  };
  while (kept() == 0)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  const Ran asked = run_program(folder, {"query", "cut", "--decisions", "1 s"});
  EXPECT_EQ(asked.code, 2);
  EXPECT_NE(asked.err.find("another process is working on the campaign in 'cut'; wait"),
            std::string::npos)
      << asked.err;
  EXPECT_EQ(process.end(SIGINT), 128 + SIGINT) << read_text(folder / "err");
  EXPECT_NE(read_text(folder / "said").find("eyrie campaign c.yaml --out cut --resume goes on"),
            std::string::npos)
      << read_text(folder / "said");
  const Ran report = run_program(folder, {"report", "cut", "--ways", "0"});
  EXPECT_NE(report.out.find("\nnot the whole campaign: interrupted\n"), std::string::npos)
      << report.out << report.err;
  const std::string all = table("cut");
  EXPECT_GE(std::count(all.begin(), all.end(), '\n'), 2) << all;
}

TEST_F(Campaign, StopsCleanlyOnAFullDiskAndGoesOnWhenThereIsRoom) {
  const Ran full = run("full", {}, {.file_size_limit = 64 * 1024});
  EXPECT_EQ(full.code, 1) << full.out;
  EXPECT_NE(full.err.find("full/results.db"), std::string::npos) << full.err;
  EXPECT_NE(full.err.find("File too large"), std::string::npos) << full.err;
  const Ran ran = run("full", {"--resume"});
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(table("full"), undisturbed());
}

TEST_F(Campaign, NamesNoScenarioOutsideItsFolder) {
  folder.write("secret.yaml", "hunter2");
  folder.write("merge", "hunter2");
  std::filesystem::create_directory(folder / "in");
  std::filesystem::create_symlink("../secret.yaml", folder / "in/link.yaml");
  const auto said = [&](const std::string& scenario, std::vector<std::string> more = {}) {
    folder.write("in/c.yaml", changed({"small.yaml", scenario}));
    std::vector<std::string> words{"campaign", "in/c.yaml", "--out", "out"};
    words.insert(words.end(), more.begin(), more.end());
    const Ran ran = run_program(folder, words);
    EXPECT_EQ(ran.code, 2);
    EXPECT_EQ(ran.err.find("hunter2"), std::string::npos) << ran.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "out"));
    return ran.err;
  };
  for (const std::string name :
       {"../secret.yaml", "link.yaml", "eyrie:../../../../etc/hostname", "/etc/passwd.yaml"})
    EXPECT_TRUE(said(name).find("is outside the folder of") != std::string::npos ||
                said(name).find("there is no scenario") != std::string::npos)
        << said(name);
  EXPECT_NE(said("../secret.yaml").find("in/c.yaml:3:11: '"), std::string::npos);
  EXPECT_NE(said("../small").find("there is no scenario '../small'"), std::string::npos);
  EXPECT_NE(said("''").find("in/c.yaml:3:11: scenario: expected a name or a file"),
            std::string::npos);
  EXPECT_EQ(said("merge").find("expected a map"), std::string::npos) << "ours is meant";
}

TEST_F(Campaign, RefusesToGoOnWithSomethingElse) {
  ASSERT_EQ(run("out").code, 0);
  const std::string before = read_text(folder / "out/results.db");
  const auto refused = [&](std::vector<std::string> more, const std::string& words) {
    const Ran ran = run("out", std::move(more));
    EXPECT_EQ(ran.code, 2);
    EXPECT_NE(ran.err.find(words), std::string::npos) << ran.err;
    EXPECT_EQ(table("out").size(), undisturbed().size());
  };
  refused({}, "'out' is there already: --resume goes on with it");
  folder.write("c.yaml", changed({"[400 kt, 480 kt]", "[400 kt, 490 kt]"}));
  refused({"--resume"},
          "\n  'the campaign', line 5, column 67: was ', values: [400 kt, 480 kt]}', is ', values: "
          "[400 kt, 490 kt]}'\n");
  folder.write("c.yaml", kCampaign);
  folder.write("small.yaml",
               changed_scenario({{"until: 2 s", "until: 60 s"}, {"vote: 10,", "vote: 11,"}}));
  refused({"--resume"},
          "\n  'small.yaml', line 10, column 27: was '- navigate: {vote: 10, speed: 480 "
          "kt}', is '- navigate: {vote: 11, speed: 480 kt}'\n");
  folder.write("small.yaml", changed_scenario({{"until: 2 s", "until: 60 s"}}));
  EXPECT_EQ(run("out", {"--resume"}).code, 0);
  EXPECT_EQ(table("out"), undisturbed());
}

TEST_F(Campaign, RefusesResultsThatWereChangedByHand) {
  folder.write("c.yaml", changed({"replicates: 40", "replicates: 2"}));
  ASSERT_EQ(run("out").code, 0);
  EXPECT_EQ(run("out", {"--resume"}).code, 0);
  const std::string file = folder / "out/results.db", whole = read_text(file);
  for (const auto& [sql, what] :
       {std::pair("UPDATE replicates SET \"end\" = 1 WHERE cell = 1", "flown"),
        std::pair("DELETE FROM replicates WHERE replicate = 1", "flown"),
        std::pair("DELETE FROM cells WHERE cell = 0", "begun"),
        std::pair("UPDATE cells SET speed = '2'", "begun"),
        std::pair("UPDATE measures SET kind = 'x'", "begun")}) {
    folder.write("out/results.db", whole);
    sql::Database(file, sql::Database::Access::write)
        .run(std::string(sql) + "; PRAGMA journal_mode=DELETE");
    const std::string before = read_text(file);
    const Ran ran = run("out", {"--resume"});
    EXPECT_EQ(ran.code, 2) << sql;
    EXPECT_NE(ran.err.find(fmt::format("'out/results.db' was changed after it was {}: the hash of "
                                       "what is there is 0x",
                                       what)),
              std::string::npos)
        << ran.err;
    EXPECT_EQ(read_text(file), before) << "left as it is";
  }
}

TEST_F(Campaign, RefusesATableThatIsNoFileBeforeItFlies) {
  folder.write("c.yaml", changed({"replicates: 40", "replicates: 1"}));
  ASSERT_EQ(run("out").code, 0);
  std::filesystem::remove(folder / "out/results.csv");
  std::filesystem::create_symlink("elsewhere.csv", folder / "out/results.csv");
  folder.write("c.yaml", changed({"replicates: 40", "replicates: 2"}));
  for (const Ran& ran : {run("out", {"--resume"}), run_program(folder, {"report", "out"})}) {
    EXPECT_EQ(ran.code, 2);
    EXPECT_EQ(ran.err, "eyrie: 'out/results.csv' is a symbolic link; only files are replaced\n");
  }
  EXPECT_EQ(run_program(folder, {"query", "out", "SELECT count(*) AS n FROM replicates"}).out,
            "n\n2\n");
  EXPECT_FALSE(std::filesystem::exists(folder / "out/report.html"));
}

TEST_F(Campaign, GoesOnToMoreReplicatesThanItWasBegunWith) {
  const std::string more = changed({"replicates: 40", "replicates: 60"});
  ASSERT_EQ(run("out").code, 0);
  for (const int number : {1, 2})
    ASSERT_EQ(run("in2", {"--part", fmt::format("{}/2", number)}).code, 0);
  ASSERT_EQ(run("in2", {"--join"}).code, 0);
  folder.write("c.yaml", more);
  const Ran whole = run("whole"), resumed = run("out", {"--resume"});
  EXPECT_EQ(resumed.code, 0) << resumed.err;
  EXPECT_EQ(hash_in(resumed), hash_in(whole));
  EXPECT_EQ(table("out"), table("whole"));
  // and in the parts
  EXPECT_NE(run("in2", {"--join"}).err.find("part 1 of 2 has 40 of 60 replicates"),
            std::string::npos);
  for (const int number : {1, 2})
    ASSERT_EQ(run("in2", {"--part", fmt::format("{}/2", number), "--resume"}).code, 0);
  ASSERT_EQ(run("in2", {"--join"}).code, 0);
  EXPECT_EQ(table("in2"), table("whole"));
  EXPECT_EQ(
      run_program(folder, {"query", "out", "SELECT count(*) FROM losses", "--decisions", "1 s"})
          .code,
      0);
  folder.write("c.yaml", kCampaign);
  EXPECT_NE(run("out", {"--resume"}).err.find("was 'replicates: 60', is 'replicates: 40'"),
            std::string::npos);
}

TEST_F(Campaign, AtTheEndOfItsBudgetSaysThatItNeedsALargerOne) {
  const std::string budget = "replicates: 40\nbudget: {replicates: ";
  const std::string end =
      "eyrie campaign c.yaml --out out --resume goes on when its file has a "
      "larger budget\n";
  folder.write("c.yaml", changed({"replicates: 40", budget + "3}"}));
  EXPECT_NE(run("out").out.find(end), std::string::npos);
  EXPECT_NE(run("out", {"--resume"}).out.find(end), std::string::npos) << "of the same file";
  folder.write("c.yaml", changed({"replicates: 40", budget + "5}"}));
  EXPECT_EQ(run("out", {"--resume"}).code, 0);
  const std::string all = table("out");
  EXPECT_EQ(std::count(all.begin(), all.end(), '\n'), 6);
}

TEST_F(Campaign, SaysWhichCellsAreWiderThanTheRuleAsks) {
  folder.write(
      "small.yaml",
      changed_scenario({{"      route:", "      spread: {altitude: 3000 ft}\n      route:"}}));
  for (const auto& [width, wide] : {std::pair("0.001 kg", 2), {"10000 kg", 0}}) {
    folder.write(
        "c.yaml",
        changed({"replicates: 40",
                 fmt::format("stop: {{measure: fuel, width: {}, least: 10, most: 20}}", width)}) +
            "  fuel: {what: fuel_left, who: blue}\n");
    const std::string out = fmt::format("wide{}", wide);
    EXPECT_EQ(run(out).out.find("fuel is still wider than `stop` asks in 2 of 2 cells") !=
                  std::string::npos,
              wide == 2);
    EXPECT_NE(run(out, {"--resume", "--json"}).out.find(fmt::format("\"wide\":{}", wide)),
              std::string::npos);
  }
}

TEST_F(Campaign, LeavesNothingAfterAMistake) {
  const auto before = folder.everything();
  folder.write("c.yaml", changed({"start.speed", "start.spede"}));
  const Ran ran = run("out");
  EXPECT_EQ(ran.code, 2);
  EXPECT_NE(ran.err.find("did you mean 'speed'?"), std::string::npos) << ran.err;
  EXPECT_EQ(folder.everything(), before);
  folder.write("c.yaml", kCampaign);
  folder.write("taken/thesis.tex", "kept");
  EXPECT_NE(run("taken").err.find("'taken' is there already, and is no campaign"),
            std::string::npos);
}

/// With cells that do it well and cells that do it badly.
std::string faulty(const std::string& how) {
  return R"(eyrie: 1
name: faulty
scenario: small.yaml
factors:
  pilot:
    levels:
      good: trees.cruise=navigate
      bad: 'trees.cruise={misbehave: {how: )" +
         how + R"(}}'
replicates: 3
measures:
  end: {what: end_time}
)";
}

TEST_F(Campaign, KeepsAReplicateThatFailsWithTheCommandThatFliesItAgain) {
  folder.write("c.yaml", faulty("20"));
  const Ran ran = run("out", {"--plugin", plugin("faulty")});
  EXPECT_EQ(ran.code, 1) << ran.err;
  EXPECT_NE(ran.err.find("3 replicates ended with a fault"), std::string::npos) << ran.err;
  EXPECT_NE(ran.out.find("root of tree 'cruise', from libfaulty.so, threw: no fuel\n  eyrie fly "),
            std::string::npos)
      << ran.out;
  EXPECT_NE(ran.out.find("0     good   3  60 (no bounds)\n1     bad    3  -"), std::string::npos)
      << ran.out;
  const auto at = ran.out.find("  eyrie fly ") + 2;
  folder.write("again.sh",
               program_path() + ran.out.substr(at + 5, ran.out.find('\n', at) - at - 5));
  const std::string again = fmt::format("cd {} && EYRIE_HOME={} sh again.sh > /dev/null 2> err",
                                        folder.path().string(), source_root());
  EXPECT_EQ(WEXITSTATUS(std::system(again.c_str())), 1);
  EXPECT_NE(read_text(folder / "err").find("threw: no fuel"), std::string::npos)
      << read_text(folder / "err");
}

TEST_F(Campaign, IsNoSearchThatHidesFlightsThatFail) {
  folder.write("s.yaml", faulty("20") +
                             "optimize: {measure: end, goal: maximize, generations: 1, "
                             "population: 6, proof: 2}\n");
  const Ran ran =
      run_program(folder, {"optimize", "s.yaml", "--out", "out", "--plugin", plugin("faulty")});
  EXPECT_EQ(ran.code, 1) << ran.out;
  EXPECT_NE(ran.err.find("ended with a fault, which counts for nothing, the first with "
                         "eagle"),
            std::string::npos)
      << ran.err;
  EXPECT_NE(ran.err.find("\n  eyrie fly small.yaml"), std::string::npos) << ran.err;
}

TEST_F(Campaign, NamesTheReplicateInWhichAPluginEndsTheProgram) {
  folder.write("c.yaml", faulty("30"));
  for (int session = 0; session < 2; ++session) {
    const Ran ran = run("out", {"--resume", "--workers", "2", "--plugin", plugin("faulty")});
    EXPECT_EQ(ran.code, 1);
    EXPECT_NE(ran.err.find("libfaulty.so called exit()"), std::string::npos) << ran.err;
    EXPECT_NE(ran.err.find("eyrie fly small.yaml --set 'trees.cruise={misbehave: {how: 30}}'"),
              std::string::npos)
        << ran.err;
    EXPECT_NE(ran.err.find(" --seed "), std::string::npos) << ran.err;
  }
}

TEST_F(Campaign, SaysEachReplicateAsALineOfJson) {
  const Ran ran = run("out", {"--json"});
  EXPECT_EQ(ran.code, 0) << ran.err;
  std::istringstream lines(ran.out);
  std::string line;
  int n = 0;
  for (; std::getline(lines, line); ++n) {
    const auto json = nlohmann::json::parse(line, nullptr, false);
    ASSERT_FALSE(json.is_discarded()) << line;
    if (n < 80) {
      EXPECT_EQ(json["cell"], n / 40);
      EXPECT_EQ(json["replicate"], n % 40);
      EXPECT_EQ(json["values"]["end"], 60.0);
    } else {
      EXPECT_EQ(json["ended"], "complete");
    }
  }
  EXPECT_EQ(n, 81);
}

}  // namespace
}  // namespace eyrie::test
