// SPDX-License-Identifier: MIT
/// \file  Every call on a file and every allocation fails once.
#include <gtest/gtest.h>

#include <array>

#include "faults/ground.hpp"

namespace eyrie::test {
namespace {

TEST(Faults, NothingHappensWithoutOne) {
  for (const Try& t : every_try()) {
    const Done& d = done(t);
    EXPECT_EQ(d.ended.ran.code, 0) << t.name << d.ended.ran.err;
    EXPECT_EQ(d.ended.ran.err, "") << t.name;
    EXPECT_GT(d.ended.allocations, 50U) << t.name;
    EXPECT_EQ(d.before == d.after, t.target.empty()) << t.name;
    if (!t.target.empty()) {
      EXPECT_GT(d.ended.calls, 10U) << t.name;
      EXPECT_GT(d.ended.written, 50U) << t.name;
    }
  }
}

TEST(Faults, OfEveryCallOnAFileLeaveTheOldOrTheNewWhole) {
  constexpr std::array kErrors{ENOSPC, EIO, EMFILE, EACCES, ENOMEM, EROFS};
  int tried = 0;
  for (const Try& t : every_try())
    for (std::uint64_t call = 1; call <= done(t).ended.calls; ++call)
      for (std::size_t i = 0; i < kErrors.size(); ++i) {
        if (!try_all() && i != drawn(call, kErrors.size()))
          continue;
        Fault fault;
        fault.files.at = call;
        fault.files.error = kErrors[i];
        EXPECT_EQ(broken(t, fault), "");
        ++tried;
      }
  EXPECT_GT(tried, 150);
}

TEST(Faults, OfAllocationsLeaveTheOldOrTheNewWhole) {
  constexpr std::uint64_t kDrawn = 30;
  for (const Try& t : every_try()) {
    const std::uint64_t all = done(t).ended.allocations, count = try_all() ? all : kDrawn;
    for (std::uint64_t i = 0; i < count; ++i) {
      Fault fault;
      // the last ones are those in which files are put in their places
      fault.allocation = try_all() ? i + 1 : i % 2 ? all - drawn(i, all / 20) : 1 + drawn(i, all);
      EXPECT_EQ(broken(t, fault), "");
    }
  }
}

}  // namespace
}  // namespace eyrie::test
