// SPDX-License-Identifier: MIT
#include "sim/world.hpp"

#include <algorithm>

#include "core/hash.hpp"

namespace eyrie::sim {

namespace {

constexpr std::byte kLeaving{1};

bool all_zero(const std::byte* bytes, std::size_t size) {
  return std::all_of(bytes, bytes + size, [](std::byte b) { return b == std::byte{0}; });
}

}  // namespace

World::World(std::shared_ptr<const Schema> schema, std::uint64_t seed)
    : schema_(std::move(schema)) {
  EYRIE_THROW_UNLESS(schema_ != nullptr, "a world needs a schema");
  lines_.resize(schema_->bytes() / sizeof(Line));
  header() = {.step = 0,
              .seed = seed,
              .refused_births = 0,
              .next_id = 1,
              .tables = static_cast<std::uint32_t>(schema_->tables().size())};
}

std::byte* World::marks(TableId table) {
  return data() + schema_->column(schema_->table(table).columns[1]).offset;
}

const std::byte* World::marks(TableId table) const {
  return data() + schema_->column(schema_->table(table).columns[1]).offset;
}

std::span<const std::byte> World::column_bytes(std::uint32_t index) const {
  EYRIE_ASSERT(index < schema_->columns().size());
  const ColumnInfo& column = schema_->column(index);
  return {data() + column.offset, std::size_t{column.stride} * rows(column.table)};
}

std::optional<std::uint32_t> World::row_of(std::span<const PlayerId> players, PlayerId who) {
  const auto it = std::ranges::lower_bound(players, who);
  if (it == players.end() || *it != who)
    return std::nullopt;
  return static_cast<std::uint32_t>(it - players.begin());
}

std::optional<RowRef> World::find(PlayerId who) const {
  const auto tables = static_cast<std::uint32_t>(schema_->tables().size());
  for (std::uint32_t i = 1; i <= tables; ++i)
    if (const auto found = row(TableId{i}, who))
      return RowRef{TableId{i}, *found};
  return std::nullopt;
}

std::optional<Born> World::spawn(TableId table) {
  std::uint32_t& count = counts()[table.value - 1];
  const bool out_of_ids = header().next_id == std::numeric_limits<std::uint32_t>::max();
  if (count == schema_->table(table).capacity || out_of_ids) {
    ++header().refused_births;
    return std::nullopt;
  }
  const Born born{.id = PlayerId{header().next_id++}, .row = count++};
  const ColumnInfo& ids_column = schema_->column(schema_->table(table).columns[0]);
  std::memcpy(data() + ids_column.offset + born.row * sizeof(PlayerId), &born.id, sizeof(PlayerId));
  return born;
}

void World::remove(TableId table, std::uint32_t row) {
  EYRIE_ASSERT(row < rows(table));
  marks(table)[row] = kLeaving;
  any_leaving_ = true;
}

void World::compact_marked() {
  any_leaving_ = false;
  const auto tables = static_cast<std::uint32_t>(schema_->tables().size());
  for (std::uint32_t i = 1; i <= tables; ++i)
    if (std::memchr(marks(TableId{i}), static_cast<int>(kLeaving), rows(TableId{i})) != nullptr)
      compact(TableId{i});
}

void World::compact(TableId table) {
  const TableInfo& info = schema_->table(table);
  const std::uint32_t count = rows(table);
  const std::byte* leave = marks(table);
  const auto kept = static_cast<std::uint32_t>(count - std::count(leave, leave + count, kLeaving));

  // the marks last: they say which rows of the other columns stay
  for (std::size_t c = info.columns.size(); c-- > 0;) {
    const std::size_t which = c == 0 ? 1 : (c == 1 ? 0 : c);
    const ColumnInfo& column = schema_->column(info.columns[which]);
    std::byte* bytes = data() + column.offset;
    const std::size_t stride = column.stride;
    std::uint32_t to = 0;
    for (std::uint32_t from = 0; from < count; ++from) {
      if (leave[from] == kLeaving)
        continue;
      if (to != from)
        std::memcpy(bytes + to * stride, bytes + from * stride, stride);
      ++to;
    }
    std::memset(bytes + kept * stride, 0, (count - kept) * stride);
  }
  counts()[table.value - 1] = kept;
}

std::optional<World> World::moved_to(std::shared_ptr<const Schema> schema) const {
  if (!same_but_for_bytes(*schema, *schema_))
    return std::nullopt;
  World moved(std::move(schema), seed());
  moved.any_leaving_ = any_leaving_;
  std::memcpy(moved.data(), data(), header_bytes().size());
  for (std::uint32_t i = 0; i < schema_->columns().size(); ++i) {
    const ColumnInfo& column = moved.schema().column(i);
    if (rows(column.table) > moved.schema().table(column.table).capacity)
      return std::nullopt;
    if (column.stride == schema_->column(i).stride)
      std::memcpy(moved.data() + column.offset, column_bytes(i).data(), column_bytes(i).size());
  }
  return moved;
}

void World::become(const World& other) {
  if (schema_ != other.schema_) {
    *this = other;
    return;
  }
  any_leaving_ = other.any_leaving_;
  for (const TableInfo& table : schema_->tables()) {
    const TableId id = schema_->column(table.columns[0]).table;
    const std::size_t used = std::max(rows(id), other.rows(id));  // what was used becomes zero
    for (const std::uint32_t index : table.columns) {
      const ColumnInfo& column = schema_->column(index);
      std::memcpy(data() + column.offset, other.data() + column.offset, used * column.stride);
    }
  }
  std::memcpy(data(), other.data(), header_bytes().size());
}

std::uint64_t World::hash() const {
  Hasher hasher;
  hasher.bytes(header_bytes().data(), header_bytes().size());
  const auto columns = static_cast<std::uint32_t>(schema_->columns().size());
  for (std::uint32_t i = 0; i < columns; ++i) {
    const std::span<const std::byte> bytes = column_bytes(i);
    if (schema_->column(i).seldom) {
      if (all_zero(bytes.data(), bytes.size()))
        continue;
      hasher.word(i);
    }
    hasher.bytes(bytes.data(), bytes.size());
  }
  return hasher.value();
}

bool World::same_bytes(const World& other) const {
  return schema_->bytes() == other.schema_->bytes() &&
         schema_->layout_hash() == other.schema_->layout_hash() &&
         std::memcmp(data(), other.data(), schema_->bytes()) == 0;
}

bool World::canonical() const {
  const auto tables = static_cast<std::uint32_t>(schema_->tables().size());
  if (header().tables != tables)
    return false;
  for (std::uint32_t i = 1; i <= tables; ++i)
    if (rows(TableId{i}) > schema_->table(TableId{i}).capacity)
      return false;
  for (std::uint32_t i = 1; i <= tables; ++i) {
    const TableId table{i};
    PlayerId last{0};
    for (const PlayerId id : ids(table)) {
      const std::optional<RowRef> place = find(id);
      if (id <= last || id >= next_id() || !place || place->table != table)
        return false;
      last = id;
    }
    if (!all_zero(marks(table), rows(table)))
      return false;
    for (const std::uint32_t index : schema_->table(table).columns) {
      const ColumnInfo& column = schema_->column(index);
      const std::size_t used = std::size_t{column.stride} * rows(table);
      const std::size_t room = std::size_t{column.stride} * schema_->table(table).capacity;
      if (!all_zero(data() + column.offset + used, room - used))
        return false;
    }
  }
  return true;
}

}  // namespace eyrie::sim
