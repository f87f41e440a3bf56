// SPDX-License-Identifier: MIT
#include "core/describe.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "core/bind.hpp"
#include "support/description_mistakes.hpp"

namespace eyrie {
namespace described {

enum class Turn : std::uint8_t { level, slice };

struct Leg {
  static constexpr std::string_view type_name = "leg";
  static constexpr std::string_view help = "one leg of a route";
  double altitude = 6096;
  std::optional<float> speed;

  static constexpr auto params() {
    return std::tuple{param("altitude", &Leg::altitude, "m", at_least(0), "height to fly"),
                      param("speed", &Leg::speed, "m/s", positive(), "speed to fly")};
  }
};

class Everything {
 public:
  static constexpr std::string_view type_name = "everything";
  static constexpr std::string_view help = "one parameter of every kind";

  static constexpr auto params() {
    using T = Everything;
    return std::tuple{
        param("range", &T::range_, "m", range(0, 50e3), "break inside"),
        param("gain", &T::gain_, "a plain number of any size").required(),
        param("share", &T::share_, range(0, 1), "a plain number"),
        param("count", &T::count_, range(1, 8), "a whole number"),
        param("on", &T::on_, "a switch"),
        param("label", &T::label_, "a text"),
        param("turn", &T::turn_, "a choice"),
        param("offset", &T::offset_, "m", "a vector"),
        param("angles", &T::angles_, "rad", range(-kPi, kPi), "an array"),
        param("legs", &T::legs_, "a list of groups").items(0, 16),
        param("first", &T::first_, "a group"),
        param("delay", &T::delay_, "s", at_least(0), "an optional"),
        param("drag", &T::drag_, axis("mach", "1"), "1", at_least(0), "one variable"),
        param("thrust", &T::thrust_, axis("mach", "1"), axis("altitude", "m"), "N", at_least(0),
              "two variables"),
    };
  }

 private:
  double range_ = si(2, "nmi");
  double gain_ = 1;
  float share_ = 0.1f;
  std::uint16_t count_ = 3;
  bool on_ = true;
  std::string label_ = "alpha";
  Turn turn_ = Turn::slice;
  Vec3 offset_{si(6000, "ft"), 0, -1};
  std::array<double, 2> angles_{si(-30, "deg"), si(30, "deg")};
  std::vector<Leg> legs_;
  Leg first_{.altitude = si(10, "km"), .speed = 250.0f};
  std::optional<double> delay_;
  Table1 drag_;
  Table2 thrust_;
};

/// Binds and describes itself, as types of upper layers do.
struct Callsign {
  std::string text = "eagle";
};
void bind_value(Callsign& out, const Value& value, Diagnostics& diagnostics,
                const ParamInfo& info) {
  if (value.text.empty())
    diagnostics.error(value.where, info.name + ": a callsign has letters");
  else
    out.text = value.text;
}
void describe_value(ParamInfo& info, const Callsign& value) {
  info.kind = ParamKind::text;
  info.default_text = value.text;
}

struct Named {
  static constexpr std::string_view type_name = "named";
  Callsign callsign;
  std::vector<Callsign> others;
  static constexpr auto params() {
    return std::tuple{param("callsign", &Named::callsign, "who"),
                      param("others", &Named::others, "who else")};
  }
};

struct Sloppy {
  static constexpr std::string_view type_name = "sloppy";
  double vote = -1;
  double Speed = 0;
  Turn turn = static_cast<Turn>(7);
  int twice = 0;
  static constexpr auto params() {
    return std::tuple{param("vote", &Sloppy::vote, range(0, 1), "negative by default"),
                      param("Speed", &Sloppy::Speed, "m/s", range(2, 1), "bad name, empty range"),
                      param("turn", &Sloppy::turn, "default without a name"),
                      param("twice", &Sloppy::twice, ""), param("twice", &Sloppy::twice, "again")};
  }
};

}  // namespace described

template <>
struct EnumNames<described::Turn> {
  static constexpr std::array names{
      std::pair<std::string_view, described::Turn>{"level", described::Turn::level},
      std::pair<std::string_view, described::Turn>{"slice", described::Turn::slice}};
};

namespace described {
namespace {

static_assert(Described<Everything> && !Described<double> && !Described<Callsign>);
static_assert(enum_name(Turn::slice) == "slice");
static_assert(enum_name(static_cast<Turn>(7)) == "");

// what takes no unit or range does not compile with one
template <class Member>
concept MayHaveUnit = requires(Member Leg::*m) {
  param("x", m, Unit(Dimension::time), "help");
};
template <class Member>
concept MayHaveRange = requires(Member Leg::*m) {
  param("x", m, range(0, 1), "help");
};
static_assert(MayHaveUnit<double> && MayHaveUnit<std::optional<float>> && MayHaveUnit<Vec3> &&
              MayHaveUnit<std::vector<std::array<double, 2>>> && MayHaveUnit<Callsign>);
static_assert(!MayHaveUnit<int> && !MayHaveUnit<bool> && !MayHaveUnit<std::string> &&
              !MayHaveUnit<Turn> && !MayHaveUnit<std::vector<int>> && !MayHaveUnit<Leg>);
static_assert(MayHaveRange<int> && MayHaveRange<std::vector<int>> && !MayHaveRange<bool> &&
              !MayHaveRange<std::string> && !MayHaveRange<Turn> && !MayHaveRange<Leg>);

static_assert(range(0, 1).contains(0) && range(0, 1).contains(1) && !range(0, 1).contains(1.1));
static_assert(!positive().contains(0) && positive().contains(1e-300));
static_assert(any().contains(-1e308) && !any().contains(std::numeric_limits<double>::quiet_NaN()));
static_assert(at_least(2).contains(2) && !at_least(2).contains(1.9));

const ParamInfo& named(const std::vector<ParamInfo>& infos, std::string_view name) {
  for (const ParamInfo& info : infos)
    if (info.name == name)
      return info;
  ADD_FAILURE() << "no parameter " << name;
  return infos.front();
}

TEST(Parameters, ListsEveryKindInTheOrderOfTheDescription) {
  const std::vector<ParamInfo> infos = parameters<Everything>();
  using K = ParamKind;
  const std::vector<std::pair<std::string, K>> expected{
      {"range", K::number}, {"gain", K::number},   {"share", K::number}, {"count", K::integer},
      {"on", K::boolean},   {"label", K::text},    {"turn", K::choice},  {"offset", K::list},
      {"angles", K::list},  {"legs", K::list},     {"first", K::group},  {"delay", K::number},
      {"drag", K::table1},  {"thrust", K::table2},
  };
  ASSERT_EQ(infos.size(), expected.size());
  for (std::size_t i = 0; i < infos.size(); ++i) {
    EXPECT_EQ(infos[i].name, expected[i].first);
    EXPECT_EQ(infos[i].kind, expected[i].second) << infos[i].name;
  }
}

TEST(Parameters, GivesDefaultsAsAFileWouldWriteThem) {
  const std::vector<ParamInfo> infos = parameters<Everything>();
  const auto text = [&](std::string_view name) { return named(infos, name).default_text; };
  EXPECT_EQ(text("range"), "2 nmi");
  EXPECT_EQ(text("gain"), "");  // required
  EXPECT_EQ(text("share"), "0.1");
  EXPECT_EQ(text("count"), "3");
  EXPECT_EQ(text("on"), "true");
  EXPECT_EQ(text("label"), "alpha");
  EXPECT_EQ(text("turn"), "slice");
  EXPECT_EQ(text("offset"), "[6000 ft, 0 m, -1 m]");
  EXPECT_EQ(text("angles"), "[-30 deg, 30 deg]");
  EXPECT_EQ(text("legs"), "[]");
  EXPECT_EQ(text("first"), "");
  EXPECT_EQ(text("delay"), "null");
}

TEST(Parameters, TakesDefaultsFromAnObject) {
  Leg low;
  low.altitude = 30.48;
  EXPECT_EQ(parameters(low)[0].default_text, "100 ft");
}

TEST(Parameters, SaysUnitRangeChoicesAndNeed) {
  const std::vector<ParamInfo> infos = parameters<Everything>();
  EXPECT_EQ(named(infos, "range").unit, Unit("m"));
  EXPECT_EQ(named(infos, "range").limits, range(0, 50e3));
  EXPECT_EQ(named(infos, "range").help, "break inside");
  EXPECT_FALSE(named(infos, "range").required);
  EXPECT_TRUE(named(infos, "gain").required);
  EXPECT_EQ(named(infos, "gain").unit, Unit());
  EXPECT_EQ(named(infos, "gain").limits, any());
  EXPECT_EQ(named(infos, "turn").choices, (std::vector<std::string>{"level", "slice"}));
  EXPECT_TRUE(named(infos, "delay").optional);
  EXPECT_FALSE(named(infos, "share").optional);
}

struct Small {
  static constexpr std::string_view type_name = "small";
  std::uint8_t n = 1;
  static constexpr auto params() { return std::tuple{param("n", &Small::n, at_least(1), "n")}; }
};

TEST(Parameters, NarrowsIntegersToTheirType) {
  EXPECT_EQ(parameters<Small>()[0].limits, range(1, 255));
}

TEST(Parameters, DescribesItemsAndGroups) {
  const std::vector<ParamInfo> infos = parameters<Everything>();
  const ParamInfo& angles = named(infos, "angles");
  EXPECT_EQ(angles.min_items, 2u);
  EXPECT_EQ(angles.max_items, 2u);
  ASSERT_EQ(angles.children.size(), 1u);
  EXPECT_EQ(angles.children[0].kind, ParamKind::number);
  EXPECT_EQ(angles.children[0].unit, Unit("rad"));
  EXPECT_EQ(angles.children[0].limits, range(-kPi, kPi));
  EXPECT_EQ(named(infos, "offset").max_items, 3u);

  const ParamInfo& legs = named(infos, "legs");
  EXPECT_EQ(legs.max_items, 16u);
  const ParamInfo& leg = legs.children.at(0);
  EXPECT_EQ(leg.kind, ParamKind::group);
  EXPECT_EQ(leg.type_name, "leg");
  ASSERT_EQ(leg.children.size(), 2u);
  EXPECT_EQ(leg.children[0].default_text, "20000 ft");
  EXPECT_EQ(leg.children[1].limits, positive());
  EXPECT_TRUE(leg.children[1].optional);

  // a group that is a member has the defaults of that member
  const ParamInfo& first = named(infos, "first");
  ASSERT_EQ(first.children.size(), 2u);
  EXPECT_EQ(first.children[0].default_text, "10 km");
  EXPECT_EQ(first.children[1].default_text, "250 m/s");
}

TEST(Parameters, NamesTheAxesOfTables) {
  const std::vector<ParamInfo> infos = parameters<Everything>();
  ASSERT_EQ(named(infos, "drag").axes.size(), 1u);
  ASSERT_EQ(named(infos, "thrust").axes.size(), 2u);
  EXPECT_EQ(named(infos, "thrust").axes[1].name, "altitude");
  EXPECT_EQ(named(infos, "thrust").axes[1].unit, Unit("m"));
  EXPECT_EQ(named(infos, "thrust").unit, Unit("N"));
}

TEST(Parameters, LetsATypeDescribeItself) {
  const std::vector<ParamInfo> infos = parameters<Named>();
  EXPECT_EQ(infos[0].kind, ParamKind::text);
  EXPECT_EQ(infos[0].default_text, "eagle");
  EXPECT_EQ(infos[1].kind, ParamKind::list);
  EXPECT_EQ(infos[1].children.at(0).kind, ParamKind::text);
}

TEST(DescriptionMistakes, FindsNoneInAGoodDescription) {
  EXPECT_EQ(description_mistakes<Everything>(), "");
  EXPECT_EQ(description_mistakes<Named>(), "");
}

TEST(DescriptionMistakes, FindsWhatItsWriterOverlooked) {
  EXPECT_EQ(description_mistakes<Sloppy>(),
            "sloppy: Speed is not a name in snake_case\n"
            "sloppy: Speed has a range without a value\n"
            "sloppy: twice has no help\n"
            "sloppy: twice is described twice\n"
            "sloppy: the default of vote: -1 is outside [0, 1]\n"
            "sloppy: the default of Speed: 0 m/s is outside [2 m/s, 1 m/s]\n"
            "sloppy: the default of turn: expected one of level, slice, got ''\n");
}

}  // namespace
}  // namespace described
}  // namespace eyrie
