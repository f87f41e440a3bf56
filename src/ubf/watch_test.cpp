// SPDX-License-Identifier: MIT
#include "ubf/watch.hpp"

#include <gtest/gtest.h>

namespace eyrie::ubf {
namespace {

TEST(TransitionLog, KeepsTransitionsInOrderUntilItIsCleared) {
  TransitionLog log;
  log.add({1, kNone, 0});
  log.add({1, 0, 2});
  ASSERT_EQ(log.entries().size(), 2u);
  EXPECT_EQ(log.entries()[1], (Transition{1, 0, 2}));
  log.clear();
  EXPECT_TRUE(log.entries().empty());
}

TEST(TransitionLog, CountsWhatDoesNotFit) {
  TransitionLog log;
  for (std::size_t i = 0; i < TransitionLog::kCapacity + 3; ++i)
    log.add({static_cast<NodeIndex>(i), 0, 1});
  EXPECT_EQ(log.entries().size(), TransitionLog::kCapacity);
  EXPECT_EQ(log.entries().back().node, TransitionLog::kCapacity - 1);
  EXPECT_EQ(log.dropped(), 3u);
  log.clear();
  EXPECT_EQ(log.dropped(), 0u);
}

}  // namespace
}  // namespace eyrie::ubf
