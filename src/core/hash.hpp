// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace eyrie {

/// XXH3-64 (seed 0) of some bytes: the same value on every machine and for every compiler.
[[nodiscard]] std::uint64_t hash_bytes(std::span<const std::byte> bytes);

/// "0x0123456789abcdef"
[[nodiscard]] std::string hash_text(std::uint64_t hash);

/// The same hash fed piece by piece; how the bytes were cut into pieces does not matter. Allocates
/// nothing. Not meant against an adversary.
class Hasher {
 public:
  Hasher();

  void bytes(const void* data, std::size_t size);
  /// Eight bytes, little-endian.
  void word(std::uint64_t value);
  /// The hash of everything so far; more may follow.
  [[nodiscard]] std::uint64_t value() const;

 private:
  static constexpr std::size_t kStateSize = 576;
  alignas(64) std::byte state_[kStateSize];
};

}  // namespace eyrie
