// SPDX-License-Identifier: MIT
#include "ubf/action_traits.hpp"

#include <gtest/gtest.h>

#include <cstring>

#include "core/hash.hpp"
#include "support/ubf/testing.hpp"

namespace eyrie::ubf::testing {

/// An action whose description forgets a field.
struct Forgetful {
  std::optional<double> heading;
  std::optional<float> speed;
};
/// One that it forgets would fit into the padding behind the others.
struct Padded {
  std::optional<double> heading;
  std::optional<bool> fire, flare;
};
/// One that is listed twice, in place of another.
struct Doubled {
  std::optional<bool> fire, flare;
};
/// Directions that are counted in other ways.
struct Turning {
  std::optional<double> turn;
  std::optional<float> course;
};
/// A member that is no optional.
struct Plain {
  std::optional<double> heading;
  bool urgent = false;
};

}  // namespace eyrie::ubf::testing

template <>
struct eyrie::ubf::ActionTraits<eyrie::ubf::testing::Forgetful> {
  static constexpr auto fields =
      std::tuple{field<blend::Angle>("heading", &testing::Forgetful::heading, "rad")};
};
template <>
struct eyrie::ubf::ActionTraits<eyrie::ubf::testing::Padded> {
  static constexpr auto fields =
      std::tuple{field<blend::Angle>("heading", &testing::Padded::heading, "rad"),
                 field<blend::Strongest>("fire", &testing::Padded::fire)};
};
template <>
struct eyrie::ubf::ActionTraits<eyrie::ubf::testing::Doubled> {
  static constexpr auto fields =
      std::tuple{field<blend::Strongest>("fire", &testing::Doubled::fire),
                 field<blend::Strongest>("flare", &testing::Doubled::fire)};
};
template <>
struct eyrie::ubf::ActionTraits<eyrie::ubf::testing::Turning> {
  static constexpr auto fields =
      std::tuple{field<blend::Angle>("turn", &testing::Turning::turn, "rad", {-kPi, kPi}),
                 field<blend::Angle>("course", &testing::Turning::course, "rad", {0, kTau})};
};
template <>
struct eyrie::ubf::ActionTraits<eyrie::ubf::testing::Plain> {
  static constexpr auto fields =
      std::tuple{field<blend::Angle>("heading", &testing::Plain::heading, "rad")};
};

namespace eyrie::ubf::testing {
namespace {

template <class Field>
using TurningSum = typename Field::Sum;

const Action kFull{.heading = 1, .altitude = 2, .speed = 3.0F, .release = 4, .mode = 5};

TEST(ActionTraits, KnowsTheFieldsInOrder) {
  EXPECT_EQ(kFields<Action>, 5u);
  const auto fields = action_fields<Action>();
  EXPECT_EQ(fields.front().name, "heading");
  EXPECT_EQ(fields.back().name, "mode");
}

TEST(ActionTraits, NoticesAForgottenField) {
  EXPECT_TRUE(fields_cover_action<Action>());
  EXPECT_FALSE(fields_cover_action<Forgetful>());
  EXPECT_FALSE(fields_cover_action<Padded>()) << "in tail padding";
  EXPECT_FALSE(fields_cover_action<Doubled>());
  EXPECT_FALSE(fields_cover_action<Plain>());
}

TEST(ActionTraits, ClearsEveryField) {
  Action action = kFull;
  EXPECT_FALSE(is_empty(action));
  clear(action);
  EXPECT_TRUE(is_empty(action));
  EXPECT_TRUE(equal(action, Action{}));
}

TEST(ActionTraits, ComparesFieldByField) {
  EXPECT_TRUE(equal(kFull, kFull));
  for_each_field<Action>([&](const auto& f, auto) {
    Action other = kFull;
    (other.*f.member).reset();
    EXPECT_FALSE(equal(other, kFull)) << f.name;
    EXPECT_FALSE(is_empty(other));
  });
}

TEST(ActionTraits, PacksIntoBytesAndBack) {
  Action back{.altitude = 99};
  PackedAction<Action>(kFull).unpack(back);
  EXPECT_TRUE(equal(back, kFull));
  const Action some{.speed = 7.0F};
  PackedAction<Action>(some).unpack(back);
  EXPECT_TRUE(equal(back, some));
}

TEST(ActionTraits, PacksEqualActionsIntoEqualBytesWhateverWasThereBefore) {
  Action reused = kFull;
  clear(reused);
  reused.mode = 1;
  const Action fresh{.mode = 1};
  PackedAction<Action> a(kFull), b;
  a.assign(reused);
  b.assign(fresh);
  EXPECT_EQ(std::memcmp(&a, &b, sizeof a), 0);
  static_assert(NoPadding<PackedAction<Action>>);
}

TEST(ActionTraits, HashesWhatIsSetAndItsValue) {
  const auto hash = [](const Action& action) {
    const PackedAction<Action> packed(action);
    return hash_bytes(std::as_bytes(std::span(&packed, 1)));
  };
  EXPECT_EQ(hash({.heading = 1}), hash({.heading = 1}));
  EXPECT_NE(hash({.heading = 1}), hash({.altitude = 1}));
  EXPECT_NE(hash({.release = 0}), hash({}));
}

TEST(ActionFields, CountDirectionsAsTheirRangeDoes) {
  FieldSums<Turning, TurningSum> sums;
  const auto heavy = [](const auto&) { return 3.0; };
  sums.add({.turn = -0.2, .course = 6.2831850F}, [](const auto&) { return 1.0; });
  sums.add({.turn = -0.4, .course = 0.0F}, heavy);
  Turning blended;
  sums.get(blended);
  EXPECT_NEAR(*blended.turn, -0.35, 0.001);
  EXPECT_EQ(implausible_field(blended), kFields<Turning>) << implausible_text(blended, 1);
  action_fields<Turning>()[0].set(&blended, wrap_tau(-0.2));
  EXPECT_NEAR(*blended.turn, -0.2, 1e-12);
}

}  // namespace
}  // namespace eyrie::ubf::testing
