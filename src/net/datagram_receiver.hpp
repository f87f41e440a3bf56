// SPDX-License-Identifier: MIT
#pragma once
/// \file  Datagrams that come in, taken by a thread of their own.
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>

#include "net/endpoint.hpp"

namespace eyrie::net {

struct ReceiverOptions {
  /// IPv4, where others send to. A group (224.0.0.0/4) is joined, and of other addresses those of
  /// this machine hear what is sent to them alone; for any other it is what comes to the port. A
  /// port of 0 becomes one that is free.
  Endpoint at;
  std::string interface = {};  ///< own address in whose network a group is joined; empty: loopback
  std::size_t slots = 2048;    ///< datagrams that may wait
};

/// Keeps what came until it is asked, and never makes anybody wait. Where too many wait already one
/// is dropped, and counted.
class DatagramReceiver {
 public:
  static constexpr std::size_t kLongest = 2048;  ///< bytes; longer ones are counted and no more
  using WallClock = std::chrono::system_clock;
  /// Of a datagram: its bytes, which are good during the call, and when it came.
  using Use = std::function<void(std::span<const std::byte> bytes, WallClock::time_point came)>;

  /// Throws std::system_error if it cannot listen there.
  explicit DatagramReceiver(const ReceiverOptions& options);
  ~DatagramReceiver();
  DatagramReceiver(const DatagramReceiver&) = delete;
  DatagramReceiver& operator=(const DatagramReceiver&) = delete;

  [[nodiscard]] std::uint16_t port() const;
  /// By one thread: calls `use` with each that has come since, until now.
  void drain(const Use& use);
  /// Takes no more.
  void close();

  /// After close().
  struct Counts {
    std::uint64_t received = 0, bytes = 0;
    std::uint64_t dropped = 0;   ///< there was no room for them
    std::uint64_t too_long = 0;  ///< longer than kLongest
  };
  [[nodiscard]] Counts counts() const;

 private:
  struct Line;
  std::unique_ptr<Line> line_;
};

}  // namespace eyrie::net
