// SPDX-License-Identifier: MIT
#pragma once
/// \file  What is known of one field of a row. Include core/field.hpp, which says how to use it.
#include <fmt/format.h>

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace eyrie {

enum class Scalar : std::uint8_t { f64, f32, u8, u16, u32, u64, i8, i16, i32, i64, bytes };

[[nodiscard]] constexpr std::size_t scalar_size(Scalar type) {
  constexpr std::array<std::uint8_t, 11> kSizes{8, 4, 1, 2, 4, 8, 1, 2, 4, 8, 1};
  return kSizes[static_cast<std::size_t>(type)];
}

/// "f64", "u8" ... as recordings and layout hashes spell them.
[[nodiscard]] std::string_view scalar_name(Scalar type);

/// A short name that can be put together while compiling. Converts to std::string_view.
class FieldName {
 public:
  static constexpr std::size_t kCapacity = 63;

  constexpr FieldName() = default;
  constexpr FieldName(const char* text) : FieldName(std::string_view(text)) {}
  constexpr FieldName(std::string_view text) {
    for (const char c : text)
      push(c);
  }
  [[nodiscard]] constexpr std::string_view view() const { return {text_.data(), size_}; }
  constexpr operator std::string_view() const { return view(); }

  [[nodiscard]] constexpr FieldName operator+(std::string_view tail) const {
    FieldName result = *this;
    for (const char c : tail)
      result.push(c);
    return result;
  }
  [[nodiscard]] constexpr FieldName operator[](std::size_t index) const {
    std::array<char, 20> digits{};
    std::size_t count = 0;
    do
      digits[count++] = static_cast<char>('0' + index % 10);
    while ((index /= 10) != 0);
    FieldName result = *this + "[";
    while (count > 0)
      result.push(digits[--count]);
    return result + "]";
  }
  friend constexpr bool operator==(const FieldName& a, const FieldName& b) {
    return a.view() == b.view();
  }
  template <std::convertible_to<std::string_view> Text>
  friend constexpr bool operator==(const FieldName& a, const Text& b) {
    return a.view() == std::string_view(b);
  }

 private:
  constexpr void push(char c) {
    text_.at(size_) = c;  // a name that is too long does not compile
    ++size_;
  }
  std::array<char, kCapacity> text_{};
  std::uint8_t size_ = 0;
};

/// `count` scalars of one type, one after the other, at a byte offset of a row.
struct FieldInfo {
  FieldName name;
  std::uint32_t offset = 0;
  Scalar type = Scalar::bytes;
  std::uint32_t count = 1;
  std::string_view unit;                                ///< SI symbol, "" for none
  std::string_view (*choice)(std::uint64_t) = nullptr;  ///< name of an enum's value, "" if none

  [[nodiscard]] constexpr std::size_t size() const { return scalar_size(type) * count; }
};

template <class Row>
concept HasFields = requires {
  Row::fields();
};

}  // namespace eyrie

template <>
struct fmt::formatter<eyrie::FieldName> : fmt::formatter<std::string_view> {
  template <class Context>
  auto format(const eyrie::FieldName& name, Context& context) const {
    return fmt::formatter<std::string_view>::format(name.view(), context);
  }
};
