// SPDX-License-Identifier: MIT
#include "debrief/explainer.hpp"

#include <fmt/format.h>

namespace eyrie::debrief {
namespace {

/// "#3 (bogey1)": as the agent knows it, and who it really was.
std::string debrief_name(const Perceived& one, const scenario::Roster& roster) {
  if (!one.truth)
    return fmt::format("#{}", one.number);
  return roster.find(one.truth) ? fmt::format("#{} ({})", one.number, roster.name(one.truth))
                                : fmt::format("#{} (missile {})", one.number, one.truth.value);
}

}  // namespace

std::optional<Decision> Explainer::explain(const sim::World& before, const sim::World& after,
                                           PlayerId who, std::span<const sim::Order> orders) const {
  std::optional<Decision> decision;
  if (const auto found = scenario_.find(before, who))
    found->fleet.agents->look_again(before, after, who, orders, [&](const team::AnyMoment& m) {
      decision = m.decision(*asked_.fleet_of(who).agents);
      for (Perceived& one : decision->perceived)
        one.name = debrief_name(one, scenario_.roster);
    });
  return decision;
}

ubf::NodeIndex Explainer::leader(const sim::World& world, PlayerId who) const {
  const auto found = scenario_.find(world, who);
  return found ? found->fleet.agents->last_decision(world, found->row).node : ubf::kNone;
}

std::string Explainer::leader_label(const sim::World& world, PlayerId who) const {
  const auto found = scenario_.find(world, who);
  return found ? found->fleet.leader(world, found->row) : "nobody";
}

}  // namespace eyrie::debrief
