// SPDX-License-Identifier: MIT
#include "core/hash.hpp"

#include <fmt/format.h>

#include <bit>
#include <new>

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace eyrie {
namespace {

XXH3_state_t* state_of(std::byte* storage) {
  return std::launder(reinterpret_cast<XXH3_state_t*>(storage));
}

const XXH3_state_t* state_of(const std::byte* storage) {
  return std::launder(reinterpret_cast<const XXH3_state_t*>(storage));
}

}  // namespace

std::uint64_t hash_bytes(std::span<const std::byte> bytes) {
  return XXH3_64bits(bytes.data(), bytes.size());
}

std::string hash_text(std::uint64_t hash) {
  return fmt::format("0x{:016x}", hash);
}

Hasher::Hasher() {
  static_assert(sizeof(XXH3_state_t) <= kStateSize && alignof(XXH3_state_t) <= 64);
  static_assert(std::is_trivially_copyable_v<XXH3_state_t>);
  XXH3_64bits_reset(new (static_cast<void*>(state_)) XXH3_state_t);
}

void Hasher::bytes(const void* data, std::size_t size) {
  XXH3_64bits_update(state_of(state_), data, size);
}

void Hasher::word(std::uint64_t value) {
  static_assert(std::endian::native == std::endian::little);
  bytes(&value, sizeof value);
}

std::uint64_t Hasher::value() const {
  return XXH3_64bits_digest(state_of(state_));
}

}  // namespace eyrie
