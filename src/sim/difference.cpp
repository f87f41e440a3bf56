// SPDX-License-Identifier: MIT
#include "sim/difference.hpp"

#include <algorithm>

namespace eyrie::sim {

namespace {

/// Nothing if two numbers are the same.
std::optional<Difference> differ(std::uint64_t step, std::string table, std::string field,
                                 std::uint64_t left, std::uint64_t right) {
  if (left == right)
    return std::nullopt;
  return Difference{.step = step,
                    .table = std::move(table),
                    .field = std::move(field),
                    .left = fmt::to_string(left),
                    .right = fmt::to_string(right)};
}

/// The header of a world; the numbers of rows come with their tables.
std::optional<Difference> differ_in_header(const World& left, const World& right) {
  const std::uint64_t step = left.step();
  if (auto found = differ(step, "", "step", step, right.step()))
    return found;
  if (auto found = differ(step, "", "seed", left.seed(), right.seed()))
    return found;
  if (auto found = differ(step, "", "next_id", left.next_id().value, right.next_id().value))
    return found;
  return differ(step, "", "refused_births", left.refused_births(), right.refused_births());
}

/// Names the first field in which two rows differ; false if they are the same.
bool name_field(Difference& found, std::span<const FieldInfo> fields, const std::byte* left,
                const std::byte* right) {
  const auto where = find_difference(fields, left, right);
  if (!where)
    return false;
  const FieldInfo& info = fields[where->field];
  found.field = scalar_label(info, where->index);
  found.left = format_scalar(info, left, where->index);
  found.right = format_scalar(info, right, where->index);
  return true;
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
  EYRIE_DEMAND(name_field(found, column.fields, a.data() + at, b.data() + at),
               "the fields of a column cover its rows");
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
    if (auto found =
            differ(left.step(), table.name, "rows", left.rows(TableId{t}), right.rows(TableId{t})))
      return found;
  }
  return std::nullopt;
}

std::optional<Difference> first_difference(std::uint64_t step, std::span<const Event> left,
                                           std::span<const Event> right) {
  for (std::uint32_t i = 0; i < std::min(left.size(), right.size()); ++i) {
    Difference found{.step = step, .table = "events", .row = i, .player = left[i].who};
    if (name_field(found, fields_of<Event>(), reinterpret_cast<const std::byte*>(&left[i]),
                   reinterpret_cast<const std::byte*>(&right[i])))
      return found;
  }
  return differ(step, "events", "count", left.size(), right.size());
}

namespace {

/// Mixes one word into a running value. Cheaper than a full hash for scattered scalars: a digest
/// is to tell worlds apart, a World::hash() decides whether they are equal. The multiplier and the
/// shift are those of splitmix64 (Steele, Lea and Flood, OOPSLA 2014).
std::uint64_t mix(std::uint64_t value, std::uint64_t word) {
  value = (value ^ word) * 0xBF58476D1CE4E5B9u;
  return value ^ (value >> 31);
}

/// A scalar, or what is left of a slab of bytes.
std::uint64_t word_at(const std::byte* bytes, std::size_t size) {
  const auto load = [&]<class T>(T word) {
    std::memcpy(&word, bytes, sizeof word);
    return std::uint64_t{word};
  };
  switch (size) {
    case 8:
      return load(std::uint64_t{});
    case 4:
      return load(std::uint32_t{});
    case 2:
      return load(std::uint16_t{});
    case 1:
      return load(std::uint8_t{});
    default:
      break;
  }
  std::uint64_t rest = 0;
  std::memcpy(&rest, bytes, size);
  return rest;
}

/// One field of one row: of the bytes, of the field and of the row.
std::uint64_t cell(std::uint64_t seed, const std::byte* bytes, std::size_t size) {
  std::uint64_t value = seed;
  for (; size > sizeof(std::uint64_t); size -= sizeof(std::uint64_t)) {
    value = mix(value, word_at(bytes, sizeof(std::uint64_t)));
    bytes += sizeof(std::uint64_t);
  }
  return mix(value, word_at(bytes, size));
}

std::uint16_t digest_header(const World& world) {
  std::uint64_t value = mix(mix(0, world.step()), world.seed());
  value = mix(mix(value, world.next_id().value), world.refused_births());
  for (std::uint32_t t = 1; t <= world.schema().tables().size(); ++t)
    value = mix(value, world.rows(TableId{t}));
  return fold(value);
}

/// The golden ratio in 64 bits: seeds that lie apart.
constexpr std::uint64_t kApart = 0x9E3779B97F4A7C15u;

/// The fields of a column, each the sum of its cells, which are also added to their rows. Sums and
/// not chains, so that the processor works on many cells at once.
void digest_column(const ColumnInfo& column, std::span<const std::byte> bytes,
                   std::span<std::uint64_t> rows, std::vector<std::uint16_t>& fields) {
  for (const FieldInfo& field : column.fields) {
    const std::size_t size = field.size();
    const std::uint64_t number = (fields.size() + 1) * kApart;
    std::uint64_t sum = 0, seed = number;
    const std::byte* at = bytes.data() + field.offset;
    for (std::uint64_t& row : rows) {
      const std::uint64_t value = cell(seed, at, size);
      sum += value;
      row += value;
      seed += number;
      at += column.stride;
    }
    fields.push_back(fold(sum));
  }
}

/// The rows of one table, which stand together and in order.
std::span<const Digest::Row> rows_of(const Digest& digest, std::uint32_t table) {
  const auto rows = std::ranges::equal_range(digest.rows, table, {}, &Digest::Row::table);
  return {rows.begin(), rows.end()};
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

void digest(const World& world, Digest& out) {
  const Schema& schema = world.schema();
  out.step = world.step();
  out.header = digest_header(world);
  out.fields.clear();
  out.rows.clear();
  std::vector<std::uint64_t> sums;
  for (std::uint32_t t = 1; t <= schema.tables().size(); ++t)
    sums.resize(sums.size() + world.rows(TableId{t}));
  const auto rows_of_table = [&](TableId table) {
    std::size_t first = 0;
    for (std::uint32_t t = 1; t < table.value; ++t)
      first += world.rows(TableId{t});
    return std::span(sums).subspan(first, world.rows(table));
  };
  for (std::uint32_t i = 0; i < schema.columns().size(); ++i)
    digest_column(schema.column(i), world.column_bytes(i), rows_of_table(schema.column(i).table),
                  out.fields);
  for (std::uint32_t t = 1; t <= schema.tables().size(); ++t)
    for (std::uint32_t row = 0; row < world.rows(TableId{t}); ++row)
      out.rows.push_back({.table = t,
                          .player = world.ids(TableId{t})[row],
                          .hash = fold(rows_of_table(TableId{t})[row])});
}

Digest digest(const World& world) {
  Digest out;
  digest(world, out);
  return out;
}

std::optional<Difference> compare(const Schema& schema, const Digest& left, const Digest& right) {
  if (left == right)
    return std::nullopt;
  if (auto found =
          differ(left.step, "", "number of fields", left.fields.size(), right.fields.size()))
    return found;

  // the first field that differs says which column it is
  const auto first = std::mismatch(left.fields.begin(), left.fields.end(), right.fields.begin());
  auto index = static_cast<std::size_t>(first.first - left.fields.begin());
  Difference found{.step = left.step};
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
