// SPDX-License-Identifier: MIT
/// \file  A campaign that is flown in parts and joined: the same as in one process.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "sql/database.hpp"
#include "support/campaign/background.hpp"
#include "support/campaign/two_speeds.hpp"

namespace eyrie::test {
namespace {

class CampaignParts : public Campaign {
 protected:
  [[nodiscard]] Ran part(int number, int of, const std::string& out = "out") const {
    return run(out, {"--part", fmt::format("{}/{}", number, of), "--resume"});
  }
  [[nodiscard]] std::string refused(std::vector<std::string> more) const {
    const Ran ran = run("out", std::move(more));
    EXPECT_EQ(ran.code, 2) << ran.out;
    return ran.err;
  }
};

TEST_F(CampaignParts, GiveTheTableAndHashOfOneProcess) {
  folder.write("c.yaml", changed({"replicates: 40", "replicates: 4"}));
  const Ran whole = run("whole");
  for (const int of : {1, 3, 11}) {
    const std::string out = fmt::format("in{}", of);
    for (int number = 1; number <= of; ++number)
      ASSERT_EQ(part(number, of, out).code, 0) << number << " of " << of;
    const Ran joined = run(out, {"--join"});
    ASSERT_EQ(joined.code, 0) << joined.err;
    EXPECT_EQ(table(out), table("whole")) << of;
    EXPECT_EQ(hash_in(joined), hash_in(whole)) << of;
    EXPECT_EQ(hash_in(run(out, {"--join"})), hash_in(whole)) << "joined twice";
    EXPECT_EQ(hash_in(run(out, {"--resume"})), hash_in(whole)) << "a campaign as any other";
  }
}

TEST_F(CampaignParts, AreJoinedWhenAllOfThemAreWhole) {
  EXPECT_NE(refused({"--join"}).find("there is no part of a campaign in 'out'"), std::string::npos);
  for (const char* none :
       {"part_1_of_99999999999", "part_4_of_3", "part_x_of_3", "part_1_of_3.old"})
    std::filesystem::create_directories(folder / (std::string("out/") + none));
  EXPECT_NE(refused({"--join"}).find("there is no part of a campaign in 'out'"), std::string::npos);
  ASSERT_EQ(part(2, 3).code, 0);
  const auto before = folder.everything();
  EXPECT_EQ(refused({"--join"}),
            "eyrie: 'out' has not all parts yet; fly what is missing (--array=1,3)\n"
            "  part 1 of 3 has 0 of 27 replicates\n  part 3 of 3 has 0 of 26 replicates\n");
  EXPECT_NE(refused({"--resume"}).find("holds parts of a campaign: --join"), std::string::npos);
  EXPECT_NE(refused({"--part", "2/4"}).find("'out' holds parts of 3, not of 4"), std::string::npos);
  EXPECT_EQ(folder.everything(), before);
}

TEST_F(CampaignParts, KilledAtAnyMomentGoOnToTheSameTable) {
  undisturbed();
  const auto before = used_by_processes();
  ASSERT_EQ(part(1, 2).code, 0);
  const auto whole = used_by_processes() - before;
  int killed = 0;
  // the first three together have less than half of the time that all of it takes
  for (int i = 0; i < 10; ++i) {
    const Background process(folder,
                             {"campaign", "c.yaml", "--out", "out", "--part", "2/2", "--resume"},
                             whole * (2 * i + 1) / 20);
    killed += process.end(0) == -SIGPROF;
  }
  EXPECT_GE(killed, 3);
  ASSERT_EQ(part(2, 2).code, 0);
  ASSERT_EQ(run("out", {"--join"}).code, 0);
  EXPECT_EQ(table("out"), undisturbed());
}

TEST_F(CampaignParts, ChangedByHandAreRefused) {
  folder.write("c.yaml", changed({"replicates: 40", "replicates: 2"}));
  for (const int number : {1, 2})
    ASSERT_EQ(part(number, 2).code, 0);
  sql::Database(folder / "out/part_2_of_2/results.db", sql::Database::Access::write)
      .run("UPDATE replicates SET \"end\" = 1; PRAGMA journal_mode=DELETE");
  const auto before = folder.everything();
  EXPECT_NE(refused({"--join"}).find("'out/part_2_of_2/results.db' was changed after it was flown"),
            std::string::npos);
  EXPECT_EQ(folder.everything(), before);
}

TEST_F(CampaignParts, OfSomethingElseAreRefused) {
  ASSERT_EQ(part(1, 2).code, 0);
  folder.write("c.yaml", changed({"[400 kt, 480 kt]", "[400 kt, 490 kt]"}));
  ASSERT_EQ(part(2, 2).code, 0);
  const std::string difference =
      "'the campaign', line 5, column 67: was ', values: [400 kt, 480 kt]}', is ', values: [400 "
      "kt, 490 kt]}'\n";
  EXPECT_NE(refused({"--join"}).find("'out/part_1_of_2' was begun with something else"),
            std::string::npos);
  EXPECT_NE(refused({"--join"}).find(difference), std::string::npos);
  EXPECT_NE(refused({"--part", "1/2", "--resume"}).find(difference), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(folder / "out/results.db"));
  folder.write("c.yaml", kCampaign);
  const Ran ran = run("out/part_1_of_2", {"--resume"});
  EXPECT_EQ(ran.code, 2);
  EXPECT_NE(ran.err.find("'the part' is used no more"), std::string::npos) << ran.err;
}

TEST_F(CampaignParts, AreNotFlownOfWhatNeedsAllResults) {
  for (const char* text : {"3", "0/3", "4/3", "1/0", "1/3x", "-1/3", ""})
    EXPECT_NE(refused({"--part", text}).find("--part"), std::string::npos) << text;
  folder.write("c.yaml", changed({"replicates: 40",
                                  "stop: {measure: end, width: 1 s}\nbudget: {time: 1 h, "
                                  "replicates: 70}"}));
  EXPECT_EQ(refused({"--part", "1/3"}),
            "c.yaml:6:7: stop: needs the results of all parts; without it, 'replicates' says how "
            "many are flown\n"
            "c.yaml:7:33: budget: replicates: a part does not know how many the others have "
            "flown\n");
  EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

}  // namespace
}  // namespace eyrie::test
