// SPDX-License-Identifier: MIT
#pragma once
/// \file  From the worlds before and after a step to the decision that an agent made in it.
#include <optional>
#include <span>

#include "debrief/decision.hpp"
#include "driver/driver_system.hpp"
#include "pilot/pilot_system.hpp"
#include "scenario/scenario.hpp"

namespace eyrie::debrief {

/// Looks at decisions of one scenario again.
class Explainer {
 public:
  explicit Explainer(const scenario::Scenario& scenario) : Explainer(scenario, scenario) {}
  /// Of what `asked`, the scenario with other trees, would have decided there.
  Explainer(const scenario::Scenario& scenario, const scenario::Scenario& asked)
      : scenario_(scenario), asked_(asked) {}

  /// Nothing if that agent had no decision due in the step, has no tree, or left the run in it.
  [[nodiscard]] std::optional<Decision> explain(const sim::World& before, const sim::World& after,
                                                PlayerId who,
                                                std::span<const sim::Order> orders) const;

  /// Who led after the last decision, as the agent's row keeps it; kNone for nobody.
  [[nodiscard]] ubf::NodeIndex leader(const sim::World& world, PlayerId who) const;
  /// Its label, such as "pursue"; "nobody".
  [[nodiscard]] std::string leader_label(const sim::World& world, PlayerId who) const;

 private:
  const scenario::Scenario& scenario_;
  const scenario::Scenario& asked_;
};

/// A system of a simulation by its type, or null.
template <class System>
[[nodiscard]] const System* find_system(const sim::Simulation& simulation) {
  for (const auto& system : simulation.systems())
    if (const auto* found = dynamic_cast<const System*>(system.get()))
      return found;
  return nullptr;
}

}  // namespace eyrie::debrief
