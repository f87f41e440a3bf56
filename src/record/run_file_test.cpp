// SPDX-License-Identifier: MIT
#include "record/run_file.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string>

#include "core/hash.hpp"

namespace eyrie::record {
namespace {

RunFile example() {
  RunFile run;
  run.build = "0.1.0";
  run.scenario = "a.yaml";
  run.files = {{"a.yaml", "eyrie: 1\n"}, {"data/aircraft/x.yaml", ""}};
  run.sets = {"seed=3", "blue.x=4"};
  run.seed = 42;
  run.until = 12.5;
  run.layout_hash = 7;
  run.orders.resize(2);
  run.orders[1].step = 9;
  run.trail.steps_per_mark = 50;
  run.trail.folds = {1, 2, 3};
  run.trail.marks.resize(2);
  run.trail.marks[1] = {.step = 3, .hash = 99, .digest = {}};
  run.trail.marks[1].digest.fields = {4, 5};
  run.trail.marks[1].digest.rows = {{1, PlayerId{2}, 3}};
  run.outcome = "blue is home";
  return run;
}

/// The bytes with a checksum that fits, as someone who wants to break the reader would make them.
std::string signed_again(std::string bytes) {
  bytes.resize(bytes.size() - 8);
  const std::uint64_t sum = hash_bytes(std::as_bytes(std::span(bytes.data(), bytes.size())));
  return bytes.append(reinterpret_cast<const char*>(&sum), 8);
}

TEST(RunFile, ComesBackAsItWas) {
  const Decoded back = decode(encode(example()));
  EXPECT_EQ(back.error, "");
  EXPECT_TRUE(back.run == example());
}

TEST(RunFile, HasAFormatOfItsOwnWithPlugins) {
  RunFile plugged = example();
  plugged.plugins = {{"/x/libmine.so", 0x0123456789abcdef}, {"/x/libother.so", 2}};
  const std::string bytes = encode(plugged);
  EXPECT_EQ(bytes[8], kRunFileWithPlugins);
  EXPECT_TRUE(decode(bytes).run == plugged);
  EXPECT_EQ(encode(example())[8], kRunFileVersion) << "the others stay as they were";
  std::string cut = bytes.substr(0, bytes.size() - 8 - 1) + std::string(8, ' ');
  EXPECT_EQ(decode(signed_again(cut)).error, "the run file is corrupt: its sections do not fit");
}

TEST(RunFile, SaysWhatIsWrongWithForeignFiles) {
  EXPECT_EQ(decode("").error, "this is not a run file");
  EXPECT_EQ(decode("PNG and so on, long enough to hold a header").error, "this is not a run file");
  EXPECT_EQ(decode("EYRIERUN").error, "the run file is cut");
  std::string other = encode(example());
  other[8] = 9;
  EXPECT_EQ(decode(other).error,
            "the run file has format version 9; this program reads versions 1 and 2");
  EXPECT_EQ(read_run_file("/nowhere/x").error, "cannot read the file");
}

RC_GTEST_PROP(RunFile, RefusesEveryCut, ()) {
  const std::string whole = encode(example());
  const auto size = *rc::gen::inRange<std::size_t>(0, whole.size());
  RC_ASSERT(!decode(std::string_view(whole).substr(0, size)).error.empty());
}

RC_GTEST_PROP(RunFile, RefusesEveryFlippedBit, ()) {
  std::string bytes = encode(example());
  bytes[*rc::gen::inRange<std::size_t>(0, bytes.size())] ^=
      static_cast<char>(1 << *rc::gen::inRange(0, 8));
  RC_ASSERT(!decode(bytes).error.empty());
}

RC_GTEST_PROP(RunFile, SurvivesDamageWithAFittingChecksum, ()) {
  std::string bytes = encode(example());
  const auto at = *rc::gen::inRange<std::size_t>(16, bytes.size() - 8);
  bytes[at] = static_cast<char>(*rc::gen::inRange(0, 256));
  static_cast<void>(decode(signed_again(bytes)));  // must neither crash nor allocate without end
  const auto size = *rc::gen::inRange<std::size_t>(24, bytes.size());
  RC_ASSERT(!decode(signed_again(bytes.substr(0, size))).error.empty() || size == bytes.size());
}

}  // namespace
}  // namespace eyrie::record
