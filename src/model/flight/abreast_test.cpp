// SPDX-License-Identifier: MIT
#include "model/flight/abreast.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "core/draw.hpp"
#include "support/model/lone_flight.hpp"

namespace eyrie::model::flight {
namespace {

/// A dozen aircraft of two kinds, each doing something else, above and below what it can do.
struct Crowd {
  static constexpr std::size_t kSize = 12;

  Crowd() : models{PointMass(test::simple_airframe()), PointMass(test::ideal_airframe())} {
    Draw draw(1, PlayerId{1}, Stream::test, 0);
    for (std::size_t i = 0; i < kSize; ++i) {
      Row& row = rows.emplace_back();
      Kinematics& k = row.kinematics;
      k.position = {draw.uniform(-80e3, 80e3), draw.uniform(-80e3, 80e3),
                    draw.uniform(-15e3, -500)};
      const Vertical at = reference.vertical_at(k.position);
      set_vertical(k, at);
      k.speed = draw.uniform(60, 600);
      k.heading = draw.uniform(-kPi, kPi);
      k.pitch = draw.uniform(-1.5, 1.5);
      k.roll = draw.uniform(-kPi, kPi);
      k.load_factor = draw.uniform(-1, 7);
      k.velocity = k.speed * k.north;
      row.propulsion.fuel = i % 5 == 4 ? 0.3 : draw.uniform(100, 3000);  // runs dry on the way
      row.propulsion.throttle = draw.uniform(0, 2);
      command(row, draw);
    }
  }

  struct Row {
    Kinematics kinematics;
    Flying flying;
    Propulsion propulsion;
    Command command;
  };
  static void command(Row& row, Draw& draw) {
    static constexpr std::array kModes{AutopilotMode::hold,   AutopilotMode::aim,
                                       AutopilotMode::route,  AutopilotMode::follow,
                                       AutopilotMode::loiter, AutopilotMode::aim};
    row.command.mode = kModes[static_cast<std::size_t>(draw.uniform(0, 5.999))];
    row.command.heading = draw.uniform(-kPi, kPi);
    row.command.climb = draw.uniform(-1.5, 1.5);
    row.command.altitude = draw.uniform(100, 14e3);
    row.command.speed = draw.uniform(50, 500);
    row.command.load_factor = draw.uniform(0, 9);
    row.command.reference_position = row.kinematics.position + Vec3{2000, 500, 0};
    row.command.reference_velocity = {200, 30, 0};
  }

  /// Flies `seconds`, so many at a time, with other commands every other second.
  template <class Fly>
  void fly(double seconds, Fly fly_those) {
    Draw draw(2, PlayerId{1}, Stream::test, 0);
    for (int step = 0; step < static_cast<int>(seconds / test::kDt); ++step) {
      std::vector<Flyer> flyers;
      for (std::size_t i = 0; i < kSize; ++i) {
        Row& row = rows[i];
        if (step % 100 == 99)
          command(row, draw);
        flyers.push_back({.model = &models[i < 8 ? i / 2 % 2 : 0],
                          .kinematics = &row.kinematics,
                          .flying = &row.flying,
                          .propulsion = &row.propulsion,
                          .command = &row.command,
                          .routes = routes,
                          .load = {.mass = 100.0 * static_cast<double>(i), .drag_area = 0.02},
                          .time = step * test::kDt,
                          .tells_energy = step % 5 == 0});
      }
      std::vector<Flyer*> all;
      for (Flyer& flyer : flyers)
        all.push_back(&flyer);
      fly_those(Sky{reference, environment, test::kDt}, std::span<Flyer* const>(all));
      for (const Flyer& flyer : flyers)
        ran_dry += flyer.ran_dry;
    }
  }

  std::array<PointMass, 2> models;
  Reference reference{{.latitude = radians(40), .longitude = radians(10)}};
  Environment environment{{.wind = {{.altitude = 0, .speed = 5, .from = 1},
                                    {.altitude = 9000, .speed = 30, .from = 2}}}};
  std::vector<Route> routes{{.name = "mission",
                             .waypoints = {{.position = {30e3, 0, 0}, .altitude = 6000},
                                           {.position = {-30e3, 9e3, 0}, .altitude = 3000}},
                             .end = RouteEnd::repeat}};
  std::vector<Row> rows;
  int ran_dry = 0;
};

template <class Real>
void in_groups(const Sky& sky, std::span<Flyer* const> flyers) {
  for (std::size_t i = 0; i < flyers.size(); i += math::kLanes<Real>)
    fly_abreast<Real>(sky, &flyers[i]);
}

void expect_same(const Crowd& a, const Crowd& b) {
  for (std::size_t i = 0; i < Crowd::kSize; ++i) {
    const auto &x = a.rows[i], &y = b.rows[i];
    EXPECT_EQ(std::memcmp(&x.kinematics, &y.kinematics, sizeof x.kinematics), 0) << i;
    EXPECT_EQ(std::memcmp(&x.propulsion, &y.propulsion, sizeof x.propulsion), 0) << i;
    EXPECT_EQ(std::memcmp(&x.flying, &y.flying, sizeof x.flying), 0) << i;
    EXPECT_TRUE(std::isfinite(norm(x.kinematics.position))) << i;
  }
  EXPECT_EQ(a.ran_dry, b.ran_dry);
}

TEST(Abreast, FliesInLanesAsItFliesAlone) {
  Crowd alone, pairs;
  alone.fly(60, in_groups<double>);
  pairs.fly(60, in_groups<math::Lanes<2>>);
  EXPECT_GE(alone.ran_dry, 1) << "one must run dry for the test to be about that too";
  expect_same(alone, pairs);
}

TEST(Abreast, FliesInTheLanesOfThisProcessorAsItFliesAlone) {
  Crowd alone;
  alone.fly(60, in_groups<double>);
  for (const std::size_t size : {Crowd::kSize, std::size_t{7}, std::size_t{1}}) {
    Crowd parts;
    parts.fly(60, [&](const Sky& sky, std::span<Flyer* const> flyers) {
      flight::fly(sky, flyers.first(size));
      flight::fly(sky, flyers.subspan(size));
    });
    expect_same(alone, parts);
  }
}

}  // namespace
}  // namespace eyrie::model::flight
