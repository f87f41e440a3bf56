// SPDX-License-Identifier: MIT
#pragma once
/// \file  Who won in a decision, and because of what, in words.
#include "team/explain.hpp"

namespace eyrie::debrief {

using team::Answer, team::Decision, team::Rival, team::Won;

/// "voted 40 against 10", or how else a field was won.
[[nodiscard]] std::string reason(const Won& won);
/// What a node has to say of itself: "failed: no target", "not asked", "running, 40".
[[nodiscard]] std::string words(const Answer& answer);
/// Why somebody else leads now: what became of who led before (an index into now.nodes).
[[nodiscard]] std::string why_not(const Decision& now, ubf::NodeIndex before);

}  // namespace eyrie::debrief
