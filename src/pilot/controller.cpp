// SPDX-License-Identifier: MIT
#include "pilot/controller.hpp"

#include <algorithm>

namespace eyrie::pilot {
namespace {

void fly(const Action& action, model::Command& command) {
  command.mode = action.mode.value_or(action.heading ? model::AutopilotMode::hold : command.mode);
  if (action.heading)
    command.heading = wrap_pi(*action.heading);
  if (action.altitude)
    command.altitude = *action.altitude;
  if (action.speed)
    command.speed = *action.speed;
  if (action.load_factor)
    command.load_factor = *action.load_factor;
  if (command.mode != model::AutopilotMode::follow)
    return;
  if (action.follow) {
    command.reference_position = action.follow->position;
    command.reference_velocity = action.follow->velocity;
    command.reference_time = action.follow->time;
    command.offset = action.follow->offset;
  } else if (action.mode) {
    command.mode = model::AutopilotMode::hold;
  }
}

}  // namespace

double time_of_flight(const State& state, const Seen& target) {
  // an average over the flights of docs/models/missile.md: 2.3 to 3 times the speed of sound
  constexpr double kMeanSpeed = 750;
  const double own = target.range > 0 ? dot(target.ned, state.velocity_ned) / target.range : 0;
  return target.range / (kMeanSpeed + std::max(0.0, target.closing - own)) + 3;
}

void execute(const Action& action, const State& state, model::Command& command,
             model::Request& request, Agent& agent) {
  fly(action, command);

  agent.target = action.target.value_or(TrackId{});
  request = {};
  request.target = agent.target;
  request.trigger = action.trigger.value_or(false) ? 1 : 0;
  request.radar_off = action.radar.value_or(true) ? 0 : 1;
  if (action.release) {
    request.shoot_at = action.release->track;
    request.store = static_cast<std::uint8_t>(action.release->store + 1);
    for (const Seen& seen : state.tracks_seen()) {
      if (seen.id() != action.release->track)
        continue;
      const bool again = agent.shot_track == seen.id() && state.time < agent.shot_until;
      agent.shots_at_track = static_cast<std::uint8_t>(again ? agent.shots_at_track + 1 : 1);
      agent.shots = static_cast<std::uint8_t>(std::min(agent.shots + 1, 255));
      agent.shot_track = seen.id();
      agent.shot_time = state.time;
      agent.shot_until = state.time + time_of_flight(state, seen);
    }
  }
}

}  // namespace eyrie::pilot
