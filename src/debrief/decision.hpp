// SPDX-License-Identifier: MIT
#pragma once
/// \file  What a decision (team/decision.hpp) says in words, and who won in it because of what.
#include <nlohmann/json_fwd.hpp>

#include "driver/driver_system.hpp"
#include "pilot/pilot_system.hpp"
#include "scenario/roster.hpp"
#include "scenario/scenario.hpp"
#include "team/explain.hpp"

namespace eyrie::debrief {

using team::Answer, team::Changed, team::Decision, team::Perceived, team::Rival, team::Value;
using team::parting, team::Won;

/// From the worlds before and after a step to the decision that an agent made in it. Nothing if it
/// had no decision due in the step, has no tree, or left the run in it.
[[nodiscard]] std::optional<Decision> explain(const scenario::Scenario& scenario,
                                              const sim::World& before, const sim::World& after,
                                              PlayerId who, std::span<const sim::Order> orders);

/// Puts names for the numbers in the text of a value: "#3 (bogey1)", "AIM-120 at #3 (bogey1)". The
/// decision says who is #3; those that explain() gives have them.
void put_names(std::string& text, const Decision& decision, const scenario::Scenario& scenario);

/// A system of a simulation by its type, or null.
template <class System>
[[nodiscard]] const System* find_system(const sim::Simulation& simulation) {
  for (const auto& system : simulation.systems())
    if (const auto* found = dynamic_cast<const System*>(system.get()))
      return found;
  return nullptr;
}

/// "voted 40 against 10", or how else a field was won.
[[nodiscard]] std::string reason(const Won& won);
/// What a node has to say of itself: "failed: no target", "not asked", "running, 40".
[[nodiscard]] std::string words(const Answer& answer);
/// Why somebody else leads now: what became of who led before (an index into now.nodes).
[[nodiscard]] std::string why_not(const Decision& now, ubf::NodeIndex before);

// Decisions for the terminal and for tools, with texts of files escaped as each of them needs it.

/// The whole decision: what was seen, every node's answer, who won each field and against whom.
[[nodiscard]] std::string decision_text(const Decision& decision, const scenario::Roster& roster);
/// One line: time, who leads, vote, the action.
[[nodiscard]] std::string decision_line(const Decision& decision);
/// An object, also for pages; docs/howto/explain-a-decision.md has the keys.
[[nodiscard]] nlohmann::ordered_json decision_json(const Decision& decision,
                                                   const scenario::Roster& roster);

/// The columns of decision_csv().
inline constexpr std::string_view kDecisionCsv =
    "time_s,step,player,tree,node,status,vote,field,value,unit,won\n";
/// A row per field that a node proposed (or one without a field), of all nodes that were asked.
/// `value` is a number in SI where it is one, nothing where there is none, and else a text in
/// quotes.
[[nodiscard]] std::string decision_csv(const Decision& decision, const scenario::Roster& roster);

/// Somebody else leads than at the decision before.
struct Change {
  Decision now;
  std::string from = "nobody", to = "nobody";  ///< labels
  std::string why = {};
  std::vector<std::string> events = {};  ///< for which it was looked for, as the story tells them
};
[[nodiscard]] std::string change_text(const Change& change);
[[nodiscard]] nlohmann::ordered_json change_json(const Change& change,
                                                 const scenario::Roster& roster);

/// "bvr/pursue": with the label above.
[[nodiscard]] std::string branch_of(const Decision& decision, ubf::NodeIndex node);
/// "pursue", or "nobody".
[[nodiscard]] std::string label_of(const Decision& decision, ubf::NodeIndex node);

}  // namespace eyrie::debrief
