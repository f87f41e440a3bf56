// SPDX-License-Identifier: MIT
#include "sim/number_check.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "sim/run.hpp"
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

}  // namespace
}  // namespace eyrie::sim
