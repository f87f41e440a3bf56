// SPDX-License-Identifier: MIT
#include "net/precedence.hpp"

#include <gtest/gtest.h>
#include <sched.h>

#include <thread>

namespace eyrie::net {
namespace {

using std::chrono::milliseconds;

TEST(Precedence, IsOfOneThreadAndAsLongAsItIsWanted) {
  const auto policy = [] { return sched_getscheduler(0) & ~SCHED_RESET_ON_FORK; };
  ASSERT_EQ(policy(), SCHED_OTHER);
  {
    Precedence precedence;
    precedence.ask(true);
    EXPECT_EQ(policy(), precedence.permitted() ? SCHED_FIFO : SCHED_OTHER);
    std::thread([&] { EXPECT_EQ(policy(), SCHED_OTHER) << "of a thread that it starts"; }).join();
    precedence.ask(false);
    EXPECT_EQ(policy(), SCHED_OTHER);
    precedence.ask(true);
  }
  EXPECT_EQ(policy(), SCHED_OTHER) << "when nobody holds it any more";
}

/// Looked after so early that it counts as late each time: it is moved, sleeps on, wakes in time
/// and may then run anywhere again.
TEST(Precedence, MovesWhoeverIsNotAwakeInTimeAndLetsHimGo) {
  cpu_set_t before, after;
  ASSERT_EQ(sched_getaffinity(0, sizeof before, &before), 0);
  Precedence precedence(-milliseconds(12));
  precedence.ask(true);
  if (!precedence.permitted() || CPU_COUNT(&before) < 2)
    GTEST_SKIP() << "needs SCHED_FIFO and two processors";
  Clock::time_point due = Clock::now();
  for (int i = 0; i < 10; ++i) {
    due += milliseconds(20);
    precedence.sleep_until(due, [] { return false; });
    EXPECT_GE(Clock::now(), due);
    ASSERT_EQ(sched_getaffinity(0, sizeof after, &after), 0);
    EXPECT_TRUE(CPU_EQUAL(&before, &after));
  }
  EXPECT_GE(precedence.moves(), 1u);
}

TEST(Precedence, SleepsToTheTimeOrUntilItIsEnough) {
  for (const bool wanted : {false, true}) {
    Precedence precedence;
    precedence.ask(wanted);
    const Clock::time_point begun = Clock::now();
    precedence.sleep_until(begun + milliseconds(20), [] { return false; });
    EXPECT_GE(Clock::now() - begun, milliseconds(20));
    precedence.sleep_until(Clock::time_point::max(), [] { return true; });
    int asked = 0;
    precedence.sleep_until(begun + std::chrono::hours(1), [&] { return ++asked > 3; });
    EXPECT_EQ(asked, 4);
    EXPECT_GE(Clock::now() - begun, milliseconds(170)) << "asked every 50 ms";
  }
}

}  // namespace
}  // namespace eyrie::net
