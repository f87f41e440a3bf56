// SPDX-License-Identifier: MIT
#include "core/describe.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace eyrie {
namespace test {

enum class Gear : std::uint8_t { up, down };

}  // namespace test

template <>
struct EnumNames<test::Gear> {
  using G = test::Gear;
  static constexpr std::array names{std::pair<std::string_view, G>{"up", G::up},
                                    std::pair<std::string_view, G>{"down", G::down}};
};

namespace {

using test::Gear;

struct Wing {
  double span = 10;
  std::optional<double> sweep;

  static constexpr std::string_view type_name = "wing";
  static constexpr std::string_view help = "a wing";
  static constexpr auto params() {
    return std::tuple{param("span", &Wing::span, "m", "from tip to tip"),
                      param("sweep", &Wing::sweep, "rad", "null: straight")};
  }
};

struct Glider {
  std::string label = "glider";
  double mass = 300;
  float fraction = 0.5F;
  int seats = 1;
  bool motor = false;
  Gear gear = Gear::up;
  Vec3 center;
  Table1 polar{{0, 1}, {2, 3}};
  Table2 lift{{0, 1}, {0, 1}, {2, 3, 4, 5}};
  Wing wing;
  std::vector<double> ballast{1, 2};
  std::array<double, 2> tanks{0, 0};
  std::vector<Wing> spare{Wing{}};

  static constexpr std::string_view type_name = "glider";
  static constexpr std::string_view help = "a glider";
  static constexpr auto params() {
    using G = Glider;
    return std::tuple{
        param("label", &G::label, "name"),
        param("mass", &G::mass, "kg", "empty"),
        param("fraction", &G::fraction, range(0, 1), "of something"),
        param("seats", &G::seats, range(1, 2), "for people"),
        param("motor", &G::motor, "whether it has one"),
        param("gear", &G::gear, "where it is"),
        param("center", &G::center, "m", "of mass"),
        param("polar", &G::polar, axis("speed", "m/s"), "m/s", any(), "sink"),
        param("lift", &G::lift, axis("mach", {}), axis("alpha", "rad"), {}, any(), "coefficient"),
        param("wing", &G::wing, "its wing"),
        param("ballast", &G::ballast, "kg", "in bags"),
        param("tanks", &G::tanks, "kg", "left and right"),
        param("spare", &G::spare, "wings in the trailer")};
  }
};

TEST(ParameterBits, DifferWhenTheLastBitOfAnyParameterDoes) {
  const auto next = [](auto x) {
    return std::nextafter(x, std::numeric_limits<decltype(x)>::max());
  };
  std::set<std::string> seen{parameter_bits(Glider{})};
  std::size_t tried = 1;
  const auto changed = [&](auto change) {
    Glider g;
    change(g);
    seen.insert(parameter_bits(g));
    ++tried;
  };
  changed([&](Glider& g) { g.mass = next(g.mass); });
  changed([&](Glider& g) { g.fraction = next(g.fraction); });
  changed([&](Glider& g) { g.seats = 2; });
  changed([&](Glider& g) { g.motor = true; });
  changed([&](Glider& g) { g.gear = Gear::down; });
  changed([&](Glider& g) { g.center.x = next(0.0); });
  changed([&](Glider& g) { g.center.y = next(0.0); });
  changed([&](Glider& g) { g.center.z = -0.0; });
  changed([&](Glider& g) { g.polar = Table1({0, next(1.0)}, {2, 3}); });
  changed([&](Glider& g) { g.polar = Table1({0, 1}, {2, next(3.0)}); });
  changed([&](Glider& g) { g.lift = Table2({0, next(1.0)}, {0, 1}, {2, 3, 4, 5}); });
  changed([&](Glider& g) { g.lift = Table2({0, 1}, {0, next(1.0)}, {2, 3, 4, 5}); });
  changed([&](Glider& g) { g.lift = Table2({0, 1}, {0, 1}, {2, 3, 4, next(5.0)}); });
  changed([&](Glider& g) { g.wing.span = next(g.wing.span); });
  changed([&](Glider& g) { g.wing.sweep = 0; });
  changed([&](Glider& g) { g.wing.sweep = next(0.0); });
  changed([&](Glider& g) { g.ballast = {1, next(2.0)}; });
  changed([&](Glider& g) { g.ballast = {1}; });
  changed([&](Glider& g) { g.tanks[1] = next(0.0); });
  changed([&](Glider& g) { g.spare[0].span = 11; });
  changed([&](Glider& g) { g.spare.clear(); });
  EXPECT_EQ(seen.size(), tried);
}

TEST(ParameterBits, LeaveTextsOut) {
  Glider renamed;
  renamed.label = "sailplane";
  EXPECT_EQ(parameter_bits(renamed), parameter_bits(Glider{}));
}

}  // namespace
}  // namespace eyrie
