// SPDX-License-Identifier: MIT
#pragma once
/// \file  What a World is made of: tables of typed columns, described once, fixed at load.
#include "sim/event.hpp"

namespace eyrie::sim {

inline constexpr std::uint32_t kNoColumn = std::numeric_limits<std::uint32_t>::max();

/// Typed key of one column: hands out `std::span<Row>` in a World of the schema it came from.
template <class Row>
struct Column {
  std::uint32_t index = kNoColumn;
  explicit operator bool() const { return index != kNoColumn; }
};

/// Key of a column of raw bytes: a slab of constant size per row, such as the memory of a brain.
struct ByteColumn {
  std::uint32_t index = kNoColumn;
  explicit operator bool() const { return index != kNoColumn; }
};

/// One column as the kernel sees it.
struct ColumnInfo {
  std::string name;
  TableId table;
  std::uint32_t stride = 0;  ///< bytes per row
  std::uint64_t offset = 0;  ///< of row 0 in the World's buffer, a multiple of 64
  std::vector<FieldInfo> fields;
  /// No part of the hash of a world where all of it is zero. No part of the layout either.
  bool seldom = false;
  /// Who writes it; nothing if that was not described. No part of the layout.
  std::optional<std::vector<WrittenBy>> writers = {};
};

/// One table: its columns share one row order, which is spawn order.
struct TableInfo {
  std::string name;
  std::uint32_t capacity = 0;
  std::uint64_t ids = 0;               ///< offset of the ids
  std::vector<std::uint32_t> columns;  ///< [0] the ids, [1] the leaving marks, then as added
};

/// Where a column is in a World: what every look at one needs, and nothing else.
struct ColumnPlace {
  std::uint64_t offset = 0;
  std::uint32_t table = 0;  ///< index
};

/// The const description of a World. Immutable once built and shared by every World of a run.
class Schema {
 public:
  static constexpr std::size_t kAlignment = 64;  ///< of columns in a World, bytes: a cache line

  [[nodiscard]] std::span<const TableInfo> tables() const { return tables_; }
  [[nodiscard]] std::span<const ColumnInfo> columns() const { return columns_; }
  [[nodiscard]] const TableInfo& table(TableId t) const { return tables_[t.value - 1]; }
  [[nodiscard]] const ColumnInfo& column(std::uint32_t index) const { return columns_[index]; }

  [[nodiscard]] const ColumnPlace& place(std::uint32_t index) const { return places_[index]; }

  /// The table of that name, or an empty id.
  [[nodiscard]] TableId find_table(std::string_view name) const;
  /// Index of the column of that name in a table, or kNoColumn.
  [[nodiscard]] std::uint32_t find_column(TableId table, std::string_view name) const;

  /// Size of a World's buffer in bytes, a multiple of 64.
  [[nodiscard]] std::uint64_t bytes() const { return bytes_; }
  /// Names, types, offsets and strides of everything in a row. Capacities are left out on
  /// purpose: a world may be moved to where there is more room, and it hashes the same there.
  [[nodiscard]] std::uint64_t layout_hash() const { return layout_hash_; }

 private:
  friend class SchemaBuilder;
  std::vector<TableInfo> tables_;
  std::vector<ColumnInfo> columns_;
  std::vector<ColumnPlace> places_;  ///< by column
  std::uint64_t bytes_ = 0;
  std::uint64_t layout_hash_ = 0;
};

/// A row is plain bytes, of which Row::fields() names each once: a byte that nobody describes is
/// padding, and padding would make equal worlds look different.
template <class Row>
concept DescribedRow = HasFields<Row> && std::is_standard_layout_v<Row> && alignof(Row) <= 64 &&
                       fields_cover_row<Row>();

/// Collects tables and columns, then builds the Schema. Misuse (a name given twice, a name that is
/// not an identifier, a capacity of zero, a field described twice, an unknown table) is a mistake
/// of the program and throws std::logic_error.
class SchemaBuilder {
 public:
  /// A table of at most `capacity` rows, in [1, 2^24].
  TableId add_table(std::string_view name, std::uint32_t capacity);

  template <DescribedRow Row>
  Column<Row> add_column(TableId table, std::string_view name) {
    const auto fields = Row::fields();
    return {add(table, name, sizeof(Row), fields)};
  }

  /// `stride` bytes per row, in [1, 2^20] and a multiple of 8.
  ByteColumn add_bytes(TableId table, std::string_view name, std::uint32_t stride);

  /// Says who writes a column, so that sim::WriteCheck can tell who else does.
  void set_writers(std::uint32_t column, std::span<const WrittenBy> writers);

  /// A column that is zero in most runs: World::hash() passes it by as long as it is.
  void set_seldom(std::uint32_t column);

  /// The finished schema. The builder is empty afterwards.
  [[nodiscard]] std::shared_ptr<const Schema> build();

 private:
  std::uint32_t add(TableId table, std::string_view name, std::size_t stride,
                    std::span<const FieldInfo> fields);

  /// What is being built.
  [[nodiscard]] Schema& open() const;

  std::unique_ptr<Schema> schema_ = std::make_unique<Schema>();
};

/// Whether worlds have the same tables, but for their capacities and for how many bytes without a
/// description are in a column, such as what the trees of agents remember.
[[nodiscard]] bool same_but_for_bytes(const Schema& a, const Schema& b);

}  // namespace eyrie::sim
