// SPDX-License-Identifier: MIT
#include "pilot/policy/observation.hpp"

#include <gtest/gtest.h>

#include "core/math.hpp"
#include "support/no_allocation.hpp"
#include "support/pilot/testing.hpp"

namespace eyrie::pilot {
namespace {

using namespace pilot::testing;

std::vector<float> seen(const Observation& observation, const Desk& desk) {
  std::vector<float> numbers(observation.size(), 99);
  observation.write(desk.state(), numbers.data());
  return numbers;
}
std::vector<float> seen(std::string_view text, const Desk& desk) {
  return seen(Observation(text), desk);
}

TEST(Observation, MapsARangeToMinusOneToOneAndStaysThereBeyondIt) {
  Desk desk;
  EXPECT_EQ(seen("altitude linear 0 m 16 km", desk), std::vector<float>{0});
  EXPECT_EQ(seen("altitude linear 6 km 8 km\naltitude linear 9 km 10 km", desk),
            (std::vector<float>{1, -1}));
  EXPECT_EQ(seen("speed linear 200 m/s 300 m/s\nmach linear 0 2", desk)[0], 0);
  desk.flying.energy.available = std::numeric_limits<float>::infinity();
  EXPECT_EQ(seen("available linear 0 9", desk), std::vector<float>{1});
}

TEST(Observation, IsZeroWhereThereIsNoValue) {
  Desk desk;
  constexpr std::string_view kText =
      "range linear 0 m 10 km\ntarget_right sine\ntarget_right cosine\nrange present\n";
  EXPECT_EQ(seen(kText, desk), (std::vector<float>{0, 0, 0, 0}));
  desk.track({0, -5e3, 0});
  const std::vector<float> numbers = seen(kText, desk);
  EXPECT_NEAR(numbers[0], 0, 1e-6);
  EXPECT_NEAR(numbers[1], -1, 1e-6) << "on the left";
  EXPECT_NEAR(numbers[2], 0, 1e-6);
  EXPECT_EQ(numbers[3], 1);
}

TEST(Observation, ReadsBackItsText) {
  const Observation observation(
      "\n  range   linear 0 m 40 nmi\r\ntarget_right linear -180 deg 180 deg\n\n"
      "target_right sine\nmissile_range present\nmach linear -.5 2e0\naltitude linear 0 36000 ft");
  EXPECT_EQ(observation.text(),
            "range linear 0 m 40 nmi\ntarget_right linear -180 deg 180 deg\ntarget_right sine\n"
            "missile_range present\nmach linear -0.5 2\naltitude linear 0 m 36000 ft\n");
  EXPECT_EQ(Observation(observation.text()).text(), observation.text());
  EXPECT_EQ(Observation(observation.text()).hash(), observation.hash());
  EXPECT_NE(Observation("mach linear 0 2").hash(), Observation("mach linear 0 3").hash());
  EXPECT_EQ(Observation("mach linear 0 2").hash(), 12550703580809052284U) << "files hold it";
}

TEST(Observation, SaysWhereAndWhatIsWrong) {
  const auto mistakes = [](std::string_view text) -> std::string {
    try {
      Observation(text, {"seen.txt", 7, 1});
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(mistakes("mach linear 0 2\nrnge linear 0 m 1 m\nroll tangent\nmach sine\n"),
            "seen.txt:8:1: there is no state field 'rnge'; did you mean 'range'?\n"
            "seen.txt:9:6: expected linear, sine, cosine or present, got 'tangent'\n"
            "seen.txt:10:6: 'mach' is no angle: sine is for angles");
  EXPECT_EQ(mistakes("roll"),
            "seen.txt:7:5: expected linear, sine, cosine or present behind the name, got the end");
  EXPECT_EQ(mistakes("range linear 5 m"),
            "seen.txt:7:17: expected two numbers from less to more, such as 6000 ft, got the end");
  EXPECT_EQ(mistakes("range linear 5 m 5 m"), "seen.txt:7:18: the range must go from less to more");
  EXPECT_EQ(mistakes("range linear 0 m 5 kt"),
            "seen.txt:7:18: expected a length such as '6000 ft', got '5 kt' (a speed)");
  EXPECT_EQ(mistakes("mach linear 0 1 x"),
            "seen.txt:7:15: expected a plain number such as '0.5', got '1 x'");
  EXPECT_EQ(mistakes("roll sine 3"), "seen.txt:7:11: expected the end of the line, got '3'");
  EXPECT_EQ(mistakes(" \n"), "seen.txt:7:1: there is no line in it");
  std::string many;
  for (int i = 0; i < 1025; ++i)
    many += "roll sine\n";
  EXPECT_EQ(mistakes(many), "seen.txt:7:1: more than 1024 lines");
}

TEST(Observation, AllocatesNothing) {
  Desk desk;
  desk.track({5e3, 0, 0});
  desk.threat(1, 5e3);
  std::string text;
  for (const auto& field : ubf::StateFields<State>::all())
    text += std::string(field.info.name) + " present\n";
  const Observation observation(text);
  std::vector<float> numbers(observation.size());
  const State state = desk.state();
  const NoAllocation guard;
  observation.write(state, numbers.data());
}

}  // namespace
}  // namespace eyrie::pilot
