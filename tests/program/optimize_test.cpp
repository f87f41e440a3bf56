// SPDX-License-Identifier: MIT
/// \file  eyrie optimize, through the real program.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "support/program.hpp"
#include "support/small_scenario.hpp"

namespace eyrie::test {
namespace {

constexpr std::string_view kSearch = R"(eyrie: 1
name: high
scenario: small.yaml
factors:
  height: {path: blue.flights.eagle.start.altitude, values: !uniform {low: 10000 ft, high: 30000 ft}}
replicates: 2
optimize: {measure: fuel, goal: maximize, generations: 3, proof: 4}
measures:
  fuel: {what: fuel_left, who: blue}
)";

TEST(Optimize, WritesWhatItFoundAndGoesOnWhereItEnded) {
  const TempFolder folder;
  folder.write("small.yaml", kSmallScenario);
  folder.write("s.yaml", kSearch);
  const Ran first = run_program(folder, {"optimize", "s.yaml", "--out", "o", "--workers", "2"});
  EXPECT_EQ(first.code, 0) << first.err;
  const std::string winner = read_text(folder / "o/winner.yaml");
  EXPECT_NE(winner.find("# 4 seeds each"), winner.npos) << winner;
  const std::string log = read_text(folder / "o/candidates.csv");
  EXPECT_EQ(std::count(log.begin(), log.end(), '\n'), 2 + 3 * 4);
  EXPECT_EQ(run_program(folder, {"fly", "o/winner.yaml", "--out", "w"}).code, 0);

  const Ran again = run_program(folder, {"optimize", "s.yaml", "--out", "o"});
  EXPECT_EQ(again.code, 2);
  EXPECT_EQ(again.err,
            "eyrie: 'o' is there already: --resume goes on with it, --out names another folder\n");

  // as if it had been killed after the first generation
  std::size_t end = 0;
  for (int line = 0; line < 2 + 4; ++line)
    end = log.find('\n', end) + 1;
  folder.write("o/candidates.csv", log.substr(0, end));
  const Ran resumed = run_program(folder, {"optimize", "s.yaml", "--out", "o", "--resume"});
  EXPECT_EQ(resumed.code, 0) << resumed.err;
  EXPECT_EQ(read_text(folder / "o/candidates.csv"), log);
  EXPECT_EQ(read_text(folder / "o/winner.yaml"), winner);

  folder.write("small.yaml", changed_scenario({{"480 kt", "470 kt"}}));
  const Ran changed = run_program(folder, {"optimize", "s.yaml", "--out", "o", "--resume"});
  EXPECT_EQ(changed.code, 2);
  EXPECT_EQ(changed.err,
            "o/candidates.csv:1:1: is of another search: its file, the scenario or the program has "
            "changed\n");
}

TEST(Optimize, SaysHowAWinnerIsFlownThatNamesANetwork) {
  const TempFolder folder;
  std::filesystem::create_directory(folder / "nets");
  std::filesystem::copy(source_root() + "/scenarios/policies/merge.safetensors",
                        folder / "nets/x.safetensors");
  folder.write("p.yaml", R"(extends: merge
name: p
until: 2 s
trees: {pol: {winner_takes_all: [{policy: {file: nets/x.safetensors, vote: 60}}]}}
replace: {blue.flights.viper.tree: pol}
)");
  folder.write("s.yaml", R"(eyrie: 1
name: s
scenario: p.yaml
factors: {f: {path: blue.flights.viper.fuel, values: !uniform {low: 1000 kg, high: 3000 kg}}}
replicates: 2
optimize: {measure: lost, goal: minimize, generations: 1, population: 4, proof: 2}
measures: {lost: {what: losses, who: blue}}
)");
  const Ran found = run_program(folder, {"optimize", "s.yaml"});
  ASSERT_EQ(found.code, 0) << found.err;
  const std::string_view said = "as a scenario of its own: ";
  const std::string command = found.out.substr(found.out.find(said) + said.size());
  EXPECT_EQ(command, "eyrie fly searches/s/winner.yaml --allow-include " +
                         std::filesystem::canonical(folder / "nets").string() + "\n");
  EXPECT_NE(read_text(folder / "searches/s/winner.yaml").find("\n# " + command), command.npos);
  EXPECT_EQ(run_line(folder, command).err, "");
  EXPECT_EQ(run_program(folder, {"fly", "searches/s/winner.yaml"}).code, 2);

  const Ran both = run_program(folder, {"validate", "--print", "p.yaml", "merge_learned"});
  EXPECT_TRUE(both.out.starts_with("# elsewhere it is flown with --allow-include "));
  EXPECT_EQ(both.out.find("allow-include", 50), both.out.npos) << "Eyrie's own are read anywhere";
  EXPECT_NE(both.out.find("\n---\n"), both.out.npos);
}

TEST(Optimize, LeavesTheFilesOfOthersAlone) {
  const TempFolder folder;
  folder.write("small.yaml", kSmallScenario);
  folder.write("s.yaml", kSearch);
  folder.write("theirs/winner.yaml", "kept");
  folder.write("file", "kept");
  for (const char* out : {"theirs", "file"})
    for (const bool resumes : {false, true}) {
      std::vector<std::string> command{"optimize", "s.yaml", "--out", out};
      if (resumes)
        command.push_back("--resume");
      const Ran ran = run_program(folder, command);
      EXPECT_EQ(ran.code, 2) << out;
      EXPECT_NE(ran.err.find(out), std::string::npos) << ran.err;
    }
  EXPECT_EQ(read_text(folder / "theirs/winner.yaml") + read_text(folder / "file"), "keptkept");
}

TEST(Optimize, TellsEachGenerationAndTheProofInJson) {
  const TempFolder folder;
  folder.write("small.yaml", kSmallScenario);
  folder.write("s.yaml", kSearch);
  const Ran ran = run_program(folder, {"optimize", "s.yaml", "--out", "o", "--json"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  std::vector<nlohmann::json> told;
  std::istringstream lines(ran.out);
  for (std::string line; std::getline(lines, line);)
    told.push_back(nlohmann::json::parse(line));
  ASSERT_EQ(told.size(), 4U) << ran.out;
  for (std::size_t g = 0; g < 3; ++g) {
    EXPECT_EQ(told[g]["generation"], g + 1);
    EXPECT_TRUE(told[g]["score"].is_number());
    EXPECT_TRUE(told[g]["values"]["height"].is_string());
  }
  EXPECT_EQ(told[3]["ended"], "complete");
  EXPECT_EQ(told[3]["seeds"], 4);
  const nlohmann::json& proof = told[3]["proof"]["fuel"];
  EXPECT_NEAR(proof["after"][0].get<double>() - proof["before"][0].get<double>(),
              proof["difference"][0].get<double>(), 1e-6);
  EXPECT_EQ(proof["difference"].size(), 4U);
  EXPECT_EQ(proof["difference"][3], 4) << "pairs";
  EXPECT_EQ(told[3]["set"][0],
            "blue.flights.eagle.start.altitude=" + told[3]["values"]["height"].get<std::string>());
}

TEST(Optimize, FliesNothingOfASearchThatIsWrong) {
  const TempFolder folder;
  folder.write("small.yaml", kSmallScenario);
  std::string text(kSearch);
  text.replace(text.find("30000 ft"), 8, "300000 ft");
  folder.write("s.yaml", text);
  const Ran ran = run_program(folder, {"optimize", "s.yaml"});
  EXPECT_EQ(ran.code, 2);
  EXPECT_NE(ran.err.find("blue.flights.eagle.start.altitude="), ran.err.npos) << ran.err;
  EXPECT_EQ(folder.everything(), (std::vector<std::string>{"s.yaml", "small.yaml"}));
}

}  // namespace
}  // namespace eyrie::test
