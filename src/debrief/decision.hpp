// SPDX-License-Identifier: MIT
#pragma once
/// \file  What a decision (team/decision.hpp) says in words.
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "driver/driver_system.hpp"
#include "pilot/pilot_system.hpp"
#include "scenario/scenario.hpp"
#include "team/explain.hpp"

namespace eyrie::debrief {

using team::Answer, team::Changed, team::Decision, team::Perceived, team::Rival, team::Value;
using team::parting, team::Won;

/// "voted 40 against 10", or how else a field was won.
[[nodiscard]] std::string reason(const Won& won);
/// What a node has to say of itself: "failed: no target", "not asked", "running, 40".
[[nodiscard]] std::string words(const Answer& answer);
/// Why somebody else leads now: what became of who led before (an index into now.nodes).
[[nodiscard]] std::string why_not(const Decision& now, ubf::NodeIndex before);

// From the worlds before and after a step to the decision that an agent made in it.

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
