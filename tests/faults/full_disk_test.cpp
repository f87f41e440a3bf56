// SPDX-License-Identifier: MIT
/// \file  The disk is full, or a file at its limit, after every 4 kB.
#include <gtest/gtest.h>

#include "commands.hpp"
#include "faults/ground.hpp"

namespace eyrie::test {
namespace {

TEST(FullDisk, AtEveryFourKilobytesLeavesTheOldOrTheNewWhole) {
  for (const Try& t : every_try()) {
    const auto written = static_cast<std::int64_t>(done(t).ended.written);
    for (std::int64_t room = 0; room < written; room += 4096) {
      Fault fault;
      fault.files.room = room;
      EXPECT_EQ(broken(t, fault), "");
    }
  }
}

TEST(FullDisk, OneByteTooSmallIsNoticed) {
  for (const Try& t : every_try()) {
    if (t.target.empty())
      continue;
    Fault fault;
    fault.files.room = static_cast<std::int64_t>(done(t).ended.written) - 1;
    const Ground ground;
    EXPECT_EQ(Child(ground.path(), t.command, fault).wait().ran.code, 1) << t.name;
  }
}

/// The run file itself has no room: the run is kept up to where it has.
TEST(FullDisk, KeepsTheRunSoFar) {
  Fault at_limit, full;
  at_limit.file_size = full.files.room = 40'000;
  for (const Fault& fault : {at_limit, full}) {
    const bool json = fault.file_size != 0;
    const auto fly = [json] {
      return app::fly(
          {.scenario = "truck.yaml", .sets = {"until=10 min"}, .out = "made", .json = json});
    };
    const Ground ground;
    const Ended ended = Child(ground.path(), fly, fault).wait();
    EXPECT_EQ(ended.ran.code, fault.file_size ? 128 + SIGXFSZ : 1) << ended.ran.err;
    EXPECT_NE(ended.ran.err.find("; the run is kept up to "), std::string::npos) << ended.ran.err;
    EXPECT_NE(ended.ran.out.find(json ? "\"kept_until_s\": " : " steps; the run file ends before"),
              std::string::npos)
        << ended.ran.out;
    const Ended again = Child(ground.path(), [] { return app::replay({.run = "made"}); }).wait();
    EXPECT_EQ(again.ran.code, 0) << again.ran.err;
    EXPECT_NE(again.ran.out.find("the same, "), std::string::npos) << again.ran.out;
  }
}

TEST(FullDisk, ReplacesNoWholeRunByAShorterOne) {
  const auto fly = [](const char* until) {
    return app::fly({.scenario = "truck.yaml", .sets = {until}, .out = "made", .force = true});
  };
  Fault full;
  full.files.room = 40'000;
  const Ground ground;
  ASSERT_EQ(Child(ground.path(), [&] { return fly("until=2 s"); }).wait().ran.code, 0);
  const Ended ended = Child(
                          ground.path(), [&] { return fly("until=10 min"); }, full)
                          .wait();
  EXPECT_EQ(ended.ran.code, 1);
  EXPECT_NE(ended.ran.err.find("'made' is as it was; the new one is 'made.2'"), std::string::npos)
      << ended.ran.err;
  const auto steps = [&](const char* run) {
    return Child(ground.path(), [&] { return app::replay({.run = run}); }).wait().ran.out;
  };
  EXPECT_NE(steps("made").find("the same, 100 steps"), std::string::npos);
  EXPECT_NE(steps("made.2").find("the same, "), std::string::npos);
}

TEST(FullDisk, AFileAtItsLimitLeavesTheOldOrTheNewWhole) {
  for (const Try& t : every_try())
    for (std::uint64_t limit = 512; limit < 64 * 1024; limit *= 2) {
      Fault fault;
      fault.file_size = limit;
      EXPECT_EQ(broken(t, fault), "");
    }
}

}  // namespace
}  // namespace eyrie::test
