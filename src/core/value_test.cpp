// SPDX-License-Identifier: MIT
#include "core/value.hpp"

#include <gtest/gtest.h>

namespace eyrie {
namespace {

Value sample() {
  return Value::map({entry("vote", "3", {"a.yaml", 2, 7}),
                     entry("children", Value::list({Value::scalar("x"), Value::null()})),
                     entry("near_vote", "4", {"a.yaml", 4, 7})},
                    {"a.yaml", 1, 1});
}

TEST(Value, FindsAnEntryByItsKey) {
  const Value value = sample();
  ASSERT_TRUE(value.is_map());
  EXPECT_EQ(value.entries.size(), 3u);
  ASSERT_NE(value.find("vote"), nullptr);
  EXPECT_EQ(value.find("vote")->text, "3");
  EXPECT_EQ(value.find_entry("vote")->where, (Location{"a.yaml", 2, 7}));
  EXPECT_EQ(value.find("votes"), nullptr);
  EXPECT_EQ(value.find("children")->items[1].kind, Value::Kind::null);
}

TEST(Value, HasNoEntriesUnlessItIsAMap) {
  EXPECT_EQ(Value::scalar("vote").find("vote"), nullptr);
  EXPECT_EQ(Value::list({}).find_entry(""), nullptr);
}

TEST(Value, IsAValueThatCopiesDeeply) {
  Value copy = sample();
  {
    const Value original = sample();
    copy = original;
  }
  copy.entries[1].value.items[0].text = "changed";
  EXPECT_EQ(sample().entries[1].value.items[0].text, "x");
  EXPECT_EQ(copy.entries[1].value.items[0].text, "changed");
}

TEST(Value, SaysWhatStandsThere) {
  EXPECT_EQ(Value::null().shown(), "nothing");
  EXPECT_EQ(Value::scalar("2 nmi").shown(), "'2 nmi'");
  EXPECT_EQ(Value::list({}).shown(), "a list");
  EXPECT_EQ(Value::map({}).shown(), "a map");
}

}  // namespace
}  // namespace eyrie
