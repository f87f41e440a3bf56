// SPDX-License-Identifier: MIT
#include "sim/packed_trail.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <vector>

namespace eyrie::sim {
namespace {

constexpr std::uint32_t kRate = 50;

/// A second of a run: most of its fields stay, some rows come and go.
struct Second {
  Mark mark;
  std::vector<std::uint16_t> folds;
};

std::vector<Second> seconds() {
  std::vector<Second> all(1);
  all[0].mark.digest.fields =
      *rc::gen::container<std::vector<std::uint16_t>>(rc::gen::arbitrary<std::uint16_t>());
  const auto count = *rc::gen::inRange(0, 8);
  for (int i = 0; i < count; ++i) {
    Second next;
    next.mark = all.back().mark;
    const auto steps = *rc::gen::inRange<std::uint64_t>(1, 4 * kRate);
    for (std::uint64_t s = next.mark.step + 1; s <= next.mark.step + steps; ++s)
      if (TrailPacker(kRate).is_fold(s))
        next.folds.push_back(*rc::gen::arbitrary<std::uint16_t>());
    next.mark.step += steps;
    next.mark.digest.step = next.mark.step;
    next.mark.hash = *rc::gen::arbitrary<std::uint64_t>();
    next.mark.digest.header = *rc::gen::arbitrary<std::uint16_t>();
    for (std::uint16_t& field : next.mark.digest.fields)
      if (*rc::gen::inRange(0, 4) == 0)
        field = *rc::gen::arbitrary<std::uint16_t>();
    if (*rc::gen::inRange(0, 2) == 0)
      next.mark.digest.rows.resize(*rc::gen::inRange<std::size_t>(0, 5));
    for (Digest::Row& row : next.mark.digest.rows)
      row = {.table = *rc::gen::inRange(1U, 4U),
             .player = PlayerId{*rc::gen::inRange(1U, 1000U)},
             .hash = *rc::gen::arbitrary<std::uint16_t>()};
    all.push_back(next);
  }
  return all;
}

std::string packed(const std::vector<Second>& all) {
  TrailPacker packer(kRate);
  for (const Second& one : all) {
    for (const std::uint16_t fold : one.folds)
      packer.fold(fold);
    packer.mark(one.mark);
  }
  return packer.take();
}

RC_GTEST_PROP(PackedTrail, ComesBackAsItWas, ()) {
  const std::vector<Second> all = seconds();
  const std::string bytes = packed(all);
  TrailUnpacker span(bytes, kRate);
  std::uint64_t step = 0;
  for (const Second& one : all) {
    RC_ASSERT(span.next());
    RC_ASSERT(span.mark() == one.mark);
    std::size_t next = 0;
    for (; step <= one.mark.step; ++step)
      if (span.has_fold(step))
        RC_ASSERT(span.fold(step) == one.folds.at(next++));
    RC_ASSERT(next == one.folds.size());
  }
  RC_ASSERT(!span.next());
  RC_ASSERT(span.ok());
}

RC_GTEST_PROP(PackedTrail, NoticesWhenItIsCut, ()) {
  const std::vector<Second> all = seconds();
  const std::string bytes = packed(all);
  const auto size = *rc::gen::inRange<std::size_t>(0, bytes.size());
  TrailUnpacker span(std::string_view(bytes).substr(0, size), kRate);
  std::size_t whole = 0;
  while (span.next())
    ++whole;
  RC_ASSERT(whole < all.size());
}

/// Whatever the bytes are; the sanitizers see what goes over an edge.
RC_GTEST_PROP(PackedTrail, SurvivesDamage, ()) {
  std::string bytes = packed(seconds());
  bytes[*rc::gen::inRange<std::size_t>(0, bytes.size())] = *rc::gen::arbitrary<char>();
  TrailUnpacker span(bytes, kRate);
  std::uint64_t last = 0;
  while (span.next()) {
    RC_ASSERT(span.mark().step >= last);
    last = span.mark().step;
    for (std::uint64_t step = last > 5 ? last - 5 : 0; step <= last; ++step)
      if (span.has_fold(step))
        static_cast<void>(span.fold(step));
  }
}

TEST(PackedTrail, RefusesNumbersThatTheBytesCannotHold) {
  const auto refused = [](std::initializer_list<int> numbers) {
    std::string bytes;
    for (const int number : numbers)
      bytes.push_back(static_cast<char>(number));
    TrailUnpacker span(bytes, kRate);
    while (span.next()) {
    }
    return !span.ok();
  };
  EXPECT_FALSE(refused({0, 1, 2, 3, 4, 5, 6, 7, 8, 1, 2, 0, 0})) << "a start without fields";
  EXPECT_TRUE(refused({0, 1, 2, 3, 4, 5, 6, 7, 8, 1, 2, 3, 0})) << "three fields";
  EXPECT_TRUE(refused({0, 1, 2, 3, 4, 5, 6, 7, 8, 1, 2, 0, 1, 2})) << "two rows";
  EXPECT_TRUE(refused({0, 1, 2, 3, 4, 5, 6, 7, 8, 1, 2, 0, 2})) << "neither the same nor other";
  EXPECT_TRUE(refused({0, 1, 2, 3, 4, 5, 6, 7, 8, 1, 2, 0, 0, 127, 0, 0})) << "127 steps";
  EXPECT_TRUE(
      refused({0, 1, 2, 3, 4, 5, 6, 7, 8, 1, 2, 0, 0, 0, 1, 2, 3, 4, 5, 6, 7, 8, 1, 2, 0, 0}))
      << "a second without steps";
  EXPECT_TRUE(refused({255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 1})) << "2^70 steps";
}

/// What changes seldom costs little: a digest of a thousand fields of which two change is small.
TEST(PackedTrail, KeepsOnlyWhatChanged) {
  TrailPacker packer(kRate);
  Mark mark;
  mark.digest.fields.resize(1000);
  packer.mark(mark);
  EXPECT_GT(packer.take().size(), 2000u);
  for (int second = 1; second <= 10; ++second) {
    mark.step += kRate;
    mark.digest.fields[7] = static_cast<std::uint16_t>(second);
    mark.digest.fields[900] = static_cast<std::uint16_t>(-second);
    for (int i = 0; i < 10; ++i)
      packer.fold(0);
    packer.mark(mark);
  }
  EXPECT_LT(packer.take().size(), 10 * 45u);
}

}  // namespace
}  // namespace eyrie::sim
