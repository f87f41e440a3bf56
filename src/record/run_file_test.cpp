// SPDX-License-Identifier: MIT
#include "record/run_file.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cerrno>
#include <string>

#include "core/hash.hpp"
#include "disk/file_system.hpp"
#include "sim/swarm_test.hpp"
#include "support/instead.hpp"
#include "support/program.hpp"

namespace eyrie::record {
namespace {

/// The trail of a run of 103 steps.
sim::HashTrail trail() {
  sim::TrailPacker packer(50);
  sim::Mark mark;
  for (const std::uint64_t last : {0, 50, 100, 103}) {
    for (; mark.step < last; ++mark.step)
      if (packer.is_fold(mark.step + 1))
        packer.fold(static_cast<std::uint16_t>(mark.step));
    mark.hash = 99 + last;
    mark.digest.step = last;
    mark.digest.fields = {4, static_cast<std::uint16_t>(last)};
    mark.digest.rows = {{1, PlayerId{2}, 3}};
    packer.mark(mark);
  }
  return *sim::trail_of(packer.take(), 50);
}

RunFile example() {
  RunFile run;
  run.build = "0.1.0";
  run.scenario = "a.yaml";
  run.files = {{"a.yaml", "eyrie: 1\n"}, {"data/aircraft/x.yaml", ""}};
  run.sets = {"seed=3", "blue.x=4"};
  run.seed = 42;
  run.layout_hash = 7;
  run.plugins = {{"/x/libmine.so", 0x0123456789abcdef}, {"/x/libother.so", 2}};
  run.trail = trail();
  run.orders.resize(2);
  run.orders[1].step = 9;
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

TEST(RunFile, IsTheSameInHoweverManyChunksItsTrailCame) {
  const RunFile run = example();
  RunEncoder encoder;
  std::string bytes = encoder.head(run);
  for (const char one : run.trail.spans)
    bytes += encoder.chunk({&one, 1});
  bytes += encoder.tail(run.trail.steps_per_second, run.orders, run.outcome);
  const Decoded back = decode(bytes);
  EXPECT_EQ(back.error, "");
  EXPECT_TRUE(back.run == run);
}

TEST(RunFile, RefusesATrailThatIsNone) {
  RunFile run = example();
  run.trail.spans.clear();
  EXPECT_EQ(decode(encode(run)).error,
            "the run file has no hashes that a replay could be compared with");
  run.trail.spans = trail().spans + "x";
  EXPECT_EQ(decode(encode(run)).error, "the run file is corrupt: its hashes do not fit");
}

/// What it says of its length is not believed: a trail of so many steps has folds for them.
TEST(RunFile, RefusesStepsThatNobodyHashed) {
  RunFile run = example();
  run.trail.spans += std::string("\xff\xff\xff\xff\x07", 5) + std::string(1000, '\0');
  EXPECT_EQ(decode(encode(run)).error, "the run file is corrupt: its hashes do not fit");
}

TEST(RunFile, SaysWhatIsWrongWithForeignFiles) {
  EXPECT_EQ(decode("").error, "this is not a run file");
  EXPECT_EQ(decode("PNG and so on, long enough to hold a header").error, "this is not a run file");
  EXPECT_EQ(decode("EYRIERUN").error, "the run file is cut");
  std::string other = encode(example());
  other[8] = 9;
  EXPECT_EQ(decode(other).error,
            "the run file has format version 9, and this Eyrie reads version 3: open it with the "
            "one that recorded it");
  EXPECT_EQ(read_run_file("/nowhere/x").error, "there is no such file");
  EXPECT_EQ(read_run_file("/dev/zero").error, "is a device, not a file");
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

namespace {

/// A disk on which a file has room for so many bytes.
class Small final : public disk::FileSystem {
 public:
  explicit Small(std::size_t room) : room_(room) {}
  ssize_t write(int file, const void* from, std::size_t size) override {
    if (used_ == room_) {
      errno = EFBIG;
      return -1;
    }
    const ssize_t written = FileSystem::write(file, from, std::min(size, room_ - used_));
    used_ += static_cast<std::size_t>(written);
    return written;
  }
  int cut(int file, off_t size) override {
    used_ = static_cast<std::size_t>(size);
    return FileSystem::cut(file, size);
  }

 private:
  std::size_t room_, used_ = 0;
};

/// Flies birds for an hour; what the writer says at the end.
std::string fly(disk::Sink& sink) {
  static const sim::swarm::Swarm swarm(300, 400);
  sim::World world = swarm.world(257);
  sim::Workspace work(*swarm.simulation);
  RunFile known;
  known.build = "test";
  RunFileWriter writer(sink, known);
  writer.begin(world, swarm.simulation->dt());
  for (int i = 0; i < 3600 * 50; ++i) {
    const sim::StepInfo info{world.step(), world.seed(), swarm.simulation->dt()};
    writer.observe(world, info, swarm.simulation->step(world, work));
  }
  writer.finish(world);
  return writer.close({}, "all fly");
}

TEST(RunFileWriter, WritesWhatEncodeWouldWrite) {
  const test::TempFolder folder;
  disk::Sink sink(folder / "run.eyrie");
  EXPECT_EQ(fly(sink), "");
  ASSERT_TRUE(sink.close());
  const Decoded back = read_run_file(folder / "run.eyrie");
  ASSERT_EQ(back.error, "");
  EXPECT_EQ(back.run.build, "test");
  EXPECT_EQ(back.run.outcome, "all fly");
  EXPECT_EQ(back.run.trail.last_step, 180'000U);
  EXPECT_GT(back.run.trail.spans.size(), 150'000U) << "several chunks";
}

TEST(RunFileWriter, EndsTheRunWhereThereIsRoomForItsEnd) {
  const test::TempFolder folder;
  for (const std::size_t room : {70'000, 131'080, 150'000}) {
    Small disk(room);
    const disk::Instead instead(disk);
    disk::Sink sink(folder / "run.eyrie");
    const std::string words = fly(sink);
    ASSERT_TRUE(sink.close()) << room;
    const Decoded back = read_run_file(folder / "run.eyrie");
    ASSERT_EQ(back.error, "") << room;
    EXPECT_LT(back.run.trail.last_step, 180'000U);
    EXPECT_GT(back.run.trail.last_step, 1'000U);
    EXPECT_EQ(words, "cannot write '" + (folder / "run.eyrie") +
                         "': File too large; the run is kept up to " +
                         std::to_string(back.run.trail.last_step / 50) + " s");
  }
}

TEST(RunFileWriter, FailsWithoutRoomForAnything) {
  const test::TempFolder folder;
  for (const std::size_t room : {100, 4'000}) {
    Small disk(room);
    const disk::Instead instead(disk);
    disk::Sink sink(folder / "run.eyrie");
    EXPECT_EQ(fly(sink), "");
    EXPECT_FALSE(sink.close());
    EXPECT_NE(sink.error().find("File too large"), std::string::npos);
  }
}

}  // namespace

}  // namespace eyrie::record
