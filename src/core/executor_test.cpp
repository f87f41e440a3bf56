// SPDX-License-Identifier: MIT
#include "core/executor.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <ctime>
#include <stdexcept>
#include <thread>
#include <vector>

#include "support/no_allocation.hpp"

namespace eyrie {
namespace {

using namespace std::chrono_literals;

class ExecutorOf : public ::testing::TestWithParam<unsigned> {
 protected:
  Executor executor_{GetParam()};
};
INSTANTIATE_TEST_SUITE_P(Workers, ExecutorOf, ::testing::Values(1u, 2u, 3u, 7u),
                         ::testing::PrintToStringParamName());

TEST_P(ExecutorOf, VisitsEveryRowOnceInConstantChunks) {
  for (const std::size_t rows : {0u, 1u, 255u, 256u, 257u, 512u, 10'000u, 100'001u}) {
    std::vector<int> visits(rows, 0);
    std::vector<int> chunks(chunk_count(rows), 0);
    executor_.for_chunks(rows, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
      ++chunks[chunk];
      EXPECT_EQ(begin, chunk * kChunk);
      EXPECT_EQ(end, std::min(rows, begin + kChunk));
      for (std::size_t row = begin; row < end; ++row)
        ++visits[row];
    });
    EXPECT_EQ(visits, std::vector<int>(rows, 1));
    EXPECT_EQ(chunks, std::vector<int>(chunk_count(rows), 1));
  }
}

TEST_P(ExecutorOf, GivesTheSameSumForAnyNumberOfWorkers) {
  const std::size_t rows = 20'000;
  const auto sum_with = [&](const Executor& executor) {
    std::vector<double> partial(chunk_count(rows));
    executor.for_chunks(rows, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
      for (std::size_t row = begin; row < end; ++row)
        partial[chunk] += 1.0 / static_cast<double>(row + 1);
    });
    double sum = 0;
    for (const double part : partial)
      sum += part;
    return sum;
  };
  EXPECT_EQ(sum_with(executor_), sum_with(Executor(1)));
}

TEST_P(ExecutorOf, MakesTheWritesOfOnePhaseVisibleToTheNext) {
  // many short phases of changing size: a worker that comes late to one must not touch the next
  std::vector<std::size_t> value(3000, 0), next(3000, 0);
  for (std::size_t phase = 1; phase <= 2000; ++phase) {
    const std::size_t rows = phase % 3 == 0 ? 3000 : 257 + phase % 500;
    executor_.for_chunks(rows, [&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t row = begin; row < end; ++row)
        next[row] = value[rows - 1 - row] + 1;
    });
    std::size_t expected = 0, sum = 0;
    for (std::size_t row = 0; row < rows; ++row) {
      expected += value[row] + 1;
      sum += next[row];
    }
    ASSERT_EQ(sum, expected) << "phase " << phase;
    std::swap(value, next);
  }
}

TEST_P(ExecutorOf, AllocatesNothingPerCall) {
  std::vector<double> values(5000, 1.0);
  const auto twice = [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row)
      values[row] *= 2;
  };
  executor_.for_chunks(values.size(), twice);
  {
    NoAllocation guard(NoAllocation::Scope::process);
    for (int i = 0; i < 100; ++i)
      executor_.for_chunks(values.size(), twice);
  }
  EXPECT_EQ(values.back(), 0x1p101);
}

TEST_P(ExecutorOf, KnowsItsWorkers) {
  EXPECT_EQ(executor_.workers(), GetParam());
}

TEST(Executor, RunsChunksAtTheSameTime) {
  const Executor executor(3);
  std::atomic<int> inside{0};
  std::atomic<bool> met{false};
  const auto deadline = std::chrono::steady_clock::now() + 20s;
  executor.for_chunks(3 * kChunk, [&](std::size_t, std::size_t, std::size_t) {
    if (++inside == 3)
      met = true;
    while (!met && std::chrono::steady_clock::now() < deadline)
      std::this_thread::yield();
  });
  EXPECT_TRUE(met) << "three chunks and three workers, but never three at a time";
}

TEST(Executor, RunsOneChunkInTheCallingThread) {
  const Executor executor(4);
  std::thread::id by;
  executor.for_chunks(kChunk, [&](std::size_t, std::size_t, std::size_t) {
    by = std::this_thread::get_id();
    executor.for_chunks(10, [](std::size_t, std::size_t, std::size_t) {});  // and may nest
  });
  EXPECT_EQ(by, std::this_thread::get_id());
}

TEST(Executor, SleepsWhenThereIsNothingToDo) {
  const Executor executor(4);
  executor.for_chunks(10 * kChunk, [](std::size_t, std::size_t, std::size_t) {});
  std::this_thread::sleep_for(20ms);
  const std::clock_t before = std::clock();  // of all threads of the process
  std::this_thread::sleep_for(200ms);
  EXPECT_LT(static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC, 0.05);
}

TEST(Executor, StartsAndEndsWithoutWork) {
  for (unsigned i = 0; i < 50; ++i)
    const Executor executor(1 + i % 5);
}

TEST(Executor, RefusesTooFewAndTooManyWorkers) {
  EXPECT_THROW(Executor(0), std::logic_error);
  EXPECT_THROW(Executor(257), std::logic_error);
}

class ExecutorDeathTest : public ::testing::Test {
 protected:
  void SetUp() override { ::testing::FLAGS_gtest_death_test_style = "threadsafe"; }
};

TEST_F(ExecutorDeathTest, RefusesToNest) {
  EXPECT_DEATH(
      {
        const Executor executor(2);
        executor.for_chunks(2 * kChunk, [&](std::size_t, std::size_t, std::size_t) {
          executor.for_chunks(2 * kChunk, [](std::size_t, std::size_t, std::size_t) {});
        });
      },
      "one for_chunks at a time");
}

TEST_F(ExecutorDeathTest, LetsNoExceptionThrough) {
  for (const unsigned workers : {1u, 2u})
    EXPECT_DEATH(
        {
          const Executor executor(workers);
          try {
            executor.for_chunks(2 * kChunk, [](std::size_t chunk, std::size_t, std::size_t) {
              if (chunk == 1)
                throw std::runtime_error("not in a step");
            });
          } catch (const std::exception&) {
          }
        },
        "not in a step");
}

}  // namespace
}  // namespace eyrie
