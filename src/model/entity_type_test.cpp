// SPDX-License-Identifier: MIT
#include "model/entity_type.hpp"

#include <gtest/gtest.h>

namespace eyrie::model {
namespace {

TEST(EntityType, IsTwoToSevenNumbersBetweenDots) {
  EXPECT_EQ(entity_type_of("1.2.225.1.5.3"), (EntityType{1, 2, 225, 1, 5, 3, 0}));
  EXPECT_EQ(entity_type_of("2.1.65535.255.3.4.7"), (EntityType{2, 1, 65535, 255, 3, 4, 7}));
  EXPECT_EQ(entity_type_of("1.2"), (EntityType{.kind = 1, .domain = 2}));
}

TEST(EntityType, IsNoOtherText) {
  for (const char* text : {"", "1", "1.", ".1", "1.2.", "1..2", "1.2.3.4.5.6.7.8", "1.256",
                           "1.2.65536", "1.-2", "1.2 ", "1,2", "0x1.2", "F-15"})
    EXPECT_FALSE(entity_type_of(text)) << text;
}

TEST(Emitter, IsANumber) {
  EXPECT_EQ(emitter_of("1800"), 1800);
  EXPECT_EQ(emitter_of("0"), 0);
  for (const char* text : {"", "65536", "-1", "1800 ", "APG-63"})
    EXPECT_FALSE(emitter_of(text)) << text;
}

}  // namespace
}  // namespace eyrie::model
