// SPDX-License-Identifier: MIT
#include "sim/simulation.hpp"

namespace eyrie::sim {

namespace {

std::size_t index_of(Phase phase) {
  return static_cast<std::size_t>(phase);
}

std::size_t most_chunks(const Schema& schema) {
  std::size_t most = 0;
  for (const TableInfo& table : schema.tables())
    most = std::max(most, chunk_count(table.capacity));
  return most;
}

// Rates come from text such as '20 Hz' and dt from 1.0 / 50: both are off by a rounding or two.
constexpr double kRelativeSlack = 1e-9;
constexpr double kSlowest = 1.0 / 3600;  // Hz

}  // namespace

Period period_steps(double rate, double dt) {
  EYRIE_THROW_UNLESS(std::isfinite(dt) && dt > 0, "dt must be positive and finite");
  const double base = 1 / dt;
  if (!std::isfinite(rate) || rate <= 0)
    return {0, fmt::format("a rate must be above 0 Hz, got {} Hz", rate)};
  if (rate < kSlowest * (1 - kRelativeSlack))
    return {0, fmt::format("{} Hz is slower than once per hour", rate)};
  if (rate > base * (1 + kRelativeSlack))
    return {0, fmt::format("{} Hz is faster than the step, which runs at {:.6g} Hz", rate, base)};

  const double exact = base / rate;
  const double nearest = std::nearbyint(exact);
  if (nearest > std::numeric_limits<std::uint32_t>::max())
    return {0, fmt::format("{} Hz is too slow for steps of {} s", rate, dt)};
  if (std::fabs(exact - nearest) <= kRelativeSlack * exact)
    return {static_cast<std::uint32_t>(nearest), {}};
  return {0, fmt::format("{} Hz does not divide the base rate of {:.6g} Hz; near it are {:.6g} Hz "
                         "and {:.6g} Hz",
                         rate, base, base / std::ceil(exact), base / std::floor(exact))};
}

std::uint32_t steps_in_a_second(double dt) {
  return static_cast<std::uint32_t>(std::clamp(std::nearbyint(1 / dt), 1.0, 1e9));
}

bool CommitContext::remove(PlayerId who) {
  const std::optional<RowRef> place = world_.find(who);
  if (place)
    world_.remove(place->table, place->row);
  return place.has_value();
}

Workspace::Workspace(const Simulation& simulation, unsigned workers, std::size_t room)
    : executor_(workers), emitted_(room), events_(4 * room) {
  by_chunk_.reserve(simulation.chunks_);
  for (std::size_t i = 0; i < simulation.chunks_; ++i)
    by_chunk_.emplace_back(room);
}

void Workspace::collect(std::size_t chunks) {
  for (std::size_t i = 0; i < chunks; ++i) {
    if (by_chunk_[i].failed()) [[unlikely]]
      events_.fail(std::move(*by_chunk_[i].take_fault()));
    for (const Event& event : by_chunk_[i].events())
      events_.emit(event);
    by_chunk_[i].clear();
  }
}

Simulation::Simulation(std::shared_ptr<const Schema> schema, double dt)
    : schema_(std::move(schema)), dt_(dt), chunks_(most_chunks(*schema_)) {}

const System* Simulation::handler(OrderKind kind) const {
  return kind.value < by_order_.size() ? by_order_[kind.value] : nullptr;
}

void Simulation::step(std::span<const Stepped> worlds) const {
  EYRIE_THROW_UNLESS(worlds.size() <= kMostTogether, "too many worlds are stepped together");
  for (const Stepped& one : worlds) {
    EYRIE_THROW_UNLESS(one.world && one.work, "a world or a workspace is missing");
    EYRIE_THROW_UNLESS(&one.world->schema() == schema_.get(),
                       "the world belongs to another simulation");
    EYRIE_THROW_UNLESS(one.work->by_chunk_.size() >= chunks_,
                       "the workspace was made for another simulation");
    for (const Stepped* other = &one + 1; other < worlds.data() + worlds.size(); ++other)
      EYRIE_THROW_UNLESS(other->world != one.world && other->work != one.work,
                         "a world or a workspace is there twice");
  }
  std::array<Going, kMostTogether> places;
  const std::span<Going> going = std::span(places).first(worlds.size());
  for (std::size_t i = 0; i < worlds.size(); ++i) {
    const World& world = *worlds[i].world;
    going[i] = {
        worlds[i].world, worlds[i].work, {.step = world.step(), .seed = world.seed(), .dt = dt_}};
    going[i].work->events_.clear();
    going[i].work->fault_.reset();
    if (!worlds[i].orders.empty())
      apply(worlds[i].orders, going[i]);
  }
  run<&System::perceive>(Phase::perceive, going);
  run<&System::decide>(Phase::decide, going);
  run<&System::act>(Phase::act, going);
  if (going.size() > 1)
    move_together(going);
  else
    run<&System::move>(Phase::move, going);
  run<&System::interact>(Phase::interact, going);
  for (const Going& one : going) {
    if (one.work->fault_) [[unlikely]] {
      one.work->events_.clear();
      continue;
    }
    commit(one);
    ++one.world->header().step;
  }
}

void Simulation::apply(std::span<const Order> orders, const Going& one) const {
  World& world = *one.world;
  Workspace& work = *one.work;
  for (const Order& order : orders) {
    const System* system = handler(order.kind);
    EYRIE_DEMAND(order.step == world.step(), "an order is applied in the step it names");
    EYRIE_DEMAND(system != nullptr, "an order needs a system that accepts its kind");
    if (work.check_) [[unlikely]]
      work.check_->begin(world);
    system->apply_order(world, one.info, order, work.events_);
    if (failed(*system, one)) [[unlikely]]
      return;
    if (work.check_) [[unlikely]]
      work.check_->end(world, *system, Phase::orders);
  }
}

template <auto kPart>
void Simulation::run(Phase phase, std::span<const Going> worlds) const {
  for (const Turn& turn : by_phase_[index_of(phase)])
    for (const Going& one : worlds) {
      const std::uint32_t rows = one.world->rows(turn.table);
      if (rows == 0 || one.work->fault_)
        continue;
      if (rows > kChunk || one.work->check_) [[unlikely]] {
        run_at_length<kPart>(turn, phase, one, rows);
        continue;
      }
      [&]() noexcept {
        (turn.system->*kPart)(*one.world, one.info, {0, rows}, one.work->events_);
      }();
      static_cast<void>(failed(*turn.system, one));
    }
}

template <auto kPart>
void Simulation::run_at_length(const Turn& turn, Phase phase, const Going& one,
                               std::uint32_t rows) const {
  const System& system = *turn.system;
  World& world = *one.world;
  Workspace& work = *one.work;
  if (work.check_)
    work.check_->begin(world);
  const auto run_chunk = [&](Chunk chunk, Outbox& out) noexcept {
    (system.*kPart)(world, one.info, chunk, out);
  };
  if (rows <= kChunk) {
    run_chunk({0, rows}, work.events_);
  } else {
    work.executor_.for_chunks(rows, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
      run_chunk({begin, end}, work.by_chunk_[chunk]);
    });
    work.collect(chunk_count(rows));
  }
  if (!failed(system, one) && work.check_)
    work.check_->end(world, system, phase, [&](World& other, Chunk chunk) {
      (system.*kPart)(other, one.info, chunk, work.emitted_);
      static_cast<void>(work.emitted_.take_fault());
      work.emitted_.clear();
    });
}

void Simulation::move_together(std::span<const Going> worlds) const {
  for (const Turn& turn : by_phase_[index_of(Phase::move)]) {
    std::array<Share, kMostTogether> shares;
    std::array<const Going*, kMostTogether> whose;
    std::size_t count = 0;
    for (const Going& one : worlds) {
      const std::uint32_t rows = one.world->rows(turn.table);
      if (rows == 0 || one.work->fault_)
        continue;
      if (rows > kChunk || one.work->check_) [[unlikely]] {
        run_at_length<&System::move>(turn, Phase::move, one, rows);
        continue;
      }
      shares[count] = {one.world, one.info, {0, rows}, &one.work->events_};
      whose[count++] = &one;
    }
    if (count == 0)
      continue;
    [&]() noexcept { turn.system->move_together(std::span(shares).first(count)); }();
    for (std::size_t i = 0; i < count; ++i)
      static_cast<void>(failed(*turn.system, *whose[i]));
  }
}

bool Simulation::fail(const System& system, const Going& one) {
  Workspace& work = *one.work;
  work.fault_ = work.events_.take_fault();
  work.fault_->system = system.name();
  work.fault_->step = one.info.step;
  return true;
}

void Simulation::commit(const Going& one) const {
  World& world = *one.world;
  Workspace& work = *one.work;
  WriteCheck* const check = work.check_.get();
  CommitContext context(world, work.emitted_);
  std::span<const Event> events = work.events();
  for (const auto& [system, table] : by_phase_[index_of(Phase::commit)]) {
    if (check) [[unlikely]]
      check->begin(world);
    system->commit(world, one.info, events, context);
    if (check) [[unlikely]]
      check->end(world, *system, Phase::commit);
    if (work.emitted_.events().empty()) [[likely]]
      continue;
    // appended only now: the system was reading the events it was given
    for (const Event& event : work.emitted_.events())
      work.events_.emit(event);
    work.emitted_.clear();
    events = work.events();
  }
  world.compact();
}

SimulationBuilder::SimulationBuilder(std::shared_ptr<const Schema> schema, double dt) {
  EYRIE_THROW_UNLESS(schema != nullptr, "a simulation needs a schema");
  EYRIE_THROW_UNLESS(std::isfinite(dt) && dt > 0, "dt must be positive and finite");
  simulation_.reset(new Simulation(std::move(schema), dt));
}

void SimulationBuilder::add(std::unique_ptr<const System> system,
                            const std::array<bool, kPhases>& phases) {
  EYRIE_THROW_UNLESS(simulation_ != nullptr, "the simulation was built already");
  EYRIE_THROW_UNLESS(system != nullptr, "a system is missing");
  const TableId table = system->table();
  EYRIE_THROW_UNLESS(table && table.value <= simulation_->schema_->tables().size(),
                     "a system needs a table of this schema");
  for (const OrderKind kind : system->accepts()) {
    EYRIE_THROW_UNLESS(phases[index_of(Phase::orders)],
                       "a system that accepts orders must override apply_order");
    EYRIE_THROW_UNLESS(
        simulation_->handler(kind) == nullptr && std::ranges::count(system->accepts(), kind) == 1,
        "two systems accept the same kind of order, or one twice");
  }
  for (const OrderKind kind : system->accepts()) {
    auto& by_order = simulation_->by_order_;
    by_order.resize(std::max<std::size_t>(by_order.size(), kind.value + 1u), nullptr);
    by_order[kind.value] = system.get();
  }
  for (std::size_t i = 0; i < kPhases; ++i)
    if (phases[i])
      simulation_->by_phase_[i].push_back({system.get(), table});
  simulation_->systems_.push_back(std::move(system));
}

std::shared_ptr<const Simulation> SimulationBuilder::build() {
  EYRIE_THROW_UNLESS(simulation_ != nullptr, "the simulation was built already");
  return std::shared_ptr<const Simulation>(std::move(simulation_));
}

}  // namespace eyrie::sim
