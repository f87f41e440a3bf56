// SPDX-License-Identifier: MIT
#include "record/story.hpp"

#include <gtest/gtest.h>

#include "support/recorded.hpp"

namespace eyrie::record {
namespace {

TEST(Story, TellsHowNearAMissileBurstAndBesideWhom) {
  const debrief::Recorded recorded = test::recorded_flight("sweep", 1);
  const auto& roster = recorded.scenario->roster;
  const PlayerId missile{100}, shooter = *roster.find("bogey1"), target = *roster.find("eagle1"),
                               other = *roster.find("eagle2");
  const sim::Event launched{.kind = model::EventKind::launch,
                            .detail = shooter.value,
                            .who = missile,
                            .whom = target,
                            .values = {15000}};
  const sim::Event burst{.kind = model::EventKind::detonation,
                         .who = missile,
                         .whom = other,
                         .values = {4.9F, 0.656F, 0.7F}};
  std::string told;
  Story story(*recorded.scenario,
              [&](const StoryLine& line) { told = line.who + ": " + line.text; });
  const debrief::Reflight flight(recorded);
  for (const sim::Event& event : {launched, burst})
    story.observe(flight.after(), {}, std::span(&event, 1));
  EXPECT_EQ(told.substr(told.find(" bursts")), " bursts 16 ft from eagle2: no kill, Pk 0.66");
  EXPECT_TRUE(told.starts_with("bogey1: ")) << told;
}

}  // namespace
}  // namespace eyrie::record
