// SPDX-License-Identifier: MIT
#pragma once
/// \file  A host of real-time telemetry: Tacview connects, and gets what is written of a flight
/// while it is flown.
#include <chrono>
#include <cstdint>
#include <memory>
#include <string>

#include "net/endpoint.hpp"

namespace eyrie::net {

struct TelemetryOptions {
  Endpoint at;
  std::string name = "Eyrie";                  ///< one line, shown to the client
  std::string password;                        ///< UTF-8; empty: anybody may join
  std::size_t connections = 64;                ///< at a time, those included that have not joined
  std::size_t waiting = 8 << 20;               ///< bytes, for one client; it is dropped beyond
  std::chrono::milliseconds greeting{10'000};  ///< in which a client has to join
};

/// A thread of its own has all sockets; whoever sends text hands it over and goes on. A client that
/// joins late gets everything that is there first. One that is too slow is dropped, one that does
/// not talk as Tacview does is refused, and none is waited for.
class TelemetryHost {
 public:
  /// Listens. Throws std::system_error if it cannot.
  explicit TelemetryHost(TelemetryOptions options);
  ~TelemetryHost();

  /// With the port that was free, if any would do.
  [[nodiscard]] const Endpoint& at() const;

  /// Whether somebody joined who has got nothing yet.
  [[nodiscard]] bool wanted() const;
  /// The next lines. `whole`, of use if somebody is wanted(), is instead of all that was sent so
  /// far, these lines included.
  void send(std::string_view text, std::string whole);

  /// Nobody may join any more; waits until the system has taken everything for everybody, for so
  /// long at most.
  void close(std::chrono::milliseconds wait);

  /// So far.
  struct Counts {
    std::uint64_t joined = 0;   ///< clients
    std::uint64_t refused = 0;  ///< connections that did not become clients, or were too many
    std::uint64_t dropped = 0;  ///< clients that were too slow
    std::uint64_t bytes = 0;    ///< sent to all of them
  };
  [[nodiscard]] Counts counts() const;

 private:
  struct Network;
  std::unique_ptr<Network> network_;
};

}  // namespace eyrie::net
