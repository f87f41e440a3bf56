// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/bind.hpp"

namespace eyrie {
namespace {

struct Engine {
  static constexpr std::string_view type_name = "engine";
  Table1 drag = Table1::constant(7);
  Table2 thrust = Table2::constant(7);
  static constexpr auto params() {
    return std::tuple{
        param("drag", &Engine::drag, axis("mach", "1"), "1", range(0, 1), "drag coefficient"),
        param("thrust", &Engine::thrust, axis("mach", "1"), axis("altitude", "m"), "N", at_least(0),
              "full thrust")};
  }
};

/// "1|2|3" as a list of scalars; all on one line, one column apart.
Value numbers(std::string_view words, int line = 1) {
  std::vector<Value> items;
  while (!words.empty()) {
    const std::size_t end = std::min(words.find('|'), words.size());
    items.push_back(Value::scalar(std::string(words.substr(0, end)),
                                  {"f.yaml", line, static_cast<int>(items.size()) + 1}));
    words.remove_prefix(std::min(end + 1, words.size()));
  }
  return Value::list(std::move(items), {"f.yaml", line, 0});
}

Value map(std::vector<Value::Entry> entries, int line = 1) {
  return Value::map(std::move(entries), {"f.yaml", line, 0});
}

/// The errors of a document, "" if it binds. After an error the tables are as they were.
std::string errors(Engine& engine, std::string key, Value table) {
  Diagnostics found;
  bind(engine, Value::map({entry(std::move(key), std::move(table))}), found);
  if (!found.ok()) {
    EXPECT_EQ(engine.drag, Table1::constant(7));
    EXPECT_EQ(engine.thrust, Table2::constant(7));
  }
  return found.text();
}
std::string errors(std::string key, Value table) {
  Engine engine;
  return errors(engine, std::move(key), std::move(table));
}

TEST(BindTable, ReadsATableOfOneVariable) {
  Engine engine;
  EXPECT_EQ(
      errors(engine, "drag",
             map({entry("mach", numbers("0|0.9|1.2")), entry("value", numbers("0.02|0.03|0.06"))})),
      "");
  EXPECT_EQ(engine.drag, Table1({0, 0.9, 1.2}, {0.02, 0.03, 0.06}));
}

TEST(BindTable, ReadsATableOfTwoVariablesRowByRow) {
  Engine engine;
  EXPECT_EQ(
      errors(engine, "thrust",
             map({entry("mach", numbers("0|0.9")), entry("altitude", numbers("0|10000 ft|11 km")),
                  entry("value",
                        Value::list({numbers("80 kN|60 kN|20 kN"), numbers("90 kN|70 kN|0")}))})),
      "");
  EXPECT_EQ(engine.thrust, Table2({0, 0.9}, {0, 3048, 11000}, {80e3, 60e3, 20e3, 90e3, 70e3, 0}));
}

TEST(BindTable, GivesAWholeAxisItsUnit) {
  Engine engine;
  EXPECT_EQ(
      errors(engine, "thrust",
             map({entry("units", map({entry("altitude", "ft"), entry("value", "lbf")})),
                  entry("mach", numbers("0|0.9")), entry("altitude", numbers("0|10000|30000")),
                  entry("value", Value::list({numbers("10|20|30"), numbers("40|50|60")}))})),
      "");
  EXPECT_EQ(engine.thrust, Table2({0, 0.9}, {0, 3048, 9144},
                                  {si(10, "lbf"), si(20, "lbf"), si(30, "lbf"), si(40, "lbf"),
                                   si(50, "lbf"), si(60, "lbf")}));
}

TEST(BindTable, SaysWhichPartIsMissingOrUnknown) {
  EXPECT_EQ(errors("drag", map({entry("mach", numbers("0"))}, 4)),
            "f.yaml:4: drag: the table needs the parameter 'value'");
  EXPECT_EQ(errors("drag", map({})),
            "f.yaml:1: drag: the table needs the parameter 'mach'\n"
            "f.yaml:1: drag: the table needs the parameter 'value'");
  EXPECT_EQ(errors("drag", map({entry("mach", numbers("0", 2)), entry("values", numbers("0", 3)),
                                entry("value", numbers("0", 4))})),
            "f.yaml:3: drag: the table has no parameter 'values'; did you mean 'value'?");
  EXPECT_EQ(errors("drag", Value::scalar("0.02", {"f.yaml", 4, 2})),
            "f.yaml:4:2: drag: expected a table, got '0.02'");
  EXPECT_EQ(errors("drag", Value::null({"f.yaml", 4, 2})),
            "f.yaml:4:2: drag: expected a table, got nothing");
}

TEST(BindTable, PointsAtTheNumberThatIsWrong) {
  EXPECT_EQ(errors("drag", map({entry("mach", numbers("0|0.9|0.9", 2)),
                                entry("value", numbers("0.1|0.2|0.3", 3))})),
            "f.yaml:2:3: drag.mach[2]: 0.9 is not above 0.9: breakpoints must increase");
  EXPECT_EQ(
      errors("drag", map({entry("mach", numbers("0|x", 2)), entry("value", numbers("0.1|2", 3))})),
      "f.yaml:2:2: drag.mach[1]: expected a plain number such as '0.5', got 'x'\n"
      "f.yaml:3:2: drag.value[1]: 2 is outside [0, 1]");
  EXPECT_EQ(
      errors("thrust",
             map({entry("mach", numbers("0|1", 2)), entry("altitude", numbers("0|1 kg", 3)),
                  entry("value", Value::list({numbers("0|0", 4), numbers("0|-1 N", 5)}))})),
      "f.yaml:3:2: thrust.altitude[1]: expected a length such as '6000 ft', got '1 kg' (a mass)\n"
      "f.yaml:5:2: thrust.value[1][1]: -1 N is less than 0 N");
}

TEST(BindTable, ChecksTheShapeOfTheValues) {
  EXPECT_EQ(errors("drag", map({entry("mach", numbers("0|1")), entry("value", numbers("0.5", 3))})),
            "f.yaml:3: drag.value: expected exactly 2 items, got 1");
  EXPECT_EQ(errors("drag", map({entry("mach", numbers("", 2)), entry("value", numbers(""))})),
            "f.yaml:2: drag.mach: expected at least 1 item, got 0");
  EXPECT_EQ(
      errors("drag", map({entry("mach", "0.5", {"f.yaml", 2, 3}), entry("value", numbers(""))})),
      "f.yaml:2:3: drag.mach: expected a list, got '0.5'");
  const auto thrust = [](std::vector<Value> rows) {
    return errors("thrust",
                  map({entry("mach", numbers("0|1")), entry("altitude", numbers("0|1 km|2 km")),
                       entry("value", Value::list(std::move(rows), {"f.yaml", 4, 0}))}));
  };
  EXPECT_EQ(thrust({numbers("0|0|0", 5)}),
            "f.yaml:4: thrust.value: expected exactly 2 items, got 1");
  EXPECT_EQ(thrust({numbers("0|0|0", 5), numbers("0|0", 6)}),
            "f.yaml:6: thrust.value[1]: expected exactly 3 items, got 2");
  EXPECT_EQ(thrust({numbers("0|0|0", 5), Value::scalar("0", {"f.yaml", 6, 2})}),
            "f.yaml:6:2: thrust.value[1]: expected a list, got '0'");
}

TEST(BindTable, ChecksTheSharedUnits) {
  const auto with = [](Value units, std::string_view altitudes) {
    return errors("thrust", map({entry("units", std::move(units)), entry("mach", numbers("0|1")),
                                 entry("altitude", numbers(altitudes, 3)),
                                 entry("value", Value::list({numbers("0|0"), numbers("0|0")}))}));
  };
  const auto one = [](std::string key, std::string unit) {
    return map({entry(std::move(key), std::move(unit), {"f.yaml", 2, 9})}, 2);
  };
  EXPECT_EQ(
      with(one("altitude", "feet"), "0|1"),
      "f.yaml:2:9: thrust.units.altitude: expected the unit of a length, such as 'm', got 'feet'\n"
      "f.yaml:3:2: thrust.altitude[1]: expected a length such as '6000 ft', got '1' (without a "
      "unit)");
  EXPECT_EQ(with(one("mach", "m/s"), "0|1 km"),
            "f.yaml:2:9: thrust.units.mach: these are plain numbers and have no unit, got 'm/s'");
  EXPECT_EQ(with(one("altitud", "ft"), "0|1 km"),
            "f.yaml:2:9: thrust.units: units has no parameter 'altitud'; did you mean 'altitude'?");
  EXPECT_EQ(with(one("altitude", "ft"), "0|1 km"),
            "f.yaml:3:2: thrust.altitude[1]: expected a plain number such as '0.5', got '1 km' (a "
            "length)");
  EXPECT_EQ(with(Value::scalar("ft", {"f.yaml", 2, 9}), "0|1 km"),
            "f.yaml:2:9: thrust.units: expected a map, got 'ft'");
}

TEST(BindTable, ReportsSharedUnitsInTheirOwnUnit) {
  EXPECT_EQ(errors("thrust", map({entry("units", map({entry("value", "lbf")})),
                                  entry("mach", numbers("0")), entry("altitude", numbers("0")),
                                  entry("value", Value::list({numbers("-5", 4)}))})),
            "f.yaml:4:1: thrust.value[0][0]: -5 lbf is less than 0 N");
}

TEST(BindTable, LeavesTheRestToTheTable) {
  const std::vector<double> far{-1.7e308, 1.7e308}, values{0, 0};
  EXPECT_EQ(
      errors("drag",
             map({entry("mach", numbers("-1.7e308|1.7e308")), entry("value", numbers("0|0"))}, 5)),
      "f.yaml:5: drag: " + Table1::problem(far, values).value());
}

}  // namespace
}  // namespace eyrie
