// SPDX-License-Identifier: MIT
#include "record/run_file.hpp"

#include <gtest/gtest.h>

#include <cerrno>

#include "disk/file_system.hpp"
#include "sim/swarm_test.hpp"
#include "support/program.hpp"

namespace eyrie::record {
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
