// SPDX-License-Identifier: MIT
#include "train/vector_env.hpp"

#include <algorithm>
#include <stdexcept>

#include "core/draw.hpp"
#include "core/version.hpp"
#include "pilot/pilot_system.hpp"
#include "sim/run.hpp"
#include "train/slot.hpp"

namespace eyrie::train {

void VectorEnv::check_actions(std::span<const float> actions) const {
  if (const std::size_t size = results_->masks.size(); actions.size() != size)
    refuse("actions: {} numbers, expected {}", actions.size(), size);
  const float* action = actions.data();
  for (std::size_t env = 0; env < shape_.envs; ++env) {
    if (slots_[env].fault)
      refuse("environment {} cannot go on: reset it", env);
    for (std::size_t agent = 0; agent < shape_.agents; ++agent)
      for (std::size_t i = 0; i < shape_.action; ++i, ++action) {
        if (std::isnan(*action))
          refuse("action {} of {} in environment {} is not a number", action_names_[i],
                 task_.learners[agent], env);
        if (*action != 0 && !slots_[env].agents[agent].alive)
          refuse("{} in environment {} is dead: its actions must be 0", task_.learners[agent], env);
      }
  }
}

std::uint64_t VectorEnv::next_seed(std::size_t env) const {
  Draw draw(options_.seed, PlayerId{static_cast<std::uint32_t>(env + 1)}, Stream::episode,
            slots_[env].episodes);
  return draw.bits() >> 11;  // a float64 holds it
}

void VectorEnv::begin(Slot& slot, std::uint64_t seed, Lane& lane) const {
  scenario_->begin(slot.world, seed);
  slot.seed = seed;
  slot.outcome = scenario::Outcome::running;
  slot.course = {};
  slot.fault.reset();
  slot.orders.clear();
  for (std::size_t i = 0; i < slot.agents.size(); ++i) {
    Slot::Agent& agent = slot.agents[i];
    agent.alive = true;
    agent.merit = {};
    std::ranges::fill(agent.votes, -1.0F);
  }
  Lane::One& one = *lane.ones.front();
  while (slot.world.step() < lead_ && slot.outcome == scenario::Outcome::running) {
    order(slot, one.orders, nullptr);
    const sim::Stepped step{&slot.world, &one.work, one.orders};
    scenario_->simulation->step(std::span(&step, 1));
    look(slot, lane.judge, one.work);
  }
  for (std::size_t i = 0; i < slot.agents.size(); ++i)
    slot.agents[i].rounds = rounds_of(slot.world, i).value_or(0);
}

std::optional<std::uint32_t> VectorEnv::rounds_of(const sim::World& world,
                                                  std::size_t agent) const {
  const auto row = world.row(scenario_->aircraft.table, learners_[agent].id);
  return row ? std::optional(world.rows(scenario_->aircraft.gun)[*row].rounds) : std::nullopt;
}

void VectorEnv::end(Slot& slot) const {
  slot.last = {slot.seed, slot.world.step(), slot.outcome};
  std::swap(slot.last_orders, slot.orders);
  ++slot.episodes;
}

void VectorEnv::reset(std::uint64_t seed) {
  options_.seed = seed;
  each_run([&](Lane& lane, std::size_t env, std::size_t next) {
    for (; env < next; ++env) {
      slots_[env].episodes = 0;
      begin(slots_[env], next_seed(env), lane);
    }
  });
  for (std::size_t env = 0; env < shape_.envs; ++env) {
    show(env);
    tell_fault(env);
  }
}

void VectorEnv::reset_one(std::size_t env, std::uint64_t seed) {
  if (env >= shape_.envs)
    refuse("environment {} of {}", env, shape_.envs);
  begin(slots_[env], seed, *lanes_.front());
  show(env);
  tell_fault(env);
}

void VectorEnv::step(std::span<const float> actions) {
  check_actions(actions);
  const std::size_t each = shape_.agents * shape_.action;
  each_run([&](Lane& lane, std::size_t env, std::size_t next) {
    advance(std::span(slots_).subspan(env, next - env), lane, actions.data() + env * each);
    for (; env < next; ++env)
      judge(slots_[env], env, lane);
  });
  for (std::size_t env = 0; env < shape_.envs; ++env)
    tell_fault(env);
}

template <class Use>
void VectorEnv::each_run(Use use) {
  // as many groups for each worker, none larger than what a lane can step together
  const std::size_t envs = shape_.envs, workers = lanes_.size();
  const std::size_t most = workers * sim::kMostTogether;
  const std::size_t groups = workers * ((envs + most - 1) / most);
  executor_->for_chunks(groups * kChunk, [&](std::size_t i, std::size_t, std::size_t) {
    const auto free = std::ranges::find_if(lanes_, [](const auto& lane) {
      return !lane->in_use.test_and_set(std::memory_order_acquire);
    });
    use(**free, i * envs / groups, (i + 1) * envs / groups);
    (*free)->in_use.clear(std::memory_order_release);
  });
}

void VectorEnv::tell_fault(std::size_t env) const {
  if (slots_[env].fault)
    throw Faulted(fmt::format(
        "environment {}, episode {}: {}", env, slots_[env].seed,
        scenario::fault_text(*slots_[env].fault, scenario_->roster, scenario_->simulation->dt())));
}

void VectorEnv::command(Slot& slot, std::size_t agent, const float* action,
                        std::vector<sim::Order>& orders) const {
  const Learner& learner = learners_[agent];
  const std::uint64_t step = slot.world.step();
  if (!task_.votes) {
    const pilot::Controls::Start& start = slot.agents[agent].start;
    orders.push_back(sim::order_for(step, learner.id, pilot::OrderKind::manual,
                                    controls_.apply(start, {action, shape_.action})));
    return;
  }
  for (std::size_t i = 0; i < shape_.action; ++i) {
    const double unit = std::clamp(static_cast<double>(action[i]), -1.0, 1.0);
    const auto vote = static_cast<float>(0.5 * (1 + unit) * task_.votes->most);
    float& before = slot.agents[agent].votes[i];
    if (vote == before)
      continue;
    before = vote;
    orders.push_back(sim::order_for(step, learner.id, pilot::OrderKind::vote,
                                    model::VoteChange{.vote = vote, .number = learner.nodes[i]}));
  }
}

void VectorEnv::advance(std::span<Slot> group, Lane& lane, const float* actions) const {
  for (Slot& slot : group)
    for (Slot::Agent& agent : slot.agents)
      agent.merit = {};
  for (std::uint32_t made = 0; made < period_; ++made) {
    std::array<sim::Stepped, sim::kMostTogether> steps;
    std::array<Slot*, sim::kMostTogether> whose;
    std::size_t count = 0;
    for (std::size_t i = 0; i < group.size(); ++i) {
      Slot& slot = group[i];
      if (slot.outcome != scenario::Outcome::running)
        continue;
      Lane::One& one = *lane.ones[count];
      order(slot, one.orders, made == 0 ? actions + i * shape_.agents * shape_.action : nullptr);
      steps[count] = {&slot.world, &one.work, one.orders};
      whose[count++] = &slot;
    }
    if (count == 0)
      return;
    scenario_->simulation->step(std::span(steps).first(count));
    for (std::size_t i = 0; i < count; ++i)
      look(*whose[i], lane.judge, lane.ones[i]->work);
  }
}

/// The orders of a step: the scenario's own, then those of the decision, if it is made now.
void VectorEnv::order(Slot& slot, std::vector<sim::Order>& orders, const float* actions) const {
  const std::uint64_t step = slot.world.step();
  orders.clear();
  for (const sim::Order& order : scenario_->orders)
    if (order.step == step)
      orders.push_back(order);
  if (step == 0)
    for (const Choice& choice : choices_) {
      Draw draw(slot.seed, choice.player, Stream::episode, 0, 1);
      const auto pick =
          static_cast<std::size_t>(draw.uniform() * static_cast<double>(choice.trees.size()));
      orders.push_back(pilot::PilotSystem::swap_tree_order(0, choice.player, choice.trees[pick]));
    }
  if (actions)
    for (std::size_t agent = 0; agent < shape_.agents; ++agent)
      if (slot.agents[agent].alive &&
          slot.world.row(scenario_->aircraft.table, learners_[agent].id))
        command(slot, agent, actions + agent * shape_.action, orders);
  if (slot.kept)
    slot.orders.insert(slot.orders.end(), orders.begin(), orders.end());
}

/// What came of a step.
void VectorEnv::look(Slot& slot, scenario::Judge& judge, const sim::Workspace& work) const {
  if (work.fault()) [[unlikely]] {
    slot.fault = *work.fault();
    slot.outcome = scenario::Outcome::fault;
    return;
  }
  for (const sim::Event& event : work.events())
    for (std::size_t agent = 0; agent < shape_.agents; ++agent)
      note(event, learners_[agent].id, scenario_->roster, slot.agents[agent].merit);
  slot.outcome = judge.after_step(slot.world, work.events(), slot.course);
}

void VectorEnv::judge(Slot& slot, std::size_t env, Lane& lane) {
  Results& out = *results_;
  // who is still there
  bool any = false;
  const std::size_t first = env * shape_.agents;
  for (std::size_t agent = 0; agent < shape_.agents; ++agent) {
    Slot::Agent& one = slot.agents[agent];
    const auto rounds = rounds_of(slot.world, agent);
    one.was_alive = one.alive;
    one.alive = one.alive && rounds;
    one.merit.alive = one.alive;
    one.merit.rounds = one.rounds - rounds.value_or(one.rounds);
    one.rounds -= one.merit.rounds;
    any |= one.alive;
  }
  if (slot.fault) [[unlikely]]
    return;
  const bool over = slot.outcome != scenario::Outcome::running || !any;
  const bool decided = over && slot.outcome != scenario::Outcome::time;

  // what it was worth
  for (std::size_t agent = 0; agent < shape_.agents; ++agent) {
    const Slot::Agent& one = slot.agents[agent];
    out.rewards[first + agent] =
        one.was_alive ? static_cast<float>(reward(task_.rewards, *scenario_, slot.world,
                                                  learners_[agent].id, one.merit, over, seconds_))
                      : 0.0F;
    out.terminated[first + agent] = one.was_alive && (!one.alive || decided) ? 1 : 0;
    out.truncated[first + agent] = one.alive && over && !decided ? 1 : 0;
  }

  // what they see: of an episode that is over, and of the one that begins
  float* last = out.last_observations.data() + first * shape_.observation;
  std::uint8_t* last_mask = out.last_masks.data() + first * shape_.action;
  if (out.over[env]) {
    std::fill_n(last, shape_.agents * shape_.observation, 0.0F);
    std::fill_n(last_mask, shape_.agents * shape_.action, std::uint8_t{0});
  }
  out.over[env] = over ? 1 : 0;
  if (over) {
    for (std::size_t agent = 0; agent < shape_.agents; ++agent)
      observe(slot, agent, last + agent * shape_.observation, last_mask + agent * shape_.action);
    end(slot);
    begin(slot, next_seed(env), lane);
  }
  show_now(env);
}

void VectorEnv::show_now(std::size_t env) {
  Results& out = *results_;
  Slot& slot = slots_[env];
  for (std::size_t agent = 0; agent < shape_.agents; ++agent) {
    const std::size_t at = env * shape_.agents + agent;
    out.alive[at] = slot.agents[agent].alive ? 1 : 0;
    observe(slot, agent, out.observations.data() + at * shape_.observation,
            out.masks.data() + at * shape_.action);
  }
}

void VectorEnv::show(std::size_t env) {
  Results& out = *results_;
  const std::size_t first = env * shape_.agents;
  std::fill_n(out.rewards.data() + first, shape_.agents, 0.0F);
  std::fill_n(out.terminated.data() + first, shape_.agents, std::uint8_t{0});
  std::fill_n(out.truncated.data() + first, shape_.agents, std::uint8_t{0});
  std::fill_n(out.last_observations.data() + first * shape_.observation,
              shape_.agents * shape_.observation, 0.0F);
  std::fill_n(out.last_masks.data() + first * shape_.action, shape_.agents * shape_.action,
              std::uint8_t{0});
  out.over[env] = 0;
  show_now(env);
}

void VectorEnv::observe(Slot& slot, std::size_t agent, float* observation,
                        std::uint8_t* mask) const {
  const bool there =
      slot.agents[agent].alive &&
      perceive(*scenario_, slot.world, learners_[agent].id, [&](const pilot::State& state) {
        observation_.write(state, observation);
        if (task_.votes)
          return;
        slot.agents[agent].start = controls_.start(state);
        controls_.mask(slot.agents[agent].start, mask);
      });
  if (!there)
    std::fill_n(observation, shape_.observation, 0.0F);
  if (!there || task_.votes)
    std::fill_n(mask, shape_.action, static_cast<std::uint8_t>(there ? 1 : 0));
}

const VectorEnv::Slot& VectorEnv::slot(std::size_t env) const {
  if (env >= slots_.size())
    refuse("environment {} of {}", env, slots_.size());
  return slots_[env];
}
std::uint64_t VectorEnv::seed(std::size_t env) const {
  return slot(env).seed;
}
const Finished& VectorEnv::finished(std::size_t env) const {
  return slot(env).last;
}
const sim::World& VectorEnv::world(std::size_t env) const {
  return slot(env).world;
}

std::shared_ptr<const VectorEnv::Snapshot> VectorEnv::save() const {
  return std::make_shared<const Snapshot>(Snapshot{hash_, options_.seed, slots_});
}

void VectorEnv::restore(const Snapshot& snapshot) {
  if (snapshot.slots.size() != slots_.size() || snapshot.task != hash_)
    refuse("this was saved by environments of another task, scenario or number");
  options_.seed = snapshot.seed;
  for (std::size_t env = 0; env < shape_.envs; ++env) {
    auto world = snapshot.slots[env].world.moved_to(scenario_->simulation->shared_schema());
    EYRIE_DEMAND(world.has_value(), "worlds of one task have one schema");
    slots_[env] = snapshot.slots[env];
    slots_[env].keep(env < options_.keep_episodes ? room_ : 0);
    slots_[env].world = std::move(*world);
    show(env);
  }
}

record::RunFile VectorEnv::episode(std::size_t env, bool last_one) const {
  const Slot& slot = this->slot(env);
  if (!slot.kept)
    refuse("episodes of environment {} are not kept: those of the first {} are", env,
           options_.keep_episodes);
  if (last_one && slot.last.steps == 0)
    refuse("no episode of environment {} is over", env);
  const std::uint64_t seed = last_one ? slot.last.seed : slot.seed;
  const std::uint64_t steps = last_one ? slot.last.steps : slot.world.step();
  record::RunFile run = record::run_file_of(*scenario_, seed, kVersion);
  run.orders = last_one ? slot.last_orders : slot.orders;
  run.outcome = enum_name(last_one ? slot.last.outcome : slot.outcome);

  sim::Run flight(scenario_->simulation, scenario_->world(seed));
  sim::TrailRecorder trail;
  flight.attach(trail);
  for (const sim::Order& order : run.orders)
    EYRIE_DEMAND(flight.submit(order).empty(), "these orders were carried out before");
  while (flight.world().step() < steps && !flight.fault())
    flight.step();
  flight.finish();
  run.trail = trail.trail();
  return run;
}

}  // namespace eyrie::train
