// SPDX-License-Identifier: MIT
#include "page/column.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <zlib.h>

#include <cmath>

#include "page/page.hpp"
#include "support/packed.hpp"

namespace eyrie::page {
namespace {

std::vector<std::int64_t> read_column(const ColumnBytes& bytes, const Json& place) {
  return test::read_column(std::string_view(bytes.bytes()).substr(place[0]), place[1], place[3]);
}

RC_GTEST_PROP(Column, ComesBackToWithinHalfAQuantum, (std::vector<std::int32_t> raw)) {
  Column column(0.125), other(1);
  for (const std::int32_t value : raw) {
    column.add(value / 7.0);
    other.add(value % 3);
  }
  ColumnBytes bytes;
  static_cast<void>(bytes.put(other));
  const Json place = bytes.put(column);
  const auto back = read_column(bytes, place);
  RC_ASSERT(back.size() == raw.size());
  for (std::size_t i = 0; i < raw.size(); ++i)
    RC_ASSERT(std::fabs(0.125 * static_cast<double>(back[i]) - raw[i] / 7.0) <= 0.0625 + 1e-9);
}

TEST(Column, KeepsNothingAsNothing) {
  Column column(0.1);
  for (const double value : {1.0, std::nan(""), 2.0})
    column.add(value);
  ColumnBytes bytes;
  const auto back = read_column(bytes, bytes.put(column));
  EXPECT_EQ(back[1], Column::kNothing);
  EXPECT_EQ(back[2], 20);
}

TEST(Column, TakesTheDifferencesThatAreShortest) {
  Column constant, ramp, parabola;
  for (int i = 0; i < 1000; ++i) {
    constant.add(1e6);
    ramp.add(1000.0 * i);
    parabola.add(1000.0 * i * i);
  }
  ColumnBytes bytes;
  EXPECT_EQ(bytes.put(constant)[3], 1);
  EXPECT_EQ(bytes.put(ramp)[3], 2);
  EXPECT_EQ(bytes.put(parabola)[3], 2);
  EXPECT_LT(bytes.bytes().size(), 6000U);
}

TEST(Packed, IsZlib) {
  const std::string text(10'000, 'x'), packed = deflated(text);
  EXPECT_LT(packed.size(), 100U);
  std::string back(text.size(), '\0');
  uLongf size = back.size();
  ASSERT_EQ(uncompress(reinterpret_cast<Bytef*>(back.data()), &size,
                       reinterpret_cast<const Bytef*>(packed.data()), packed.size()),
            Z_OK);
  EXPECT_EQ(back, text);
}

TEST(Packed, ComesBackWhateverItsLengthAndHasNoMark) {
  std::string text;
  for (unsigned i = 0; i < 60; ++i) {
    EXPECT_EQ(test::unpacked(packed(text)), text) << i;
    text.push_back(static_cast<char>(i * 2654435761U >> 24));
  }
  const std::string whole = packed(text);
  EXPECT_EQ(whole.find('<'), whole.npos);
}

}  // namespace
}  // namespace eyrie::page
