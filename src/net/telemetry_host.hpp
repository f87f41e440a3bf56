// SPDX-License-Identifier: MIT
#pragma once
/// \file  A host of real-time telemetry: Tacview connects, and gets what is written of a flight
/// while it is flown. https://www.tacview.net/documentation/realtime/
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

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

// The words with which Tacview and the host begin, before the host sends ACMI text.

/// What the host says first, with the zero that ends it. `name`: one line.
[[nodiscard]] std::string host_greeting(std::string_view name);

/// No client's greeting is longer, the zero included.
inline constexpr std::size_t kLongestGreeting = 1024;

struct ClientGreeting {
  std::string name;
  std::string hash;  ///< of the password; "0": none
};
/// Of the text before the zero. Nothing if it is that of another protocol, or another version.
[[nodiscard]] std::optional<ClientGreeting> client_greeting(std::string_view text);

/// CRC-64/WE, by which Tacview tells a password (UTF-8), in UTF-16LE, as hexadecimal digits; "0" of
/// none. Whoever reads it on the way can use it: it is no secret on a network that others share.
[[nodiscard]] std::string password_hash(std::string_view password);
/// Whether a client with that hash knows the password: by CRC-32, too, as older ones tell it. There
/// may be none, and then every hash will do.
[[nodiscard]] bool is_hash_of(std::string_view hash, std::string_view password);

[[nodiscard]] std::uint64_t crc64_we(std::string_view bytes);
[[nodiscard]] std::uint32_t crc32(std::string_view bytes);

}  // namespace eyrie::net
