// SPDX-License-Identifier: MIT
#include "model/events.hpp"

#include <gtest/gtest.h>

#include "sim/schema.hpp"

namespace eyrie::model {
namespace {

TEST(Events, AllHaveANameInTheSchema) {
  sim::SchemaBuilder builder;
  builder.add_table("anybody", 1);
  describe_events(builder);
  const auto schema = builder.build();
  for (std::uint16_t kind = 1; kind < static_cast<std::uint16_t>(EventKind::count); ++kind) {
    const sim::EventInfo* info = schema->event(sim::EventKind(kind));
    ASSERT_NE(info, nullptr) << kind;
    EXPECT_EQ(info->name, event_name(static_cast<EventKind>(kind)));
  }
  EXPECT_EQ(schema->event(EventKind::launch)->name, "launch");
  ASSERT_EQ(schema->event(EventKind::gun_burst)->values.size(), 3u);
  EXPECT_EQ(schema->event(EventKind::gun_burst)->values[1].unit, "m");
  EXPECT_TRUE(schema->event(EventKind::kill)->values.empty());
}

TEST(Events, HaveNoNameOutsideTheList) {
  EXPECT_EQ(event_name(EventKind::none), "");
  EXPECT_EQ(event_name(EventKind::count), "");
  EXPECT_EQ(event_name(static_cast<EventKind>(9999)), "");
}

}  // namespace
}  // namespace eyrie::model
