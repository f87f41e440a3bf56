// SPDX-License-Identifier: MIT
#include "sim/schema.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>

#include "core/hash.hpp"
#include "core/text.hpp"
#include "sim/world.hpp"

namespace eyrie::sim {

namespace {

constexpr std::uint32_t kMostRows = 1u << 24;
constexpr std::uint32_t kWidestSlab = 1u << 20;

[[noreturn]] void misuse(const std::string& words) {
  throw std::logic_error("schema: " + words);
}

void demand_identifier(std::string_view name) {
  const auto letter = [](char c) { return is_small(c) || c == '_'; };
  const bool good =
      !name.empty() && letter(name[0]) &&
      std::all_of(name.begin(), name.end(), [&](char c) { return letter(c) || is_digit(c); });
  if (!good)
    misuse(fmt::format("'{}' is not a lower-case identifier", name));
}

void add_text(Hasher& hasher, std::string_view text) {
  hasher.word(text.size());
  hasher.bytes(text.data(), text.size());
}

std::uint64_t hash_layout(const Schema& schema) {
  Hasher hasher;
  for (const TableInfo& table : schema.tables()) {
    add_text(hasher, table.name);
    hasher.word(table.columns.size());
    for (const std::uint32_t index : table.columns) {
      const ColumnInfo& column = schema.column(index);
      add_text(hasher, column.name);
      hasher.word(column.fields.size());
      for (const FieldInfo& field : column.fields) {
        add_text(hasher, field.name);
        hasher.word(field.offset);
        add_text(hasher, scalar_name(field.type));
        hasher.word(field.count);
      }
    }
  }
  return hasher.value();
}

std::uint64_t round_up(std::uint64_t bytes) {
  return (bytes + Schema::kAlignment - 1) / Schema::kAlignment * Schema::kAlignment;
}

}  // namespace

TableId Schema::find_table(std::string_view name) const {
  for (std::uint32_t i = 0; i < tables_.size(); ++i)
    if (tables_[i].name == name)
      return TableId{i + 1};
  return {};
}

std::uint32_t Schema::find_column(TableId table, std::string_view name) const {
  for (const std::uint32_t index : this->table(table).columns)
    if (columns_[index].name == name)
      return index;
  return kNoColumn;
}

Schema& SchemaBuilder::open() const {
  if (schema_ == nullptr)
    misuse("it was built already");
  return *schema_;
}

TableId SchemaBuilder::add_table(std::string_view name, std::uint32_t capacity) {
  Schema& schema = open();
  demand_identifier(name);
  if (schema.find_table(name))
    misuse(fmt::format("table '{}' is added twice", name));
  if (capacity == 0 || capacity > kMostRows)
    misuse(fmt::format("table '{}' must have room for 1 to {} rows, not {}", name, kMostRows,
                       capacity));
  schema.tables_.push_back({.name = std::string(name), .capacity = capacity, .columns = {}});
  const TableId table{static_cast<std::uint32_t>(schema.tables_.size())};

  constexpr FieldInfo kId{.name = "id", .type = Scalar::u32};
  constexpr FieldInfo kMark{.name = "leaving", .type = Scalar::u8};
  add(table, "id", sizeof(PlayerId), {&kId, 1});
  add(table, "leaving", 1, {&kMark, 1});
  return table;
}

ByteColumn SchemaBuilder::add_bytes(TableId table, std::string_view name, std::uint32_t stride) {
  constexpr std::uint32_t kAlignment = 8;
  if (stride == 0 || stride > kWidestSlab || stride % kAlignment != 0)
    misuse(fmt::format("'{}': a stride of {} bytes is not in [1, {}] or no multiple of {}", name,
                       stride, kWidestSlab, kAlignment));
  const FieldInfo bytes{.name = "bytes", .type = Scalar::bytes, .count = stride};
  return {add(table, name, stride, {&bytes, 1})};
}

std::uint32_t SchemaBuilder::add(TableId table, std::string_view name, std::size_t stride,
                                 std::span<const FieldInfo> fields) {
  Schema& schema = open();
  demand_identifier(name);
  if (!table || table.value > schema.tables_.size())
    misuse(fmt::format("column '{}' is added to an unknown table", name));
  TableInfo& info = schema.tables_[table.value - 1];
  if (schema.find_column(table, name) != kNoColumn)
    misuse(fmt::format("column '{}' is added twice to table '{}'", name, info.name));
  std::set<std::string_view> names;
  for (const FieldInfo& field : fields)
    if (!names.insert(field.name.view()).second)
      misuse(
          fmt::format("{}.{}: field '{}' is described twice", info.name, name, field.name.view()));

  const auto index = static_cast<std::uint32_t>(schema.columns_.size());
  schema.columns_.push_back({.name = std::string(name),
                             .table = table,
                             .stride = static_cast<std::uint32_t>(stride),
                             .fields = {fields.begin(), fields.end()}});
  info.columns.push_back(index);
  return index;
}

void SchemaBuilder::set_writers(std::uint32_t column, std::span<const WrittenBy> writers) {
  open().columns_.at(column).writers.emplace(writers.begin(), writers.end());
}

void SchemaBuilder::set_seldom(std::uint32_t column) {
  open().columns_.at(column).seldom = true;
}

std::shared_ptr<const Schema> SchemaBuilder::build() {
  Schema& schema = open();
  if (schema.tables_.empty())
    misuse("it has no table");
  std::uint64_t bytes = round_up(World::header_bytes(schema.tables_.size()));
  schema.places_.resize(schema.columns_.size());
  for (TableInfo& table : schema.tables_) {
    table.ids = bytes;
    for (const std::uint32_t index : table.columns) {
      ColumnInfo& column = schema.columns_[index];
      column.offset = bytes;
      schema.places_[index] = {bytes, column.table.value - 1};
      bytes = round_up(bytes + std::uint64_t{column.stride} * table.capacity);
    }
  }
  schema.bytes_ = bytes;
  schema.layout_hash_ = hash_layout(schema);
  return std::move(schema_);
}

bool same_but_for_bytes(const Schema& a, const Schema& b) {
  const auto same_field = [](const FieldInfo& x, const FieldInfo& y) {
    return x.name == y.name && x.type == y.type && x.offset == y.offset &&
           (x.count == y.count || x.type == Scalar::bytes);
  };
  return std::ranges::equal(a.tables(), b.tables(), {}, &TableInfo::name, &TableInfo::name) &&
         std::ranges::equal(a.columns(), b.columns(),
                            [&](const ColumnInfo& x, const ColumnInfo& y) {
                              return x.name == y.name && x.table == y.table &&
                                     std::ranges::equal(x.fields, y.fields, same_field);
                            });
}

}  // namespace eyrie::sim
