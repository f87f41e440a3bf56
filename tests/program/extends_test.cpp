// SPDX-License-Identifier: MIT
/// \file  A scenario that changes a shipped one, through the real program: flown, recorded, flown
/// again without the files it was made of, printed as one file.
#include <gtest/gtest.h>

#include "support/program.hpp"
#include "support/small_scenario.hpp"

namespace eyrie::test {
namespace {

/// "world hash 0x... after ... steps"
std::string hash_of(const Ran& ran) {
  EXPECT_EQ(ran.code, 0) << ran.err;
  const auto at = ran.out.find("world hash ");
  return at == std::string::npos ? ran.out + ran.err
                                 : ran.out.substr(at, ran.out.find('\n', at) - at);
}

constexpr const char* kEager =
    "extends: sweep\n"
    "name: eager\n"
    "insert:\n"
    "  before trees.wall.winner_takes_all.follow_lead: {snapshot: {vote: 58}}\n"
    "replace:\n"
    "  trees.press.per_field.release_weapon.zone: 1.8\n"
    "remove: [red.flights.bogey.players.bogey2]\n";

Ran fly(const TempFolder& folder, std::vector<std::string> words) {
  for (const char* word : {"--quiet", "--no-debrief", "--until", "12 min"})
    words.emplace_back(word);
  words.insert(words.begin(), "fly");
  return run_program(folder, words);
}

TEST(Extends, FliesTheSameBitsIfNothingIsChanged) {
  const TempFolder folder;
  folder.write("same.yaml", "extends: sweep\n");
  folder.write("eager.yaml", kEager);
  const std::string hash = hash_of(fly(folder, {"sweep", "--out", "a"}));
  EXPECT_EQ(hash_of(fly(folder, {"same.yaml", "--out", "b"})), hash);
  EXPECT_NE(hash_of(fly(folder, {"eager.yaml", "--out", "c"})), hash);
}

TEST(Extends, IsRecordedWithAllThatItIsMadeOf) {
  const TempFolder folder;
  folder.write("far/base.yaml", kEager);
  folder.write("far/own.yaml", "extends: base.yaml\nseed: 5\n");
  const std::string hash = hash_of(fly(folder, {"far/own.yaml", "--out", "r"}));
  std::filesystem::remove_all(folder / "far");
  // nothing but the run file: no shipped scenario either
  const Ran again = run_program(folder, {"replay", "r"}, {.home = folder.path().string()});
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_NE(again.out.find("the same"), std::string::npos) << again.out;
  EXPECT_NE(again.out.find(hash.substr(11, 18)), std::string::npos) << again.out << hash;
  const Ran what_if =
      run_program(folder, {"whatif", "r", "--player", "eagle1", "--set",
                           "trees.wall.winner_takes_all.snapshot.vote=5", "--at", "5 min"});
  EXPECT_EQ(what_if.code, 0) << what_if.err;
}

TEST(Extends, IsPrintedAsOneFileThatFliesTheSame) {
  const TempFolder folder;
  folder.write("eager.yaml", kEager);
  const Ran printed = run_program(folder, {"validate", "--print", "eager.yaml"});
  ASSERT_EQ(printed.code, 0) << printed.err;
  EXPECT_EQ(printed.out.find("extends"), std::string::npos);
  EXPECT_NE(printed.out.find("players: [bogey1]"), std::string::npos) << printed.out;
  folder.write("whole.yaml", printed.out);
  EXPECT_EQ(hash_of(fly(folder, {"whole.yaml", "--out", "a"})),
            hash_of(fly(folder, {"eager.yaml", "--out", "b"})));
}

TEST(Extends, IsRefusedAtTheLineThatIsWrong) {
  const TempFolder folder;
  folder.write("secret.yaml", "seed: [\n");
  const auto said = [&](const std::string& words) {
    folder.write("mine/x.yaml", words);
    const Ran ran = run_program(folder, {"validate", "mine/x.yaml"});
    EXPECT_EQ(ran.code, 2) << words;
    return ran.err;
  };
  EXPECT_EQ(said("extends: ../secret.yaml\n"),
            "mine/x.yaml:1:10: 'secret.yaml' is outside the folder of the scenario and the "
            "installation; --allow-include FOLDER (in Python include=) allows it\n");
  EXPECT_EQ(said("extends: sweep\ninsert: {trees.wall.winner_takes_all: {gret: {vote: 3}}}\n"),
            "mine/x.yaml:2:40: there is no node 'gret'\n");
  EXPECT_EQ(said("extends: sweep\nremove: [trees.veteran.sequencer.trees.wvr]\n").substr(0, 84),
            "mine/x.yaml:2:10: 'wvr' cannot be removed: eyrie:scenarios/packages/veteran.yaml:95:");
  EXPECT_EQ(
      said("extends: sweep\nremove: [red.flights.bogey.players.bogey1]\n"),
      "mine/x.yaml:2:10: 'bogey1' cannot be removed: eyrie:scenarios/sweep.yaml:35:16: flight "
      "'bogey' has no lead: none of its players is 'bogey1'\n");
  EXPECT_TRUE(said("extends: merge\nremove: [trees]\n")
                  .starts_with("mine/x.yaml:2:10: 'trees' cannot be removed: eyrie:scenarios/"));
  EXPECT_EQ(said("extends: sweep\nreplcae: {seed: 3}\n"),
            "mine/x.yaml:2:1: scenario has no parameter 'replcae'; did you mean 'replace'?\n");
}

TEST(Extends, ChangesAPackageThatIsIncluded) {
  const TempFolder folder;
  folder.write("pack.yaml", "trees: {cruise: {winner_takes_all: [navigate]}}\n");
  folder.write("x.yaml",
               changed_scenario({{"trees:\n  cruise:\n    winner_takes_all:\n      - avoid_ground: "
                                  "{vote: 100}\n      - navigate: {vote: 10, speed: 480 kt}\n",
                                  "include: pack.yaml\n"}}) +
                   "insert: {trees.cruise.winner_takes_all: {avoid_ground: {vote: 100}}}\n");
  EXPECT_EQ(run_program(folder, {"validate", "x.yaml"}).out,
            "x.yaml: 2 aircraft in 1 flight, 1 tree\n");
}

TEST(Validate, ChecksPackages) {
  const TempFolder folder;
  folder.write("good.yaml", "include: more.yaml\ntrees: {a: {winner_takes_all: [navigate]}}\n");
  folder.write("more.yaml", "trees: {b: {winner_takes_all: [scatter]}}\n");
  const Ran good = run_program(folder, {"validate", "good.yaml", "more.yaml"});
  EXPECT_EQ(good.err, "");
  EXPECT_EQ(good.out, "good.yaml: a package, 2 trees\nmore.yaml: a package, 1 tree\n");
  EXPECT_EQ(run_program(folder, {"fly", "more.yaml"}).err,
            "more.yaml:1:1: a package of trees and data: fly a scenario that includes it\n");
  folder.write("bad.yaml",
               "trees:\n"
               "  a: {winner_takes_al: [{pursue: {vote: ten}}, {tree: b}]}\n"
               "data: {guns: {mine: {base: m62}}}\n");
  const Ran bad = run_program(folder, {"validate", "bad.yaml"});
  EXPECT_EQ(bad.code, 2);
  EXPECT_EQ(bad.err,
            "bad.yaml:2:7: there is no node 'winner_takes_al'; did you mean 'winner_takes_all'?\n"
            "bad.yaml:2:41: vote: expected a plain number such as '0.5', got 'ten'\n"
            "bad.yaml:2:55: there is no tree 'b', only a\n"
            "bad.yaml:3:28: unknown gun 'm62'; did you mean 'm61'?\n");
}

}  // namespace
}  // namespace eyrie::test
