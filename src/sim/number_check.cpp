// SPDX-License-Identifier: MIT
#include "sim/number_check.hpp"

#include <fmt/format.h>

#include <cstring>

#include "core/field.hpp"

namespace eyrie::sim {
namespace {

/// Whether one of `count` numbers is NaN or infinite: all bits of its exponent are set.
template <class Bits>
bool any_beyond(const std::byte* numbers, std::uint32_t count, Bits exponent) {
  bool beyond = false;
  for (std::uint32_t i = 0; i < count; ++i) {
    Bits bits;
    std::memcpy(&bits, numbers + i * sizeof bits, sizeof bits);
    beyond |= (bits & exponent) == exponent;
  }
  return beyond;
}
bool any_beyond(Scalar type, const std::byte* numbers, std::uint32_t count) {
  return type == Scalar::f64 ? any_beyond<std::uint64_t>(numbers, count, 0x7ff0000000000000)
                             : any_beyond<std::uint32_t>(numbers, count, 0x7f800000);
}

/// The first one in a row, with its name and unit.
std::string words_for(const ColumnInfo& column, const std::byte* row) {
  for (const FieldInfo& field : column.fields)
    if (field.type == Scalar::f64 || field.type == Scalar::f32)
      for (std::uint32_t i = 0; i < field.count; ++i)
        if (any_beyond(field.type, row + field.offset + i * scalar_size(field.type), 1))
          return fmt::format("{}.{} is {}{}{}", column.name, scalar_label(field, i),
                             scalar_value(field, row, i), field.unit.empty() ? "" : " ",
                             field.unit);
  return {};
}

}  // namespace

NumberCheck::NumberCheck(const Schema& schema) {
  for (std::uint32_t c = 0; c < schema.columns().size(); ++c)
    for (const FieldInfo& field : schema.column(c).fields) {
      if (field.type != Scalar::f64 && field.type != Scalar::f32)
        continue;
      Stretch* last = stretches_.empty() ? nullptr : &stretches_.back();
      if (last && last->column == c && last->type == field.type &&
          last->offset + last->count * scalar_size(last->type) == field.offset)
        last->count += field.count;
      else
        stretches_.push_back({c, field.offset, field.count, field.type});
    }
}

std::optional<Fault> NumberCheck::find(const World& world) const {
  for (const Stretch& s : stretches_) {
    const ColumnInfo& column = world.schema().column(s.column);
    const auto bytes = world.column_bytes(s.column);
    for (std::size_t at = 0; at < bytes.size(); at += column.stride)
      if (any_beyond(s.type, bytes.data() + at + s.offset, s.count)) [[unlikely]]
        return Fault{.player = world.ids(column.table)[at / column.stride],
                     .what = words_for(column, bytes.data() + at)};
  }
  return std::nullopt;
}

}  // namespace eyrie::sim
