// SPDX-License-Identifier: MIT
#include "model/row_boxes.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace eyrie::model {
namespace {

RC_GTEST_PROP(RowBoxes, FindWhatEveryRowAskedAloneWouldSay, ()) {
  std::vector<Kinematics> rows(*rc::gen::inRange<std::size_t>(1, 1200));
  std::uint32_t draw = *rc::gen::arbitrary<std::uint32_t>();
  const auto next = [&] { return double((draw = draw * 1664525U + 1013904223U) >> 8) / (1 << 24); };
  Vec3 lead;
  for (std::size_t i = 0; i < rows.size(); ++i) {  // in flights of seven
    if (i % 7 == 0)
      lead = {1e5 * next(), 1e5 * next(), 1e4 * next()};
    rows[i].position = lead + Vec3{1e4 * next(), 1e3 * next(), 10 * next()};
  }
  // a reach that ends at a row itself
  const Vec3 place = rows[rows.size() / 2].position;
  const double reach2 =
      norm2(rows[*rc::gen::inRange<std::size_t>(0, rows.size())].position - place);
  std::vector<std::pair<std::size_t, double>> found, wanted;
  RowBoxes(rows).each_within(place, reach2,
                             [&](std::size_t row, double d2) { found.emplace_back(row, d2); });
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (const double d2 = norm2(rows[i].position - place); d2 <= reach2)
      wanted.emplace_back(i, d2);
  RC_ASSERT(found == wanted);

  const std::size_t first = *rc::gen::inRange<std::size_t>(0, rows.size());
  std::vector<std::pair<std::size_t, std::size_t>> pairs, wanted_pairs;
  RowBoxes(rows).each_pair_within(first, rows.size(), reach2,
                                  [&](auto i, auto j, double) { pairs.emplace_back(i, j); });
  for (std::size_t i = first; i < rows.size(); ++i)
    for (std::size_t j = 0; j < rows.size(); ++j)
      if (norm2(rows[j].position - rows[i].position) <= reach2)
        wanted_pairs.emplace_back(i, j);
  RC_ASSERT(pairs == wanted_pairs);
}

}  // namespace
}  // namespace eyrie::model
