// SPDX-License-Identifier: MIT
#pragma once
/// \file  Decisions of a recorded run that somebody asks for: at a time, around an event, where
/// somebody else took the lead, or those on which the run turned.
#include <set>

#include "debrief/decision.hpp"
#include "debrief/recorded.hpp"
#include "record/story.hpp"

namespace eyrie::debrief {

/// Which decisions of one player are wanted.
struct Wanted {
  double from = 0, to = 1e9;  ///< s
  bool once = false;          ///< only the first decision in that time
  bool changes = false;       ///< where somebody else leads than before
  /// Those that events come of in which a word begins so; "": any decision.
  std::string event = {};
};

struct Found {
  std::uint64_t count = 0;
  std::set<std::string> events;  ///< the names of those that the player had
  double until = 0;              ///< s, when the player was last there
};

/// Flies the run again and hands on each, one by one: of a decision that was not asked for as a
/// change `now` alone is given. Each node says where it stands in the document. `stop` is asked in
/// every step and ends the work.
[[nodiscard]] Found look(
    const Recorded& recorded, PlayerId who, const Wanted& wanted,
    const std::function<void(const Change&)>& use,
    const std::function<bool()>& stop = [] { return false; });

/// What was found as it is told: who took over, a decision's line, or, at a time or an event, the
/// decision whole below the events that it was looked for by.
[[nodiscard]] std::string found_text(const Change& found, const Wanted& wanted,
                                     const scenario::Roster& roster);
[[nodiscard]] nlohmann::ordered_json found_json(const Change& found, const Wanted& wanted,
                                                const scenario::Roster& roster);

/// Why nothing was found: "eagle1 made no decision in that time".
[[nodiscard]] std::string nothing_text(const std::string& player, const Wanted& wanted,
                                       const Found& found);

/// What a run turned on: shots, losses, new leads and phases, and the decisions they come of.
struct Moment {
  record::StoryLine line;
  std::optional<Decision> decision = {};
};
[[nodiscard]] std::vector<Moment> key_moments(
    const Recorded& recorded, const std::function<bool()>& stop = [] { return false; });
[[nodiscard]] std::string moments_text(std::span<const Moment> moments,
                                       const scenario::Roster& roster);
[[nodiscard]] std::string moments_json(std::span<const Moment> moments,
                                       const scenario::Roster& roster);

}  // namespace eyrie::debrief
