// SPDX-License-Identifier: MIT
#include "scenario/end_guard.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <latch>
#include <thread>

namespace eyrie::scenario {
namespace {

/// Ends the program in eight threads at once.
void end_at_once(void (*end)()) {
  const EndGuard guard(3, [](const std::string& done) {
    ::usleep(1000);  // time enough for the others to get away
    std::fprintf(stderr, "last words: %s\n", done.c_str());
  });
  std::latch begin(8);
  std::vector<std::jthread> threads;
  for (int i = 0; i < 8; ++i)
    threads.emplace_back([&] {
      begin.arrive_and_wait();
      end();
    });
}

TEST(EndGuardDeathTest, HearsTheFirstOfThreadsThatEndTheProgramAtOnce) {
  for (int i = 0; i < 10; ++i) {
    EXPECT_EXIT(end_at_once([] { std::exit(0); }), testing::ExitedWithCode(3),
                R"(last words: somebody called exit\(\))");
    EXPECT_EXIT(end_at_once([] { std::quick_exit(0); }), testing::ExitedWithCode(3),
                R"(last words: somebody called quick_exit\(\))");
    EXPECT_EXIT(end_at_once([] { std::terminate(); }), testing::ExitedWithCode(3),
                "last words: somebody called std::terminate");
  }
}

TEST(EndGuardDeathTest, DoesNotWaitForItself) {
  EXPECT_EXIT(
      {
        const EndGuard guard(3, [](const std::string&) { std::exit(4); });
        std::exit(0);
      },
      testing::ExitedWithCode(4), "");
}

}  // namespace
}  // namespace eyrie::scenario
