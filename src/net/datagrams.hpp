// SPDX-License-Identifier: MIT
#pragma once
/// \file  Datagrams to one address, to a network or to a group, and those that come in: sent and
/// taken by threads of their own.
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>

#include "net/endpoint.hpp"

namespace eyrie::net {

struct DatagramOptions {
  /// IPv4: of a machine, of all of a network (its broadcast address) or of a group (224.0.0.0/4).
  Endpoint to;
  /// Own address, by whose network they go. Empty: as the system routes them, but those to a group
  /// within this machine alone.
  std::string interface;
  std::size_t slots = 4096;  ///< datagrams that may wait
};

/// Whoever has a datagram hands it over and goes on: he waits for nothing, whatever the network
/// does. Where too many wait already it is dropped, and counted.
class DatagramSender {
 public:
  static constexpr std::size_t kLongest = 1472;  ///< bytes, in one frame of an Ethernet

  /// Throws std::system_error if there is no such address or interface here.
  explicit DatagramSender(const DatagramOptions& options);
  ~DatagramSender();

  /// By one thread. At most kLongest bytes.
  void send(std::span<const std::byte> bytes);
  /// Sends what waits, then no more.
  void close();

  /// After close().
  struct Counts {
    std::uint64_t sent = 0, bytes = 0;
    std::uint64_t dropped = 0;  ///< there was no room for them
    std::uint64_t failed = 0;   ///< the system did not take them
    int error = 0;              ///< why it did not take the first of these: errno
  };
  [[nodiscard]] Counts counts() const;

 private:
  struct Line;
  std::unique_ptr<Line> line_;
};

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
