// SPDX-License-Identifier: MIT
#include "sim/check.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <memory>
#include <string>
#include <tuple>

#include "sim/columns.hpp"
#include "sim/run.hpp"
#include "sim/simulation.hpp"
#include "sim/swarm_test.hpp"

namespace eyrie::sim {
namespace {

using swarm::Body;
using swarm::Swarm;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(NumberCheck, FindsEveryNumberThatIsNone) {
  const Swarm swarm;
  World world = swarm.world(3);
  const NumberCheck check(world.schema());
  EXPECT_FALSE(check.find(world));
  const auto bodies = world.rows(swarm.keys.body);
  for (std::size_t row = 0; row < bodies.size(); ++row)
    for (const double bad : {kNan, -kNan, HUGE_VAL, -HUGE_VAL})
      for (double* number :
           {&bodies[row].position.x, &bodies[row].position.z, &bodies[row].velocity.y}) {
        const double before = std::exchange(*number, bad);
        const auto found = check.find(world);
        ASSERT_TRUE(found);
        EXPECT_EQ(found->player, world.ids(swarm.keys.birds)[row]);
        *number = before;
      }
  bodies[1].velocity.y = kNan;
  EXPECT_EQ(check.find(world)->what, "body.velocity.y is nan");
  bodies[1].velocity.y = std::numeric_limits<double>::max();
  EXPECT_FALSE(check.find(world));
}

TEST(NumberCheck, EndsARunWithinASecond) {
  const Swarm swarm;
  World world = swarm.world(3);
  world.rows(swarm.keys.body)[2].velocity.z = kNan;
  sim::Run run(swarm.simulation, world);
  for (int i = 0; i < 200 && !run.fault(); ++i)
    run.step();
  ASSERT_TRUE(run.fault());
  EXPECT_LE(run.world().step(), 50U);
  EXPECT_EQ(run.world().step(), run.fault()->step);
}

struct Number {
  double value = 7;
  static constexpr auto fields() { return field_list(field("value", &Number::value)); }
};

struct CarColumns : Table<CarColumns> {
  Column<Number> place, speed, seen, plate;
  static constexpr std::string_view table_name = "car";
  static constexpr auto columns() {
    using C = CarColumns;
    return std::tuple{column("place", &C::place, WrittenBy{"drive", Phase::move}),
                      column("speed", &C::speed, WrittenBy{"drive", Phase::decide}),
                      column("seen", &C::seen, WrittenBy{"drive", Phase::perceive},
                             WrittenBy{"drive", Phase::commit}),
                      column("plate", &C::plate)};
  }
};

enum class Breach {
  none,
  in_another_phase,
  of_another_system,
  what_is_set_at_birth,
  of_another_row,
  from_another_row,
  of_another_table,
  in_commit
};

/// Drives as it is described, or breaks a rule once the world is two steps old.
class Drive final : public System {
 public:
  Drive(const CarColumns& cars, const CarColumns& others, Breach breach)
      : cars_(cars), others_(others), breach_(breach) {}
  std::string_view name() const override { return "drive"; }
  TableId table() const override { return cars_.table; }

  void perceive(World& world, const StepInfo&, Chunk chunk, Outbox&) const override {
    const auto places = std::as_const(world).rows(cars_.place);
    for (std::size_t i = chunk.begin; i < chunk.end; ++i)
      world.rows(cars_.seen)[i].value = places[places.size() - 1 - i].value;  // as it may
  }
  void decide(World& world, const StepInfo& info, Chunk chunk, Outbox&) const override {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      world.rows(cars_.speed)[i].value += 1;
      if (info.step >= 2)
        breach(world, i);
    }
  }
  void move(World& world, const StepInfo& info, Chunk chunk, Outbox&) const override {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i)
      world.rows(cars_.place)[i].value += world.rows(cars_.speed)[i].value * info.dt;
  }
  void commit(World& world, const StepInfo& info, std::span<const Event>,
              CommitContext& context) const override {
    world.rows(cars_.seen)[0].value = 0;
    if (info.step == 1 && world.rows(cars_.table) < 5)
      world.rows(cars_.plate)[context.spawn(cars_.table)->row].value = 3;  // as it is born
    if (info.step >= 2 && breach_ == Breach::in_commit)
      world.rows(cars_.speed)[1].value = 0;
  }

 private:
  void breach(World& world, std::size_t i) const {
    const auto speeds = world.rows(cars_.speed);
    if (breach_ == Breach::in_another_phase)
      world.rows(cars_.place)[i].value = 0;
    if (breach_ == Breach::what_is_set_at_birth)
      world.rows(cars_.plate)[i].value = 1;
    if (breach_ == Breach::of_another_row && i == 0)
      speeds[1].value += 1e3;
    if (breach_ == Breach::from_another_row && i > 0)
      speeds[i].value += speeds[i - 1].value;
    if (breach_ == Breach::of_another_table)
      world.rows(others_.speed)[0].value = static_cast<double>(i);
  }

  CarColumns cars_, others_;
  Breach breach_;
};

/// Reads everything and writes nothing, unless it breaks a rule.
class Guest final : public System {
 public:
  Guest(const CarColumns& cars, bool breaks) : cars_(cars), breaks_(breaks) {}
  std::string_view name() const override { return "guest"; }
  TableId table() const override { return cars_.table; }
  void move(World& world, const StepInfo&, Chunk chunk, Outbox&) const override {
    for (std::size_t i = chunk.begin; breaks_ && i < chunk.end; ++i)
      world.rows(cars_.place)[i].value = 1;
  }

 private:
  CarColumns cars_;
  bool breaks_;
};

/// Another table of the same shape, which nobody drives.
struct Parked : CarColumns {
  static Parked define(SchemaBuilder& builder) {
    Parked keys;
    keys.table = builder.add_table("parked", 1);
    keys.speed = builder.add_column<Number>(keys.table, "speed");
    return keys;
  }
};

/// What is found in ten steps, in words.
std::string found(Breach breach, bool* honest_steps = nullptr) {
  SchemaBuilder schema;
  const CarColumns cars = CarColumns::define(schema, 5);
  const Parked parked = Parked::define(schema);
  SimulationBuilder builder(schema.build());
  builder.add<Drive>(cars, parked, breach);
  builder.add<Guest>(cars, breach == Breach::of_another_system);
  const auto simulation = builder.build();
  World world = simulation->world(1);
  for (int i = 0; i < 4; ++i)
    cars.set_defaults(world, world.spawn(cars.table)->row);
  static_cast<void>(world.spawn(parked.table));
  Workspace work(*simulation);
  Paranoid paranoid(*simulation, world, 2);
  for (int i = 0; i < 10; ++i) {
    if (auto difference = paranoid.step(world, work))
      return difference->text();
    if (honest_steps)
      *honest_steps = i >= 1;
  }
  return "";
}

TEST(WriteCheck, FindsNothingWhereEverybodyWritesWhatIsHis) {
  EXPECT_EQ(found(Breach::none), "");
}

TEST(WriteCheck, NamesWhoWritesInAnotherPhase) {
  EXPECT_EQ(found(Breach::in_another_phase),
            "step 2: drive in decide writes what is written only by drive in move "
            "(car.place.value of player 1 (row 0): 7.34, 0)");
}

TEST(WriteCheck, NamesWhoWritesWhatBelongsToAnotherSystem) {
  EXPECT_EQ(found(Breach::of_another_system).substr(0, 73),
            "step 0: guest in move writes what is written only by drive in move (car.p");
}

TEST(WriteCheck, NamesWhoWritesWhatIsSetAtBirth) {
  bool honest_steps = false;
  EXPECT_EQ(found(Breach::what_is_set_at_birth, &honest_steps),
            "step 2: drive in decide writes what is written by nobody "
            "(car.plate.value of player 1 (row 0): 7, 1)");
  EXPECT_TRUE(honest_steps) << "a birth is none";
}

TEST(WriteCheck, NamesWhoWritesAnotherRowThanItsOwn) {
  const std::string text = found(Breach::of_another_row);
  EXPECT_NE(text.find("drive in decide writes another row than its own, 0 (car.speed.value of "
                      "player 2 (row 1)"),
            text.npos)
      << text;
}

TEST(WriteCheck, NamesWhoReadsWhatAnotherRowWritesThen) {
  const std::string text = found(Breach::from_another_row);
  EXPECT_EQ(text.find("step 2: drive in decide reads what another row writes then"), 0U) << text;
}

TEST(WriteCheck, NamesWhoWritesInAnotherTable) {
  const std::string text = found(Breach::of_another_table);
  EXPECT_EQ(text.find("step 2: drive in decide writes a row of another table (parked.speed"), 0U)
      << text;
}

TEST(WriteCheck, LooksAtTheCommitToo) {
  const std::string text = found(Breach::in_commit);
  EXPECT_EQ(text.find("step 2: drive in commit writes what is written only by drive in decide"), 0U)
      << text;
}

TEST(Table, StandsInTheWorldAsItIsDescribed) {
  SchemaBuilder builder;
  const CarColumns cars = CarColumns::define(builder, 2);
  const auto schema = builder.build();
  EXPECT_EQ(schema->find_table("car"), cars.table);
  const auto& columns = schema->table(cars.table).columns;
  ASSERT_EQ(columns.size(), 6U);
  EXPECT_EQ(schema->column(columns[2]).name, "place");
  EXPECT_EQ(schema->column(columns[5]).name, "plate");
  EXPECT_EQ(schema->column(columns[5]).writers, std::vector<WrittenBy>{});
  EXPECT_EQ(schema->column(columns[3]).writers, (std::vector{WrittenBy{"drive", Phase::decide}}));
}

TEST(Table, GivesTheBornTheirDefaults) {
  SchemaBuilder builder;
  const CarColumns cars = CarColumns::define(builder, 2);
  World world(builder.build(), 1);
  cars.set_defaults(world, world.spawn(cars.table)->row);
  EXPECT_EQ(world.rows(cars.plate)[0].value, 7);
}

struct Cab {
  const Number& place;
  const Number& seen;
  int passengers;
  static constexpr auto columns() { return std::tuple{&CarColumns::place, &CarColumns::seen}; }
};

TEST(Views, TakeWhatIsPerceivedFromTheOtherWorld) {
  SchemaBuilder builder;
  const CarColumns cars = CarColumns::define(builder, 2);
  World before(builder.build(), 1);
  for (int i = 0; i < 2; ++i)
    static_cast<void>(before.spawn(cars.table));
  World after = before;
  before.rows(cars.place)[1].value = 1;
  before.rows(cars.seen)[1].value = 2;
  after.rows(cars.place)[0].value = 3;
  after.rows(cars.seen)[0].value = 4;
  const Views<Cab, const World> then(before, cars), now(after, cars);
  const Cab cab = then.at_both(1, now, 0, 5);
  EXPECT_EQ(cab.place.value, 1);
  EXPECT_EQ(cab.seen.value, 4);
  EXPECT_EQ(cab.passengers, 5);
  EXPECT_EQ(then.at(1, 0).seen.value, 2);
}

}  // namespace
}  // namespace eyrie::sim
