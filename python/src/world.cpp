// SPDX-License-Identifier: MIT
/// \file  Worlds as values: stepped, copied, given orders, and looked at row by
/// row.
#include <unistd.h>

#include "common.hpp"
#include "core/hash.hpp"
#include "scenario/mission.hpp"
#include "scenario/operator_orders.hpp"

namespace eyrie::python {
namespace {

using Bytes = nb::ndarray<nb::numpy, const std::uint8_t, nb::ndim<1>>;

/// One world with what ends it. Not for two threads at once: who finds it in
/// use is told so.
class World {
 public:
  World(Scenario scenario, std::uint64_t seed, std::optional<double> until, unsigned workers)
      : scenario_(std::move(scenario.loaded)), seed_(seed), until_(until), workers_(workers) {
    if (until)
      if (const auto problem = scenario::until_problem(scenario_->spec, *until))
        refuse("until: {}", *problem);
    mission_.reset(new scenario::Mission(scenario_, seed, until, {.workers = workers}));
  }
  /// Threads do not live on in a child of fork(): nobody may wait for them
  /// there.
  ~World() {
    if (is_forked())
      static_cast<void>(mission_.release());
  }
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  [[nodiscard]] std::unique_ptr<World> copy() const {
    const InUse used = use();
    return std::unique_ptr<World>(new World(*this, 0));
  }

  /// How many steps were made: fewer than `count` at the end of the mission.
  std::uint64_t step(std::uint64_t count) {
    const InUse used = use();
    happened_.clear();
    try {
      return without_gil([&](const auto& stop) {
        std::uint64_t made = 0;
        while (made < count && !stop() && mission_->step()) {
          ++made;
          keep_events();
        }
        return made;
      });
    } catch (const nb::python_error&) {  // of a signal, which is no fault of the step it came in
      mission_->forgive();
      throw;
    }
  }
  /// Steps until a World::step(), without a word of the end of the mission or of what happened.
  void step_to(std::uint64_t step) {
    if (step > world().step())
      static_cast<void>(this->step(step - world().step()));
    happened_.clear();
  }

  void order(const std::string& json, std::optional<std::uint64_t> at) {
    const InUse used = use();
    if (mission_->outcome() != scenario::Outcome::running)
      refuse("the mission is over ({}): nobody carries out an order any more",
             enum_name(mission_->outcome()));
    scenario::OperatorOrders asked =
        scenario::orders_from_json(*scenario_, json, at.value_or(world().step()));
    leave_out_unable(asked, *scenario_, world(), mission_->run().orders_for(world().step()));
    if (!asked.problem.empty())
      refuse("{}", printable(asked.problem));
    for (const sim::Order& order : asked.orders)
      submit(order);
  }
  void submit(const sim::Order& order) {
    if (const std::string refused = mission_->run().submit(order); !refused.empty())
      refuse("{}", printable(refused));
  }
  /// All orders so far as bytes, for pickling.
  [[nodiscard]] nb::bytes orders() const {
    const auto all = all_orders();
    return nb::bytes(all.data(), all.size() * sizeof(sim::Order));
  }
  /// Replaces the scenario's own: of a world that has made no step.
  void set_orders(const nb::bytes& bytes) {
    if (bytes.size() % sizeof(sim::Order) != 0)
      refuse("these are no orders");
    mission_.reset(new scenario::Mission(scenario_, scenario_->world(seed_), until(), false,
                                         {.workers = workers_}));
    for (std::size_t at = 0; at < bytes.size(); at += sizeof(sim::Order)) {
      sim::Order order;
      std::memcpy(&order, static_cast<const char*>(bytes.data()) + at, sizeof order);
      submit(order);
    }
  }

  /// The live rows of a column as bytes that are read where they are; `self`
  /// lives on with them.
  [[nodiscard]] Bytes rows(nb::handle self, const std::string& table,
                           const std::string& column) const {
    const InUse used = use();
    const sim::Schema& schema = world().schema();
    const TableId in = schema.find_table(table);
    if (!in)
      refuse("there is no table {}{}", quote(table),
             nearest_or_all(table, listed(schema.tables(), &sim::TableInfo::name)));
    const std::uint32_t index = schema.find_column(in, column);
    if (index == sim::kNoColumn)
      refuse("table {} has no column {}{}", table, quote(column),
             nearest_or_all(column, listed(schema.table(in).columns, [&](std::uint32_t one) {
                              return schema.column(one).name;
                            })));
    const auto bytes = world().column_bytes(index);
    return Bytes(reinterpret_cast<const std::uint8_t*>(bytes.data()), {bytes.size()}, self);
  }
  /// Table and row of a player; nothing if it is gone.
  [[nodiscard]] std::optional<std::tuple<std::string, std::uint32_t>> find(
      const std::string& player) const {
    const InUse used = use();
    const auto at = world().find(player_named(scenario_->roster, player));
    if (!at)
      return std::nullopt;
    return std::tuple(world().schema().table(at->table).name, at->row);
  }

  /// What happened in the last step(), as a table.
  [[nodiscard]] Columns events() const {
    const InUse used = use();
    TableBuilder table;
    add_event_columns(table);
    record::EventTable rows = names_;
    for (const debrief::Happened& one : happened_)
      for (const sim::Event& event : one.events)
        table.row(rows.row(event, one.info));
    return table.take();
  }

  [[nodiscard]] std::uint64_t seed() const { return seed_; }
  [[nodiscard]] double until() const { return until_.value_or(scenario_->spec.until); }
  [[nodiscard]] unsigned workers() const { return workers_; }
  [[nodiscard]] std::uint64_t steps() const { return use(), world().step(); }
  [[nodiscard]] double time() const { return use(), run().time(); }
  [[nodiscard]] std::string hash() const { return use(), hash_text(world().hash()); }
  [[nodiscard]] std::string outcome() const {
    return use(), std::string(enum_name(mission_->outcome()));
  }
  /// Why the next step cannot be made; "" if nothing is known against it.
  [[nodiscard]] std::string fault() const {
    const InUse used = use();
    const sim::Fault* fault = run().fault();
    return fault ? printable_lines(
                       scenario::fault_text(*fault, scenario_->roster, scenario_->simulation->dt()))
                 : "";
  }

 private:
  /// Goes on from where another one is.
  World(const World& other, int)
      : scenario_(other.scenario_),
        seed_(other.seed_),
        until_(other.until_),
        workers_(other.workers_),
        names_(other.names_) {
    mission_.reset(new scenario::Mission(scenario_, other.world(), until(),
                                         other.mission_->any_home(), {.workers = workers_}));
    for (const sim::Order& order : other.all_orders())
      if (order.step >= world().step())
        submit(order);
      else
        before_.push_back(order);
  }

  /// While it lives nobody else may use the world.
  InUse use() const {
    if (is_forked())
      raise("Error",
            "a world with several workers does not live on in a forked process: its threads are "
            "not there; make one anew there, or let a world with a single worker be forked");
    return {in_use_,
            "this world is being stepped, by another thread or by who asks now; a copy() may be "
            "used meanwhile"};
  }

  /// Since the first step, the scenario's own included.
  [[nodiscard]] std::vector<sim::Order> all_orders() const {
    std::vector<sim::Order> all = before_;
    all.insert(all.end(), run().orders().begin(), run().orders().end());
    return all;
  }
  [[nodiscard]] bool is_forked() const { return workers_ > 1 && process_ != ::getpid(); }
  [[nodiscard]] const sim::Run& run() const { return mission_->run(); }
  [[nodiscard]] const sim::World& world() const { return run().world(); }
  void keep_events() {
    const auto events = run().workspace().events();
    if (events.empty())
      return;
    for (const sim::Event& event : events)
      names_.note(event);
    happened_.push_back(
        {{world().step() - 1, seed_, run().simulation().dt()}, {events.begin(), events.end()}});
  }

  std::shared_ptr<const scenario::Scenario> scenario_;
  std::uint64_t seed_;
  std::optional<double> until_;
  unsigned workers_;
  std::vector<sim::Order> before_;  ///< orders of the world that it is a copy of
  record::EventTable names_{*scenario_};
  std::vector<debrief::Happened> happened_;  ///< in the last step()
  std::unique_ptr<scenario::Mission> mission_;
  ::pid_t process_ = ::getpid();
  mutable bool in_use_ = false;
};

std::unique_ptr<World> world_of(const Scenario& scenario, std::optional<std::uint64_t> seed,
                                std::optional<double> until, unsigned workers) {
  return std::make_unique<World>(scenario, seed.value_or(scenario.loaded->spec.seed), until,
                                 workers);
}

}  // namespace

void add_world(nb::module_& m) {
  m.def("world", &world_of, nb::arg("scenario"), nb::arg("seed").none(), nb::arg("until").none(),
        nb::arg("workers"), "The world at step 0.");
  nb::class_<World>(m, "World", "Everything that changes in a run, and what ends it.")
      .def("copy", &World::copy, "Another one that goes on from here.")
      .def("step", &World::step, nb::arg("count"), "Makes steps; gives how many were made.")
      .def("step_to", &World::step_to, nb::arg("step"), "Makes steps up to that one.")
      .def("order", &World::order, nb::arg("json"), nb::arg("at").none(),
           "Gives an order, in the words of docs/live.md, for a step.")
      .def("orders", &World::orders, "All orders so far, packed.")
      .def("set_orders", &World::set_orders, nb::arg("orders"), "Those instead, at step 0.")
      .def(
          "rows",
          [](nb::handle_t<World> self, const std::string& table, const std::string& column) {
            return nb::cast<World&>(self).rows(self, table, column);
          },
          nb::arg("table"), nb::arg("column"), "The live rows of a column as bytes, not copied.")
      .def("find", &World::find, nb::arg("player"), "(table, row) of a player, None if it is gone.")
      .def("events", &World::events, "What happened in the last step(), as columns.")
      .def_prop_ro("seed", &World::seed, "Of its draws.")
      .def_prop_ro("until", &World::until, "s, when it ends at the latest.")
      .def_prop_ro("workers", &World::workers, "How many threads make a step.")
      .def_prop_ro("steps", &World::steps, "How many steps were made since the start.")
      .def_prop_ro("time", &World::time, "s, since the start.")
      .def_prop_ro("hash", &World::hash, "0x and 16 hexadecimal digits: of everything in it.")
      .def_prop_ro("outcome", &World::outcome, "`running`, or why the mission is over.")
      .def_prop_ro("fault", &World::fault, "Why the next step cannot be made, or an empty text.");
}

}  // namespace eyrie::python
