// SPDX-License-Identifier: MIT
#include "sim/snapshot.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstring>
#include <sstream>
#include <stdexcept>
#include <string>

#include "core/hash.hpp"
#include "sim/swarm_test.hpp"

namespace eyrie::sim {
namespace {

using swarm::fly;
using swarm::Swarm;

const Swarm& swarm_of_test() {
  static const Swarm swarm(60, 80);
  return swarm;
}

const World& flown() {
  static const World world = [] {
    World w = swarm_of_test().world(50, 5);
    fly(swarm_of_test(), w, 30);
    return w;
  }();
  return world;
}

std::string saved(const World& world) {
  std::ostringstream out;
  EXPECT_TRUE(save(world, out));
  return out.str();
}

Loaded read(const std::string& bytes, const Swarm& swarm = swarm_of_test()) {
  std::istringstream in(bytes);
  return load(swarm.simulation->shared_schema(), in);
}

/// Overwrites some bytes and makes the checksum right again, as a malicious author would.
template <class T>
std::string forged(std::string bytes, std::size_t at, T value) {
  std::memcpy(bytes.data() + at, &value, sizeof value);
  const std::size_t end = bytes.size() - sizeof(std::uint64_t);
  const std::uint64_t sum = hash_bytes(std::as_bytes(std::span(bytes.data(), end)));
  std::memcpy(bytes.data() + end, &sum, sizeof sum);
  return bytes;
}

constexpr std::size_t kVersionAt = 8, kByteOrderAt = 12, kLayoutAt = 16, kSizeAt = 24;
constexpr std::size_t kHeaderAt = 32;
constexpr std::size_t kBirdsAt = kHeaderAt + World::header_bytes(0);
constexpr std::size_t kFirstIdAt = kHeaderAt + World::header_bytes(2);

TEST(SavedWorld, LoadsAsTheSameBytesAndFliesOnTheSame) {
  Loaded loaded = read(saved(flown()));
  ASSERT_TRUE(loaded.world) << loaded.error;
  EXPECT_TRUE(loaded.error.empty());
  EXPECT_TRUE(loaded.world->same_bytes(flown()));

  World on = flown();
  fly(swarm_of_test(), on, 30);
  fly(swarm_of_test(), *loaded.world, 30, 3);
  EXPECT_EQ(loaded.world->hash(), on.hash());
}

TEST(SavedWorld, LoadsWhereThereIsMoreRoom) {
  const Swarm large(500, 600);
  const Loaded loaded = read(saved(flown()), large);
  ASSERT_TRUE(loaded.world) << loaded.error;
  EXPECT_EQ(loaded.world->hash(), flown().hash());
}

TEST(SavedWorld, HoldsLiveRowsOnly) {
  const World empty = swarm_of_test().simulation->world(1);
  EXPECT_LT(saved(empty).size(), 100u);
}

TEST(SavedWorld, MayStandInsideALargerFile) {
  std::stringstream file;
  ASSERT_TRUE(save(flown(), file));
  file << "and more";
  ASSERT_TRUE(load(swarm_of_test().simulation->shared_schema(), file).world);
  std::string rest;
  std::getline(file, rest);
  EXPECT_EQ(rest, "and more");
}

TEST(SavedWorld, SaysThatTheDiskIsFull) {
  std::ostringstream out;
  out.setstate(std::ios::badbit);
  EXPECT_FALSE(save(flown(), out));
}

TEST(SavedWorld, MustBeBetweenTwoSteps) {
  World world = flown();
  world.remove(swarm_of_test().keys.birds, 0);
  std::ostringstream out;
  EXPECT_THROW((void)save(world, out), std::logic_error);
}

TEST(DamagedWorld, IsRefusedWithTheReason) {
  const std::string good = saved(flown());
  EXPECT_EQ(read("").error, "this is not a saved world: it does not begin with EYRIEWLD");
  EXPECT_EQ(read("players:\n  - eagle1\n  - eagle2\n  - eagle3\n").error,
            "this is not a saved world: it does not begin with EYRIEWLD");
  EXPECT_EQ(read(good.substr(0, 20)).error, "the saved world is cut: it ends before its data does");
  EXPECT_EQ(read(good.substr(0, good.size() - 1)).error,
            "the saved world is cut: it ends before its data does");
  EXPECT_EQ(read(forged(good, kByteOrderAt, 0x04030201u)).error,
            "the world was saved on a machine of the other byte order");
  EXPECT_EQ(read(forged(good, kVersionAt, 2u)).error,
            "the saved world has format version 2, this program reads version 1");
  EXPECT_NE(read(forged(good, kLayoutAt, std::uint64_t{1})).error.find("another layout"),
            std::string::npos);
  EXPECT_NE(read(forged(good, kSizeAt, ~std::uint64_t{0})).error.find("it claims"),
            std::string::npos);

  std::string flipped = good;
  flipped[good.size() / 2] ^= 1;
  EXPECT_EQ(read(flipped).error, "the saved world is damaged: its checksum does not match");
}

TEST(DamagedWorld, IsRefusedWhenItHasMoreRowsThanThereIsRoom) {
  const Swarm small(10, 10);
  EXPECT_EQ(read(saved(swarm_of_test().world(50)), small).error,
            "table 'bird' of the saved world has 50 rows, there is room for 10");
  EXPECT_NE(read(forged(saved(flown()), kBirdsAt, ~0u)).error.find("there is room for 60"),
            std::string::npos);
}

TEST(DamagedWorld, IsRefusedWhenItsPlayersAreForgedWithAGoodChecksum) {
  const std::string good = saved(flown());
  const std::string disorder = "the saved world is damaged: its players are not in order";
  EXPECT_EQ(read(forged(good, kFirstIdAt, 0u)).error, disorder);
  EXPECT_EQ(read(forged(good, kFirstIdAt, 1000000u)).error, disorder);
  constexpr std::size_t kNextIdAt = kHeaderAt + 24;
  EXPECT_EQ(read(forged(good, kNextIdAt, 1u)).error, disorder);

  // a pellet that claims the id of a bird: in order in its own table, but there twice
  const std::uint32_t bird = flown().ids(swarm_of_test().keys.birds)[0].value;
  const Schema& schema = flown().schema();
  std::size_t first_pellet_at = kFirstIdAt;
  for (std::uint32_t i = 0; i < schema.table(swarm_of_test().keys.pellets).columns[0]; ++i)
    first_pellet_at += flown().column_bytes(i).size();
  EXPECT_EQ(read(forged(good, first_pellet_at, bird)).error, disorder);

  constexpr std::size_t kTablesAt = kHeaderAt + 28;
  EXPECT_EQ(read(forged(good, kTablesAt, 9u)).error, disorder);
}

RC_GTEST_PROP(DamagedWorld, IsRefusedWhateverByteIsFlipped, ()) {
  static const std::string good = saved(flown());
  std::string bad = good;
  const auto at = *rc::gen::inRange<std::size_t>(0, good.size());
  bad[at] = static_cast<char>(bad[at] ^ *rc::gen::inRange(1, 256));
  const Loaded loaded = read(bad);
  RC_ASSERT(!loaded.world);
  RC_ASSERT(!loaded.error.empty());
}

TEST(DamagedWorld, IsRefusedWhereverItIsCut) {
  const std::string good = saved(swarm_of_test().world(3));
  for (std::size_t size = 0; size < good.size(); ++size) {
    const Loaded loaded = read(good.substr(0, size));
    ASSERT_FALSE(loaded.world) << size;
    ASSERT_FALSE(loaded.error.empty()) << size;
  }
}

RC_GTEST_PROP(DamagedWorld, IsRefusedWhenItIsNoise, (const std::string& noise)) {
  RC_ASSERT(!read(noise).world);
  const std::string good = saved(flown());
  const auto keep = *rc::gen::inRange<std::size_t>(0, good.size());
  RC_PRE(noise != good.substr(keep, noise.size()));
  RC_ASSERT(!read(good.substr(0, keep) + noise).world);
}

}  // namespace
}  // namespace eyrie::sim
