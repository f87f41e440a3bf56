// SPDX-License-Identifier: MIT
#pragma once
/// \file  Packets as a capture file of an Ethernet: pcap, which Wireshark and tcpdump read
/// (draft-ietf-opsawg-pcap). Each PDU is one UDP datagram to everybody, at its simulated time.
#include <cstddef>
#include <span>

#include "disk/sink.hpp"

namespace eyrie::dis {

class PcapWriter {
 public:
  /// `epoch`: s since 1970 of time 0.
  PcapWriter(disk::Sink& sink, std::uint64_t epoch);
  /// At most 1400 bytes, at a time (s).
  void write(double time, std::span<const std::byte> payload);

 private:
  disk::Sink& sink_;
  std::uint64_t epoch_;
  std::uint16_t number_ = 0;
};

}  // namespace eyrie::dis
