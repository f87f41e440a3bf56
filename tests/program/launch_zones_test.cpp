// SPDX-License-Identifier: MIT
/// \file  The launch zones beside the program save time and do nothing else: without the file, and
/// with a wrong one, the program says and flies the same.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdlib>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "support/program.hpp"

namespace eyrie::test {
namespace {

namespace fs = std::filesystem;

/// EYRIE_PROGRAM for the time of a test.
class OtherProgram {
 public:
  explicit OtherProgram(const std::string& path) : before_(program_path()) {
    ::setenv("EYRIE_PROGRAM", path.c_str(), 1);
  }
  ~OtherProgram() { ::setenv("EYRIE_PROGRAM", before_.c_str(), 1); }

 private:
  std::string before_;
};

std::string run_file(const TempFolder& folder) {
  return read_text(folder.path() / "run" / "run.eyrie");
}

TEST(LaunchZonesBesideTheProgram, NeverChangeWhatItFlies) {
  const TempFolder prefix, folder;
  fs::create_directory(prefix / "bin");
  fs::copy_file(program_path(), prefix / "bin/eyrie");
  const std::string zones = prefix / "launch_zones.bin";
  const std::string built = EYRIE_ZONES;
  const OtherProgram copy(prefix / "bin/eyrie");
  // long enough for the first shots
  const std::vector<std::string> fly{"fly",          "sweep",   "--until", "12 min",
                                     "--no-debrief", "--force", "--out",   "run"};
  const Ran without = run_program(folder, fly);
  ASSERT_EQ(without.code, 0) << without.err;
  ASSERT_NE(without.out.find("fox 3"), std::string::npos) << without.out;
  const std::string flown = run_file(folder);
  ASSERT_FALSE(flown.empty());

  const std::vector<std::function<void()>> ways{
      [&] { fs::copy_file(built, zones); },
      [&] { fs::resize_file(zones, fs::file_size(zones) / 2); },
      [&] { ASSERT_EQ(fs::remove(zones) ? ::mkfifo(zones.c_str(), 0600) : -1, 0); }};
  for (std::size_t i = 0; i < ways.size() && fs::exists(built); ++i) {
    ways[i]();
    const Ran with = run_program(folder, fly);
    EXPECT_EQ(with.code, 0) << i;
    EXPECT_TRUE(run_file(folder) == flown) << i;
    EXPECT_EQ(with.err, without.err) << i;
  }
}

}  // namespace
}  // namespace eyrie::test
