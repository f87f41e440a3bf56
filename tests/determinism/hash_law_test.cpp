// SPDX-License-Identifier: MIT
/// \file  A law for the hash: whatever byte of a world changes, of whatever column of whatever
/// table, or of its header, the hash is another one, and differences and digests name the field.
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <vector>

#include "core/draw.hpp"
#include "core/field.hpp"
#include "scenario/scenario.hpp"
#include "sim/difference.hpp"
#include "sim/world.hpp"

namespace eyrie {
namespace {

constexpr std::uint32_t kRows = 2;

/// Aircraft, missiles and vehicles, as a scenario flies them.
std::shared_ptr<const scenario::Scenario> everything() {
  static const auto loaded =
      scenario::load({"scenarios/convoy.yaml", {}}, scenario::Source::disk("."));
  return loaded;
}

/// Every byte of a column, also where the world hands it out for reading only.
std::span<std::byte> writable(std::span<const std::byte> bytes) {
  return {const_cast<std::byte*>(bytes.data()), bytes.size()};
}

/// Two rows in every table, full of bytes that mean nothing.
sim::World full_world() {
  sim::World world = everything()->simulation->world(1);
  const sim::Schema& schema = world.schema();
  for (std::uint32_t t = 1; t <= schema.tables().size(); ++t)
    for (std::uint32_t row = 0; row < kRows; ++row)
      EYRIE_DEMAND(world.spawn(TableId{t}), "there is room");
  for (const sim::TableInfo& table : schema.tables())
    for (std::size_t c = 2; c < table.columns.size(); ++c) {  // behind the ids and the marks
      Draw draw(7, PlayerId{table.columns[c] + 1}, Stream::test, 0);
      for (std::byte& b : writable(world.column_bytes(table.columns[c])))
        b = static_cast<std::byte>(draw.uniform() * 256);
    }
  return world;
}

/// The field of a column that a byte of its row belongs to, and which of its scalars.
struct Named {
  const FieldInfo* field = nullptr;
  std::uint32_t index = 0;
};
Named named(const sim::ColumnInfo& column, std::size_t byte) {
  Named found;
  for (const FieldInfo& field : column.fields) {
    if (byte < field.offset || byte >= field.offset + field.size())
      continue;
    EXPECT_EQ(found.field, nullptr) << column.name << " byte " << byte << " is in two fields";
    found = {&field, static_cast<std::uint32_t>((byte - field.offset) / scalar_size(field.type))};
  }
  EXPECT_NE(found.field, nullptr) << column.name << " byte " << byte << " is padding";
  return found;
}

/// Calls `check(column index, row, byte of the row, the byte)` for every byte of every row.
template <class Check>
void for_each_byte(sim::World& world, Check check) {
  const sim::Schema& schema = world.schema();
  for (std::uint32_t index = 0; index < schema.columns().size(); ++index) {
    const std::size_t stride = schema.column(index).stride;
    const auto bytes = writable(world.column_bytes(index));
    ASSERT_EQ(bytes.size(), kRows * stride);
    for (std::size_t at = 0; at < bytes.size(); ++at)
      check(index, static_cast<std::uint32_t>(at / stride), at % stride, bytes[at]);
  }
}

TEST(HashLaw, EveryBitOfEveryColumnChangesTheHash) {
  sim::World world = full_world();
  const std::uint64_t before = world.hash();
  std::size_t flips = 0;
  for_each_byte(world, [&](std::uint32_t index, std::uint32_t row, std::size_t at, std::byte& b) {
    for (int bit = 0; bit < 8; ++bit, ++flips) {
      b ^= std::byte{1} << bit;
      EXPECT_NE(world.hash(), before)
          << world.schema().column(index).name << " row " << row << " byte " << at;
      b ^= std::byte{1} << bit;
    }
  });
  EXPECT_EQ(world.hash(), before);
  EXPECT_GT(flips, 100'000U);  // the real rows, not some small ones
}

TEST(HashLaw, EveryBitOfTheHeaderChangesTheHash) {
  sim::World world = full_world();
  const std::uint64_t before = world.hash();
  const auto header = writable(world.header_bytes());
  const std::size_t tables = world.schema().tables().size();
  const std::size_t counts = header.size() - tables * sizeof(std::uint32_t);
  for (std::size_t at = 0; at < counts; ++at)
    for (int bit = 0; bit < 8; ++bit) {
      header[at] ^= std::byte{1} << bit;
      EXPECT_NE(world.hash(), before) << at;
      header[at] ^= std::byte{1} << bit;
    }
  // of the numbers of rows those that the buffer has room for: fewer rows than there are
  for (std::size_t t = 0; t < tables; ++t)
    for (const std::uint32_t rows : {0U, 1U}) {
      sim::World other = world;
      std::memcpy(writable(other.header_bytes()).data() + counts + t * sizeof rows, &rows,
                  sizeof rows);
      EXPECT_NE(other.hash(), before) << t;
    }
  EXPECT_EQ(world.hash(), before);
}

TEST(HashLaw, ADifferenceNamesTheFieldOfEveryByte) {
  const sim::World left = full_world();
  sim::World right = left;
  for_each_byte(right, [&](std::uint32_t index, std::uint32_t row, std::size_t at, std::byte& b) {
    const sim::ColumnInfo& column = right.schema().column(index);
    const Named field = named(column, at);
    ASSERT_NE(field.field, nullptr);
    b ^= std::byte{0x10};
    const auto found = first_difference(left, right);
    b ^= std::byte{0x10};
    ASSERT_TRUE(found) << column.name << " byte " << at;
    EXPECT_EQ(found->table, right.schema().table(column.table).name);
    EXPECT_EQ(found->column, column.name);
    EXPECT_EQ(found->field, scalar_label(*field.field, field.index));
    EXPECT_EQ(found->row, row);
    EXPECT_EQ(found->player, left.ids(column.table)[row]);
  });
}

TEST(HashLaw, ADigestNamesTheFieldOfEveryByte) {
  const sim::World left = full_world();
  const sim::Digest before = digest(left);
  sim::World right = left;
  std::size_t flips = 0, missed = 0;
  for_each_byte(right, [&](std::uint32_t index, std::uint32_t row, std::size_t at, std::byte& b) {
    const sim::ColumnInfo& column = right.schema().column(index);
    b ^= std::byte{0x10};
    const auto found = compare(right.schema(), before, digest(right));
    b ^= std::byte{0x10};
    ++flips;
    // a digest is short: once in a while two fields, or two rows, have the same
    if (!found || found->field.empty() || !found->row) {
      ++missed;
      return;
    }
    EXPECT_EQ(found->table, right.schema().table(column.table).name);
    EXPECT_EQ(found->column, column.name);
    EXPECT_EQ(found->field, named(column, at).field->name.view());
    EXPECT_EQ(found->row, row);
  });
  EXPECT_LE(missed, 1 + flips / 5000);
}

}  // namespace
}  // namespace eyrie
