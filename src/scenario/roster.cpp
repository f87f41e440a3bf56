// SPDX-License-Identifier: MIT
#include "scenario/roster.hpp"

#include <algorithm>

namespace eyrie::scenario {

void share_out(const std::vector<std::string>& ours, const Value& list, Roster& roster,
               Diagnostics& diagnostics) {
  if (ours.empty())
    return;
  const std::vector<std::string> names = roster.names();
  for (std::size_t i = 0; i < ours.size(); ++i)
    if (std::ranges::find(names, ours[i]) == names.end())
      diagnostics.error(i < list.items.size() ? list.items[i].where : list.where,
                        "there is no side, flight or player {}{}", quote(ours[i]),
                        did_you_mean(ours[i], names));
  const auto named = [&](std::string_view name) {
    return std::ranges::find(ours, name) != ours.end();
  };
  for (auto& player : roster.players) {
    player.remote = !named(player.name) && !named(roster.flights[player.flight].name) &&
                    !named(side_name(player.side));
    if (player.remote && player.fleet != 0)
      diagnostics.error(list.where,
                        "{} is no aircraft, and only these can be flown by another "
                        "program: name it, or its side, among ours",
                        player.name);
  }
}

}  // namespace eyrie::scenario
