// SPDX-License-Identifier: MIT
#pragma once
/// \file  The words with which Tacview and a host of real-time telemetry begin, before the host
/// sends ACMI text. https://www.tacview.net/documentation/realtime/
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace eyrie::net {

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
