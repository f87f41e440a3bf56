// SPDX-License-Identifier: MIT
/// \file  Every signal at many moments of every command: at calls on files, and at allocations,
/// which are everywhere else.
#include <gtest/gtest.h>
#include <signal.h>

#include <array>

#include "faults/ground.hpp"

namespace eyrie::test {
namespace {

constexpr std::array kSignals{SIGINT, SIGTERM, SIGHUP, SIGXFSZ, SIGKILL};

TEST(Kills, LeaveTheOldOrTheNewOrTheRunSoFar) {
  const std::uint64_t moments = try_all() ? 100 : 6;
  std::uint64_t killed = 0;
  for (const Try& t : every_try())
    for (const int signal : kSignals)
      for (std::uint64_t i = 0; i < moments; ++i) {
        Fault fault;
        const std::uint64_t draw = killed * 7919 + i;
        if (i % 2 == 0 && done(t).ended.calls) {
          fault.files.at = 1 + drawn(draw, done(t).ended.calls);
          fault.files.signal = signal;
        } else {
          fault.allocation = 1 + drawn(draw, done(t).ended.allocations);
          fault.signal = signal;
        }
        EXPECT_EQ(broken(t, fault), "");
        ++killed;
      }
  EXPECT_GE(killed, 200U);
}

/// The signal comes between the first file and the last: the run so far is there afterwards. So it
/// is if somebody passes the signal on, as timeout(1) does, and it comes twice.
TEST(Kills, OfAFlightKeepTheRunSoFar) {
  for (const auto& [signal, times] :
       {std::pair{SIGINT, 1}, {SIGINT, 2}, {SIGTERM, 1}, {SIGTERM, 2}, {SIGHUP, 1}, {SIGXFSZ, 1}}) {
    const Ground ground;
    const Try fly = every_try().front();
    Fault fault;
    fault.files.signal = signal;
    fault.files.times = times;
    fault.files.at = done(fly).ended.calls / 3;
    const Ended ended = Child(ground.path(), fly.command, fault).wait();
    EXPECT_EQ(ended.ran.code, 128 + signal) << ended.ran.err;
    EXPECT_TRUE(std::filesystem::exists(ground / "deep/made/run.eyrie"));
  }
}

TEST(Kills, ASecondSignalEndsAtOnceAndLeavesNothing) {
  for (const Try& t : every_try())
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
      if (t.target.empty())
        continue;
      const Ground ground;
      const Tree before = ground.tree();
      Fault fault;
      fault.files.signal = signal;
      fault.files.times = 2;
      fault.files.apart = 300'000;
      fault.files.at = done(t).ended.calls / 3;
      const Ended ended = Child(ground.path(), t.command, fault).wait();
      EXPECT_EQ(ended.ran.code, -signal) << t.name;
      Tree after = ground.tree();
      after.erase("deep/");
      EXPECT_TRUE(after == before) << t.name;
    }
}

/// After a killed process the next one removes what is left.
TEST(Kills, AreCleanedUpByTheNextRun) {
  const Try fly = every_try().front();
  const Ground ground;
  Fault fault;
  fault.files.signal = SIGKILL;
  fault.files.at = done(fly).ended.calls / 2;
  EXPECT_EQ(Child(ground.path(), fly.command, fault).wait().ran.code, -SIGKILL);
  EXPECT_FALSE(ground.tree() == done(fly).before);
  EXPECT_EQ(Child(ground.path(), fly.command).wait().ran.code, 0);
  EXPECT_TRUE(ground.tree() == done(fly).after);
}

}  // namespace
}  // namespace eyrie::test
