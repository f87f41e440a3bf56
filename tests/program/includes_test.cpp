// SPDX-License-Identifier: MIT
/// \file  What a scenario of a stranger may read: files below its folder and the installation, few
/// enough, and nothing else of the disk ever reaches the terminal.
#include <gtest/gtest.h>

#include <filesystem>

#include "support/program.hpp"
#include "support/small_scenario.hpp"

namespace eyrie::test {
namespace {
namespace fs = std::filesystem;

constexpr const char* kSecret = "root:$6$secret:19000: [\n";
constexpr const char* kOutside =
    " is outside the folder of the scenario and the installation; --allow-include FOLDER (in "
    "Python include=) allows it\n";

/// box/mine/x.yaml is the scenario; box/secret.yaml and box/other/ are none of its business.
class Includes : public testing::Test {
 protected:
  Includes() {
    folder_.write("secret.yaml", kSecret);
    folder_.write("other/trees.yaml", "trees: {extra: navigate}\n");
    folder_.write("mine/near.yaml", "trees: {near: navigate}\n");
  }
  Ran validate(const std::string& include, std::vector<std::string> more = {}) const {
    folder_.write("mine/x.yaml", kSmallScenario + "include: " + include + "\n");
    more.insert(more.begin(), {"validate", "mine/x.yaml"});
    return run_program(folder_, more);
  }

  TempFolder folder_;
};

TEST_F(Includes, StayBelowTheScenariosFolderOrTheInstallation) {
  fs::create_symlink("../secret.yaml", folder_.path() / "mine/link.yaml");
  fs::create_directory_symlink("..", folder_.path() / "mine/up");
  fs::create_directory_symlink("/etc", folder_.path() / "mine/etc");
  struct Case {
    std::string include, shown;
  };
  for (const Case& c :
       {Case{"/etc/passwd", "/etc/passwd"}, Case{"/etc/shadow", "/etc/shadow"},
        Case{"../secret.yaml", "secret.yaml"}, Case{"sub/../../secret.yaml", "secret.yaml"},
        Case{"link.yaml", "mine/link.yaml"}, Case{"up/secret.yaml", "mine/up/secret.yaml"},
        Case{"etc/passwd", "mine/etc/passwd"}, Case{"../other/trees.yaml", "other/trees.yaml"},
        Case{"../not_there.yaml", "not_there.yaml"}, Case{"/dev/zero", "/dev/zero"}}) {
    const Ran ran = validate(c.include);
    EXPECT_EQ(ran.code, 2) << c.include;
    EXPECT_EQ(ran.err, "mine/x.yaml:21:10: '" + c.shown + "'" + kOutside);
    EXPECT_EQ(ran.out, "");
  }
}

TEST_F(Includes, AreReadWhereTheyMayStand) {
  EXPECT_EQ(validate("near.yaml").code, 0);
  EXPECT_EQ(validate("../mine/near.yaml").code, 0);
  EXPECT_EQ(validate(source_root() + "/scenarios/packages/pilots.yaml").code, 0);
  const Ran allowed = validate("../other/trees.yaml", {"--allow-include", "other"});
  EXPECT_EQ(allowed.err, "");
  EXPECT_EQ(allowed.code, 0);
  EXPECT_EQ(validate("../secret.yaml", {"--allow-include", "other"}).code, 2);
  EXPECT_EQ(validate("near.yaml", {"--allow-include", "gone"}).err,
            "eyrie: --allow-include 'gone': there is no such folder\n");
}

TEST_F(Includes, ThatAreMisspelledNameTheNearestFile) {
  folder_.write("mine/pack/pilots.yaml", "trees: {extra: navigate}\n");
  struct Case {
    std::string include, shown, meant;
  };
  for (const Case& c :
       {Case{"naer.yaml", "mine/naer.yaml", "near.yaml"},
        Case{"[near.yaml, pack/pilot.yml]", "mine/pack/pilot.yml", "pack/pilots.yaml"},
        Case{"pakc/pilots.yaml", "mine/pakc/pilots.yaml", "pack/pilots.yaml"}}) {
    const Ran ran = validate(c.include);
    EXPECT_EQ(ran.code, 2);
    EXPECT_EQ(ran.err, "mine/x.yaml:21:" + std::string(c.include[0] == '[' ? "22" : "10") +
                           ": cannot read '" + c.shown + "'; did you mean '" + c.meant + "'?\n");
  }
  EXPECT_EQ(validate("y.yaml").err, "mine/x.yaml:21:10: cannot read 'mine/y.yaml'\n")
      << "a file does not include itself";
}

TEST_F(Includes, OfAnAllowedFolderStayInTheRun) {
  folder_.write("mine/x.yaml", kSmallScenario + "include: ../other/trees.yaml\n");
  EXPECT_EQ(run_program(folder_, {"fly", "mine/x.yaml", "--out", "r"}).code, 2);
  EXPECT_EQ(
      run_program(folder_, {"fly", "mine/x.yaml", "--allow-include", "other", "--out", "r"}).code,
      0);
  fs::remove_all(folder_.path() / "other");
  EXPECT_EQ(run_program(folder_, {"replay", "r"}).code, 0);
}

/// A model's name cannot lead out of data/ either.
TEST_F(Includes, AreNotTheOnlyNamesOfFiles) {
  folder_.write("mine/evil.yaml", "label: read\n");
  for (const std::string name : {"../../mine/evil", "/etc/passwd", "..", ".", "-x"}) {
    std::string text = kSmallScenario;
    text.replace(text.find("f15c"), 4, "'" + name + "'");
    folder_.write("mine/x.yaml", text);
    const Ran ran = run_program(folder_, {"validate", "mine/x.yaml"});
    EXPECT_EQ(ran.code, 2);
    EXPECT_EQ(ran.err, "mine/x.yaml:15:17: unknown aircraft '" + name +
                           "', only f15c, f16c, laero_fighter, mig29, paper_fighter, su27\n");
  }
}

TEST_F(Includes, InIncludesEndSomewhere) {
  for (int i = 0; i < 10'000; ++i)
    folder_.write("mine/c" + std::to_string(i) + ".yaml",
                  "include: c" + std::to_string(i + 1) + ".yaml\n");
  const Ran ran = validate("c0.yaml");
  EXPECT_EQ(ran.code, 2);
  EXPECT_EQ(ran.err,
            "mine/c49.yaml:1:10: includes in includes, more than 50 deep: 'mine/x.yaml' -> "
            "'mine/c0.yaml' -> ... -> 'mine/c50.yaml'\n");
}

TEST_F(Includes, AreLimitedInNumber) {
  std::string list = "[";
  for (int i = 0; i < 60'000; ++i)
    list += (i ? ", m" : "m") + std::to_string(i) + ".yaml";
  const Ran ran = validate(list + "]");
  EXPECT_EQ(ran.code, 2);
  EXPECT_NE(ran.err.find("'mine/m0.yaml'\n"), std::string::npos);
  EXPECT_NE(ran.err.find("\n... and 950 or more\n"), std::string::npos) << ran.err;
}

TEST_F(Includes, AreLimitedInWhatTheyHoldTogether) {
  std::string many = "trees: {t: [0";
  for (int i = 0; i < 150'000; ++i)
    many += ",0";
  many += "]}\n";
  for (const char* name : {"a", "b", "c", "d", "e"})
    folder_.write("mine/" + std::string(name) + ".yaml", many);
  const Ran ran = validate("[a.yaml, b.yaml, c.yaml, d.yaml, e.yaml]");
  EXPECT_EQ(ran.code, 2);
  EXPECT_NE(ran.err.find("mine/x.yaml:21:35: with 'mine/d.yaml' the scenario has more than 500000 "
                         "values\n"),
            std::string::npos)
      << ran.err;
}

TEST_F(Includes, MayHoldNothingAndSaySo) {
  folder_.write("mine/nothing.yaml", "~\n");
  EXPECT_EQ(validate("nothing.yaml").err, "mine/nothing.yaml:1:1: expected a map, got nothing\n");
  folder_.write("mine/x.yaml", "~\n");
  EXPECT_EQ(run_program(folder_, {"validate", "mine/x.yaml"}).err,
            "mine/x.yaml:1:1: expected a map, got nothing\n");
}

}  // namespace
}  // namespace eyrie::test
