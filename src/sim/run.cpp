// SPDX-License-Identifier: MIT
#include "sim/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/assert.hpp"

namespace eyrie::sim {

namespace {

constexpr auto kEarlier = [](const Order& order, std::uint64_t step) { return order.step < step; };
constexpr auto kLater = [](std::uint64_t step, const Order& order) { return step < order.step; };

}  // namespace

Run::Run(std::shared_ptr<const Simulation> simulation, World start, const RunOptions& options)
    : simulation_(std::move(simulation)),
      world_(std::move(start)),
      work_(*simulation_, options.workers) {
  EYRIE_THROW_UNLESS(&world_.schema() == &simulation_->schema(),
                     "the world belongs to another simulation");
  if (options.paranoid_workers != 0)
    paranoid_.emplace(*simulation_, world_, options.paranoid_workers);
}

void Run::attach(Observer& observer) {
  observers_.push_back(&observer);
  observer.begin(world_, simulation_->dt());
}

void Run::finish() {
  for (Observer* observer : observers_)
    observer->finish(world_);
}

std::string Run::submit(const Order& order) {
  if (simulation_->handler(order.kind) == nullptr)
    return fmt::format("nobody accepts orders of kind {}", order.kind.value);
  if (order.step < world_.step())
    return fmt::format("an order for step {} comes too late: step {} is next", order.step,
                       world_.step());
  const auto after = std::upper_bound(orders_.begin(), orders_.end(), order.step, kLater);
  orders_.insert(after, order);
  return {};
}

std::span<const Event> Run::step() {
  const auto first = std::lower_bound(orders_.begin(), orders_.end(), world_.step(), kEarlier);
  const auto last = std::upper_bound(first, orders_.end(), world_.step(), kLater);
  const std::span<const Order> orders(first, last);
  const StepInfo info{.step = world_.step(), .seed = world_.seed(), .dt = simulation_->dt()};

  if (!paranoid_) {
    simulation_->step(world_, work_, orders);
  } else if (auto found = paranoid_->step(world_, work_, orders); found && !difference_) {
    difference_ = std::move(found);
  }
  for (Observer* observer : observers_)
    observer->observe(world_, info, work_.events());
  return work_.events();
}

void Run::restore(const World& world) {
  EYRIE_THROW_UNLESS(&world.schema() == &simulation_->schema(),
                     "the world belongs to another simulation");
  world_ = world;
}

}  // namespace eyrie::sim
