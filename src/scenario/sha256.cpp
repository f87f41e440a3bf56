// SPDX-License-Identifier: MIT
#include "scenario/sha256.hpp"

#include <fmt/format.h>
#include <sha2.h>  // libmd
#include <sys/types.h>

#include <array>
#include <cstdint>
#include <iterator>

namespace eyrie::scenario {

std::string sha256(std::string_view bytes) {
  SHA2_CTX context;
  SHA256Init(&context);
  SHA256Update(&context, reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  std::array<std::uint8_t, SHA256_DIGEST_LENGTH> digest;
  SHA256Final(digest.data(), &context);
  std::string text;
  for (const std::uint8_t byte : digest)
    fmt::format_to(std::back_inserter(text), "{:02x}", byte);
  return text;
}

}  // namespace eyrie::scenario
