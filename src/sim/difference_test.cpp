// SPDX-License-Identifier: MIT
#include "sim/difference.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include "sim/swarm_test.hpp"

namespace eyrie::sim {
namespace {

using swarm::fly;
using swarm::Happening;
using swarm::Swarm;

TEST(FirstDifference, IsNoneBetweenEqualWorlds) {
  const Swarm swarm;
  World left = swarm.world(50);
  fly(swarm, left, 30);
  const World right = left;
  EXPECT_EQ(first_difference(left, right), std::nullopt);
  EXPECT_EQ(compare(left.schema(), digest(left), digest(right)), std::nullopt);
}

TEST(FirstDifference, NamesStepTableColumnRowPlayerFieldAndBothValues) {
  const Swarm swarm;
  World left = swarm.world(50);
  World right = left;
  left.rows(swarm.keys.body)[7].velocity.z = 1.5;
  right.rows(swarm.keys.body)[7].velocity.z = 1.25;
  const auto found = first_difference(left, right);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->step, 0u);
  EXPECT_EQ(found->table, "bird");
  EXPECT_EQ(found->column, "body");
  EXPECT_EQ(found->row, 7u);
  EXPECT_EQ(found->player, PlayerId{8});
  EXPECT_EQ(found->field, "velocity.z");
  EXPECT_EQ(found->left, "1.5");
  EXPECT_EQ(found->right, "1.25");
  EXPECT_EQ(found->text(),
            "step 0: bird.body.velocity.z of player 8 (row 7) is 1.5, and 1.25 in the other");
}

TEST(FirstDifference, SeesASingleBitOfABrain) {
  const Swarm swarm;
  World left = swarm.world(3);
  const World right = left;
  left.bytes(swarm.keys.brain, 2)[20] = std::byte{4};
  const auto found = first_difference(left, right);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->column, "brain");
  EXPECT_EQ(found->field, "bytes[20]");
  EXPECT_EQ(found->row, 2u);
}

TEST(FirstDifference, SeesTheHeaderAndTheNumberOfRows) {
  const Swarm swarm;
  const World left = swarm.world(3, 1);
  EXPECT_EQ(first_difference(left, swarm.world(3, 2))->text(),
            "step 0: seed is 1, and 2 in the other");
  EXPECT_EQ(first_difference(left, swarm.world(4, 1))->field, "next_id");

  World with_bird = left;
  World with_pellet = left;
  (void)with_bird.spawn(swarm.keys.birds);
  (void)with_pellet.spawn(swarm.keys.pellets);
  EXPECT_EQ(first_difference(with_bird, with_pellet)->text(),
            "step 0: bird.rows is 4, and 3 in the other");
}

TEST(FirstDifference, RefusesWorldsOfDifferentLayouts) {
  const Swarm swarm;
  SchemaBuilder builder;
  (void)builder.add_table("stone", 1);
  const World stone(builder.build(), 1);
  EXPECT_THROW((void)first_difference(swarm.world(1), stone), std::logic_error);
}

TEST(FirstDifference, NamesTheEventThatDiffers) {
  const std::vector<Event> left{{.kind = Happening::shot, .who = PlayerId{3}},
                                {.kind = Happening::hit, .values = {0, 2.5f}}};
  std::vector<Event> right = left;
  EXPECT_EQ(first_difference(9, left, right), std::nullopt);
  right[1].values[1] = 3;
  const auto found = first_difference(9, left, right);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->text(), "step 9: events.values[1] of row 1 is 2.5, and 3 in the other");
  right.pop_back();
  EXPECT_EQ(first_difference(9, left, right)->text(),
            "step 9: events.count is 2, and 1 in the other");
}

/// Changes one random bit in a live row of a world: exactly that must be named, by the comparison
/// of worlds and by that of digests.
RC_GTEST_PROP(Digest, NamesTheFieldAndRowOfAnyChangedBit, ()) {
  static const Swarm swarm(40, 60);
  static const World start = [] {
    World world = swarm.world(30);
    fly(swarm, world, 25);
    return world;
  }();
  World left = start;
  const Schema& schema = left.schema();

  const auto index = *rc::gen::suchThat(
      rc::gen::inRange<std::uint32_t>(0, static_cast<std::uint32_t>(schema.columns().size())),
      [&](std::uint32_t i) {
        // an id that changes is another player, and marks are gone after a step
        const std::string& name = schema.column(i).name;
        return name != "id" && name != "leaving" && !start.column_bytes(i).empty();
      });
  const auto bytes = left.column_bytes(index);
  const auto at = *rc::gen::inRange<std::size_t>(0, bytes.size());
  const auto bit = *rc::gen::inRange(0, 8);
  const_cast<std::byte&>(bytes[at]) ^= static_cast<std::byte>(1 << bit);

  const ColumnInfo& column = schema.column(index);
  const auto row = static_cast<std::uint32_t>(at / column.stride);
  const auto by_world = first_difference(start, left);
  const auto by_digest = compare(schema, digest(start), digest(left));
  RC_ASSERT(by_world && by_digest);
  for (const auto& found : {*by_world, *by_digest}) {
    RC_ASSERT(found.step == start.step());
    RC_ASSERT(found.table == schema.table(column.table).name);
    RC_ASSERT(found.column == column.name);
    RC_ASSERT(found.row == row);
    RC_ASSERT(found.player == start.ids(column.table)[row]);
  }
  // a digest knows fields, a world also which scalar of a field
  RC_ASSERT(by_world->field.substr(0, by_digest->field.size()) == by_digest->field);
  RC_ASSERT(by_world->left != by_world->right);
}

TEST(Digest, SeesThatTwoRowsExchangedAValue) {
  const Swarm swarm;
  World left = swarm.world(9);
  const World right = left;
  std::swap(left.rows(swarm.keys.body)[2].position.y, left.rows(swarm.keys.body)[5].position.y);
  const auto found = compare(left.schema(), digest(left), digest(right));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->field, "position.y");
  EXPECT_EQ(found->row, 2u);
}

TEST(Digest, NamesARowOfTheTableWhoseFieldDiffers) {
  SchemaBuilder mixed;  // the first column that differs is of the second table
  const TableId a = mixed.add_table("a", 5);
  const TableId b = mixed.add_table("b", 5);
  const auto column_b = mixed.add_column<swarm::Vitals>(b, "vitals");
  const auto column_a = mixed.add_column<swarm::Vitals>(a, "vitals");
  World one(mixed.build(), 1);
  for (int i = 0; i < 2; ++i)
    ASSERT_TRUE(one.spawn(a) && one.spawn(b));
  World two = one;
  two.rows(column_a)[0].hits = 1;
  two.rows(column_b)[1].hits = 1;
  const auto found = compare(one.schema(), digest(one), digest(two));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->table, "b");
  EXPECT_EQ(found->row, 1u);
  EXPECT_EQ(found->player, PlayerId{4});
}

TEST(Digest, SeesTheHeader) {
  const Swarm swarm;
  const auto found =
      compare(swarm.simulation->schema(), digest(swarm.world(3, 1)), digest(swarm.world(3, 2)));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->text(), "step 0: header differs");
}

TEST(Digest, SeesAMissingRow) {
  const Swarm swarm;
  const World more = swarm.world(3);
  World less = more;
  less.remove(swarm.keys.birds, 1);
  less.compact();
  const auto found = compare(more.schema(), digest(more), digest(less));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->table, "bird");
  EXPECT_EQ(found->column, "id");
  EXPECT_EQ(found->row, 1u);
  EXPECT_EQ(found->player, PlayerId{2});
}

TEST(Digest, OfAnotherLayoutIsReportedNotRead) {
  const Swarm swarm;
  const Digest left = digest(swarm.world(3));
  Digest right = left;
  right.fields.pop_back();
  EXPECT_EQ(compare(swarm.simulation->schema(), left, right)->field, "number of fields");
}

}  // namespace
}  // namespace eyrie::sim
