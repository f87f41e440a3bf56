// SPDX-License-Identifier: MIT
#include "sim/difference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "core/assert.hpp"
#include "core/field.hpp"

namespace eyrie::sim {

namespace {

/// The header of a world as text; the numbers of rows come with their tables.
std::optional<Difference> differ_in_header(const World& left, const World& right) {
  Difference found{.step = left.step()};
  const auto differ = [&](const char* name, std::uint64_t a, std::uint64_t b) {
    if (a == b || !found.field.empty())
      return;
    found.field = name;
    found.left = fmt::to_string(a);
    found.right = fmt::to_string(b);
  };
  differ("step", left.step(), right.step());
  differ("seed", left.seed(), right.seed());
  differ("next_id", left.next_id().value, right.next_id().value);
  differ("refused_births", left.refused_births(), right.refused_births());
  return found.field.empty() ? std::nullopt : std::optional(found);
}

/// One row of one column; `found` has the step, table and column already.
void name_field(Difference& found, const ColumnInfo& column, const std::byte* left,
                const std::byte* right) {
  const auto where = find_difference(column.fields, left, right);
  EYRIE_DEMAND(where.has_value(), "the fields of a column cover its rows");
  const FieldInfo& info = column.fields[where->field];
  found.field = scalar_label(info, where->index);
  found.left = format_scalar(info, left, where->index);
  found.right = format_scalar(info, right, where->index);
}

}  // namespace

std::optional<Difference> first_difference(const World& left, const World& right,
                                           std::uint32_t index) {
  const std::span<const std::byte> a = left.column_bytes(index);
  const std::span<const std::byte> b = right.column_bytes(index);
  const std::size_t common = std::min(a.size(), b.size());
  if (common == 0 || std::memcmp(a.data(), b.data(), common) == 0)
    return std::nullopt;

  const ColumnInfo& column = left.schema().column(index);
  const auto first =
      std::mismatch(a.begin(), a.begin() + static_cast<std::ptrdiff_t>(common), b.begin());
  const auto row = static_cast<std::uint32_t>((first.first - a.begin()) / column.stride);
  Difference found{.step = left.step(),
                   .table = left.schema().table(column.table).name,
                   .column = column.name,
                   .row = row,
                   .player = left.ids(column.table)[row]};
  const std::size_t at = std::size_t{row} * column.stride;
  name_field(found, column, a.data() + at, b.data() + at);
  return found;
}

std::string Difference::text() const {
  std::string what;
  for (const std::string& part : {table, column, field})
    if (!part.empty())
      what += (what.empty() ? "" : ".") + part;
  if (what.empty())
    what = "the world";
  if (row && player)
    what += fmt::format(" of player {} (row {})", player.value, *row);
  else if (row)
    what += fmt::format(" of row {}", *row);
  if (!rule.empty())
    return fmt::format("step {}: {} ({}: {}, {})", step, rule, what, left, right);
  if (left.empty() && right.empty())
    return fmt::format("step {}: {} differs", step, what);
  return fmt::format("step {}: {} is {}, and {} in the other", step, what, left, right);
}

std::optional<Difference> first_difference(const World& left, const World& right) {
  const Schema& schema = left.schema();
  EYRIE_THROW_UNLESS(schema.layout_hash() == right.schema().layout_hash(),
                     "only worlds of one layout can be compared");
  if (auto found = differ_in_header(left, right))
    return found;
  for (std::uint32_t t = 1; t <= schema.tables().size(); ++t) {
    const TableInfo& table = schema.table(TableId{t});
    for (const std::uint32_t index : table.columns)
      if (auto found = first_difference(left, right, index))
        return found;
    if (left.rows(TableId{t}) != right.rows(TableId{t}))
      return Difference{.step = left.step(),
                        .table = table.name,
                        .field = "rows",
                        .left = fmt::to_string(left.rows(TableId{t})),
                        .right = fmt::to_string(right.rows(TableId{t}))};
  }
  return std::nullopt;
}

std::optional<Difference> first_difference(std::uint64_t step, std::span<const Event> left,
                                           std::span<const Event> right) {
  const std::size_t common = std::min(left.size(), right.size());
  constexpr std::span<const FieldInfo> kFields = fields_of<Event>();
  for (std::size_t i = 0; i < common; ++i) {
    const auto* a = reinterpret_cast<const std::byte*>(&left[i]);
    const auto* b = reinterpret_cast<const std::byte*>(&right[i]);
    if (const auto where = find_difference(kFields, a, b)) {
      const FieldInfo& info = kFields[where->field];
      return Difference{.step = step,
                        .table = "events",
                        .row = static_cast<std::uint32_t>(i),
                        .player = left[i].who,
                        .field = scalar_label(info, where->index),
                        .left = format_scalar(info, a, where->index),
                        .right = format_scalar(info, b, where->index)};
    }
  }
  if (left.size() == right.size())
    return std::nullopt;
  return Difference{.step = step,
                    .table = "events",
                    .field = "count",
                    .left = fmt::to_string(left.size()),
                    .right = fmt::to_string(right.size())};
}

}  // namespace eyrie::sim
