// SPDX-License-Identifier: MIT
/// \file  The disk is full, or a file at its limit, after every 4 kB.
#include <gtest/gtest.h>

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
