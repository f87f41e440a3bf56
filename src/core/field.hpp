// SPDX-License-Identifier: MIT
#pragma once
/// \file  A row describes its scalars once: for hashing, recording, comparing and printing.
///
///   struct Fuel {
///     double mass = 0, flow = 0;
///     std::array<float, 3> tanks{};
///     std::uint8_t reserved[4]{};
///     static constexpr auto fields() {
///       return field_list(field("mass", &Fuel::mass, "kg"), field("flow", &Fuel::flow, "kg/s"),
///                         field("tanks", &Fuel::tanks, "kg"), field("reserved", &Fuel::reserved));
///     }
///   };
///
/// field() takes scalars, enums, ids, Vec3, Mat3, nested rows, and arrays (std or C) of
/// these. Arrays of scalars stay one field with a count; all else becomes one field per scalar,
/// with names such as "position.x" or "tracks[3].range".
#include <fmt/format.h>

#include <optional>
#include <ranges>

#include "core/enum_names.hpp"
#include "core/id.hpp"
#include "core/units.hpp"
#include "core/vec.hpp"

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

namespace eyrie::detail {

/// Offset of a member, also while compiling: compares the address of the member with the address of
/// every byte of a union that holds both.
template <class Row, class Member>
constexpr std::uint32_t offset_of(Member Row::*member) {
  union Overlay {
    constexpr Overlay() : bytes{} {}
    unsigned char bytes[sizeof(Row)];
    Row row;
  };
  const Overlay overlay;
  for (std::uint32_t i = 0; i < sizeof(Row); ++i)
    if (static_cast<const void*>(&(overlay.row.*member)) ==
        static_cast<const void*>(&overlay.bytes[i]))
      return i;
  return sizeof(Row);
}

/// How many elements an array has; 0 for what is none.
template <class T>
inline constexpr std::size_t array_size = 0;
template <class T, std::size_t N>
inline constexpr std::size_t array_size<std::array<T, N>> = N;
template <class T, std::size_t N>
inline constexpr std::size_t array_size<T[N]> = N;

template <class T>
inline constexpr bool is_id = false;
template <class Tag>
inline constexpr bool is_id<Id<Tag>> = true;

template <class T>
inline constexpr bool is_one_scalar =
    std::is_arithmetic_v<T> || std::is_enum_v<T> || is_id<T>;  // std::byte is an enum

template <class T>
constexpr Scalar scalar_type() {
  if constexpr (std::is_same_v<T, std::byte>) {
    return Scalar::bytes;
  } else if constexpr (is_id<T>) {
    return Scalar::u32;
  } else if constexpr (std::is_enum_v<T>) {
    return scalar_type<std::underlying_type_t<T>>();
  } else if constexpr (std::is_floating_point_v<T>) {
    static_assert(sizeof(T) == 8 || sizeof(T) == 4, "long double has padding");
    return sizeof(T) == 8 ? Scalar::f64 : Scalar::f32;
  } else {
    constexpr Scalar kUnsigned[]{Scalar::u8, Scalar::u16, Scalar::u32, Scalar::u64};
    constexpr Scalar kSigned[]{Scalar::i8, Scalar::i16, Scalar::i32, Scalar::i64};
    constexpr std::size_t kLog2 = sizeof(T) == 1 ? 0 : sizeof(T) == 2 ? 1 : sizeof(T) == 4 ? 2 : 3;
    return std::is_signed_v<T> ? kSigned[kLog2] : kUnsigned[kLog2];
  }
}

template <NamedEnum E>
constexpr std::string_view choice_name(std::uint64_t value) {
  return enum_name(static_cast<E>(value));
}

template <class T>
constexpr FieldInfo scalars(FieldName name, std::uint32_t offset, std::uint32_t count,
                            std::string_view unit) {
  FieldInfo info{name, offset, scalar_type<T>(), count, unit};
  if constexpr (NamedEnum<T>)
    info.choice = &choice_name<T>;
  return info;
}

/// Every scalar of a `T` at `offset`, as std::array<FieldInfo, N>.
template <class T>
constexpr auto flatten(FieldName name, std::uint32_t offset, std::string_view unit) {
  if constexpr (is_one_scalar<T>) {
    return std::array{scalars<T>(name, offset, 1, unit)};
  } else if constexpr (array_size<T> != 0) {
    using Element = std::ranges::range_value_t<T>;
    if constexpr (is_one_scalar<Element>) {
      return std::array{scalars<Element>(name, offset, array_size<T>, unit)};
    } else {
      constexpr std::size_t kEach = decltype(flatten<Element>(name, offset, unit)){}.size();
      std::array<FieldInfo, kEach * array_size<T>> result{};
      for (std::size_t i = 0, next = 0; i < array_size<T>; ++i)
        for (const FieldInfo& info : flatten<Element>(
                 name[i], static_cast<std::uint32_t>(offset + i * sizeof(Element)), unit))
          result[next++] = info;
      return result;
    }
  } else if constexpr (HasFields<T>) {
    auto result = T::fields();
    for (FieldInfo& info : result) {
      info.name = name + "." + info.name;
      info.offset += offset;
    }
    return result;
  } else if constexpr (std::is_same_v<T, Mat3>) {
    using Row = decltype(T::row_x);
    std::array<FieldInfo, 9> result{};
    std::size_t next = 0;
    for (const auto& [part, row] :
         {std::pair(".row_x", &Mat3::row_x), {".row_y", &Mat3::row_y}, {".row_z", &Mat3::row_z}})
      for (const FieldInfo& info : flatten<Row>(name + part, offset + offset_of(row), unit))
        result[next++] = info;
    return result;
  } else {
    static_assert(std::is_same_v<T, Vec3>,
                  "a row has scalars, Vec3, Mat3, rows, and arrays of these");
    return std::array{scalars<double>(name + ".x", offset + offset_of(&Vec3::x), 1, unit),
                      scalars<double>(name + ".y", offset + offset_of(&Vec3::y), 1, unit),
                      scalars<double>(name + ".z", offset + offset_of(&Vec3::z), 1, unit)};
  }
}

template <HasFields Row>
inline constexpr auto kFields = Row::fields();

}  // namespace eyrie::detail

namespace eyrie {

/// The fields of one member: a std::array<FieldInfo, N>, where N depends on the type.
template <class Row, class Member>
[[nodiscard]] constexpr auto field(std::string_view name, Member Row::*member, Unit unit = {}) {
  return detail::flatten<Member>(name, detail::offset_of(member), unit.si_symbol);
}

/// Joins what field() returned, in the order of the members.
template <std::size_t... N>
[[nodiscard]] constexpr auto field_list(const std::array<FieldInfo, N>&... parts) {
  std::array<FieldInfo, (0 + ... + N)> result{};
  std::size_t next = 0;
  const auto append = [&](const auto& part) {
    for (const FieldInfo& info : part)
      result[next++] = info;
  };
  (append(parts), ...);
  return result;
}

/// True if the fields cover every byte of a row exactly once: no padding, nothing forgotten.
template <HasFields Row>
[[nodiscard]] constexpr bool fields_cover_row() {
  std::array<bool, sizeof(Row)> covered{};
  for (const FieldInfo& info : detail::kFields<Row>)
    for (std::size_t i = info.offset; i < info.offset + info.size(); ++i) {
      if (i >= covered.size() || covered[i])
        return false;
      covered[i] = true;
    }
  for (const bool byte : covered)
    if (!byte)
      return false;
  return std::is_trivially_copyable_v<Row>;
}

/// One table per row type, alive for the whole program.
template <HasFields Row>
[[nodiscard]] constexpr std::span<const FieldInfo> fields_of() {
  return detail::kFields<Row>;
}

/// A scalar of the row that starts at `row`, exactly: numbers in their shortest form that reads
/// back to the same bits, enums by name, bytes as hexadecimal.
[[nodiscard]] std::string format_scalar(const FieldInfo& info, const std::byte* row,
                                        std::uint32_t index = 0);

/// The scalar as a double (64-bit integers beyond 2^53 are rounded).
[[nodiscard]] double scalar_value(const FieldInfo& info, const std::byte* row,
                                  std::uint32_t index = 0);

/// "gains[2]", or the name alone if the field is a single scalar.
[[nodiscard]] std::string scalar_label(const FieldInfo& info, std::uint32_t index);

/// The first scalar whose bits differ between two rows.
struct FieldDifference {
  std::size_t field = 0;  ///< index into `fields`
  std::uint32_t index = 0;
};
[[nodiscard]] std::optional<FieldDifference> find_difference(std::span<const FieldInfo> fields,
                                                             const std::byte* a,
                                                             const std::byte* b);

}  // namespace eyrie

template <>
struct fmt::formatter<eyrie::FieldName> : fmt::formatter<std::string_view> {
  template <class Context>
  auto format(const eyrie::FieldName& name, Context& context) const {
    return fmt::formatter<std::string_view>::format(name.view(), context);
  }
};
