// SPDX-License-Identifier: MIT
#include "core/hash.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <type_traits>
#include <vector>

#include "core/id.hpp"
#include "support/no_allocation.hpp"

namespace eyrie {
namespace {

/// 0, 1, 2 ... 250, 0, 1 ...
std::vector<std::byte> some_bytes(std::size_t count) {
  std::vector<std::byte> bytes(count);
  for (std::size_t i = 0; i < count; ++i)
    bytes[i] = static_cast<std::byte>(i % 251);
  return bytes;
}

TEST(Hash, HasTheValuesOfXxh3) {
  // as computed by libxxhash 0.8.1 (XXH3_64bits), which is not what this file is linked with
  EXPECT_EQ(hash_bytes({}), 0x2d06800538d394c2u);
  EXPECT_EQ(hash_bytes(some_bytes(100)), 0x4e4f921a64bd1cu);
  EXPECT_EQ(hash_bytes(some_bytes(10000)), 0x1cb3abee1c2fc1c4u);
}

TEST(Hash, DoesNotDependOnThePieces) {
  const std::vector<std::byte> bytes = some_bytes(5000);
  for (const std::size_t piece : {1u, 7u, 64u, 256u, 1000u, 4999u}) {
    Hasher hasher;
    for (std::size_t at = 0; at < bytes.size(); at += piece)
      hasher.bytes(&bytes[at], std::min(piece, bytes.size() - at));
    EXPECT_EQ(hasher.value(), hash_bytes(bytes)) << piece;
  }
}

TEST(Hash, TakesAWordAsEightLittleEndianBytes) {
  Hasher words, bytes;
  words.word(0x0807060504030201);
  const std::array<unsigned char, 8> same{1, 2, 3, 4, 5, 6, 7, 8};
  bytes.bytes(same.data(), same.size());
  EXPECT_EQ(words.value(), bytes.value());
}

TEST(Hash, GoesOnAfterAValueAndInACopy) {
  const std::vector<std::byte> bytes = some_bytes(600);
  Hasher hasher;
  hasher.bytes(bytes.data(), 300);
  EXPECT_EQ(hasher.value(), hash_bytes(std::span(bytes).first(300)));
  Hasher copy = hasher;
  copy.bytes(&bytes[300], 300);
  hasher.bytes(&bytes[300], 300);
  EXPECT_EQ(hasher.value(), hash_bytes(bytes));
  EXPECT_EQ(copy.value(), hasher.value());
}

TEST(Hash, AllocatesNothing) {
  const std::vector<std::byte> bytes = some_bytes(5000);
  NoAllocation guard;
  Hasher hasher;
  hasher.bytes(bytes.data(), bytes.size());
  EXPECT_EQ(hasher.value(), hash_bytes(bytes));
}

TEST(Id, NamesNothingByDefaultAndOrdersByAge) {
  EXPECT_FALSE(PlayerId{});
  EXPECT_TRUE(PlayerId{1});
  EXPECT_LT(PlayerId{1}, PlayerId{2});
  EXPECT_EQ(std::hash<PlayerId>{}(PlayerId{7}), 7u);
  static_assert(!std::is_convertible_v<PlayerId, TrackId>);
  static_assert(!std::is_convertible_v<std::uint32_t, PlayerId>);
  static_assert(std::has_unique_object_representations_v<PlayerId>);
}

}  // namespace
}  // namespace eyrie
