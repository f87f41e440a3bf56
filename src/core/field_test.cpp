// SPDX-License-Identifier: MIT
#include "core/field.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <set>
#include <string>
#include <vector>

namespace eyrie {
namespace rows {

enum class Mode : std::uint8_t { hold, follow };
enum class Deep : std::int16_t { minus = -2, zero = 0 };

}  // namespace rows

template <>
struct EnumNames<rows::Mode> {
  static constexpr std::array names{
      std::pair<std::string_view, rows::Mode>{"hold", rows::Mode::hold},
      std::pair<std::string_view, rows::Mode>{"follow", rows::Mode::follow}};
};
template <>
struct EnumNames<rows::Deep> {
  static constexpr std::array names{
      std::pair<std::string_view, rows::Deep>{"minus", rows::Deep::minus},
      std::pair<std::string_view, rows::Deep>{"zero", rows::Deep::zero}};
};

namespace rows {

struct Scalars {
  double f64 = -0.1;
  float f32 = 0.1f;
  std::uint32_t u32 = 4000000000;
  std::uint64_t u64 = 18446744073709551615u;
  std::int64_t i64 = -9;
  std::int32_t i32 = -5;
  std::uint16_t u16 = 65535;
  std::int16_t i16 = -7;
  Deep deep = Deep::minus;
  std::uint8_t u8 = 255;
  std::int8_t i8 = -1;
  Mode mode = Mode::follow;
  bool flag = true;
  std::array<std::byte, 2> raw{std::byte{0xab}, std::byte{0x01}};

  static constexpr auto fields() {
    using R = Scalars;
    return field_list(field("f64", &R::f64, "m"), field("f32", &R::f32, "rad"),
                      field("u32", &R::u32), field("u64", &R::u64), field("i64", &R::i64),
                      field("i32", &R::i32), field("u16", &R::u16), field("i16", &R::i16),
                      field("deep", &R::deep), field("u8", &R::u8), field("i8", &R::i8),
                      field("mode", &R::mode), field("flag", &R::flag), field("raw", &R::raw));
  }
};

struct Track {
  Vec3 position;
  PlayerId who;
  float age = 0;
  static constexpr auto fields() {
    return field_list(field("position", &Track::position, "m"), field("who", &Track::who),
                      field("age", &Track::age, "s"));
  }
};

struct Brain {
  std::array<Track, 2> tracks;
  Mat3 frame;
  Vec3 route[2]{};
  Mode modes[3]{};
  std::uint8_t reserved[5]{};
  static constexpr auto fields() {
    return field_list(field("tracks", &Brain::tracks), field("frame", &Brain::frame),
                      field("route", &Brain::route, "m"), field("modes", &Brain::modes),
                      field("reserved", &Brain::reserved));
  }
};

namespace {

static_assert(fields_cover_row<Scalars>());
static_assert(fields_cover_row<Track>());
static_assert(fields_cover_row<Brain>());

// each way in which a description can miss or double a byte
struct WithPadding {
  double a = 0;
  float b = 0;
  static constexpr auto fields() {
    return field_list(field("a", &WithPadding::a), field("b", &WithPadding::b));
  }
};
struct WithGap {
  double a = 0, b = 0, c = 0;
  static constexpr auto fields() {
    return field_list(field("a", &WithGap::a), field("c", &WithGap::c));
  }
};
struct WithOverlap {
  double a = 0, b = 0;
  static constexpr auto fields() {
    return field_list(field("a", &WithOverlap::a), field("a again", &WithOverlap::a),
                      field("b", &WithOverlap::b));
  }
};
struct WithoutAnything {
  double a = 0;
  static constexpr auto fields() { return std::array<FieldInfo, 0>{}; }
};
struct Nontrivial {
  double a = 0;
  Nontrivial() = default;
  Nontrivial(const Nontrivial& other) : a(other.a) {}
  static constexpr auto fields() { return field_list(field("a", &Nontrivial::a)); }
};
struct OutOfOrder {
  float a = 0, b = 0;
  static constexpr auto fields() {
    return field_list(field("b", &OutOfOrder::b), field("a", &OutOfOrder::a));
  }
};
static_assert(!fields_cover_row<WithPadding>());
static_assert(!fields_cover_row<WithGap>());
static_assert(!fields_cover_row<WithOverlap>());
static_assert(!fields_cover_row<WithoutAnything>());
static_assert(!fields_cover_row<Nontrivial>());
static_assert(fields_cover_row<OutOfOrder>());
static_assert(fields_of<OutOfOrder>()[0].offset == 4);

template <class Row>
const std::byte* bytes(const Row& row) {
  return reinterpret_cast<const std::byte*>(&row);
}

const FieldInfo& named(std::span<const FieldInfo> fields, std::string_view name) {
  for (const FieldInfo& info : fields)
    if (info.name == name)
      return info;
  ADD_FAILURE() << "no field " << name;
  return fields.front();
}

TEST(Field, KnowsTypeUnitAndPlaceOfEveryScalar) {
  const auto fields = fields_of<Scalars>();
  const std::vector<std::pair<std::string, std::string>> expected{
      {"f64", "f64"}, {"f32", "f32"}, {"u32", "u32"}, {"u64", "u64"},  {"i64", "i64"},
      {"i32", "i32"}, {"u16", "u16"}, {"i16", "i16"}, {"deep", "i16"}, {"u8", "u8"},
      {"i8", "i8"},   {"mode", "u8"}, {"flag", "u8"}, {"raw", "bytes"}};
  ASSERT_EQ(fields.size(), expected.size());
  for (std::size_t i = 0; i < fields.size(); ++i) {
    EXPECT_EQ(fields[i].name.view(), expected[i].first);
    EXPECT_EQ(scalar_name(fields[i].type), expected[i].second);
  }
  EXPECT_EQ(fields[0].unit, "m");
  EXPECT_EQ(fields[1].unit, "rad");
  EXPECT_EQ(fields[2].unit, "");
  EXPECT_EQ(fields[2].offset, offsetof(Scalars, u32));
  EXPECT_EQ(fields[13].offset, offsetof(Scalars, raw));
  EXPECT_EQ(fields[13].count, 2u);
}

TEST(Field, FlattensVectorsNestedRowsAndArrays) {
  std::vector<std::string> names;
  for (const FieldInfo& info : fields_of<Brain>())
    names.push_back(info.count == 1 ? std::string(info.name)
                                    : std::string(info.name) + " x" + std::to_string(info.count));
  EXPECT_EQ(names, (std::vector<std::string>{"tracks[0].position.x", "tracks[0].position.y",
                                             "tracks[0].position.z", "tracks[0].who",
                                             "tracks[0].age",        "tracks[1].position.x",
                                             "tracks[1].position.y", "tracks[1].position.z",
                                             "tracks[1].who",        "tracks[1].age",
                                             "frame.row_x.x",        "frame.row_x.y",
                                             "frame.row_x.z",        "frame.row_y.x",
                                             "frame.row_y.y",        "frame.row_y.z",
                                             "frame.row_z.x",        "frame.row_z.y",
                                             "frame.row_z.z",        "route[0].x",
                                             "route[0].y",           "route[0].z",
                                             "route[1].x",           "route[1].y",
                                             "route[1].z",           "modes x3",
                                             "reserved x5"}));
  EXPECT_EQ(named(fields_of<Brain>(), "tracks[1].position.y").unit, "m");
  EXPECT_EQ(named(fields_of<Brain>(), "tracks[1].age").offset,
            sizeof(Track) + offsetof(Track, age));
  EXPECT_EQ(named(fields_of<Brain>(), "route[1].z").offset, offsetof(Brain, route) + 40);
}

TEST(FormatScalar, IsExactAndReadable) {
  const Scalars row;
  std::vector<std::string> texts;
  for (const FieldInfo& info : fields_of<Scalars>())
    texts.push_back(format_scalar(info, bytes(row)));
  EXPECT_EQ(texts, (std::vector<std::string>{"-0.1", "0.1", "4000000000", "18446744073709551615",
                                             "-9", "-5", "65535", "-7", "minus", "255", "-1",
                                             "follow", "1", "ab"}));
}

TEST(FormatScalar, FallsBackOnTheNumberOfAnEnumWithoutAName) {
  Scalars row;
  row.mode = static_cast<Mode>(9);
  row.deep = static_cast<Deep>(-300);
  EXPECT_EQ(format_scalar(named(fields_of<Scalars>(), "mode"), bytes(row)), "9");
  EXPECT_EQ(format_scalar(named(fields_of<Scalars>(), "deep"), bytes(row)), "-300");
}

TEST(FormatScalar, ShowsOneOfSeveralByItsIndex) {
  Brain row;
  row.modes[1] = Mode::follow;
  const FieldInfo& modes = named(fields_of<Brain>(), "modes");
  EXPECT_EQ(format_scalar(modes, bytes(row)), "hold");
  EXPECT_EQ(format_scalar(modes, bytes(row), 1), "follow");
  EXPECT_EQ(scalar_label(modes, 1), "modes[1]");
  EXPECT_EQ(scalar_label(named(fields_of<Brain>(), "route[0].x"), 0), "route[0].x");
  EXPECT_EQ(scalar_value(modes, bytes(row), 1), 1);
}

TEST(FormatScalar, ShowsWhatIsNotANumber) {
  Scalars row;
  row.f64 = std::numeric_limits<double>::quiet_NaN();
  row.f32 = -std::numeric_limits<float>::infinity();
  EXPECT_EQ(format_scalar(fields_of<Scalars>()[0], bytes(row)), "nan");
  EXPECT_EQ(format_scalar(fields_of<Scalars>()[1], bytes(row)), "-inf");
}

TEST(ScalarValue, ReadsEveryType) {
  const Scalars row;
  std::vector<double> values;
  for (const FieldInfo& info : fields_of<Scalars>())
    values.push_back(scalar_value(info, bytes(row)));
  EXPECT_EQ(values, (std::vector<double>{-0.1, double(0.1f), 4e9, 0x1p64, -9, -5, 65535, -7, -2,
                                         255, -1, 1, 1, 0xab}));
}

RC_GTEST_PROP(FormatScalar, ReadsBackToTheSameBits, (std::uint64_t seed)) {
  Scalars row;
  const std::uint64_t bits = seed * 0x9E3779B97F4A7C15u;
  std::memcpy(&row.f64, &bits, sizeof(bits));
  RC_PRE(!std::isnan(row.f64));
  const std::string text = format_scalar(fields_of<Scalars>()[0], bytes(row));
  double back = 0;
  std::from_chars(text.data(), text.data() + text.size(), back);
  RC_ASSERT(std::memcmp(&back, &row.f64, sizeof(back)) == 0);
}

RC_GTEST_PROP(FindDifference, NamesTheScalarThatHoldsTheFirstChangedByte, ()) {
  const Brain a;
  Brain b = a;
  const auto where = *rc::gen::inRange<std::size_t>(0, sizeof(Brain));
  reinterpret_cast<unsigned char*>(&b)[where] ^= 0x40;
  const auto fields = fields_of<Brain>();
  const auto found = find_difference(fields, bytes(a), bytes(b));
  RC_ASSERT(found.has_value());
  const FieldInfo& info = fields[found->field];
  const std::size_t begin = info.offset + found->index * scalar_size(info.type);
  RC_ASSERT(begin <= where);
  RC_ASSERT(where < begin + scalar_size(info.type));
  RC_ASSERT(!find_difference(fields, bytes(a), bytes(a)).has_value());
}

TEST(FindDifference, SeesWhatComparingNumbersWouldNot) {
  Scalars a, b;
  a.f64 = 0.0;
  b.f64 = -0.0;
  EXPECT_TRUE(find_difference(fields_of<Scalars>(), bytes(a), bytes(b)));
  a.f64 = b.f64 = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(find_difference(fields_of<Scalars>(), bytes(a), bytes(b)));
}

TEST(FieldName, IsPutTogetherWhileCompiling) {
  constexpr FieldName name = FieldName("tracks")[12] + "." + "range";
  static_assert(name == "tracks[12].range");
  static_assert(FieldName("a")[0] == "a[0]");
  const std::string longest(FieldName::kCapacity, 'x');
  EXPECT_EQ(FieldName(longest).view(), longest);
}

}  // namespace
}  // namespace rows
}  // namespace eyrie
