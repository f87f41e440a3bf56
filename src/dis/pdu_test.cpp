// SPDX-License-Identifier: MIT
#include "dis/pdu.hpp"

#include <gtest/gtest.h>

namespace eyrie::dis {
namespace {

using Bytes = std::vector<std::byte>;

/// A big-endian number of some bytes.
template <class T>
T at(const Bytes& bytes, std::size_t offset) {
  T value{};
  const std::span<const std::byte> all(bytes);
  Reader reader(all.subspan(offset));
  reader.number(value);
  EXPECT_FALSE(reader.failed());
  return value;
}

Bytes bytes_of(Pdu pdu) {
  return encode({.exercise = 9, .timestamp = 0x01020304, .status = 5, .pdu = std::move(pdu)});
}

EntityState state() {
  EntityState s;
  s.id = {1, 2, 3};
  s.force = Force::opposing;
  s.type = {1, 2, 222, 1, 2, 3, 4};
  s.other_type = {2, 1, 225, 5, 6, 7, 8};
  s.velocity = {1.5f, 2.5f, 3.5f};
  s.location = {4e6, 5e5, -6e6};
  s.orientation = {0.25f, 0.5f, 0.75f};
  s.appearance = kDestroyed | kDeactivated;
  s.reckoning = Reckoning::rvw;
  s.acceleration = {7.5f, 8.5f, 9.5f};
  s.spin = {10.5f, 11.5f, 12.5f};
  s.marking = {'e', 'a', 'g', 'l', 'e', '1'};
  s.capabilities = 0xA0B0C0D0;
  s.parameters.resize(2);
  s.parameters[1].bytes[15] = 77;
  return s;
}

// offsets: IEEE 1278.1-2012, tables of clauses 6.2.66, 7.2.2 and so on
TEST(PduLayout, HasTheHeader) {
  const Bytes b = bytes_of(StopFreeze{});
  EXPECT_EQ(at<std::uint8_t>(b, 0), 7);   // version
  EXPECT_EQ(at<std::uint8_t>(b, 1), 9);   // exercise
  EXPECT_EQ(at<std::uint8_t>(b, 2), 14);  // type
  EXPECT_EQ(at<std::uint8_t>(b, 3), 5);   // family
  EXPECT_EQ(at<std::uint32_t>(b, 4), 0x01020304u);
  EXPECT_EQ(at<std::uint16_t>(b, 8), b.size());
  EXPECT_EQ(at<std::uint8_t>(b, 10), 5);
  EXPECT_EQ(at<std::uint8_t>(b, 11), 0);
}

TEST(PduLayout, HasTheEntityState) {
  const Bytes b = bytes_of(state());
  ASSERT_EQ(b.size(), 144u + 2 * 16);
  EXPECT_EQ(at<std::uint16_t>(b, 12), 1);
  EXPECT_EQ(at<std::uint16_t>(b, 16), 3);
  EXPECT_EQ(at<std::uint8_t>(b, 18), 2);  // force
  EXPECT_EQ(at<std::uint8_t>(b, 19), 2);  // variable parameters
  EXPECT_EQ(at<std::uint8_t>(b, 20), 1);  // kind
  EXPECT_EQ(at<std::uint16_t>(b, 22), 222);
  EXPECT_EQ(at<std::uint8_t>(b, 27), 4);  // extra
  EXPECT_EQ(at<std::uint16_t>(b, 30), 225);
  EXPECT_EQ(at<float>(b, 36), 1.5f);
  EXPECT_EQ(at<double>(b, 48), 4e6);
  EXPECT_EQ(at<double>(b, 64), -6e6);
  EXPECT_EQ(at<float>(b, 80), 0.75f);                // phi
  EXPECT_EQ(at<std::uint32_t>(b, 84), 0x00800018u);  // appearance
  EXPECT_EQ(at<std::uint8_t>(b, 88), 4);             // dead reckoning
  EXPECT_EQ(at<float>(b, 104), 7.5f);                // acceleration
  EXPECT_EQ(at<float>(b, 124), 12.5f);               // spin
  EXPECT_EQ(at<std::uint8_t>(b, 128), 1);            // ASCII
  EXPECT_EQ(at<char>(b, 129), 'e');
  EXPECT_EQ(at<std::uint32_t>(b, 140), 0xA0B0C0D0u);
  EXPECT_EQ(at<std::uint8_t>(b, 175), 77);
}

TEST(PduLayout, HasFireAndDetonation) {
  const Munition what{{2, 1, 225, 1, 2, 3}, 1620, 3000, 4, 5};
  Bytes b = bytes_of(Fire{.shooter = {1, 1, 7},
                          .target = {1, 1, 8},
                          .munition = {1, 1, 9},
                          .event = {1, 1, 10},
                          .mission = 11,
                          .location = {1, 2, 3},
                          .what = what,
                          .velocity = {4, 5, 6},
                          .range = 7});
  ASSERT_EQ(b.size(), 96u);
  EXPECT_EQ(at<std::uint16_t>(b, 16), 7);
  EXPECT_EQ(at<std::uint16_t>(b, 22), 8);
  EXPECT_EQ(at<std::uint16_t>(b, 28), 9);
  EXPECT_EQ(at<std::uint16_t>(b, 34), 10);
  EXPECT_EQ(at<std::uint32_t>(b, 36), 11u);
  EXPECT_EQ(at<double>(b, 40), 1);
  EXPECT_EQ(at<std::uint8_t>(b, 64), 2);
  EXPECT_EQ(at<std::uint16_t>(b, 72), 1620);
  EXPECT_EQ(at<std::uint16_t>(b, 78), 5);
  EXPECT_EQ(at<float>(b, 80), 4);
  EXPECT_EQ(at<float>(b, 92), 7);

  b = bytes_of(Detonation{.event = {1, 1, 10},
                          .velocity = {4, 5, 6},
                          .location = {1, 2, 3},
                          .what = what,
                          .place = {7, 8, 9},
                          .result = Result::end_game_miss});
  ASSERT_EQ(b.size(), 104u);
  EXPECT_EQ(at<std::uint16_t>(b, 34), 10);
  EXPECT_EQ(at<float>(b, 36), 4);
  EXPECT_EQ(at<double>(b, 48), 1);
  EXPECT_EQ(at<std::uint16_t>(b, 80), 1620);
  EXPECT_EQ(at<float>(b, 88), 7);
  EXPECT_EQ(at<std::uint8_t>(b, 100), 32);
}

Emission emission() {
  return {.emitter = {1, 1, 7},
          .event = {1, 1, 10},
          .systems = {{.name = 1800,
                       .function = 19,
                       .beams = {{.frequency = 1e10f,
                                  .azimuth = 0.5f,
                                  .function = BeamFunction::tracking,
                                  .targets = {{.who = {1, 1, 8}}, {.who = {1, 1, 9}}}}}},
                      {.name = 5, .number = 2}}};
}

TEST(PduLayout, HasTheEmission) {
  const Bytes b = bytes_of(emission());
  ASSERT_EQ(b.size(), 28u + 20 + 52 + 2 * 8 + 20);
  EXPECT_EQ(at<std::uint16_t>(b, 16), 7);
  EXPECT_EQ(at<std::uint16_t>(b, 22), 10);
  EXPECT_EQ(at<std::uint8_t>(b, 24), 1);              // changed
  EXPECT_EQ(at<std::uint8_t>(b, 25), 2);              // systems
  EXPECT_EQ(at<std::uint8_t>(b, 28), (20 + 68) / 4);  // words of the first
  EXPECT_EQ(at<std::uint8_t>(b, 29), 1);              // beams
  EXPECT_EQ(at<std::uint16_t>(b, 32), 1800);
  EXPECT_EQ(at<std::uint8_t>(b, 34), 19);
  EXPECT_EQ(at<std::uint8_t>(b, 48), 68 / 4);  // words of the beam
  EXPECT_EQ(at<std::uint8_t>(b, 49), 1);       // its number
  EXPECT_EQ(at<float>(b, 52), 1e10f);
  EXPECT_EQ(at<float>(b, 72), 0.5f);      // azimuth
  EXPECT_EQ(at<std::uint8_t>(b, 92), 4);  // function
  EXPECT_EQ(at<std::uint8_t>(b, 93), 2);  // targets
  EXPECT_EQ(at<std::uint16_t>(b, 104), 8);
  EXPECT_EQ(at<std::uint8_t>(b, 116), 5);  // words of the second
}

TEST(PduLayout, HasTheManagementOfTheExercise) {
  Bytes b = bytes_of(StartResume{
      .from = {1, 1, 0}, .to = kEverybody, .real = {3, 4}, .simulated = {5, 6}, .request = 7});
  ASSERT_EQ(b.size(), 44u);
  EXPECT_EQ(at<std::uint16_t>(b, 18), 0xFFFF);
  EXPECT_EQ(at<std::uint32_t>(b, 24), 3u);
  EXPECT_EQ(at<std::uint32_t>(b, 36), 6u);
  EXPECT_EQ(at<std::uint32_t>(b, 40), 7u);

  b = bytes_of(StopFreeze{.reason = 2, .frozen = 1, .request = 7});
  ASSERT_EQ(b.size(), 40u);
  EXPECT_EQ(at<std::uint8_t>(b, 32), 2);
  EXPECT_EQ(at<std::uint8_t>(b, 33), 1);
  EXPECT_EQ(at<std::uint32_t>(b, 36), 7u);

  b = bytes_of(Acknowledge{.what = 3, .response = 1, .request = 7});
  ASSERT_EQ(b.size(), 32u);
  EXPECT_EQ(at<std::uint16_t>(b, 24), 3);
  EXPECT_EQ(at<std::uint32_t>(b, 28), 7u);

  const Datums datums{.fixed = {{21, 22}}, .variable = {{23, "nine long"}}};
  b = bytes_of(Comment{.datums = datums});
  ASSERT_EQ(b.size(), 32u + 8 + 8 + 16);  // the text up to a whole number of 64 bits
  EXPECT_EQ(at<std::uint32_t>(b, 24), 1u);
  EXPECT_EQ(at<std::uint32_t>(b, 28), 1u);
  EXPECT_EQ(at<std::uint32_t>(b, 36), 22u);
  EXPECT_EQ(at<std::uint32_t>(b, 44), 72u);  // bits
  EXPECT_EQ(at<char>(b, 48), 'n');

  b = bytes_of(Data{.request = 7, .datums = datums});
  ASSERT_EQ(b.size(), 40u + 8 + 8 + 16);
  EXPECT_EQ(at<std::uint32_t>(b, 24), 7u);
  EXPECT_EQ(at<std::uint32_t>(b, 32), 1u);
}

std::vector<Pdu> one_of_each() {
  const Datums datums{.fixed = {{21, 22}, {23, 24}}, .variable = {{25, ""}, {26, "eight ch"}}};
  return {state(),
          Fire{.event = {1, 2, 3}, .location = {1, 2, 3}},
          Detonation{.result = Result::impact, .parameters = {{}, {}}},
          emission(),
          StartResume{.request = 1},
          StopFreeze{.reason = 2},
          Acknowledge{.response = 1},
          Data{.request = 3, .datums = datums},
          Comment{.datums = datums}};
}

TEST(Pdu, IsReadAsItWasWritten) {
  for (const Pdu& pdu : one_of_each()) {
    const Bytes bytes = bytes_of(pdu);
    const Decoded read = decode(bytes);
    ASSERT_EQ(read.refusal, std::nullopt) << pdu.index();
    EXPECT_EQ(read.packet.pdu.index(), pdu.index());
    EXPECT_EQ(read.length, bytes.size());
    EXPECT_EQ(encode(read.packet), bytes) << pdu.index();
  }
}

TEST(Pdu, IsReadInADatagramOfSeveral) {
  Bytes bytes = bytes_of(StopFreeze{});
  const Bytes second = bytes_of(state());
  bytes.insert(bytes.end(), second.begin(), second.end());
  const Decoded first = decode(bytes);
  EXPECT_EQ(first.refusal, std::nullopt);
  const Decoded next = decode(std::span(bytes).subspan(first.length));
  EXPECT_EQ(next.refusal, std::nullopt);
  EXPECT_EQ(std::get<EntityState>(next.packet.pdu).id, (EntityId{1, 2, 3}));
}

TEST(Pdu, IsRefusedWhereverItIsCutOff) {
  for (const Pdu& pdu : one_of_each()) {
    Bytes bytes = bytes_of(pdu);
    for (std::size_t size = 0; size < bytes.size(); ++size) {
      EXPECT_EQ(decode(std::span(bytes).first(size)).refusal, Unused::truncated) << size;
      if (size < 12)
        continue;
      Bytes shorter(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
      shorter[8] = static_cast<std::byte>(size >> 8);
      shorter[9] = static_cast<std::byte>(size);
      EXPECT_EQ(decode(shorter).refusal, Unused::malformed) << pdu.index() << " " << size;
    }
  }
}

TEST(Pdu, IsRefusedWithAReason) {
  const Bytes good = bytes_of(state());
  const auto with = [&](std::size_t offset, int value) {
    Bytes bytes = good;
    bytes[offset] = static_cast<std::byte>(value);
    return decode(bytes).refusal;
  };
  EXPECT_EQ(with(0, 6), std::nullopt);
  EXPECT_EQ(with(0, 5), Unused::version);
  EXPECT_EQ(with(0, 8), Unused::version);
  EXPECT_EQ(with(2, 26), Unused::kind);        // Signal
  EXPECT_EQ(with(8, 255), Unused::truncated);  // longer than the datagram
  EXPECT_EQ(with(19, 1), Unused::malformed);   // bytes are left over
  EXPECT_EQ(with(19, 255), Unused::malformed);
  Bytes beam = bytes_of(emission());
  beam[48] = std::byte{16};  // the beam has 17 words
  EXPECT_EQ(decode(beam).refusal, Unused::malformed);
  beam[48] = std::byte{0};  // its length is not said
  EXPECT_EQ(decode(beam).refusal, std::nullopt);
}

TEST(Pdu, TakesNoMemoryForFalseCounts) {
  Bytes bytes = bytes_of(Comment{});
  for (std::size_t i = 24; i < 32; ++i)
    bytes[i] = std::byte{0xFF};  // 4 billion datums of either kind
  EXPECT_EQ(decode(bytes).refusal, Unused::malformed);
}

TEST(Timestamp, IsAFractionOfTheHour) {
  EXPECT_EQ(timestamp_at(0), 0u);
  EXPECT_EQ(timestamp_at(1800), 0x80000000u);
  EXPECT_EQ(timestamp_at(3600), 0u);
  EXPECT_EQ(timestamp_at(4500), 0x40000000u);
  EXPECT_EQ(timestamp_at(3600 - 1e-9), 0u) << "the hour is full";
  EXPECT_EQ(timestamp_at(0.02) % 2, 0u) << "relative to the sender's clock";
}

}  // namespace
}  // namespace eyrie::dis
