// SPDX-License-Identifier: MIT
/// \file  Every type of node that comes with the library is asked in a flight of scenarios/.
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "debrief/decision.hpp"
#include "pilot/catalog.hpp"
#include "support/recorded.hpp"

namespace eyrie::test {
namespace {

/// The types of nodes that were asked in the first minutes of a scenario, by every pilot.
std::set<std::string> asked_in(const std::string& name) {
  const debrief::Recorded run = recorded_flight(name, 280, {});
  debrief::Reflight flight(run);
  std::set<std::string> asked;
  while (flight.step()) {
    if (flight.before().step() % 50 >= 5)  // a tenth of all decisions
      continue;
    for (std::size_t i = 0; i < run.scenario->roster.players.size(); ++i)
      if (const auto decision =
              debrief::explain(*run.scenario, flight.before(), flight.after(),
                               PlayerId{static_cast<std::uint32_t>(i + 1)}, flight.orders()))
        for (const debrief::Answer& node : decision->nodes)
          if (node.asked)
            asked.insert(node.type);
  }
  return asked;
}

TEST(Families, EveryStandardNodeFlies) {
  std::set<std::string> asked;
  for (const char* name : {"blending", "commitment", "drill", "layers", "limits", "sweep"})
    asked.merge(asked_in(name));
  const auto registry = pilot::make_registry();
  for (const ubf::NodeInfo& node : registry.catalog())
    if (node.name == "learned_vote")
      continue;  // needs a network that somebody has trained
    else if (node.kind == ubf::Kind::arbiter || node.kind == ubf::Kind::control ||
             node.kind == ubf::Kind::decorator) {
      EXPECT_TRUE(asked.contains(node.name)) << node.name;
    }
}

TEST(Families, AVoteThatFollowsTheStateIsExplainedByWhatItFollowed) {
  const debrief::Recorded run = recorded_flight("commitment", 120, {});
  debrief::Reflight flight(run);
  const PlayerId bogey{3};
  std::set<float> votes;
  while (flight.step()) {
    const auto decision =
        debrief::explain(*run.scenario, flight.before(), flight.after(), bogey, {});
    if (!decision)
      continue;
    for (const debrief::Answer& node : decision->nodes)
      if (node.type == "pursue" && node.status != ubf::Status::failure && node.asked) {
        const auto range = std::find_if(decision->state.begin(), decision->state.end(),
                                        [](const auto& v) { return v.name == "range"; });
        const double score = std::clamp((*range->number - 70 * 1852.0) / ((20 - 70) * 1852.0), 0.0,
                                        1.0);  // as in the file
        EXPECT_NEAR(node.vote, 50 * score, 1e-3);
        EXPECT_EQ(node.why, fmt::format("range {:.2g}", static_cast<float>(score)));
        votes.insert(node.vote);
      }
  }
  EXPECT_GT(votes.size(), 100U) << "it follows";
}

}  // namespace
}  // namespace eyrie::test
