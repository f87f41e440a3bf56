// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <string>

#include "disk/file_system.hpp"
#include "disk/sink.hpp"
#include "support/instead.hpp"
#include "support/program.hpp"

namespace eyrie::disk {
namespace {

TEST(Sink, WritesEverythingAndSaysSo) {
  const test::TempFolder folder;
  const std::string path = folder / "file";
  Sink sink(path);
  sink.write("one ");
  sink.write(std::string(200'000, 'x'));
  EXPECT_TRUE(sink.close());
  EXPECT_EQ(sink.error(), "");
  EXPECT_EQ(sink.path(), path);
  EXPECT_EQ(sink.size(), 200'004U);
  EXPECT_EQ(test::read_text(path), "one " + std::string(200'000, 'x'));
}

TEST(Sink, NoticesAFullDiskWhileWriting) {
  Sink sink("/dev/full");
  for (int i = 0; i < 100; ++i)
    sink.write(std::string(100'000, 'x'));
  EXPECT_EQ(sink.error(), "cannot write '/dev/full': No space left on device");
  EXPECT_FALSE(sink.close());
}

/// What is still in the buffer is lost only when it is flushed: close() must not overlook it.
TEST(Sink, NoticesAFullDiskAtTheLastByte) {
  Sink sink("/dev/full");
  sink.write("x");
  EXPECT_EQ(sink.error(), "");
  EXPECT_FALSE(sink.close());
  EXPECT_EQ(sink.error(), "cannot write '/dev/full': No space left on device");
}

TEST(Sink, SaysWhyAFileCannotBeMade) {
  Sink sink("/dev/null/below");
  sink.write("x");
  EXPECT_FALSE(sink.close());
  EXPECT_EQ(sink.error(), "cannot write '/dev/null/below': Not a directory");
}

TEST(Sink, TakesNoFileThatIsThereWhenItMustBeNew) {
  const test::TempFolder folder;
  folder.write("taken", "kept");
  std::filesystem::create_symlink("elsewhere", folder / "link");
  const int open = ::open(folder.path().c_str(), O_RDONLY | O_DIRECTORY);
  for (const char* name : {"taken", "link"}) {
    Sink sink(open, name, "shown");
    sink.write("x");
    EXPECT_FALSE(sink.close());
    EXPECT_EQ(sink.error(), "cannot write 'shown': File exists");
  }
  ::close(open);
  EXPECT_EQ(test::read_text(folder / "taken"), "kept");
  EXPECT_EQ(folder.everything(), (std::vector<std::string>{"link", "taken"}));
}

/// Takes a few bytes at a time and is interrupted in between; syncs as it is told.
struct Slow final : FileSystem {
  ssize_t write(int file, const void* from, std::size_t size) override {
    if (++calls % 2) {
      errno = EINTR;
      return -1;
    }
    return FileSystem::write(file, from, std::min<std::size_t>(size, 7));
  }
  int sync(int) override {
    errno = sync_error;
    return sync_error ? -1 : 0;
  }
  int calls = 0, sync_error = 0;
};

TEST(Sink, GoesOnWhereAWriteHasStopped) {
  const test::TempFolder folder;
  Slow slow;
  const Instead instead(slow);
  Sink sink(folder / "file");
  sink.write("as long as it takes, seven bytes at a time");
  EXPECT_TRUE(sink.close());
  EXPECT_EQ(test::read_text(folder / "file"), "as long as it takes, seven bytes at a time");
}

TEST(Sink, NoticesADiskThatKeepsNothing) {
  const test::TempFolder folder;
  Slow slow;
  slow.sync_error = EIO;
  const Instead instead(slow);
  Sink sink(folder / "file");
  sink.write("x");
  EXPECT_FALSE(sink.close());
  EXPECT_EQ(sink.error(), "cannot write '" + (folder / "file") + "': Input/output error");
}

}  // namespace

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
