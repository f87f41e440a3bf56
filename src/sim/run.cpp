// SPDX-License-Identifier: MIT
#include "sim/run.hpp"

namespace eyrie::sim {

Paranoid::Paranoid(const Simulation& simulation, const World& like, unsigned workers)
    : simulation_(simulation), second_(simulation, workers), again_(like) {
  second_.check_writes(like);
}

std::optional<Difference> Paranoid::step(World& world, Workspace& work,
                                         std::span<const Order> orders) {
  again_ = world;
  const std::span<const Event> events = simulation_.step(world, work, orders);
  if (work.fault())
    return std::nullopt;
  const std::span<const Event> events_again = simulation_.step(again_, second_, orders);

  if (!world.same_bytes(again_))
    if (auto found = first_difference(world, again_))
      return found;
  if (auto found = first_difference(world.step() - 1, events, events_again))
    return found;
  if (auto found = second_.write_check()->take())
    return found;
  if (!world.canonical())
    return Difference{.step = world.step(),
                      .field = "form",
                      .left = "not canonical (a write beyond the live rows, or a changed id)",
                      .right = "as it should be"};
  return std::nullopt;
}

Run::Run(std::shared_ptr<const Simulation> simulation, World start, const RunOptions& options)
    : simulation_(std::move(simulation)),
      world_(std::move(start)),
      work_(*simulation_, options.workers),
      copy_(world_),
      steps_per_copy_(std::max<std::uint64_t>(options.steps_per_copy, 1)),
      numbers_(simulation_->schema()),
      check_(steps_in_a_second(simulation_->dt())) {
  EYRIE_THROW_UNLESS(&world_.schema() == &simulation_->schema(),
                     "the world belongs to another simulation");
  if (options.paranoid_workers != 0)
    paranoid_.emplace(*simulation_, world_, options.paranoid_workers);
}

void Run::attach(Observer& observer) {
  observers_.push_back(&observer);
  observer.begin(world(), simulation_->dt());
}

void Run::finish() {
  for (Observer* observer : observers_)
    observer->finish(world());
}

std::string Run::submit(const Order& order) {
  if (simulation_->handler(order.kind) == nullptr)
    return fmt::format("nobody accepts orders of kind {}", order.kind.value);
  if (order.step < world().step())
    return fmt::format("an order for step {} comes too late: step {} is next", order.step,
                       world().step());
  orders_.insert(std::ranges::upper_bound(orders_, order.step, {}, &Order::step), order);
  return {};
}

std::span<const Order> Run::orders_for(std::uint64_t step) const {
  const auto orders = std::ranges::equal_range(orders_, step, {}, &Order::step);
  return {orders.begin(), orders.end()};
}

std::span<const Event> Run::step() {
  if (fault_)
    return {};
  if (world_.step() - copy_.step() >= steps_per_copy_)
    copy_ = world_;
  const std::span<const Order> orders = orders_for(world_.step());
  const StepInfo info{.step = world_.step(), .seed = world_.seed(), .dt = simulation_->dt()};

  if (!paranoid_) {
    simulation_->step(world_, work_, orders);
  } else if (auto found = paranoid_->step(world_, work_, orders); found && !difference_) {
    difference_ = std::move(found);
  }
  if (work_.fault()) [[unlikely]] {
    end_with(*work_.fault());
    return {};
  }
  if (check_.divides(world_.step()))
    if (auto fault = numbers_.find(world_)) [[unlikely]] {
      fault->step = info.step;
      end_with(std::move(*fault));
      return {};
    }
  for (Observer* observer : observers_)
    observer->observe(world_, info, work_.events());
  return work_.events();
}

void Run::end_with(Fault fault) {
  // up to the last whole step, with nobody watching: they have seen these steps
  while (copy_.step() < fault.step) {
    simulation_->step(copy_, work_, orders_for(copy_.step()));
    if (work_.fault())
      break;
  }
  fault_ = std::move(fault);
}

void Run::fail(Fault fault) {
  fault.step = copy_.step();
  fault_ = std::move(fault);
}

void Run::forgive() {
  if (!fault_)
    return;
  world_ = copy_;
  fault_.reset();
}

}  // namespace eyrie::sim
