// SPDX-License-Identifier: MIT
#pragma once
/// \file  Decisions for the terminal and for tools, with texts of files and plug-ins escaped as
/// each of them needs it.
#include <span>
#include <string>

#include "debrief/decision.hpp"
#include "scenario/roster.hpp"

namespace eyrie::debrief {

/// The whole decision: what was seen, every node's answer, who won each field and against whom.
[[nodiscard]] std::string decision_text(const Decision& decision, const scenario::Roster& roster);
/// One line: time, who leads, vote, the action.
[[nodiscard]] std::string decision_line(const Decision& decision);
/// One JSON object per decision, in an array; docs/howto/explain-a-decision.md has the keys.
[[nodiscard]] std::string decisions_json(std::span<const Decision> decisions,
                                         const scenario::Roster& roster);

/// A row per field that a node proposed (or one without a field), of all nodes that were asked:
/// time_s,step,player,tree,node,status,vote,field,value,unit,won. `value` is a number in SI where
/// it is one, nothing where there is none, and else a text in quotes.
[[nodiscard]] std::string decisions_csv(std::span<const Decision> decisions,
                                        const scenario::Roster& roster);

/// Somebody else leads than at the decision before.
struct Change {
  Decision now;
  std::string from = "nobody", to = "nobody";  ///< labels
  std::string why = {};
};
[[nodiscard]] std::string change_text(const Change& change);
[[nodiscard]] std::string changes_json(std::span<const Change> changes,
                                       const scenario::Roster& roster);

/// "bvr/pursue": with the label above.
[[nodiscard]] std::string branch_of(const Decision& decision, ubf::NodeIndex node);
/// "pursue", or "nobody".
[[nodiscard]] std::string label_of(const Decision& decision, ubf::NodeIndex node);

}  // namespace eyrie::debrief
