// SPDX-License-Identifier: MIT
#include "dis/pcap.hpp"

#include <gtest/gtest.h>

#include "support/program.hpp"

namespace eyrie::dis {
namespace {

unsigned byte_at(const std::string& text, std::size_t i) {
  return static_cast<unsigned char>(text.at(i));
}

/// The sum of RFC 1071, which is 0xFFFF over what holds its own checksum.
unsigned sum(const std::string& bytes) {
  unsigned total = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i)
    total += byte_at(bytes, i) << (i % 2 ? 0 : 8);
  while (total >> 16)
    total = (total & 0xFFFF) + (total >> 16);
  return total;
}

TEST(Pcap, IsACaptureOfDatagrams) {
  const test::TempFolder folder;
  const std::string path = folder / "made.pcap";
  {
    disk::Sink sink(path);
    PcapWriter pcap(sink, 1000);
    const std::array<std::byte, 3> odd{std::byte{1}, std::byte{2}, std::byte{0xFE}};
    pcap.write(0, odd);
    pcap.write(2.5, std::span(odd).first(2));
    ASSERT_TRUE(sink.close());
  }
  const std::string file = test::read_text(path);
  ASSERT_EQ(file.size(), 24u + (16 + 42 + 3) + (16 + 42 + 2));
  EXPECT_EQ(file.substr(0, 8), std::string("\xD4\xC3\xB2\xA1\2\0\4\0", 8));
  EXPECT_EQ(byte_at(file, 20), 1u);  // Ethernet
  // the second record: its time, its lengths
  const std::string second = file.substr(24 + 61);
  EXPECT_EQ(byte_at(second, 0) + 256 * byte_at(second, 1), 1002u);
  EXPECT_EQ(byte_at(second, 4) + 256 * byte_at(second, 5) + 65536 * byte_at(second, 6), 500000u);
  EXPECT_EQ(byte_at(second, 8), 44u);
  for (const auto& [record, size] :
       {std::pair(file.substr(24 + 16, 45), 3u), {second.substr(16), 2u}}) {
    EXPECT_EQ(record.substr(12, 2), std::string("\x08\0", 2));
    const std::string ip = record.substr(14, 20), udp = record.substr(34);
    EXPECT_EQ(sum(ip), 0xFFFFu);
    EXPECT_EQ(byte_at(ip, 3), 28 + size);
    EXPECT_EQ(udp.substr(0, 4), "\x0B\xB8\x0B\xB8");  // 3000 to 3000
    EXPECT_EQ(byte_at(udp, 5), 8 + size);
    EXPECT_EQ(sum(ip.substr(12) + std::string("\0\x11\0", 3) + static_cast<char>(8 + size) + udp),
              0xFFFFu);
  }
}

}  // namespace
}  // namespace eyrie::dis
