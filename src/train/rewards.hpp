// SPDX-License-Identifier: MIT
#pragma once
/// \file  What one decision of a learner was worth.
#include "scenario/scenario.hpp"
#include "sim/event.hpp"
#include "train/task.hpp"

namespace eyrie::train {

/// Of the last decision of one learner.
struct Merit {
  bool alive = true;        ///< after it
  bool home = false;        ///< not alive because it came home
  std::uint32_t kills = 0;  ///< of enemies
  std::uint32_t hits = 0, hits_by = 0, launches = 0;
  float rounds = 0;
};

/// Notes in `merit` what an event means for a player.
void note(const sim::Event& event, PlayerId who, const scenario::Roster& roster, Merit& merit);

/// The sum of the terms. `over`: the episode is. `seconds`: since the decision before.
[[nodiscard]] double reward(std::span<const Reward> terms, const scenario::Scenario& scenario,
                            const sim::World& world, PlayerId who, const Merit& merit, bool over,
                            double seconds);

}  // namespace eyrie::train
