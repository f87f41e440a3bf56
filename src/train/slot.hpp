// SPDX-License-Identifier: MIT
#pragma once
/// \file  What an environment keeps from decision to decision, and what a thread needs to step
/// some.
#include <atomic>
#include <stdexcept>

#include "pilot/pilot_system.hpp"
#include "train/vector_env.hpp"

namespace eyrie::train {

/// A mistake of the caller.
template <class... T>
[[noreturn]] void refuse(fmt::format_string<T...> words, T&&... values) {
  throw std::invalid_argument(fmt::format(words, std::forward<T>(values)...));
}

/// One environment: the world of its episode, and what is not in it.
struct VectorEnv::Slot {
  struct Agent {
    bool alive = true, was_alive = true;
    Merit merit;
    std::uint32_t rounds = 0;      ///< in the drum
    std::vector<float> votes;      ///< as ordered last; negative: none was
    pilot::Controls::Start start;  ///< of the controls, in what was observed last
  };

  /// `room`: for the orders of the longest episode; 0: none is kept.
  Slot(const scenario::Scenario& scenario, std::size_t learners, std::size_t votes,
       std::size_t room)
      : world(*scenario.start), agents(learners) {
    for (Agent& agent : agents)
      agent.votes.resize(votes, -1.0F);
    keep(room);
  }
  void keep(std::size_t room) {
    kept = room > 0;
    orders.reserve(room);
    last_orders.reserve(room);
  }

  sim::World world;
  std::uint64_t seed = 0;
  std::uint64_t episodes = 0;  ///< that are over since the last reset of all
  scenario::Outcome outcome = scenario::Outcome::running;
  scenario::Course course;
  std::vector<Agent> agents;
  bool kept = false;
  std::vector<sim::Order> orders, last_orders;  ///< of this episode and of the one before
  Finished last;
  std::optional<sim::Fault> fault;
};

struct VectorEnv::Lane {
  /// What one of the worlds that are stepped together needs.
  struct One {
    One(const sim::Simulation& simulation, std::size_t most_orders) : work(simulation, 1, 64) {
      orders.reserve(most_orders);
    }
    sim::Workspace work;
    std::vector<sim::Order> orders;  ///< of the step that is made
  };
  Lane(const scenario::Scenario& scenario, std::size_t most_orders)
      : judge(scenario, scenario.spec.until) {
    for (std::size_t i = 0; i < sim::kMostTogether; ++i)
      ones.push_back(std::make_unique<One>(*scenario.simulation, most_orders));
  }
  std::vector<std::unique_ptr<One>> ones;
  scenario::Judge judge;
  std::atomic_flag in_use;  ///< by a thread
};

/// Calls `use` with what the pilot of an aircraft perceives between two steps; false if it is gone.
template <class Use>
bool perceive(const scenario::Scenario& scenario, const sim::World& world, PlayerId who, Use use) {
  const auto row = world.row(scenario.aircraft.table, who);
  if (!row)
    return false;
  const sim::Views<pilot::Cockpit, const sim::World> rows(world, scenario.aircraft);
  pilot::Agent agent = world.rows(scenario.pilots.agent)[*row];
  const model::Fit& fit = world.rows(scenario.aircraft.fit)[*row];
  const pilot::State state(rows.at(*row, agent), *scenario.library, fit,
                           scenario.formations[fit.flight],
                           static_cast<double>(world.step()) * scenario.simulation->dt());
  pilot::Piloting::account(state, agent);
  use(state);
  return true;
}

}  // namespace eyrie::train
