// SPDX-License-Identifier: MIT
#include "pilot/behavior/navigate.hpp"

namespace eyrie::pilot {

Status Navigate::tick(const Tick& t, Proposal& out) const {
  const Way way = go(t, out);
  if (way.status == Status::failure)
    return way.status;
  out.action.altitude = way.wanted.altitude;
  out.action.load_factor = load_factor_;
  out.action.mode = model::AutopilotMode::route;
  out.action.route = route_;
  out.action.target = TrackId{};
  return way.status;
}

}  // namespace eyrie::pilot
