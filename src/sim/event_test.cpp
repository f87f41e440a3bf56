// SPDX-License-Identifier: MIT
#include "sim/event.hpp"

#include <gtest/gtest.h>

#include "sim/order.hpp"
#include "sim/swarm_rows_test.hpp"
#include "support/no_allocation.hpp"

namespace eyrie::sim {
namespace {

TEST(Outbox, AllocatesNothingWithinItsRoom) {
  Outbox outbox(8);
  NoAllocation guard;
  for (std::uint32_t i = 0; i < 8; ++i)
    outbox.emit({.detail = i});
  EXPECT_EQ(outbox.growths(), 0u);
}

TEST(Outbox, NeverDropsAnEventAndCountsWhenItHadToGrow) {
  Outbox outbox(4);
  for (std::uint32_t i = 0; i < 1000; ++i)
    outbox.emit({.detail = i});
  ASSERT_EQ(outbox.events().size(), 1000u);
  for (std::uint32_t i = 0; i < 1000; ++i)
    EXPECT_EQ(outbox.events()[i].detail, i);
  const std::uint64_t growths = outbox.growths();
  EXPECT_GT(growths, 0u);

  outbox.clear();
  NoAllocation guard;
  for (std::uint32_t i = 0; i < 1000; ++i)
    outbox.emit({.detail = i});
  EXPECT_EQ(outbox.growths(), growths) << "room that was needed once is kept";
}

TEST(Kind, ConvertsFromAndToTheEnumerationOfADomain) {
  const Event event{.kind = swarm::Happening::kill};
  EXPECT_TRUE(event.kind == swarm::Happening::kill);
  EXPECT_FALSE(event.kind == swarm::Happening::hit);
  EXPECT_EQ(event.kind.as<swarm::Happening>(), swarm::Happening::kill);
  EXPECT_TRUE(event.kind);
  EXPECT_FALSE(Event{}.kind);
}

TEST(Order, CarriesItsPayloadUnchanged) {
  const swarm::Turn turn{.velocity = {1, -2.5, 1e300}};
  const Order order = order_for(7, PlayerId{3}, swarm::Wish::turn, turn);
  EXPECT_EQ(order.step, 7u);
  EXPECT_EQ(order.player, PlayerId{3});
  EXPECT_TRUE(order.kind == swarm::Wish::turn);
  EXPECT_EQ(order.as<swarm::Turn>().velocity, turn.velocity);
}

}  // namespace
}  // namespace eyrie::sim
