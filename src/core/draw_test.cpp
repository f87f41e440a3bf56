// SPDX-License-Identifier: MIT
#include "core/draw.hpp"

#include <Random123/philox.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <set>
#include <type_traits>
#include <vector>

#include "core/assert.hpp"
#include "core/hash.hpp"
#include "support/no_allocation.hpp"

namespace eyrie {
namespace {

// The numbers are part of recorded runs.
static_assert(static_cast<int>(Stream::radar) == 0 && static_cast<int>(Stream::radar_noise) == 1);
static_assert(static_cast<int>(Stream::seeker) == 2);
static_assert(static_cast<int>(Stream::lethality) == 4 && static_cast<int>(Stream::iff) == 5);
static_assert(static_cast<int>(Stream::visual) == 6 && static_cast<int>(Stream::gun) == 7);
static_assert(static_cast<int>(Stream::behavior) == 8 && static_cast<int>(Stream::rwr) == 9);
static_assert(static_cast<int>(Stream::datalink) == 10);
static_assert(static_cast<int>(Stream::visual_noise) == 16 &&
              static_cast<int>(Stream::test) == 255);
static_assert(std::is_trivially_copyable_v<Draw>);

constexpr int kMany = 200'000;

struct Moments {
  double mean = 0, variance = 0;
};

template <class Next>
Moments moments_of(Next next) {
  double sum = 0, squares = 0;
  for (int i = 0; i < kMany; ++i) {
    const double x = next(i);
    sum += x;
    squares += x * x;
  }
  return {sum / kMany, squares / kMany - sum / kMany * (sum / kMany)};
}

/// Between pairs of numbers that a function gives; for independent ones its standard deviation is
/// 1 / sqrt(kMany) = 0.0022.
template <class Pair>
double correlation_of(Pair pair) {
  double product = 0;
  for (int i = 0; i < kMany; ++i) {
    const auto [a, b] = pair(static_cast<std::uint64_t>(i));
    product += (a - 0.5) * (b - 0.5);
  }
  return product / kMany * 12;
}

TEST(Philox, GivesTheKnownAnswers) {
  // kat_vectors of Random123 1.14: philox4x32 10
  struct Known {
    philox4x32_ctr_t counter;
    philox4x32_key_t key;
    philox4x32_ctr_t answer;
  };
  const Known known[] = {
      {{{0, 0, 0, 0}}, {{0, 0}}, {{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}}},
      {{{~0u, ~0u, ~0u, ~0u}}, {{~0u, ~0u}}, {{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}}},
      {{{0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}},
       {{0xa4093822, 0x299f31d0}},
       {{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}}}};
  for (const Known& k : known)
    EXPECT_TRUE(philox4x32(k.counter, k.key) == k.answer);
}

TEST(Draw, IsPhiloxOfItsArguments) {
  Draw zero(0, PlayerId{}, Stream::radar, 0);
  EXPECT_EQ(zero.bits(), 0xe169c58d6627e8d5u);
  EXPECT_EQ(zero.bits(), 0x9b00dbd8bc57ac4cu);

  Draw draw(0x1122334455667788, PlayerId{77}, Stream{3}, 0x9abc'13198a2e, 0xabcdef);
  philox4x32_ctr_t counter{{77, 0x03abcdef, 0x13198a2e, 0x9abc}};
  const philox4x32_key_t key{{0x55667788, 0x11223344}};
  for (int block = 0; block < 3; ++block, counter.v[3] += 0x10000) {
    const philox4x32_ctr_t out = philox4x32(counter, key);
    EXPECT_EQ(draw.bits(), out.v[0] | std::uint64_t{out.v[1]} << 32);
    EXPECT_EQ(draw.bits(), out.v[2] | std::uint64_t{out.v[3]} << 32);
  }
}

TEST(Draw, GivesTheSameBitsEverywhere) {
  Hasher hasher;
  for (std::uint32_t step = 0; step < 1000; ++step) {
    Draw draw(42, PlayerId{1 + step % 7}, Stream::test, step);
    for (int i = 0; i < 5; ++i) {
      hasher.word(std::bit_cast<std::uint64_t>(draw.uniform()));
      hasher.word(std::bit_cast<std::uint64_t>(draw.normal()));
    }
  }
  EXPECT_EQ(hasher.value(), 0xf4367d58cad3d214u) << std::hex << hasher.value();
}

TEST(Draw, SharesNothingBetweenPlayersStreamsStepsAndIndices) {
  std::set<std::uint64_t> seen;
  std::size_t count = 0;
  const auto take = [&](Draw draw) {
    for (int i = 0; i < 6; ++i, ++count)
      seen.insert(draw.bits());
  };
  for (std::uint32_t player = 0; player < 10; ++player)
    for (const Stream stream : {Stream::radar, Stream::radar_noise, Stream::seeker})
      for (std::uint64_t step = 0; step < 20; ++step)
        for (std::uint32_t index = 0; index < 10; ++index)
          take(Draw(1, PlayerId{player}, stream, step, index));
  take(Draw(2, PlayerId{1}, Stream::radar, 1));
  EXPECT_EQ(seen.size(), count);
}

TEST(Draw, IsUniform) {
  Draw draw(7, PlayerId{1}, Stream::test, 0);
  // one Draw gives 131072 numbers: start a new one per step
  const auto next = [](int i) {
    return Draw(7, PlayerId{1}, Stream::test, static_cast<std::uint64_t>(i)).uniform();
  };
  const Moments m = moments_of(next);
  EXPECT_NEAR(m.mean, 0.5, 4 * std::sqrt(1.0 / 12 / kMany));
  EXPECT_NEAR(m.variance, 1.0 / 12, 4 * std::sqrt(1.0 / 180 / kMany));

  std::vector<int> bins(100);
  for (int i = 0; i < 100'000; ++i) {
    const double x = draw.uniform();
    ASSERT_TRUE(x >= 0 && x < 1);
    ++bins[static_cast<std::size_t>(x * 100)];
  }
  double chi2 = 0;
  for (const int n : bins)
    chi2 += (n - 1000.0) * (n - 1000.0) / 1000;
  EXPECT_LT(chi2, 149);  // 99 degrees of freedom, 0.1 %
  EXPECT_GT(chi2, 60);
}

TEST(Draw, IsIndependentAcrossEachOfItsArguments) {
  const auto at = [](std::uint32_t player, Stream stream, std::uint64_t step, std::uint32_t index) {
    return Draw(3, PlayerId{player}, stream, step, index).uniform();
  };
  const double limit = 4 / std::sqrt(kMany);
  EXPECT_LT(std::fabs(correlation_of([&](std::uint64_t i) {
              return std::pair(at(1, Stream::radar, i, 0), at(1, Stream::seeker, i, 0));
            })),
            limit);
  EXPECT_LT(std::fabs(correlation_of([&](std::uint64_t i) {
              return std::pair(at(1, Stream::radar, i, 0), at(2, Stream::radar, i, 0));
            })),
            limit);
  EXPECT_LT(std::fabs(correlation_of([&](std::uint64_t i) {
              return std::pair(at(1, Stream::radar, i, 0), at(1, Stream::radar, i + 1, 0));
            })),
            limit);
  EXPECT_LT(std::fabs(correlation_of([&](std::uint64_t i) {
              return std::pair(at(1, Stream::radar, i, 0), at(1, Stream::radar, i, 1));
            })),
            limit);
  EXPECT_LT(std::fabs(correlation_of([&](std::uint64_t i) {
              Draw draw(3, PlayerId{1}, Stream::radar, i);
              const double first = draw.uniform();
              return std::pair(first, draw.uniform());
            })),
            limit);
}

TEST(Draw, IsNormal) {
  int beyond_1_96 = 0, beyond_3 = 0;
  double fourth = 0;
  Draw draw(5, PlayerId{9}, Stream::radar_noise, 3);
  const Moments m = moments_of([&](int i) {
    if (i == 100'000)
      draw = Draw(5, PlayerId{9}, Stream::radar_noise, 4);
    const double z = draw.normal();
    beyond_1_96 += std::fabs(z) > 1.959964;
    beyond_3 += std::fabs(z) > 3;
    fourth += z * z * z * z / kMany;
    return z;
  });
  EXPECT_NEAR(m.mean, 0, 4 / std::sqrt(kMany));
  EXPECT_NEAR(m.variance, 1, 4 * std::sqrt(2.0 / kMany));
  EXPECT_NEAR(fourth, 3, 4 * std::sqrt(96.0 / kMany));
  EXPECT_NEAR(beyond_1_96, 0.05 * kMany, 4 * std::sqrt(0.05 * kMany));
  EXPECT_NEAR(beyond_3, 0.0026998 * kMany, 4 * std::sqrt(0.0027 * kMany));
}

TEST(Draw, KnowsCertainty) {
  Draw draw(1, PlayerId{1}, Stream::test, 1);
  int hits = 0;
  for (int i = 0; i < 10'000; ++i) {
    EXPECT_FALSE(draw.chance(0));
    EXPECT_FALSE(draw.chance(-1));
    EXPECT_FALSE(draw.chance(std::nan("")));
    EXPECT_TRUE(draw.chance(1));
    EXPECT_TRUE(draw.chance(2));
    hits += draw.chance(0.3);
  }
  EXPECT_NEAR(hits, 3000, 4 * std::sqrt(2100));
}

TEST(Draw, StaysInTheRangeAskedFor) {
  Draw draw(1, PlayerId{1}, Stream::test, 2);
  for (int i = 0; i < 1000; ++i) {
    const double x = draw.uniform(-3, 5);
    EXPECT_TRUE(x >= -3 && x < 5);
  }
}

TEST(Draw, NeverGivesTheUpperEnd) {
  Draw draw(1, PlayerId{1}, Stream::test, 0);
  const double high = std::nextafter(1.0, 2.0);
  for (int i = 0; i < 1000; ++i)
    ASSERT_EQ(draw.uniform(1, high), 1);
}

TEST(Draw, GivesAllTheNumbersThatItHas) {
  Draw draw(1, PlayerId{1}, Stream::test, 0);
  double sum = 0;
  for (int i = 0; i < 131'072; ++i)
    sum += draw.uniform();
  EXPECT_NEAR(sum / 131'072, 0.5, 0.005);
  EXPECT_DEBUG_DEATH(static_cast<void>(draw.bits()), "");
}

TEST(Draw, AllocatesNothing) {
  NoAllocation guard;
  Draw draw(1, PlayerId{1}, Stream::test, 3);
  double sum = 0;
  for (int i = 0; i < 100; ++i)
    sum += draw.normal() + draw.uniform();
  EXPECT_GT(sum, 0);
}

#if EYRIE_ASSERT_ENABLED
TEST(DrawDeathTest, RefusesWhatWouldOverlap) {
  EXPECT_DEATH(Draw(1, PlayerId{1}, Stream::test, 0, 1u << 24), "index");
  EXPECT_DEATH(Draw(1, PlayerId{1}, Stream::test, std::uint64_t{1} << 48), "step");
}
#endif

}  // namespace
}  // namespace eyrie
