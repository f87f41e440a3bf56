// SPDX-License-Identifier: MIT
#include "dis/pcap.hpp"

#include <cmath>
#include <string>

#include "dis/pdu.hpp"

namespace eyrie::dis {
namespace {

// from 192.0.2.1 to all of 192.0.2.0/24, which RFC 5737 keeps free for documents
constexpr unsigned char kEthernet[] = {0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0x02,
                                       0,    0,    0,    0,    0x01, 0x08, 0};
constexpr unsigned char kAddresses[] = {192, 0, 2, 1, 192, 0, 2, 255};
constexpr std::size_t kIp = 20, kUdp = 8;

void put16(std::string& out, std::size_t value) {  // big-endian
  out += static_cast<char>(value >> 8);
  out += static_cast<char>(value);
}
void put32(std::string& out, std::uint64_t value) {  // little-endian: pcap's own numbers
  for (int i = 0; i < 4; ++i)
    out += static_cast<char>(value >> (8 * i));
}
void put(std::string& out, std::span<const unsigned char> bytes) {
  out.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
}

/// RFC 1071, over an even or odd number of bytes.
std::size_t checksum(std::string_view bytes) {
  std::size_t sum = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i)
    sum += std::size_t{static_cast<unsigned char>(bytes[i])} << (i % 2 ? 0 : 8);
  while (sum >> 16)
    sum = (sum & 0xFFFF) + (sum >> 16);
  return ~sum & 0xFFFF;
}

}  // namespace

PcapWriter::PcapWriter(disk::Sink& sink, std::uint64_t epoch) : sink_(sink), epoch_(epoch) {
  std::string header;
  put32(header, 0xA1B2C3D4);  // microseconds
  put32(header, 2 | 4 << 16);
  put32(header, 0);
  put32(header, 0);
  put32(header, 65535);
  put32(header, 1);  // Ethernet
  sink_.write(header);
}

void PcapWriter::write(double time, std::span<const std::byte> payload) {
  const std::string_view data(reinterpret_cast<const char*>(payload.data()), payload.size());

  std::string ip;
  put16(ip, 0x4500);
  put16(ip, kIp + kUdp + data.size());
  put16(ip, number_++);
  put16(ip, 0x4000);  // not to be cut into pieces
  put16(ip, 0x4011);  // 64 hops, UDP
  put16(ip, 0);
  put(ip, kAddresses);
  const std::size_t sum = checksum(ip);
  ip[10] = static_cast<char>(sum >> 8);
  ip[11] = static_cast<char>(sum);

  std::string udp;
  put16(udp, kPort);
  put16(udp, kPort);
  put16(udp, kUdp + data.size());
  std::string covered = ip.substr(12);  // addresses, protocol, length
  put16(covered, 0x11);
  put16(covered, kUdp + data.size());
  covered.append(udp).append(data);
  const std::size_t whole = checksum(covered);
  put16(udp, whole ? whole : 0xFFFF);

  const auto microseconds = static_cast<std::uint64_t>(std::llround(time * 1e6));
  const std::size_t size = std::size(kEthernet) + kIp + kUdp + data.size();
  std::string record;
  put32(record, epoch_ + microseconds / 1000000);
  put32(record, microseconds % 1000000);
  put32(record, size);
  put32(record, size);
  put(record, kEthernet);
  sink_.write(record.append(ip).append(udp).append(data));
}

}  // namespace eyrie::dis
