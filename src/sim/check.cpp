// SPDX-License-Identifier: MIT
#include "sim/check.hpp"

#include <algorithm>

namespace eyrie::sim {
namespace {

/// The first one in a row, with its name and unit.
std::string words_for(const ColumnInfo& column, const std::byte* row) {
  for (const FieldInfo& field : column.fields)
    if (field.type == Scalar::f64 || field.type == Scalar::f32)
      for (std::uint32_t i = 0; i < field.count; ++i)
        if (!std::isfinite(scalar_value(field, row, i)))
          return fmt::format("{}.{} is {}{}{}", column.name, scalar_label(field, i),
                             scalar_value(field, row, i), field.unit.empty() ? "" : " ",
                             field.unit);
  return {};
}

}  // namespace

NumberCheck::NumberCheck(const Schema& schema) {
  constexpr std::uint32_t kDouble = 0x7ff00000,
                          kFloat = 0x7f800000;  // a double's is its upper word
  for (std::uint32_t c = 0; c < schema.columns().size(); ++c) {
    Words words{.column = c};
    for (const FieldInfo& field : schema.column(c).fields) {
      if (field.type != Scalar::f64 && field.type != Scalar::f32)
        continue;
      words.mask.resize(schema.column(c).stride / sizeof(std::uint32_t));
      const std::size_t in_words = scalar_size(field.type) / sizeof(std::uint32_t);
      for (std::uint32_t i = 0; i < field.count; ++i)
        words.mask[field.offset / sizeof(std::uint32_t) + (i + 1) * in_words - 1] =
            field.type == Scalar::f64 ? kDouble : kFloat;
    }
    while (!words.mask.empty() && words.mask.back() == 0)
      words.mask.pop_back();
    for (const std::uint32_t mask : words.mask)
      words.lowest.push_back(mask & (~mask + 1));
    if (!words.mask.empty())
      columns_.push_back(std::move(words));
  }
}

std::optional<Fault> NumberCheck::find(const World& world) const {
  for (const Words& words : columns_) {
    const ColumnInfo& column = world.schema().column(words.column);
    const auto bytes = world.column_bytes(words.column);
    for (std::size_t at = 0; at < bytes.size(); at += column.stride) {
      std::uint32_t beyond = 0;
#pragma GCC unroll 4
      for (std::size_t i = 0; i < words.mask.size(); ++i) {
        std::uint32_t bits;
        std::memcpy(&bits, bytes.data() + at + i * sizeof bits, sizeof bits);
        beyond |= (bits & words.mask[i]) + words.lowest[i];
      }
      if (beyond >> 31 != 0) [[unlikely]]
        return Fault{.player = world.ids(column.table)[at / column.stride],
                     .what = words_for(column, bytes.data() + at)};
    }
  }
  return std::nullopt;
}

namespace {

bool is_serial(Phase phase) {
  return phase == Phase::orders || phase == Phase::commit;
}

/// "only by flight in move"
std::string writers_text(const ColumnInfo& column) {
  std::string text;
  for (const WrittenBy& by : *column.writers)
    text += fmt::format("{}{} in {}", text.empty() ? "only by " : " and by ", by.system,
                        enum_name(by.phase));
  return text.empty() ? "by nobody" : text;
}

}  // namespace

void WriteCheck::note(std::optional<Difference> difference, const System& system, Phase phase,
                      const std::string& rule) {
  if (!difference || found_)
    return;
  difference->rule = fmt::format("{} in {} {}", system.name(), enum_name(phase), rule);
  found_ = std::move(difference);
}

void WriteCheck::compare_columns(const World& world, const System& system, Phase phase) {
  const Schema& schema = world.schema();
  for (std::uint32_t index = 0; index < schema.columns().size(); ++index) {
    const ColumnInfo& column = schema.column(index);
    const auto& own = schema.table(column.table).columns;
    if (phase == Phase::commit && index == own[1])
      continue;  // the marks of those who leave
    const WrittenBy here{system.name(), phase};
    const bool may = index != own[0] && index != own[1] &&
                     (!column.writers || std::find(column.writers->begin(), column.writers->end(),
                                                   here) != column.writers->end());
    if (may && (is_serial(phase) || column.table == system.table()))
      continue;
    const std::string rule =
        may ? "writes a row of another table"
            : "writes what is written " + (column.writers ? writers_text(column) : "by nobody");
    note(first_difference(before_, world, index), system, phase, rule);
  }
}

void WriteCheck::end(const World& world, const System& system, Phase phase) {
  compare_columns(world, system, phase);
}

void WriteCheck::end(const World& world, const System& system, Phase phase,
                     const std::function<void(World&, Chunk)>& again) {
  compare_columns(world, system, phase);
  const std::size_t rows = world.rows(system.table());
  const auto& columns = world.schema().table(system.table()).columns;
  for (std::size_t row = rows; row-- > 0;) {
    const bool looked_at = row == world.step() % rows;
    if (looked_at)
      last_ = before_;
    again(before_, {row, row + 1});
    if (!looked_at)
      continue;
    for (const std::uint32_t index : columns) {
      const auto mine = std::as_const(before_).bytes(ByteColumn{index}, row);
      std::memcpy(last_.bytes(ByteColumn{index}, row).data(), mine.data(), mine.size());
    }
    note(first_difference(last_, before_), system, phase,
         fmt::format("writes another row than its own, {}", row));
  }
  note(first_difference(world, before_), system, phase,
       "reads what another row writes then: it differs with the order of the rows");
}

}  // namespace eyrie::sim
