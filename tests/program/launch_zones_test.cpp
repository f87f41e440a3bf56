// SPDX-License-Identifier: MIT
/// \file  Kept launch zones save time and do nothing else: without them, and with wrong ones, the
/// program says and flies the same; and the command that makes and draws them.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "support/program.hpp"

namespace eyrie::test {
namespace {

namespace fs = std::filesystem;

/// A home with Eyrie's data but no zones, and an empty cache.
struct Home {
  Home() {
    for (const char* folder : {"data", "scenarios"})
      fs::copy(folder, home / folder, fs::copy_options::recursive);
    fs::remove_all(home / "data/zones");
  }
  TempFolder home, cache;
  [[nodiscard]] RunOptions options() const {
    return {.home = home.path().string(), .cache = cache.path().string()};
  }
};

TEST(KeptLaunchZones, NeverChangeWhatTheProgramFlies) {
  const std::string shipped = fs::absolute("data/zones").string();
  const Home home;
  const TempFolder folder;
  // long enough for the first shots
  const std::vector<std::string> fly{"fly",          "sweep",   "--until", "12 min",
                                     "--no-debrief", "--force", "--out",   "run"};
  const auto flown = [&] {
    EXPECT_EQ(run_program(folder, fly, home.options()).code, 0);
    return read_text(folder.path() / "run" / "run.eyrie");
  };
  const std::string without = flown();
  ASSERT_FALSE(without.empty());
  const fs::path kept = home.cache.path() / "eyrie" / "zones";
  const auto count = [&] { return std::distance(fs::directory_iterator(kept), {}); };
  const auto made = count();
  EXPECT_GT(made, 1) << "kept for the next time";
  EXPECT_TRUE(flown() == without) << "from the cache";
  for (const auto& entry : fs::directory_iterator(kept))
    fs::resize_file(entry.path(), fs::file_size(entry.path()) / 2);
  EXPECT_TRUE(flown() == without) << "with a damaged cache";
  EXPECT_EQ(count(), made) << "made whole again";

  fs::remove_all(kept);
  fs::copy(shipped, home.home / "data/zones");
  EXPECT_TRUE(flown() == without) << "from data/zones";
  EXPECT_FALSE(fs::exists(kept)) << "nothing was flown";
}

TEST(ZonesProgram, MakesAndChecksAndDraws) {
  const std::string shipped = read_text("data/zones/aim9.zone");
  const Home home;
  const TempFolder folder;
  const Ran stale = run_program(folder, {"zones", "aim9", "--check"}, home.options());
  EXPECT_EQ(stale.code, 1);
  EXPECT_NE(stale.out.find("aim9.zone: stale, 'eyrie zones aim9' makes it anew"), std::string::npos)
      << stale.out;
  EXPECT_EQ(run_program(folder, {"zones", "aim9"}, home.options()).code, 0);
  EXPECT_TRUE(read_text(home.home / "data/zones/aim9.zone") == shipped);
  EXPECT_EQ(run_program(folder, {"zones", "aim9", "--check"}, home.options()).code, 0);

  const Ran drawn = run_program(
      folder, {"zones", "aim9", "--draw", "--out", ".", "--altitude", "20000 ft"}, home.options());
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  const std::string svg = read_text(folder.path() / "aim9.svg");
  for (const char* part : {"<svg", "r_max", "r_tr", "r_ne", "r_min", "AIM-9", "6096 m"})
    EXPECT_NE(svg.find(part), std::string::npos) << part;

  folder.write("aim9.svg", "kept");
  EXPECT_EQ(run_program(folder, {"zones", "aim9", "--draw"}, home.options()).code, 2);
  EXPECT_EQ(read_text(folder / "aim9.svg"), "kept");
  EXPECT_EQ(run_program(folder, {"zones", "aim9", "--draw", "--force"}, home.options()).code, 0);
  EXPECT_NE(read_text(folder / "aim9.svg"), "kept");

  // nothing is written of what is wrong in part
  EXPECT_EQ(run_program(folder, {"zones", "r73", "aim9", "--draw"}, home.options()).code, 2);
  EXPECT_EQ(run_program(folder, {"zones", "r73", "r37", "--draw"}, home.options()).code, 2);
  EXPECT_FALSE(fs::exists(folder / "r73.svg"));
  const Ran twice = run_program(folder, {"zones", "r73", "r73", "--draw"}, home.options());
  EXPECT_EQ(twice.code, 0) << twice.err;

  const Ran wrong = run_program(folder, {"zones", "aim10"}, home.options());
  EXPECT_EQ(wrong.code, 2);
  EXPECT_NE(wrong.err.find("did you mean"), std::string::npos) << wrong.err;
  EXPECT_EQ(run_program(folder, {"zones", "aim9", "--draw", "--speed", "0"}, home.options()).code,
            2);
}

}  // namespace
}  // namespace eyrie::test
