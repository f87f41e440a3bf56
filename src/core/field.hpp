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
///   static_assert(fields_cover_row<Fuel>());
///
/// field() takes scalars, enums, ids, Vec3, Mat3, nested rows, and arrays (std or C) of
/// these. Arrays of scalars stay one field with a count; all else becomes one field per scalar,
/// with names such as "position.x" or "tracks[3].range".
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

#include "core/field_info.hpp"
#include "core/field_types.hpp"
#include "core/units.hpp"

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
  for (const FieldInfo& info : Row::fields())
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

/// A field of the row that starts at `row`, exactly: numbers in their shortest form that reads back
/// to the same bits, enums by name, several scalars as "[1, 2]", bytes as hexadecimal.
[[nodiscard]] std::string format_scalar(const FieldInfo& info, const std::byte* row);

/// Only the scalar number `index` of a field.
[[nodiscard]] std::string format_scalar(const FieldInfo& info, const std::byte* row,
                                        std::uint32_t index);

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
