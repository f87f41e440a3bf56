// SPDX-License-Identifier: MIT
#pragma once
/// \file  What a scenario changes of what it extends and includes, by path:
///
///   insert:
///     trees.wall.winner_takes_all: {greet: {vote: 15}}       at the end of that list
///     before trees.fight.winner_takes_all.jink: last_ditch   or after: where the order counts
///     blue.flights.eagle.bingo: 2500 kg                      under a key that is not there yet
///   replace:
///     trees.press.per_field.release_weapon.zone: 1.8
///     trees.wall.winner_takes_all.navigate: egress           the item that has that name
///   remove: [red.flights.bogey.players.bogey2]
///
/// Every path means the document as it is without these changes, so their order does not count.
#include "core/value.hpp"

namespace eyrie::scenario {

/// Something that was taken out, for mistakes that follow from it.
struct Removed {
  std::string name;                 ///< its key, or what it is called in its list
  Location where;                   ///< of the path that took it out
  Location from;                    ///< where the map or list stands
  std::vector<std::string> held{};  ///< the keys of what it was
};

/// What is carried out before --set and is in no document afterwards.
[[nodiscard]] bool is_done_before_sets(std::string_view key);

/// Makes the changes that `own`, the file itself, asks for; `document` holds that file on top of
/// what it extends and includes. Refuses a path that leads nowhere, a change of what another one
/// replaces or removes, and of what stands in the file itself.
void make_changes(Value& document, const Value& own, std::vector<Removed>& removed,
                  Diagnostics& diagnostics);

/// The mistakes, those that follow from a removal where that is asked for.
[[nodiscard]] Diagnostics blame_removals(const Diagnostics& found,
                                         const std::vector<Removed>& removed);

}  // namespace eyrie::scenario
