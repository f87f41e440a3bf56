// SPDX-License-Identifier: MIT
#pragma once
/// \file  Numbers on the wire, big-endian. A record says its fields once, in
/// `static void fields(auto& wire, auto& record)`; a Writer and a Reader go over them alike.
#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <tuple>
#include <type_traits>
#include <vector>

#include "core/vec.hpp"
#include "model/entity_type.hpp"

namespace eyrie::dis {

namespace detail {

template <class T>
concept Number = std::integral<T> || std::floating_point<T>;
template <class T>
concept Enum = std::is_enum_v<T>;
template <class T>
concept Parts = requires {
  T::parts();
};

template <std::size_t N>
using Unsigned = std::conditional_t<
    N == 1, std::uint8_t,
    std::conditional_t<N == 2, std::uint16_t,
                       std::conditional_t<N == 4, std::uint32_t, std::uint64_t>>>;

/// What both directions share: from any value down to its numbers.
template <class Wire>
class Walk {
 public:
  /// The fields, one after the other.
  template <class... Values>
  void operator()(Values&... values) {
    (walk(values), ...);
  }

 private:
  template <class T>
  void walk(T& value) {
    using Plain = std::remove_const_t<T>;
    if constexpr (Number<Plain> || Enum<Plain>)
      static_cast<Wire*>(this)->number(value);
    else if constexpr (Parts<Plain>)
      std::apply([&](auto... part) { (walk(value.*part), ...); }, Plain::parts());
    else if constexpr (std::is_same_v<Plain, Vec3>)
      (*this)(value.x, value.y, value.z);
    else if constexpr (requires { value.front(); })
      for (auto& item : value)
        walk(item);
    else
      Plain::fields(*static_cast<Wire*>(this), value);
  }
};

}  // namespace detail

class Writer : public detail::Walk<Writer> {
 public:
  template <class T>
  void number(const T& value) {
    auto bits = std::bit_cast<detail::Unsigned<sizeof(T)>>(value);
    for (std::size_t i = sizeof(T); i-- > 0;)
      bytes_.push_back(static_cast<std::byte>(bits >> (8 * i)));
  }
  void zeros(std::size_t count) { bytes_.resize(bytes_.size() + count); }
  /// How many items a list has, where the list itself stands elsewhere.
  template <std::unsigned_integral Count>
  Count count(const auto& list) {
    const auto size = static_cast<Count>(list.size());
    number(size);
    return size;
  }
  void list(const auto& items, std::size_t) { (*this)(items); }
  /// The words of 32 bits from here on until end(); 0 where a byte is too small for them.
  std::size_t begin() {
    zeros(1);
    return bytes_.size() - 1;
  }
  void end(std::size_t mark) {
    const std::size_t words = (bytes_.size() - mark) / 4;
    bytes_[mark] = static_cast<std::byte>(words <= 0xFF ? words : 0);
  }
  /// Bytes up to a whole number of eight, preceded by their length in bits.
  void text(const std::string& bytes) {
    number(static_cast<std::uint32_t>(8 * bytes.size()));
    for (const char c : bytes)
      bytes_.push_back(static_cast<std::byte>(c));
    zeros((8 - bytes.size() % 8) % 8);
  }

  [[nodiscard]] std::size_t size() const { return bytes_.size(); }
  [[nodiscard]] std::vector<std::byte> take() { return std::move(bytes_); }

 private:
  std::vector<std::byte> bytes_;
};

/// Never reads beyond its bytes: what is missing is 0, and failed() says so.
class Reader : public detail::Walk<Reader> {
 public:
  explicit Reader(std::span<const std::byte> bytes) : bytes_(bytes) {}

  template <class T>
  void number(T& value) {
    detail::Unsigned<sizeof(T)> bits = 0;
    for (const std::byte b : take(sizeof(T)))
      bits = static_cast<decltype(bits)>((std::uint64_t{bits} << 8) | std::to_integer<unsigned>(b));
    value = std::bit_cast<T>(bits);
  }
  void zeros(std::size_t count) { static_cast<void>(take(count)); }
  template <std::unsigned_integral Count>
  Count count(auto&) {
    Count size = 0;
    number(size);
    return size;
  }
  /// Each item takes some bytes, so a false size costs no memory.
  template <class T>
  void list(std::vector<T>& items, std::size_t size) {
    for (items.clear(); items.size() < size && !failed_;)
      (*this)(items.emplace_back());
  }
  std::size_t begin() {
    const std::size_t mark = at_;
    std::uint8_t words = 0;
    number(words);
    return mark | std::size_t{words} << 32;
  }
  void end(std::size_t mark) {
    const std::size_t words = mark >> 32;
    failed_ |= words != 0 && 4 * words != at_ - (mark & 0xFFFFFFFF);
  }
  void text(std::string& bytes) {
    std::uint32_t bits = 0;
    number(bits);
    failed_ |= bits % 8 != 0;
    bytes.clear();
    for (const std::byte b : take(bits / 8))
      bytes += static_cast<char>(b);
    zeros((8 - bits / 8 % 8) % 8);
  }

  [[nodiscard]] bool failed() const { return failed_; }
  /// Bytes read so far.
  [[nodiscard]] std::size_t size() const { return at_; }

 private:
  std::span<const std::byte> take(std::size_t count) {
    failed_ |= count > bytes_.size() - at_;
    if (failed_)
      return {};
    at_ += count;
    return bytes_.subspan(at_ - count, count);
  }

  std::span<const std::byte> bytes_;
  std::size_t at_ = 0;
  bool failed_ = false;
};

}  // namespace eyrie::dis
