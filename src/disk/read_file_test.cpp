// SPDX-License-Identifier: MIT
#include "disk/read_file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cerrno>

#include "disk/file_system.hpp"
#include "support/program.hpp"

namespace eyrie::disk {
namespace {

TEST(ReadFile, GivesEveryByteUpToTheLimit) {
  const test::TempFolder folder;
  const std::string text = std::string("a\0b\n", 4) + std::string(200'000, 'x');
  const FileRead read = read_file(folder.write("file", text), text.size());
  EXPECT_EQ(read.problem, "");
  EXPECT_EQ(read.bytes, text);
  EXPECT_EQ(read_file(folder.write("empty", ""), 0).problem, "");
}

TEST(ReadFile, RefusesWhatIsLarger) {
  const test::TempFolder folder;
  const std::string path = folder.write("file", std::string(2049, 'x'));
  EXPECT_EQ(read_file(path, 2048).problem, "is larger than 2 kB, the most that is read");
  EXPECT_EQ(read_file(path, 2000).problem, "is larger than 2000 bytes, the most that is read");
  EXPECT_EQ(read_file(path, 2000).bytes, "");
}

/// A pipe without a writer would wait for ever, /dev/zero never ends.
TEST(ReadFile, ReadsNothingThatIsNoFile) {
  const test::TempFolder folder;
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  EXPECT_EQ(read_file(folder / "pipe", 100).problem, "is a pipe, not a file");
  EXPECT_EQ(read_file("/dev/zero", 100).problem, "is a device, not a file");
  EXPECT_EQ(read_file(folder.path(), 100).problem, "is a folder, not a file");
}

TEST(ReadFile, SaysThatThereIsNone) {
  const test::TempFolder folder;
  for (const std::string& path : {folder / "none", folder.write("file", "") + "/below",
                                  std::string("\0x", 2), std::string()}) {
    const FileRead read = read_file(path, 100);
    EXPECT_EQ(read.problem, "there is no such file");
    EXPECT_TRUE(read.missing);
  }
}

/// A file of /proc says that it has no bytes and has some; one that grows stops at the limit.
TEST(ReadFile, DoesNotRelyOnTheSizeThatAFileSays) {
  EXPECT_EQ(read_file("/proc/self/comm", 100).problem, "");
  EXPECT_NE(read_file("/proc/self/comm", 100).bytes, "");
  EXPECT_EQ(read_file("/proc/self/comm", 3).problem,
            "is larger than 3 bytes, the most that is read");
}

struct Failing final : FileSystem {
  ssize_t read(int, void*, std::size_t) override {
    errno = EIO;
    return -1;
  }
};

TEST(ReadFile, SaysThatTheDiskFails) {
  const test::TempFolder folder;
  Failing failing;
  const Instead instead(failing);
  const FileRead read = read_file(folder.write("file", "x"), 100);
  EXPECT_EQ(read.problem, "cannot be read: Input/output error");
  EXPECT_FALSE(read.missing);
}

}  // namespace
}  // namespace eyrie::disk
