// SPDX-License-Identifier: MIT
#pragma once
/// \file  Numbers, texts and blocks as bytes, as they lie in memory, and back.
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace eyrie {

template <class T>
void put_number(std::string& out, T number) {
  static_assert(std::is_arithmetic_v<T>);
  out.append(reinterpret_cast<const char*>(&number), sizeof number);
}
/// In LEB128, of which small numbers take few bytes.
inline void put_varint(std::string& out, std::uint64_t number) {
  for (; number >= 128; number >>= 7)
    out.push_back(static_cast<char>(number | 128));
  out.push_back(static_cast<char>(number));
}
/// How many bytes that takes.
[[nodiscard]] inline std::size_t varint_size(std::uint64_t number) {
  return (static_cast<std::size_t>(std::bit_width(number | 1)) + 6) / 7;
}

/// Takes what was put off the front of bytes, which must outlive it. Everything is checked against
/// what is left; after the first failure all reads give zero and ok() is false.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : left_(bytes) {}

  [[nodiscard]] bool ok() const { return ok_; }
  [[nodiscard]] bool at_end() const { return left_.empty(); }
  /// Whether `count` items of at least `size` bytes can follow; if not, that is a failure.
  bool has(std::uint64_t count, std::size_t size) {
    ok_ = ok_ && count <= left_.size() / size;
    return ok_;
  }

  template <class T>
  T number() {
    static_assert(std::is_arithmetic_v<T>);
    T x{};
    take(&x, sizeof x);
    return x;
  }
  /// One below 2^63.
  std::uint64_t varint() {
    std::uint64_t result = 0;
    for (unsigned shift = 0; shift < 63; shift += 7) {
      const auto byte = number<std::uint8_t>();
      result |= std::uint64_t{byte & 127U} << shift;
      if (byte < 128)
        return result;
    }
    ok_ = false;
    return 0;
  }
  std::string_view bytes(std::uint64_t size) {
    if (!has(size, 1))
      return {};
    const std::string_view part = left_.substr(0, size);
    left_.remove_prefix(size);
    return part;
  }
  /// Behind its size.
  std::string_view text() { return bytes(number<std::uint64_t>()); }
  /// Behind the number of its items.
  template <class T>
  std::vector<T> block() {
    static_assert(std::is_trivially_copyable_v<T>);
    const auto count = number<std::uint64_t>();
    if (!has(count, sizeof(T)))
      return {};
    std::vector<T> items(count);
    take(items.data(), count * sizeof(T));
    return items;
  }

 private:
  void take(void* to, std::size_t size) {
    if (const std::string_view part = bytes(size); !part.empty())
      std::memcpy(to, part.data(), size);
  }

  std::string_view left_;
  bool ok_ = true;
};

}  // namespace eyrie
