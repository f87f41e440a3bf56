// SPDX-License-Identifier: MIT
#pragma once
/// \file  Which C++ types a field may have and how each becomes scalars. Include core/field.hpp.
#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

#include "core/enum_names.hpp"
#include "core/field_info.hpp"
#include "core/id.hpp"
#include "core/vec.hpp"

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

template <class T>
struct ArrayOf {
  using element = void;
  static constexpr std::size_t size = 0;
};
template <class T, std::size_t N>
struct ArrayOf<std::array<T, N>> {
  using element = T;
  static constexpr std::size_t size = N;
};
template <class T, std::size_t N>
struct ArrayOf<T[N]> {
  using element = T;
  static constexpr std::size_t size = N;
};

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

/// The members of the aggregates of core/vec.hpp, which cannot describe themselves.
template <class T>
struct Parts;
template <>
struct Parts<Vec3> {
  static constexpr auto list() {
    return std::array{std::pair{".x", &Vec3::x}, std::pair{".y", &Vec3::y},
                      std::pair{".z", &Vec3::z}};
  }
};
template <>
struct Parts<Mat3> {
  static constexpr auto list() {
    return std::array{std::pair{".row_x", &Mat3::row_x}, std::pair{".row_y", &Mat3::row_y},
                      std::pair{".row_z", &Mat3::row_z}};
  }
};

template <class T, class Member>
constexpr auto member_type(Member T::*) -> Member;

/// Every scalar of a `T` at `offset`, as std::array<FieldInfo, N>.
template <class T>
constexpr auto flatten(FieldName name, std::uint32_t offset, std::string_view unit);

/// The same for `Count` of them, one after the other; `name_of(i)` names them.
template <class T, std::size_t Count, class NameOf, class OffsetOf>
constexpr auto flatten_each(NameOf name_of, OffsetOf offset_of_part, std::string_view unit) {
  constexpr std::size_t kEach = decltype(flatten<T>("", 0u, "")){}.size();
  std::array<FieldInfo, kEach * Count> result{};
  for (std::size_t i = 0; i < Count; ++i) {
    const auto part = flatten<T>(name_of(i), offset_of_part(i), unit);
    for (std::size_t k = 0; k < kEach; ++k)
      result[i * kEach + k] = part[k];
  }
  return result;
}

template <class T>
constexpr auto flatten(FieldName name, std::uint32_t offset, std::string_view unit) {
  using Element = typename ArrayOf<T>::element;
  if constexpr (is_one_scalar<T>) {
    return std::array{scalars<T>(name, offset, 1, unit)};
  } else if constexpr (is_one_scalar<Element>) {
    return std::array{scalars<Element>(name, offset, ArrayOf<T>::size, unit)};
  } else if constexpr (ArrayOf<T>::size != 0) {
    return flatten_each<Element, ArrayOf<T>::size>(
        [&](std::size_t i) { return name[i]; },
        [&](std::size_t i) { return static_cast<std::uint32_t>(offset + i * sizeof(Element)); },
        unit);
  } else if constexpr (HasFields<T>) {
    auto result = T::fields();
    for (FieldInfo& info : result) {
      info.name = name + "." + info.name;
      info.offset += offset;
    }
    return result;
  } else {
    constexpr auto kParts = Parts<T>::list();
    using Part = decltype(member_type(kParts[0].second));
    return flatten_each<Part, kParts.size()>(
        [&](std::size_t i) { return name + kParts[i].first; },
        [&](std::size_t i) { return offset + offset_of(kParts[i].second); }, unit);
  }
}

template <HasFields Row>
inline constexpr auto kFields = Row::fields();

}  // namespace eyrie::detail
