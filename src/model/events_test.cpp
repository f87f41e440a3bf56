// SPDX-License-Identifier: MIT
#include "model/events.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace eyrie::model {
namespace {

TEST(Events, AllHaveANameOfTheirOwn) {
  std::set<std::string_view> names;
  for (std::uint16_t kind = 1; kind < static_cast<std::uint16_t>(EventKind::count); ++kind)
    EXPECT_TRUE(names.insert(event_name(static_cast<EventKind>(kind))).second) << kind;
  EXPECT_FALSE(names.contains(""));
  EXPECT_EQ(event_name(EventKind::launch), "launch");
}

TEST(Events, NameTheirValues) {
  ASSERT_EQ(event_values(EventKind::gun_burst).size(), 3u);
  EXPECT_EQ(event_values(EventKind::gun_burst)[1].name, "range");
  EXPECT_TRUE(event_values(EventKind::kill).empty());
}

TEST(Events, HaveNoNameOutsideTheList) {
  for (const EventKind kind : {EventKind::none, EventKind::count, static_cast<EventKind>(9999)}) {
    EXPECT_EQ(event_name(kind), "");
    EXPECT_TRUE(event_values(kind).empty());
  }
}

}  // namespace
}  // namespace eyrie::model
