// SPDX-License-Identifier: MIT
#include "core/field.hpp"

#include <cstring>

namespace eyrie {
namespace {

template <class T>
T load(const std::byte* from) {
  T value;
  std::memcpy(&value, from, sizeof(value));
  return value;
}

const std::byte* address(const FieldInfo& info, const std::byte* row, std::uint32_t index) {
  return row + info.offset + index * scalar_size(info.type);
}

/// Calls `use` with the scalar as its own C++ type.
template <class Use>
auto with_scalar(const FieldInfo& info, const std::byte* row, std::uint32_t index, Use use) {
  const std::byte* from = address(info, row, index);
  switch (info.type) {
    case Scalar::f64:
      return use(load<double>(from));
    case Scalar::f32:
      return use(load<float>(from));
    case Scalar::u16:
      return use(load<std::uint16_t>(from));
    case Scalar::u32:
      return use(load<std::uint32_t>(from));
    case Scalar::u64:
      return use(load<std::uint64_t>(from));
    case Scalar::i8:
      return use(load<std::int8_t>(from));
    case Scalar::i16:
      return use(load<std::int16_t>(from));
    case Scalar::i32:
      return use(load<std::int32_t>(from));
    case Scalar::i64:
      return use(load<std::int64_t>(from));
    case Scalar::u8:
    case Scalar::bytes:
      break;
  }
  return use(load<std::uint8_t>(from));
}

}  // namespace

std::string_view scalar_name(Scalar type) {
  constexpr std::array<std::string_view, 11> kNames{"f64", "f32", "u8",  "u16", "u32",  "u64",
                                                    "i8",  "i16", "i32", "i64", "bytes"};
  return kNames[static_cast<std::size_t>(type)];
}

std::string format_scalar(const FieldInfo& info, const std::byte* row, std::uint32_t index) {
  return with_scalar(info, row, index, [&](auto value) {
    if (info.type == Scalar::bytes)
      return fmt::format("{:02x}", static_cast<std::uint8_t>(value));
    if (info.choice)
      if (const std::string_view name = info.choice(static_cast<std::uint64_t>(value));
          !name.empty())
        return std::string(name);
    return fmt::format("{}", value);
  });
}

double scalar_value(const FieldInfo& info, const std::byte* row, std::uint32_t index) {
  return with_scalar(info, row, index, [](auto value) { return static_cast<double>(value); });
}

std::string scalar_label(const FieldInfo& info, std::uint32_t index) {
  return info.count == 1 ? std::string(info.name) : fmt::format("{}[{}]", info.name, index);
}

std::optional<FieldDifference> find_difference(std::span<const FieldInfo> fields,
                                               const std::byte* a, const std::byte* b) {
  for (std::size_t f = 0; f < fields.size(); ++f)
    for (std::uint32_t i = 0; i < fields[f].count; ++i)
      if (std::memcmp(address(fields[f], a, i), address(fields[f], b, i),
                      scalar_size(fields[f].type)) != 0)
        return FieldDifference{f, i};
  return std::nullopt;
}

}  // namespace eyrie
