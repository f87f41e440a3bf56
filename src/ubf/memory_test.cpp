// SPDX-License-Identifier: MIT
#include "ubf/memory.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

namespace eyrie::ubf {
namespace {

struct Tight {
  double time = 0;
  std::uint16_t running = 0;
  std::uint8_t reserved[6] = {};
};
struct TailPadding {
  double time = 0;
  std::uint8_t flag = 0;
};
struct InnerPadding {
  std::uint8_t flag = 0;
  std::uint32_t count = 0;
};
struct NestedPadding {
  InnerPadding inner;
};
struct StartsAtOne {
  std::uint32_t count = 1;
};
struct WideAlignment {
  alignas(16) std::uint64_t words[2] = {};
};

TEST(Memory, MayHoldOnlyPlainBytesWithoutPadding) {
  EXPECT_TRUE(NodeMemory<Tight>);
  EXPECT_TRUE(NodeMemory<std::uint8_t>);
  EXPECT_FALSE(NodeMemory<TailPadding>);
  EXPECT_FALSE(NodeMemory<InnerPadding>);
  EXPECT_FALSE(NodeMemory<NestedPadding>);
  EXPECT_FALSE(NodeMemory<std::string>);
}

TEST(Memory, MustBeZeroBytesWhenFresh) {
  EXPECT_FALSE(NodeMemory<StartsAtOne>);
  EXPECT_TRUE(NoPadding<StartsAtOne>);
}

TEST(Memory, MustFitTheAlignmentOfTheSlab) {
  EXPECT_FALSE(NodeMemory<WideAlignment>);
}

TEST(Memory, TakesMultiplesOfEightBytes) {
  EXPECT_EQ(slab_bytes(0), 0u);
  EXPECT_EQ(slab_bytes(1), 8u);
  EXPECT_EQ(slab_bytes(8), 8u);
  EXPECT_EQ(slab_bytes(9), 16u);
}

}  // namespace
}  // namespace eyrie::ubf
