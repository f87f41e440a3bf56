// SPDX-License-Identifier: MIT
#include "record/sink.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace eyrie::record {
namespace {

TEST(Sink, WritesEverythingAndSaysSo) {
  const std::string path = (std::filesystem::temp_directory_path() / "eyrie_sink_test").string();
  {
    Sink sink(path);
    sink.write("one ");
    sink.write(std::string(100'000, 'x'));
    EXPECT_TRUE(sink.close());
    EXPECT_EQ(sink.error(), "");
    EXPECT_EQ(sink.path(), path);
  }
  std::ifstream in(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  EXPECT_EQ(text, "one " + std::string(100'000, 'x'));
  std::filesystem::remove(path);
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

}  // namespace
}  // namespace eyrie::record
