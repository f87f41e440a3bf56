// SPDX-License-Identifier: MIT
#pragma once
/// \file  Where something listens, or is sent: an address and a port.
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace eyrie::net {

struct Endpoint {
  std::string address = "127.0.0.1";  ///< numbers, of IPv4 or IPv6
  std::uint16_t port = 0;             ///< 0: any that is free

  [[nodiscard]] bool loopback() const;
  /// "127.0.0.1:42674", "[::1]:42674"
  [[nodiscard]] std::string text() const;
};

/// "42674", "0.0.0.0", "0.0.0.0:42674", "localhost", "[::1]:42674"; what is left out is as in
/// `standard`. Names are not looked up. Nothing if it is none of these.
[[nodiscard]] std::optional<Endpoint> endpoint_of(std::string_view text, const Endpoint& standard);

}  // namespace eyrie::net
