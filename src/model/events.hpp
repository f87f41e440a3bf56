// SPDX-License-Identifier: MIT
#pragma once
/// \file  The events of the air war, in the field's words.
#include <cstdint>

namespace eyrie::model {

/// `who` does it, `whom` it is done to. What the values of each kind mean is said here once.
enum class EventKind : std::uint16_t {
  none = 0,
  contact,         ///< who got a new track of whom (truth); values: range m, source bits
  track_lost,      ///< who lost its track of whom; values: age s
  identified,      ///< who identified whom; values: identity, range m
  rwr_warning,     ///< who is warned of whom's radar; values: kind, bearing rad
  missile_warning, ///< who is warned of missile whom; values: bearing rad
  release,         ///< who released a store at whom; values: store index, range m
  launch,          ///< missile who was born, whom = target; detail = shooter; values: range m, store index
  seeker_active,   ///< missile who's seeker went active
  seeker_acquired, ///< missile who's seeker sees whom; values: range m
  gun_burst,       ///< who fired the gun at whom; values: rounds, range m
  detonation,      ///< missile who's fuze fired near whom; values: miss distance m, pk, draw
  timeout,         ///< missile who ended without a fuze; values: reason (see weapon), time of flight s
  hit,             ///< who (shooter) hit whom; values: damage, miss distance m; detail = weapon player or 0
  kill,            ///< who (shooter) killed whom; detail = weapon player or 0
  crash,           ///< who hit the ground
  fuel_out,        ///< who's tanks are empty
  bingo,           ///< who reached bingo fuel
  winchester,      ///< who has no weapon left
  home,            ///< who is home and leaves the run
  phase,           ///< who's sequencer changed; values: from, to, sequencer node
  lead_change,     ///< who now leads its flight, whom led before; values: flight
  commit,          ///< who commits on whom
  defend,          ///< who breaks against missile whom or an unseen one; values: phase 1 or 2
  in_charge,       ///< who's winning behavior changed; values: node index, vote
  order,           ///< an order from outside was carried out on who; values: order kind
  count
};

}  // namespace eyrie::model
