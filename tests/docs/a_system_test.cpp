// SPDX-License-Identifier: MIT
/// \file  The code of docs/architecture.md, word for word (pages_test.cpp compares), so that the
/// page is compiled and run.
#include <gtest/gtest.h>

#include <utility>

#include "sim/run.hpp"
#include "sim/system.hpp"

namespace eyrie {
namespace {

enum class Happening : std::uint16_t { none, fuel_out };
struct Tank {
  double fuel = 0;  ///< kg
  static constexpr auto fields() { return field_list(field("fuel", &Tank::fuel)); }
};

/// Fuel burns while the engine runs; an empty tank is an event.
class Burn final : public sim::System {
 public:
  Burn(TableId cars, sim::Column<Tank> tank) : cars_(cars), tank_(tank) {}
  std::string_view name() const override { return "burn"; }
  TableId table() const override { return cars_; }

  void move(sim::World& world, const sim::StepInfo& info, sim::Chunk chunk,
            sim::Outbox& out) const override {
    const auto tanks = world.rows(tank_);
    for (std::size_t row = chunk.begin; row < chunk.end; ++row) {
      const double before =
          std::exchange(tanks[row].fuel, std::max(0.0, tanks[row].fuel - 0.5 * info.dt));
      if (before > 0 && tanks[row].fuel == 0)
        out.emit({.kind = Happening::fuel_out, .who = world.ids(cars_)[row]});
    }
  }

 private:
  TableId cars_;
  sim::Column<Tank> tank_;
};

TEST(ASystem, BurnsFuelUntilTheTankIsEmpty) {
  sim::SchemaBuilder schema;
  const TableId cars = schema.add_table("car", 1);
  const auto tank = schema.add_column<Tank>(cars, "tank");
  sim::SimulationBuilder builder(schema.build());
  builder.add<Burn>(cars, tank);
  const auto simulation = builder.build();
  sim::World start(simulation->shared_schema(), 1);
  ASSERT_TRUE(start.spawn(cars));
  start.rows(tank)[0].fuel = 0.5;  // a second's worth
  sim::Run run(simulation, std::move(start));
  std::size_t empty = 0;
  for (int step = 0; step < 100; ++step)
    empty += run.step().size();
  EXPECT_EQ(empty, 1u);
  EXPECT_EQ(run.world().rows(tank)[0].fuel, 0);
}

}  // namespace
}  // namespace eyrie
