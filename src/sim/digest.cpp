// SPDX-License-Identifier: MIT
#include "sim/digest.hpp"

#include <algorithm>
#include <cstring>
#include <span>
#include <string>

#include "core/assert.hpp"
#include "core/hash.hpp"

namespace eyrie::sim {

namespace {

/// Mixes one word into a running value. Cheaper than a full hash for scattered scalars: a digest
/// is to tell worlds apart, a World::hash() decides whether they are equal. The multiplier and the
/// shift are those of splitmix64 (Steele, Lea and Flood, OOPSLA 2014).
std::uint64_t mix(std::uint64_t value, std::uint64_t word) {
  value = (value ^ word) * 0xBF58476D1CE4E5B9u;
  return value ^ (value >> 31);
}

std::uint64_t mix_bytes(std::uint64_t value, const std::byte* bytes, std::size_t size) {
  for (; size >= sizeof(std::uint64_t); size -= sizeof(std::uint64_t)) {
    std::uint64_t word;
    std::memcpy(&word, bytes, sizeof word);
    value = mix(value, word);
    bytes += sizeof word;
  }
  if (size == 0)
    return value;
  std::uint64_t rest = 0;
  std::memcpy(&rest, bytes, size);
  return mix(value, rest);
}

std::uint32_t digest_header(const World& world) {
  std::uint64_t value = mix(mix(0, world.step()), world.seed());
  value = mix(mix(value, world.next_id().value), world.refused_births());
  for (std::uint32_t t = 1; t <= world.schema().tables().size(); ++t)
    value = mix(value, world.rows(TableId{t}));
  return fold(value);
}

/// Appends one digest per field of a column.
void digest_fields(std::vector<std::uint32_t>& out, const ColumnInfo& column,
                   std::span<const std::byte> bytes) {
  for (const FieldInfo& field : column.fields) {
    std::uint64_t value = 0;
    for (std::size_t at = field.offset; at < bytes.size(); at += column.stride)
      value = mix_bytes(value, bytes.data() + at, field.size());
    out.push_back(fold(value));
  }
}

Digest::Row digest_row(const World& world, TableId table, std::uint32_t row) {
  std::uint64_t value = 0;
  for (const std::uint32_t index : world.schema().table(table).columns) {
    const std::size_t stride = world.schema().column(index).stride;
    value = mix(value, hash_bytes(world.column_bytes(index).subspan(row * stride, stride)));
  }
  return {.table = table.value, .player = world.ids(table)[row], .hash = fold(value)};
}

/// The rows of one table, which stand together and in order.
std::span<const Digest::Row> rows_of(const Digest& digest, std::uint32_t table) {
  const auto [first, last] = std::equal_range(
      digest.rows.begin(), digest.rows.end(), Digest::Row{.table = table},
      [](const Digest::Row& a, const Digest::Row& b) { return a.table < b.table; });
  return {first, last};
}

/// Names the first row that is not the same or exists on one side only, in the table of the field
/// that differs if that is known.
void name_row(Difference& found, const Schema& schema, const Digest& left, const Digest& right) {
  const std::uint32_t table = schema.find_table(found.table).value;
  for (std::uint32_t t = 1; t <= schema.tables().size(); ++t) {
    if (table != 0 && t != table)
      continue;
    const std::span<const Digest::Row> a = rows_of(left, t);
    const std::span<const Digest::Row> b = rows_of(right, t);
    const auto [in_a, in_b] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
    if (in_a == a.end() && in_b == b.end())
      continue;
    found.table = schema.table(TableId{t}).name;
    found.row = static_cast<std::uint32_t>(in_a - a.begin());
    found.player = in_a != a.end() ? in_a->player : in_b->player;
    return;
  }
}

}  // namespace

Digest digest(const World& world) {
  const Schema& schema = world.schema();
  Digest out{.step = world.step(), .header = digest_header(world), .fields = {}, .rows = {}};
  for (std::uint32_t i = 0; i < schema.columns().size(); ++i)
    digest_fields(out.fields, schema.column(i), world.column_bytes(i));
  for (std::uint32_t t = 1; t <= schema.tables().size(); ++t)
    for (std::uint32_t row = 0; row < world.rows(TableId{t}); ++row)
      out.rows.push_back(digest_row(world, TableId{t}, row));
  return out;
}

std::optional<Difference> compare(const Schema& schema, const Digest& left, const Digest& right) {
  if (left == right)
    return std::nullopt;
  Difference found{.step = left.step};
  if (left.fields.size() != right.fields.size()) {
    found.field = "number of fields";
    found.left = std::to_string(left.fields.size());
    found.right = std::to_string(right.fields.size());
    return found;
  }

  // the first field that differs says which column it is
  const auto first = std::mismatch(left.fields.begin(), left.fields.end(), right.fields.begin());
  auto index = static_cast<std::size_t>(first.first - left.fields.begin());
  for (const ColumnInfo& column : schema.columns()) {
    if (index < column.fields.size()) {
      found.table = schema.table(column.table).name;
      found.column = column.name;
      found.field = column.fields[index].name.view();
      break;
    }
    index -= column.fields.size();
  }
  name_row(found, schema, left, right);
  if (found.field.empty() && !found.row)
    found.field = left.step != right.step ? "step" : "header";
  return found;
}

}  // namespace eyrie::sim
