// SPDX-License-Identifier: MIT
#include "ubf/expression.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <functional>

#include "support/ubf/testing.hpp"

namespace eyrie::ubf::testing {
namespace {

/// What is said of an expression that starts at column 7; empty if it is good.
std::string said_of(const std::string& text, bool quoted = false,
                    const std::vector<StateFieldInfo>& infos = state_field_infos<State>()) {
  FieldNames names;
  Diagnostics diagnostics;
  const Location where{"t.yaml", 3, 7};
  Value value = Value::scalar(text, where);
  value.quoted = quoted;
  const auto program = parse_expression(value, infos, names, diagnostics);
  EXPECT_EQ(program.has_value(), diagnostics.ok());
  return diagnostics.text();
}
bool holds(const std::string& text, const State& state) {
  const auto infos = state_field_infos<State>();
  FieldNames names;
  Diagnostics diagnostics;
  const auto program = parse_expression(Value::scalar(text), infos, names, diagnostics);
  EXPECT_TRUE(program) << diagnostics.text();
  return program && Expression<State>(*program).holds(state);
}

TEST(Expression, ComparesFieldsWithQuantitiesFieldsAndChoices) {
  const State s{.range = 9 * 1852., .altitude = 3000, .count = 2, .alarm = true, .phase = 1};
  EXPECT_TRUE(holds("range < 10 nmi", s));
  EXPECT_FALSE(holds("range < 9nmi", s));
  EXPECT_TRUE(holds("range <= 9 nmi", s));
  EXPECT_TRUE(holds("10 nmi > range", s));
  EXPECT_TRUE(holds("count == 2", s));
  EXPECT_FALSE(holds("count != 2", s));
  EXPECT_TRUE(holds("count >= -1.5e0", s));
  EXPECT_TRUE(holds("altitude < range", s));
  EXPECT_TRUE(holds("alarm", s));
  EXPECT_FALSE(holds("not alarm", s));
  EXPECT_TRUE(holds("phase == fetch", s));
  EXPECT_TRUE(holds("home != phase", s));
  EXPECT_TRUE(holds("  ( not (not alarm) )  ", s));
}

TEST(Expression, AndBindsTighterThanOrAndNotTightest) {
  State s{.range = 1, .count = 1, .alarm = true};
  EXPECT_TRUE(holds("alarm or count == 2 and count == 3", s));
  EXPECT_FALSE(holds("(alarm or count == 2) and count == 3", s));
  s.alarm = false;
  EXPECT_TRUE(holds("not alarm and count == 1", s));
  EXPECT_FALSE(holds("not (alarm or count == 1)", s));
}

TEST(Expression, NoComparisonHoldsOfWhatHasNoValue) {
  const State s{.range = kNoValue};
  for (const char* text : {"range < 1 m", "range <= 1 m", "range > 1 m", "range >= 1 m",
                           "range == 1 m", "range != 1 m", "range == range"})
    EXPECT_FALSE(holds(text, s)) << text;
  EXPECT_TRUE(holds("not range < 1 m", s));
}

/// Random expressions against plain recursion over what they were made of.
struct Formula {
  std::string text;
  std::function<bool(const State&)> value;
};
Formula formula(int depth) {
  const auto flip = [] { return *rc::gen::inRange(0, 2) == 1; };
  switch (depth > 0 ? *rc::gen::inRange(0, 5) : 0) {
    case 1: {
      const Formula f = formula(depth - 1);
      return {"not (" + f.text + ")", [f](const State& s) { return !f.value(s); }};
    }
    case 2:
    case 3: {
      const Formula a = formula(depth - 1), b = formula(depth - 1);
      return {"(" + a.text + ") and (" + b.text + ")",
              [a, b](const State& s) { return a.value(s) && b.value(s); }};
    }
    case 4: {
      const Formula a = formula(depth - 1), b = formula(depth - 1);
      return {"(" + a.text + ") or " + b.text + " or alarm",
              [a, b](const State& s) { return a.value(s) || b.value(s) || s.alarm; }};
    }
    default: {
      const int n = *rc::gen::inRange(-2, 3);
      if (flip())
        return {fmt::format("count < {}", n), [n](const State& s) { return s.count < n; }};
      return {fmt::format("{} m <= range", n), [n](const State& s) { return n <= s.range; }};
    }
  }
}
RC_GTEST_PROP(Expression, MeansWhatRecursionWouldSay, ()) {
  const Formula f = formula(4);
  State s{.range = static_cast<double>(*rc::gen::inRange(-3, 4)),
          .count = static_cast<double>(*rc::gen::inRange(-3, 4)),
          .alarm = *rc::gen::inRange(0, 2) == 1};
  if (*rc::gen::inRange(0, 4) == 0)
    s.range = kNoValue;
  RC_ASSERT(holds(f.text, s) == f.value(s));
}

TEST(Expression, MistakesAreSaidWithTheirColumnAndTheNearestName) {
  EXPECT_EQ(said_of("rang < 10 nmi"),
            "t.yaml:3:7: there is no state field 'rang'; did you mean 'range'?");
  EXPECT_EQ(said_of("alarm and rang < 10 nmi", true),
            "t.yaml:3:18: there is no state field 'rang'; did you mean 'range'?");
  EXPECT_EQ(said_of("r\xD0\xB0nge < 10 nmi"),
            "t.yaml:3:7: there is no state field 'r\xD0\xB0nge' (with the character U+0430), only "
            "range, altitude, count, alarm, phase");
  EXPECT_EQ(said_of("range < 10 kg"),
            "t.yaml:3:15: range: expected a length such as '6000 ft', got '10 kg' (a mass)");
  EXPECT_EQ(said_of("range"),
            "t.yaml:3:7: 'range' is not true or false: compare it, as in range < 6000 ft");
  EXPECT_EQ(said_of("alarm < 3"), "t.yaml:3:7: 'alarm' is true or false: write alarm or not alarm");
  EXPECT_EQ(said_of("phase == fetsh"),
            "t.yaml:3:16: 'phase' is never 'fetsh'; did you mean 'fetch'?");
  EXPECT_EQ(said_of("phase < home"),
            "t.yaml:3:7: 'phase' is one of several: compare it with == or !=");
  EXPECT_EQ(said_of("range = 3 m"), "t.yaml:3:13: write '==' to compare");
  EXPECT_EQ(said_of("range => 3 m"), "t.yaml:3:13: write '>=' for '=>'");
  EXPECT_EQ(said_of("range \u2264 3 m"), "t.yaml:3:13: write '<=' for '\u2264'");
  EXPECT_TRUE(looks_like_expression("range \u2265 3 m"));
  EXPECT_EQ(said_of("range < altitude < 3 m"),
            "t.yaml:3:24: compare two things at a time, as in 1 nmi < range and range < 10 nmi");
  EXPECT_EQ(said_of("range < count"), "t.yaml:3:15: 'count' cannot be compared with 'range'");
  EXPECT_EQ(said_of("(alarm"), "t.yaml:3:7: there is no ')' for this '('");
  EXPECT_EQ(said_of("alarm)"), "t.yaml:3:12: there is no '(' for this ')'");
  EXPECT_EQ(said_of("alarm and"), "t.yaml:3:16: expected a state field or a quantity, got the end");
  EXPECT_EQ(said_of("alarm alarm"), "t.yaml:3:13: expected 'and', 'or' or the end, got 'alarm'");
  EXPECT_EQ(said_of("alarm andd alarm"),
            "t.yaml:3:13: expected 'and', 'or' or the end, got 'andd'; did you mean 'and'?");
  EXPECT_EQ(said_of("1 m < 2 m"), "t.yaml:3:7: neither side is a state field");
  EXPECT_EQ(said_of(""), "t.yaml:3:7: expected a state field or a quantity, got the end");
  EXPECT_EQ(said_of(std::string(40, '(')), "t.yaml:3:40: nested more than 32 deep");
}

TEST(Expression, AsksForNoDirectionThatAFieldNeverHas) {
  const std::vector heading{
      FieldsOf<State>::angle("heading", "own", [](const State&) { return 0.; }).info};
  EXPECT_EQ(said_of("heading > 270 deg", false, heading),
            "t.yaml:3:17: 'heading' is from -180 deg to 180 deg, never 270 deg: that is -90 deg");
  EXPECT_EQ(said_of("-3.2 rad < heading", false, heading).find("t.yaml:3:7: 'heading' is from"), 0);
  for (const char* good : {"heading <= 180 deg", "heading > -180°", "heading == heading"})
    EXPECT_EQ(said_of(good, false, heading), "");
}

TEST(Expression, AnyTextIsReadOrRefused) {
  rc::check("any text", [](const std::string& text) { said_of(text); });
  rc::check("any words", [] {
    const auto words = *rc::gen::container<std::vector<std::string>>(
        rc::gen::element<std::string>("not", "and", "or", "(", ")", "<", ">=", "range", "alarm",
                                      "3 m", "-", "e", "phase", "home", "==", "$", "1e"));
    std::string text;
    for (const std::string& word : words)
      text += word + " ";
    said_of(text);
  });
}

}  // namespace
}  // namespace eyrie::ubf::testing
