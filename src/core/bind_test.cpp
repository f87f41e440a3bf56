// SPDX-License-Identifier: MIT
#include "core/bind.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <optional>
#include <string>
#include <vector>

namespace eyrie {
namespace bound {

enum class Mode : std::uint8_t { hold, follow };

struct Point {
  static constexpr std::string_view type_name = "waypoint";
  double altitude = 0, speed = 100;
  bool operator==(const Point&) const = default;
  static constexpr auto params() {
    return std::tuple{param("altitude", &Point::altitude, "m", range(0, 20e3), "height").required(),
                      param("speed", &Point::speed, "m/s", positive(), "speed")};
  }
};

struct BreakTurn {
  static constexpr std::string_view type_name = "break_turn";
  double vote = 1, danger_range = si(2, "nmi"), bank = 0;
  float gain = 1;
  std::int8_t steps = 1;
  std::uint64_t seed = 7;
  bool armed = true;
  std::string label = "none";
  Mode mode = Mode::hold;
  Vec3 offset;
  std::array<int, 2> pair{1, 2};
  std::vector<double> times{5};
  std::vector<bool> flags;
  std::vector<std::vector<Point>> routes;
  std::optional<double> delay = 9;
  Point home{.altitude = 1};
  std::optional<Point> tanker;

  static constexpr auto params() {
    using T = BreakTurn;
    return std::tuple{
        param("vote", &T::vote, range(0, 1000), "how strongly"),
        param("danger_range", &T::danger_range, "m", range(0, 50e3), "inside this range, break"),
        param("bank", &T::bank, "rad", range(-kPi / 3, kPi / 3), "angle of bank"),
        param("gain", &T::gain, positive(), "gain"),
        param("steps", &T::steps, at_least(-100), "steps"),
        param("seed", &T::seed, "seed"),
        param("armed", &T::armed, "armed"),
        param("label", &T::label, "label"),
        param("mode", &T::mode, "mode"),
        param("offset", &T::offset, "m", range(-1e4, 1e4), "offset"),
        param("pair", &T::pair, range(0, 9), "two numbers"),
        param("times", &T::times, "s", at_least(0), "times").items(1, 3),
        param("flags", &T::flags, "switches"),
        param("routes", &T::routes, "routes"),
        param("delay", &T::delay, "s", "delay"),
        param("home", &T::home, "home"),
        param("tanker", &T::tanker, "tanker"),
    };
  }
};

}  // namespace bound

template <>
struct EnumNames<bound::Mode> {
  static constexpr std::array names{
      std::pair<std::string_view, bound::Mode>{"hold", bound::Mode::hold},
      std::pair<std::string_view, bound::Mode>{"follow", bound::Mode::follow}};
};

namespace bound {
namespace {

Value quoted(std::string text) {
  Value value = Value::scalar(std::move(text));
  value.quoted = true;
  return value;
}

Value text(std::string t, int line = 1, int column = 1) {
  return Value::scalar(std::move(t), {"f.yaml", line, column});
}
Value list(std::vector<Value> items, int line = 1) {
  return Value::list(std::move(items), {"f.yaml", line, 1});
}
Value map(std::vector<Value::Entry> entries, int line = 1) {
  return Value::map(std::move(entries), {"f.yaml", line, 1});
}

/// What one parameter becomes, or the error without its place.
template <class Member>
std::string bind_one(std::string name, Member BreakTurn::*member, Value value) {
  BreakTurn out;
  Diagnostics found;
  value.where = {};
  const bool good = bind(out, Value::map({entry(std::move(name), std::move(value))}), found);
  EXPECT_EQ(good, found.ok());
  if (!good) {
    EXPECT_EQ(out.*member, BreakTurn{}.*member) << "a mistake must leave the default";
    return found.text();
  }
  if constexpr (std::is_arithmetic_v<Member>)
    return fmt::format("{}", out.*member);
  else
    return "bound";
}

TEST(Bind, ReadsEveryKindOfParameter) {
  BreakTurn out;
  Diagnostics found;
  Value null = Value::null();
  null.text = "null";
  const Value waypoint = map({entry("altitude", "5 km")});
  const Value document = map({
      entry("vote", "3"),
      entry("danger_range", "1 nmi"),
      entry("bank", "-60 deg"),
      entry("gain", "0.5"),
      entry("steps", "-100"),
      entry("seed", "18446744073709551615"),
      entry("armed", "false"),
      entry("label", "two words"),
      entry("mode", "follow"),
      entry("offset", list({text("6000 ft"), text("0"), text("-1 km")})),
      entry("pair", list({text("+8"), text("9")})),
      entry("times", list({text("1 min"), text("2 s")})),
      entry("flags", list({text("true"), text("false")})),
      entry("routes", list({list({waypoint, waypoint}), list({})})),
      entry("delay", null),
      entry("home", map({entry("altitude", "100 ft"), entry("speed", "360 km/h")})),
      entry("tanker", waypoint),
  });
  ASSERT_TRUE(bind(out, document, found)) << found.text();
  EXPECT_EQ(out.vote, 3);
  EXPECT_EQ(out.danger_range, 1852);
  EXPECT_EQ(out.bank, -kPi / 3);
  EXPECT_EQ(out.gain, 0.5f);
  EXPECT_EQ(out.steps, -100);
  EXPECT_EQ(out.seed, 18446744073709551615u);
  EXPECT_FALSE(out.armed);
  EXPECT_EQ(out.label, "two words");
  EXPECT_EQ(out.mode, Mode::follow);
  EXPECT_EQ(out.offset, (Vec3{1828.8, 0, -1000}));
  EXPECT_EQ(out.pair, (std::array{8, 9}));
  EXPECT_EQ(out.times, (std::vector<double>{60, 2}));
  EXPECT_EQ(out.flags, (std::vector<bool>{true, false}));
  ASSERT_EQ(out.routes.size(), 2u);
  EXPECT_EQ(out.routes[0].at(1).altitude, 5000);
  EXPECT_EQ(out.delay, std::nullopt);
  EXPECT_EQ(out.home.altitude, 30.48);
  EXPECT_EQ(out.home.speed, 100);
  ASSERT_TRUE(out.tanker);
  EXPECT_EQ(out.tanker->altitude, 5000);
}

TEST(Bind, TakesNullForNothingButNotNothing) {
  EXPECT_EQ(bind_one("delay", &BreakTurn::delay, Value::null()),
            "delay: expected a time such as '3 min', got nothing");
}

TEST(Bind, KeepsDefaultsOfWhatIsNotGiven) {
  BreakTurn out;
  Diagnostics found;
  EXPECT_TRUE(bind(out, Value::map({}), found));
  EXPECT_EQ(out.vote, 1);
  EXPECT_EQ(out.delay, 9);
  EXPECT_EQ(out.home.altitude, 1);
}

TEST(Bind, NumbersMustHaveTheRightUnitAndRange) {
  const auto range_of = [](std::string t) {
    return bind_one("danger_range", &BreakTurn::danger_range, Value::scalar(std::move(t)));
  };
  EXPECT_EQ(range_of("50 km"), "50000");
  EXPECT_EQ(range_of("51 km"), "danger_range: 51 km is outside [0 m, 50 km]");
  EXPECT_EQ(range_of(" -1 ft "), "danger_range: -1 ft is outside [0 m, 50 km]");
  EXPECT_EQ(range_of("5"),
            "danger_range: expected a length such as '6000 ft', got '5' (without a unit)");
  EXPECT_EQ(range_of("2 kg"),
            "danger_range: expected a length such as '6000 ft', got '2 kg' (a mass)");
  EXPECT_EQ(range_of(".inf"), "danger_range: expected a length such as '6000 ft', got '.inf'");
  EXPECT_EQ(bind_one("danger_range", &BreakTurn::danger_range, quoted("1 km")), "1000");
  EXPECT_EQ(bind_one("danger_range", &BreakTurn::danger_range, Value::list({})),
            "danger_range: expected a length such as '6000 ft', got a list");
  EXPECT_EQ(bind_one("danger_range", &BreakTurn::danger_range, Value::null()),
            "danger_range: expected a length such as '6000 ft', got nothing");
}

TEST(Bind, PlainNumbersMustNotBeQuoted) {
  const auto vote = [](Value v) { return bind_one("vote", &BreakTurn::vote, std::move(v)); };
  EXPECT_EQ(vote(Value::scalar("1e3")), "1000");
  EXPECT_EQ(vote(Value::scalar("-4")), "vote: -4 is outside [0, 1000]");
  EXPECT_EQ(vote(quoted("4")), "vote: expected a plain number such as '0.5', got '4' in quotes");
  EXPECT_EQ(vote(Value::scalar("NaN")), "vote: expected a plain number such as '0.5', got 'NaN'");
  EXPECT_EQ(vote(Value::map({})), "vote: expected a plain number such as '0.5', got a map");
}

TEST(Bind, FloatsMustFitAFloat) {
  const auto gain = [](std::string t) {
    return bind_one("gain", &BreakTurn::gain, Value::scalar(std::move(t)));
  };
  EXPECT_EQ(gain("1e-3"), "0.001");
  EXPECT_EQ(gain("0"), "gain: 0 is not positive");
  EXPECT_EQ(gain("1e39"), "gain: 1e39 is too large for this parameter");
}

TEST(Bind, QuantitiesAtALimitSurviveRounding) {
  // 60 deg and a third of pi need not be the same double, but they are the same angle
  const auto bank = [](std::string t) {
    return bind_one("bank", &BreakTurn::bank, Value::scalar(std::move(t)));
  };
  EXPECT_EQ(bank("60 deg"), fmt::format("{}", kPi / 3));
  EXPECT_EQ(bank("1.0471975511965979 rad"), fmt::format("{}", kPi / 3));  // one ulp above
  EXPECT_EQ(bank("-0 deg"), "0");
  EXPECT_EQ(bank("60.001 deg"), "bank: 60.001 deg is outside [-60°, 60°]");
}

TEST(Bind, IntegersAreWholeAndFitTheirType) {
  const auto steps = [](Value v) { return bind_one("steps", &BreakTurn::steps, std::move(v)); };
  EXPECT_EQ(steps(Value::scalar("127")), "127");
  EXPECT_EQ(steps(Value::scalar("-0")), "0");
  EXPECT_EQ(steps(Value::scalar("128")), "steps: 128 is outside [-100, 127]");
  EXPECT_EQ(steps(Value::scalar("-129")), "steps: -129 is less than -100");
  EXPECT_EQ(steps(Value::scalar("-101")), "steps: -101 is less than -100");
  EXPECT_EQ(steps(Value::scalar("99999999999999999999")),
            "steps: 99999999999999999999 is outside [-100, 127]");
  for (const char* wrong : {"4.0", "4e0", "0x4", "four", "", "-", "+-4", "4 ft", "1_000"})
    EXPECT_EQ(steps(Value::scalar(wrong)),
              fmt::format("steps: expected a whole number, got '{}'", wrong));
  EXPECT_EQ(steps(quoted("4")), "steps: expected a whole number, got '4' in quotes");
  EXPECT_EQ(steps(Value::list({})), "steps: expected a whole number, got a list");
  EXPECT_EQ(bind_one("seed", &BreakTurn::seed, Value::scalar("-1")),
            "seed: -1 is outside [0, 18446744073709551615]");
  Value tagged = Value::scalar("7");
  tagged.tag = "!tree";
  EXPECT_EQ(bind_one("seed", &BreakTurn::seed, tagged), "seed: unexpected tag '!tree'");
}

TEST(Bind, BooleansAreTrueOrFalse) {
  const auto armed = [](Value v) { return bind_one("armed", &BreakTurn::armed, std::move(v)); };
  EXPECT_EQ(armed(Value::scalar("false")), "false");
  for (const char* wrong : {"yes", "True", "on", "1", "~"})
    EXPECT_EQ(armed(Value::scalar(wrong)),
              fmt::format("armed: expected true or false, got '{}'", wrong));
  EXPECT_EQ(armed(quoted("true")), "armed: expected true or false, got 'true' in quotes");
  EXPECT_EQ(armed(Value::null()), "armed: expected true or false, got nothing");
}

TEST(Bind, TextsAndChoicesSayWhatTheyWant) {
  EXPECT_EQ(bind_one("label", &BreakTurn::label, Value::null()),
            "label: expected a text, got nothing");
  EXPECT_EQ(bind_one("mode", &BreakTurn::mode, Value::scalar("folow")),
            "mode: expected one of hold, follow, got 'folow'; did you mean 'follow'?");
  EXPECT_EQ(bind_one("mode", &BreakTurn::mode, Value::map({})),
            "mode: expected one of hold, follow, got a map");
}

TEST(Bind, ListsCountAndNameTheirItems) {
  const auto times = [](Value v) { return bind_one("times", &BreakTurn::times, std::move(v)); };
  const auto second = [] { return Value::scalar("1 s"); };
  EXPECT_EQ(times(Value::scalar("1 s")), "times: expected a list, got '1 s'");
  EXPECT_EQ(times(Value::list({})), "times: expected at least 1 item, got 0");
  EXPECT_EQ(times(Value::list({second(), second(), second(), second()})),
            "times: expected at most 3 items, got 4");
  EXPECT_EQ(times(Value::list({second(), Value::scalar("-1 s")})),
            "times[1]: -1 s is less than 0 s");
  EXPECT_EQ(bind_one("pair", &BreakTurn::pair, Value::list({Value::scalar("1")})),
            "pair: expected exactly 2 items, got 1");
  EXPECT_EQ(bind_one("offset", &BreakTurn::offset, Value::list({second()})),
            "offset: expected exactly 3 items, got 1");
  EXPECT_EQ(bind_one("pair", &BreakTurn::pair, list({text("3"), text("x")})),
            "f.yaml:1:1: pair[1]: expected a whole number, got 'x'");
}

TEST(Bind, CollectsEveryMistakeAtItsOwnPlace) {
  BreakTurn out;
  Diagnostics found;
  const Value document =
      map({entry("danger_rang", "2 nmi", {"f.yaml", 2, 1}), entry("vote", "-4", {"f.yaml", 3, 7}),
           entry("home", map({entry("speed", "0 kt", {"f.yaml", 6, 10})}, 6)),
           entry("routes", list({list({map({entry("altitude", text("-1 m", 7, 20)),
                                            entry("altitud", text("1 m", 8, 30))},
                                           7)})},
                                7)),
           entry("tanker", text("none", 9, 3))});
  EXPECT_FALSE(bind(out, document, found));
  EXPECT_EQ(
      found.text(),
      "f.yaml:2:1: break_turn has no parameter 'danger_rang'; did you mean 'danger_range'?\n"
      "f.yaml:3:7: vote: -4 is outside [0, 1000]\n"
      "f.yaml:6:1: home: waypoint needs the parameter 'altitude'\n"
      "f.yaml:6:10: home.speed: 0 kt is not positive\n"
      "f.yaml:7:20: routes[0][0].altitude: -1 m is outside [0 m, 20 km]\n"
      "f.yaml:8:30: routes[0][0]: waypoint has no parameter 'altitud'; did you mean 'altitude'?\n"
      "f.yaml:9:3: tanker: expected a map, got 'none'");
  EXPECT_EQ(out.tanker.has_value(), false);
  EXPECT_TRUE(out.routes.empty());
}

TEST(Bind, LeavesKeysOfOthersToThem) {
  Point out;
  Diagnostics found;
  const Value document = map({entry("altitude", "1 m"), entry("children", Value::list({}))});
  EXPECT_TRUE(bind(out, document, found, std::array<std::string_view, 1>{"children"}));
  EXPECT_FALSE(bind(out, document, found));
  EXPECT_EQ(found.text(), "waypoint has no parameter 'children', only altitude, speed");
}

struct Plain {
  static constexpr std::string_view type_name = "level";
  static constexpr auto params() { return std::tuple{}; }
};

TEST(Bind, ReadsATypeWithoutParameters) {
  Plain out;
  Diagnostics found;
  EXPECT_TRUE(bind(out, Value::map({}), found));
  EXPECT_FALSE(bind(out, map({entry("vote", "1")}), found));
  EXPECT_EQ(found.text(), "level has no parameter 'vote'");
}

TEST(Bind, RefusesWhatIsNotAMap) {
  Point out;
  Diagnostics found;
  EXPECT_FALSE(bind(out, text("5 km", 3, 2), found));
  EXPECT_FALSE(bind(out, Value::null({"f.yaml", 4, 2}), found));
  EXPECT_EQ(found.text(),
            "f.yaml:3:2: waypoint: expected a map, got '5 km'\n"
            "f.yaml:4:2: waypoint: expected a map, got nothing");
}

/// A type of an upper layer, which reads itself.
struct Callsign {
  std::string name;
};
void bind_value(Callsign& out, const Value& value, Diagnostics& diagnostics,
                const ParamInfo& info) {
  if (value.is_scalar() && !value.text.empty())
    out.name = value.text;
  else
    diagnostics.error(value.where, info.name + ": a callsign is a word");
}
struct Flight {
  static constexpr std::string_view type_name = "flight";
  std::vector<Callsign> members;
  static constexpr auto params() {
    return std::tuple{param("members", &Flight::members, "who flies")};
  }
};

TEST(Bind, LetsATypeReadItself) {
  Flight out;
  Diagnostics found;
  EXPECT_TRUE(bind(out, map({entry("members", list({text("eagle1")}))}), found));
  EXPECT_EQ(out.members.at(0).name, "eagle1");
  EXPECT_FALSE(bind(out, map({entry("members", list({text("a"), Value::null()}))}), found));
  EXPECT_EQ(found.text(), "members[1]: a callsign is a word");
}

RC_GTEST_PROP(Bind, ReadsBackWhatTheReferencePrints,
              (std::int32_t meters, std::uint16_t thousandths)) {
  BreakTurn in;
  in.danger_range = std::abs(meters % 50000) + thousandths / 65536.0;
  in.vote = thousandths / 1000.0;
  in.steps = static_cast<std::int8_t>(meters % 100);
  Diagnostics found;
  std::vector<Value::Entry> entries;
  for (const ParamInfo& info : parameters(in))
    if (info.name == "danger_range" || info.name == "vote" || info.name == "steps")
      entries.push_back(entry(info.name, info.default_text));
  BreakTurn out;
  RC_ASSERT(bind(out, Value::map(entries), found));
  RC_ASSERT(out.danger_range == in.danger_range);
  RC_ASSERT(out.vote == in.vote);
  RC_ASSERT(out.steps == in.steps);
}

}  // namespace
}  // namespace bound
}  // namespace eyrie
