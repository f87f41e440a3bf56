// SPDX-License-Identifier: MIT
#include "sim/schema.hpp"

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <stdexcept>
#include <string>

#include "sim/swarm_test.hpp"

namespace eyrie::sim {
namespace {

using swarm::Body;
using swarm::Vitals;

/// What `misuse` throws.
std::string complaint(const std::function<void(SchemaBuilder&)>& misuse) {
  SchemaBuilder builder;
  try {
    misuse(builder);
  } catch (const std::logic_error& error) {
    return error.what();
  }
  return "(nothing)";
}

/// Four bytes, of which fields() forgets the last.
struct Unnamed {
  std::uint16_t known = 0;
  std::uint8_t also_known = 0, forgotten = 0;
  static constexpr auto fields() {
    return field_list(field("known", &Unnamed::known), field("also_known", &Unnamed::also_known));
  }
};

struct Twice {
  float a = 0, b = 0;
  static constexpr auto fields() {
    return field_list(field("a", &Twice::a), field("a", &Twice::b));
  }
};

TEST(Schema, PutsEveryColumnOnItsOwnCacheLines) {
  SchemaBuilder builder;
  const auto keys = swarm::Swarm::describe(builder, 7, 3);
  const auto schema = builder.build();
  std::uint64_t end = World::header_bytes(2);
  for (const TableInfo& table : schema->tables())
    for (const std::uint32_t index : table.columns) {
      const ColumnInfo& column = schema->column(index);
      EXPECT_EQ(column.offset % 64, 0u) << column.name;
      EXPECT_GE(column.offset, end) << column.name;
      end = column.offset + std::uint64_t{column.stride} * table.capacity;
    }
  EXPECT_GE(schema->bytes(), end);
  EXPECT_EQ(schema->bytes() % 64, 0u);
  EXPECT_EQ(schema->column(keys.body.index).stride, sizeof(Body));
}

TEST(Schema, FindsTablesAndColumnsByName) {
  SchemaBuilder builder;
  const auto keys = swarm::Swarm::describe(builder, 7, 3);
  const auto schema = builder.build();
  EXPECT_EQ(schema->find_table("pellet"), keys.pellets);
  EXPECT_FALSE(schema->find_table("missile"));
  EXPECT_EQ(schema->find_column(keys.pellets, "body"), keys.pellet_body.index);
  EXPECT_EQ(schema->find_column(keys.pellets, "mood"), kNoColumn);
}

TEST(Schema, HashesTheLayoutButNotTheCapacities) {
  const auto hash_of = [](std::uint32_t room, const char* table, const char* column, bool more) {
    SchemaBuilder builder;
    const TableId t = builder.add_table(table, room);
    builder.add_column<Body>(t, column);
    builder.add_bytes(t, "brain", more ? 16 : 8);
    return builder.build()->layout_hash();
  };
  const std::uint64_t base = hash_of(10, "bird", "body", false);
  EXPECT_EQ(hash_of(2000, "bird", "body", false), base);
  EXPECT_NE(hash_of(10, "birds", "body", false), base);
  EXPECT_NE(hash_of(10, "bird", "bodies", false), base);
  EXPECT_NE(hash_of(10, "bird", "body", true), base);
}

TEST(Schema, HashesTheOrderAndTypesOfColumns) {
  const auto hash_of = [](auto add_columns) {
    SchemaBuilder builder;
    add_columns(builder, builder.add_table("bird", 1));
    return builder.build()->layout_hash();
  };
  const auto ab = hash_of([](SchemaBuilder& b, TableId t) {
    b.add_column<Body>(t, "a");
    b.add_column<Vitals>(t, "b");
  });
  const auto ba = hash_of([](SchemaBuilder& b, TableId t) {
    b.add_column<Vitals>(t, "b");
    b.add_column<Body>(t, "a");
  });
  const auto swapped = hash_of([](SchemaBuilder& b, TableId t) {
    b.add_column<Vitals>(t, "a");
    b.add_column<Body>(t, "b");
  });
  EXPECT_NE(ab, ba);
  EXPECT_NE(ab, swapped);
}

TEST(SchemaBuilder, RefusesNamesThatAreTakenOrNoIdentifiers) {
  EXPECT_EQ(complaint([](SchemaBuilder& b) { b.add_table("Bird", 1); }),
            "schema: 'Bird' is not a lower-case identifier");
  EXPECT_EQ(complaint([](SchemaBuilder& b) { b.add_table("", 1); }),
            "schema: '' is not a lower-case identifier");
  EXPECT_EQ(complaint([](SchemaBuilder& b) {
              b.add_table("bird", 1);
              b.add_table("bird", 1);
            }),
            "schema: table 'bird' is added twice");
  EXPECT_EQ(
      complaint([](SchemaBuilder& b) { b.add_column<Body>(b.add_table("bird", 1), "leaving"); }),
      "schema: column 'leaving' is added twice to table 'bird'");
}

static_assert(DescribedRow<Twice> && !DescribedRow<Unnamed>);

TEST(SchemaBuilder, RefusesARowWithTwoFieldsOfOneName) {
  EXPECT_EQ(complaint([](SchemaBuilder& b) { b.add_column<Twice>(b.add_table("bird", 1), "row"); }),
            "schema: bird.row: field 'a' is described twice");
}

TEST(SchemaBuilder, RefusesImpossibleSizes) {
  EXPECT_EQ(complaint([](SchemaBuilder& b) { b.add_table("bird", 0); }),
            "schema: table 'bird' must have room for 1 to 16777216 rows, not 0");
  EXPECT_EQ(complaint([](SchemaBuilder& b) { b.add_bytes(b.add_table("bird", 1), "brain", 12); }),
            "schema: 'brain': a stride of 12 bytes is not in [1, 1048576] or no multiple of 8");
  EXPECT_EQ(complaint([](SchemaBuilder& b) { b.add_column<Body>(TableId{3}, "body"); }),
            "schema: column 'body' is added to an unknown table");
}

TEST(SchemaBuilder, IsEmptyOnceItHasBuilt) {
  EXPECT_EQ(complaint([](SchemaBuilder& b) { (void)b.build(); }), "schema: it has no table");
  EXPECT_EQ(complaint([](SchemaBuilder& b) {
              b.add_table("bird", 1);
              (void)b.build();
              b.add_table("pellet", 1);
            }),
            "schema: it was built already");
}

}  // namespace
}  // namespace eyrie::sim
