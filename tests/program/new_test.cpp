// SPDX-License-Identifier: MIT
/// \file  `eyrie new behavior NAME` writes the folder of a plug-in, or nothing. That the folder
/// builds and passes is shown by tests/package.
#include <gtest/gtest.h>

#include "support/program.hpp"

namespace eyrie::test {
namespace {

TEST(NewBehavior, CopiesTheExampleUnderTheNewName) {
  const TempFolder folder;
  const Ran ran = run_program(folder, {"new", "behavior", "wing_rock2"});
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(folder.everything(),
            (std::vector<std::string>{"wing_rock2", "wing_rock2/CMakeLists.txt",
                                      "wing_rock2/wing_rock2.cpp", "wing_rock2/wing_rock2.yaml",
                                      "wing_rock2/wing_rock2_test.cpp"}));
  const auto lines = [](const std::string& text) {
    return std::count(begin(text), end(text), '\n');
  };
  std::ptrdiff_t length = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "wing_rock2")) {
    const std::string text = read_text(entry.path());
    length += lines(text);
    EXPECT_EQ(text.find("odge"), std::string::npos) << entry.path();
  }
  EXPECT_LE(length, 60);
  EXPECT_NE(read_text(folder / "wing_rock2/wing_rock2.cpp").find("class WingRock2 final"),
            std::string::npos);
  EXPECT_NE(ran.out.find("cd wing_rock2 && cmake -B build && "), std::string::npos) << ran.out;
}

TEST(NewBehavior, RefusesBadNamesAndProposesBetterOnes) {
  const TempFolder folder;
  const auto refused = [&](const std::string& name) {
    const Ran ran = run_program(folder, {"new", "behavior", "--", name});
    EXPECT_EQ(ran.code, 2) << name;
    EXPECT_EQ(ran.out, "") << name;
    EXPECT_TRUE(folder.everything().empty()) << name;
    return ran.err;
  };
  const std::string rule =
      " is no name for a behavior: a small letter, then small letters, digits and '_'";
  EXPECT_EQ(refused("WingRock"), "eyrie: 'WingRock'" + rule + "; perhaps 'wing_rock'?\n");
  EXPECT_EQ(refused("2 by-2"), "eyrie: '2 by-2'" + rule + "; perhaps 'by_2'?\n");
  EXPECT_EQ(refused("../up"), "eyrie: '../up'" + rule + "; perhaps 'up'?\n");
  EXPECT_EQ(refused("42"), "eyrie: '42'" + rule + "\n");
  EXPECT_EQ(refused(""), "eyrie: an argument must not be empty\neyrie new --help says more\n");
  EXPECT_EQ(refused("pursue"), "eyrie: there is already a node 'pursue' (of eyrie)\n");
  EXPECT_EQ(refused("tree"),
            "eyrie: 'tree' means something else in a scenario; perhaps 'tree_it'?\n");
  for (const char* word : {"parameters", "not", "children"})
    EXPECT_EQ(run_program(folder, {"new", "behavior", word}).code, 2) << word;
  EXPECT_EQ(refused("leads"), "eyrie: 'leads' is what a state says; perhaps 'leads_it'?\n");
  EXPECT_NE(refused(std::string(300, 'a')).find(rule), std::string::npos);
}

TEST(NewBehavior, NeverWritesIntoWhatIsThere) {
  const TempFolder folder;
  folder.write("mine/notes.txt", "my notes");
  folder.write("file", "a file");
  std::filesystem::create_directory_symlink("nowhere", folder / "link");
  const auto before = folder.everything();
  for (const std::string name : {"mine", "file", "link"}) {
    const Ran ran = run_program(folder, {"new", "behavior", name});
    EXPECT_EQ(ran.code, 2);
    EXPECT_EQ(ran.err, "eyrie: '" + name + "' exists already; nothing was written\n");
  }
  EXPECT_EQ(folder.everything(), before);
  EXPECT_EQ(read_text(folder / "mine/notes.txt"), "my notes");
}

TEST(NewBehavior, LeavesNothingHalfWritten) {
  const TempFolder folder;
  const Ran full = run_program(folder, {"new", "behavior", "mine"}, {.file_size_limit = 1024});
  EXPECT_EQ(full.code, 1);
  EXPECT_TRUE(full.err.starts_with("eyrie: cannot write 'mine/")) << full.err;
  EXPECT_TRUE(folder.everything().empty());
  const Ran lost = run_program(folder, {"new", "behavior", "mine"}, {.home = "/nowhere"});
  EXPECT_EQ(lost.code, 2);
  EXPECT_NE(lost.err.find("'/nowhere'"), std::string::npos) << lost.err;
  EXPECT_TRUE(folder.everything().empty());
}

TEST(NewBehavior, IsHelpedByTheCommandLine) {
  const TempFolder folder;
  EXPECT_EQ(run_program(folder, {"new"}).code, 2);
  EXPECT_EQ(run_program(folder, {"new", "behavior"}).code, 2);
  EXPECT_EQ(run_program(folder, {"new", "arbiter", "mine"}).code, 2);
  EXPECT_EQ(run_program(folder, {"new", "--help"}).code, 0);
}

}  // namespace
}  // namespace eyrie::test
