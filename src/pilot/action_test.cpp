// SPDX-License-Identifier: MIT
#include "pilot/action.hpp"

#include <gtest/gtest.h>

#include "ubf/trace.hpp"

namespace eyrie::pilot {
namespace {

TEST(Action, ListsEveryFieldInItsTraits) {
  static_assert(ubf::fields_cover_action<Action>());
  Action action;
  EXPECT_TRUE(ubf::is_empty(action));
  action.call = Call::land;  // the last one
  EXPECT_FALSE(ubf::is_empty(action));
}

TEST(Action, SurvivesBeingPackedIntoASlab) {
  Action action;
  action.heading = 1.25;
  action.mode = model::AutopilotMode::follow;
  action.follow = Follow{{1, 2, 3}, {4, 5, 6}, 7, {8, 9, 10}};
  action.release = Release{TrackId{4}, 2};
  action.trigger = false;
  Action back;
  ubf::PackedAction<Action>(action).unpack(back);
  EXPECT_TRUE(ubf::equal(action, back));
  EXPECT_FALSE(back.altitude.has_value());
}

TEST(Action, ReadsLikeAnOrder) {
  Action action;
  action.heading = radians(90);
  action.mode = model::AutopilotMode::follow;
  action.follow = Follow{.position = {}, .velocity = {}, .time = 0, .offset = {-305, -1829, 152}};
  action.target = TrackId{7};
  action.release = Release{TrackId{7}, 1};
  action.call = Call::defend_near;
  EXPECT_EQ(ubf::to_text(action),
            "heading 090°, mode follow, follow 1001 ft behind, 6001 ft left, 499 ft below, "
            "target #7, release store 1 at #7, call defend_near");
  EXPECT_EQ(to_text(Follow{}), "in its place");
}

}  // namespace
}  // namespace eyrie::pilot
