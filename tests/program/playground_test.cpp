// SPDX-License-Identifier: MIT
/// \file  `eyrie playground` writes its folder, or nothing. What the page in it does is shown by
/// viewer/test/playground.test.ts.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "support/packed.hpp"
#include "support/program.hpp"

namespace eyrie::test {
namespace {
namespace fs = std::filesystem;

using Names = std::vector<std::string>;

/// What a page carries as a part.
std::string part_of(const std::string& page, const std::string& type) {
  const std::string tag = "<script type=\"application/x-eyrie-" + type + "\">";
  const std::size_t begin = page.find(tag) + tag.size();
  return unpacked(page.substr(begin, page.find('<', begin) - begin));
}

TEST(Playground, CarriesEveryTextOfTheInstallationAndItsSchema) {
  const TempFolder folder;
  const Ran ran = run_program(folder, {"playground"});
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_TRUE(ran.out.starts_with("written to playground: open playground/index.html in a browser"))
      << ran.out;
  EXPECT_EQ(folder.everything(),
            (Names{"playground", "playground/eyrie-playground.txt", "playground/index.html"}));
  const auto texts =
      nlohmann::json::parse(part_of(read_text(folder / "playground/index.html"), "texts"));
  for (const char* kind : {"scenarios", "data"})
    for (const auto& entry : fs::recursive_directory_iterator(kind))
      if (entry.path().extension() == ".yaml") {
        EXPECT_EQ(texts["files"][entry.path().generic_string()], read_text(entry.path()));
      }
  EXPECT_EQ(texts["schema"]["title"], "Eyrie scenario");
}

TEST(Playground, ReplacesOneOfItsOwnAndNothingElse) {
  const TempFolder folder;
  ASSERT_EQ(run_program(folder, {"playground", "--out", "mine"}).code, 0);
  const auto refused = [&](const Names& arguments) {
    const auto before = folder.everything();
    Names words{"playground"};
    words.insert(words.end(), arguments.begin(), arguments.end());
    const Ran ran = run_program(folder, words);
    EXPECT_EQ(ran.code, 2) << ran.err;
    EXPECT_EQ(folder.everything(), before);
    return ran.err;
  };
  EXPECT_EQ(refused({"--out", "mine"}),
            "eyrie: 'mine' exists already; name another folder or add --force\n");
  EXPECT_EQ(run_program(folder, {"playground", "--out", "mine", "--force"}).code, 0);
  folder.write("site/index.html", "somebody's");
  EXPECT_EQ(refused({"--out", "site", "--force"}),
            "eyrie: 'site' has no eyrie-playground.txt: only the folder of a playground is "
            "replaced\n");
  folder.write("mine/notes.txt", "mine");
  EXPECT_EQ(refused({"--out", "mine", "--force"}),
            "eyrie: 'mine' has 'notes.txt', which Eyrie has not written: it is not replaced\n");
  EXPECT_EQ(refused({"--ot", "x"}),
            "eyrie: playground has no option '--ot'; did you mean '--out'?\n"
            "eyrie playground --help says more\n");
}

TEST(Playground, SaysWhatIsMissingAndWritesNothing) {
  const TempFolder folder;
  const Ran unbuilt = run_program(folder, {"playground"}, {.viewer = "/nowhere/debrief.html"});
  EXPECT_EQ(unbuilt.code, 1);
  EXPECT_TRUE(unbuilt.err.starts_with("eyrie: the playground is not built")) << unbuilt.err;
  EXPECT_EQ(run_program(folder, {"playground"}, {.home = "/nowhere"}).code, 2);
  const Ran full = run_program(folder, {"playground"}, {.file_size_limit = 1024});
  EXPECT_EQ(full.code, 1);
  EXPECT_TRUE(full.err.starts_with("eyrie: cannot write 'playground/index.html'")) << full.err;
  EXPECT_TRUE(folder.everything().empty());
}

}  // namespace
}  // namespace eyrie::test
