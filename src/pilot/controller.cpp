// SPDX-License-Identifier: MIT
#include "pilot/controller.hpp"

#include "model/weapon/stores.hpp"
#include "pilot/danger.hpp"
#include "pilot/gunnery.hpp"

namespace eyrie::pilot {
namespace {

using model::AutopilotMode;

void fly(const Action& action, model::Command& command) {
  if (action.mode)
    command.mode = *action.mode;
  else if (action.heading || action.altitude)
    command.mode = AutopilotMode::hold;
  if (action.heading)
    command.heading = wrap_pi(*action.heading);
  if (action.altitude)
    command.altitude = *action.altitude;
  if (action.speed)
    command.speed = *action.speed;
  if (action.climb)
    command.climb = *action.climb;
  if (action.load_factor)
    command.load_factor = *action.load_factor;

  // what the modes need
  if (command.mode == AutopilotMode::route && action.route)
    command.route = static_cast<std::uint8_t>(std::min(*action.route, 255U));  // 255: there is none
  if (command.mode != AutopilotMode::follow && command.mode != AutopilotMode::loiter)
    return;
  if (action.follow) {
    command.reference_position = action.follow->position;
    command.reference_velocity = action.follow->velocity;
    command.reference_time = action.follow->time;
    command.offset = action.follow->offset;
  } else if (action.mode) {
    command.mode = AutopilotMode::hold;
  }
}

bool is_hostile(const State& state, TrackId track) {
  const Seen* seen = state.find(track);
  return seen && seen->hostile();
}

}  // namespace

void account_for_shots(const State& state, Agent& agent) {
  // tracks that were merged go by the name of the one that is left
  const auto follow = [&](TrackId& track) {
    if (const Seen* seen = state.find(track))
      track = seen->id();
  };
  follow(agent.target);
  follow(agent.asked_track);
  for (Shot& shot : agent.shots)
    follow(shot.track);

  const auto left =
      static_cast<std::uint8_t>(std::min(model::weapon::missiles_left(state.stores), 255U));
  if (agent.ticks > 0 && left < agent.missiles && agent.asked_track) {
    Shot* oldest = &agent.shots[0];
    for (Shot& shot : agent.shots)
      if (shot.until < oldest->until)
        oldest = &shot;
    const Seen* target = state.find(agent.asked_track);
    const model::MissileType& missile = state.library.missiles[agent.asked_store];
    *oldest = {.since = state.time,
               .until = state.time + (target ? time_of_flight(state, *target, missile) : 0.0),
               .track = agent.asked_track,
               .store = static_cast<std::uint16_t>(agent.asked_store)};
  }
  for (Shot& shot : agent.shots)
    if (shot.flies(state.time) && support_left(state, shot).value_or(1) <= 0)
      shot.active = 1;
  agent.missiles = left;
}

void execute(const Action& action, const State& state, model::Command& command,
             model::Request& request, Agent& agent) {
  fly(action, command);

  TrackId wanted = action.target.value_or(agent.target);
  if (!is_hostile(state, wanted))
    wanted = {};
  if (wanted != agent.target) {
    agent.target = wanted;
    agent.target_since = state.time;
  }
  if (!state.contested)
    agent.contested_since = 0;
  else if (agent.contested_since == 0)
    agent.contested_since = state.time;
  const bool silent = action.radar ? !*action.radar : request.radar_off != 0;
  request = {.target = agent.target,
             .trigger = static_cast<std::uint8_t>(action.trigger.value_or(false)),
             .radar_off = static_cast<std::uint8_t>(silent),
             .dispense = action.dispense.value_or(model::Dispense::none)};
  // of a plug-in or a person, whose numbers may mean nothing
  if (action.release && is_hostile(state, action.release->track) &&
      action.release->store < state.library.missiles.size()) {
    request.shoot_at = agent.asked_track = action.release->track;
    request.store = static_cast<std::uint8_t>(action.release->store + 1);
    agent.asked_store = action.release->store;
  }
}

}  // namespace eyrie::pilot
