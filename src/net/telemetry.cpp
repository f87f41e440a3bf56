// SPDX-License-Identifier: MIT
#include "net/telemetry.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/text.hpp"

namespace eyrie::net {
namespace {

constexpr std::string_view kProtocols = "XtraLib.Stream.0\nTacview.RealTimeTelemetry.0\n";

std::string utf16le(std::string_view text) {
  std::string out;
  const auto put = [&](std::uint32_t unit) {
    out += static_cast<char>(unit & 0xFF);
    out += static_cast<char>(unit >> 8);
  };
  while (!text.empty()) {
    const Utf8 next = first_character(text);
    const std::uint32_t point = next.length ? static_cast<std::uint32_t>(next.point) : 0xFFFD;
    if (point < 0x10000) {
      put(point);
    } else {
      put(0xD800 + ((point - 0x10000) >> 10));
      put(0xDC00 + ((point - 0x10000) & 0x3FF));
    }
    text.remove_prefix(std::max<std::size_t>(next.length, 1));
  }
  return out;
}

}  // namespace

std::uint64_t crc64_we(std::string_view bytes) {
  std::uint64_t crc = ~std::uint64_t{0};
  for (const char byte : bytes) {
    crc ^= std::uint64_t{static_cast<unsigned char>(byte)} << 56;
    for (int bit = 0; bit < 8; ++bit)
      crc = crc >> 63 ? (crc << 1) ^ 0x42F0E1EBA9EA3693 : crc << 1;
  }
  return ~crc;
}

std::uint32_t crc32(std::string_view bytes) {
  std::uint32_t crc = ~std::uint32_t{0};
  for (const char byte : bytes) {
    crc ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit)
      crc = crc & 1 ? (crc >> 1) ^ 0xEDB88320 : crc >> 1;
  }
  return ~crc;
}

std::string host_greeting(std::string_view name) {
  return fmt::format("{}{}\n{}", kProtocols, name, '\0');
}

std::optional<ClientGreeting> client_greeting(std::string_view text) {
  if (!text.starts_with(kProtocols))
    return {};
  text.remove_prefix(kProtocols.size());
  const std::size_t end = text.find('\n');
  if (end == text.npos)
    return {};
  std::string_view hash = text.substr(end + 1);
  if (hash.ends_with('\n'))
    hash.remove_suffix(1);
  if (hash.find('\n') != hash.npos)
    return {};
  return ClientGreeting{std::string(text.substr(0, end)), std::string(hash)};
}

std::string password_hash(std::string_view password) {
  return password.empty() ? "0" : fmt::format("{:x}", crc64_we(utf16le(password)));
}

bool is_hash_of(std::string_view hash, std::string_view password) {
  return password.empty() || hash == password_hash(password) ||
         hash == fmt::format("{:x}", crc32(utf16le(password)));
}

}  // namespace eyrie::net
