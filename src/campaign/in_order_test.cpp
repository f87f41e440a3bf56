// SPDX-License-Identifier: MIT
#include "campaign/in_order.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <numeric>

namespace eyrie::campaign {
namespace {

using namespace std::chrono_literals;

class InOrder : public ::testing::TestWithParam<unsigned> {};
INSTANTIATE_TEST_SUITE_P(Workers, InOrder, ::testing::Values(1u, 2u, 3u, 8u),
                         ::testing::PrintToStringParamName());

TEST_P(InOrder, TakesEachResultOnceInTheOrderOfTheWork) {
  for (const std::uint64_t n : {0u, 1u, 2u, 7u, 3000u}) {
    std::vector<std::atomic<int>> worked(n);
    std::vector<std::uint64_t> taken;
    const auto caller = std::this_thread::get_id();
    in_order<std::unique_ptr<std::uint64_t>>(
        n, GetParam(),
        [&](std::uint64_t i) {
          ++worked[i];
          if (i % 97 == 5)
            std::this_thread::sleep_for(1ms);  // the others are ahead
          return std::make_unique<std::uint64_t>(i * i);
        },
        [&](std::uint64_t i, std::unique_ptr<std::uint64_t>&& result) {
          EXPECT_EQ(*result, i * i);
          EXPECT_EQ(std::this_thread::get_id(), caller);
          taken.push_back(i);
          return true;
        });
    std::vector<std::uint64_t> all(n);
    std::iota(all.begin(), all.end(), 0);
    EXPECT_EQ(taken, all);
    for (const auto& times : worked)
      EXPECT_EQ(times, 1);
  }
}

TEST_P(InOrder, BeginsNoMoreWorkThanMayWait) {
  std::atomic<std::uint64_t> begun = 0;
  in_order<int>(
      10'000, GetParam(),
      [&](std::uint64_t) {
        ++begun;
        return 0;
      },
      [&](std::uint64_t i, int) {
        EXPECT_LE(begun, i + 1 + 64 * GetParam());
        return i < 5000;
      });
  EXPECT_LE(begun, 5001 + 64 * GetParam());
}

TEST_P(InOrder, StopsWhenTheTakerHasEnough) {
  std::uint64_t taken = 0;
  in_order<int>(
      1'000'000'000, GetParam(), [](std::uint64_t) { return 1; },
      [&](std::uint64_t, int one) { return (taken += static_cast<std::uint64_t>(one)) < 10; });
  EXPECT_EQ(taken, 10U);
}

TEST_P(InOrder, ThrowsInTheOrderOfTheWork) {
  // the second mistake is made first
  std::atomic<bool> made = false;
  std::vector<std::uint64_t> taken;
  const auto work = [&](std::uint64_t i) {
    if (i == 4) {
      made = true;
      throw std::runtime_error("4");
    }
    if (i == 3) {
      while (GetParam() > 1 && !made)
        std::this_thread::yield();
      throw std::runtime_error("3");
    }
    return 0;
  };
  try {
    in_order<int>(1'000'000'000, GetParam(), work, [&](std::uint64_t i, int) {
      taken.push_back(i);
      return true;
    });
    FAIL() << "nothing was thrown";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "3");
  }
  EXPECT_EQ(taken, (std::vector<std::uint64_t>{0, 1, 2}));
}

TEST_P(InOrder, LetsATakersExceptionThrough) {
  EXPECT_THROW(in_order<int>(
                   1'000'000'000, GetParam(), [](std::uint64_t) { return 0; },
                   [](std::uint64_t i, int) {
                     return i == 3 ? throw std::runtime_error("the disk is full") : true;
                   }),
               std::runtime_error);
}

}  // namespace
}  // namespace eyrie::campaign
