// SPDX-License-Identifier: MIT
#include "disk/output.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "disk/failure.hpp"
#include "support/program.hpp"

namespace eyrie::disk {
namespace {

using List = std::vector<std::string>;

std::string refusal(const std::string& path, bool replace) {
  try {
    OutputFile out(path, replace);
    return "";
  } catch (const Refused& e) {
    return e.what();
  }
}

TEST(OutputFile, IsAsItWasUntilTheNewOneIsComplete) {
  const test::TempFolder folder;
  const std::string path = folder.write("file", "old");
  ::chmod(path.c_str(), 0640);
  { OutputFile(path, true).sink().write("new"); }
  EXPECT_EQ(test::read_text(path), "old");
  OutputFile out(path, true);
  out.sink().write("new");
  EXPECT_EQ(test::read_text(path), "old");
  out.commit();
  EXPECT_EQ(test::read_text(path), "new");
  struct stat made {};
  ASSERT_EQ(::stat(path.c_str(), &made), 0);
  EXPECT_EQ(made.st_mode & 0777U, 0640U);
}

TEST(OutputFile, ReplacesFilesOnlyAndOnlyWhenTold) {
  const test::TempFolder folder;
  folder.write("file", "kept");
  folder.write("folder/inside", "kept");
  std::filesystem::create_symlink("file", folder / "link");
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  const List before = folder.everything();
  EXPECT_EQ(refusal(folder / "file", false),
            "'" + (folder / "file") + "' exists already; name another file or add --force");
  for (const auto& [name, words] :
       {std::pair("folder", "is a folder; only files are replaced"),
        std::pair("link", "is a symbolic link; only"), std::pair("pipe", "is a pipe; only"),
        std::pair("none/file", "there is no folder"), std::pair("file/x", "Not a directory"),
        std::pair("..", "is no place")})
    EXPECT_NE(refusal(folder / name, true).find(words), std::string::npos)
        << refusal(folder / name, true);
  EXPECT_NE(refusal("/dev/null", true).find("is a device; only"), std::string::npos);
  EXPECT_NE(refusal("", true), "");
  EXPECT_EQ(folder.everything(), before);
}

TEST(OutputFile, GivesWayToWhatHasAppearedInTheMeantime) {
  const test::TempFolder folder;
  for (const bool replace : {false, true}) {
    OutputFile out(folder / "file", replace);
    folder.write("file", "of another");
    if (replace)
      out.commit();
    else
      EXPECT_THROW(out.commit(), Failed);
    EXPECT_EQ(test::read_text(folder / "file"), replace ? "" : "of another");
    std::filesystem::remove(folder / "file");
  }
  OutputFile out(folder / "file", true);
  ASSERT_EQ(::mkfifo((folder / "file").c_str(), 0600), 0);
  EXPECT_THROW(out.commit(), Failed);
  EXPECT_TRUE(std::filesystem::is_fifo(folder / "file"));
}

}  // namespace
}  // namespace eyrie::disk
