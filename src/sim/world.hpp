// SPDX-License-Identifier: MIT
#pragma once
/// \file  Everything that changes, in one block of bytes: copy it, assign it, hash it.
#include <algorithm>

#include "core/assert.hpp"
#include "sim/schema.hpp"

namespace eyrie::sim {

/// Where a player is.
struct RowRef {
  TableId table{};
  std::uint32_t row = 0;
  friend bool operator==(const RowRef&, const RowRef&) = default;
};

/// A player that was just made.
struct Born {
  PlayerId id{};
  std::uint32_t row = 0;
};

/// Of one run: nobody has left and nobody was born while it stays the same.
struct Census {
  std::uint64_t players = 0;
  PlayerId next_id{};
  friend bool operator==(const Census&, const Census&) = default;
};

/// Everything that changes in a run. A value: copy it to take a snapshot, assign it to roll back,
/// hash it to compare runs.
///
/// All columns of all tables lie at fixed capacity in one buffer, behind a header with the step,
/// the seed, the next id and the number of rows of each table; so a copy is one memcpy, and between
/// worlds of one schema an assignment allocates nothing. The rows of a table are in spawn order,
/// which is the order of ids. Unused rows are zero, so equal worlds have equal bytes.
///
/// A moved-from World may only be assigned to or destroyed.
class World {
  struct Header {
    std::uint64_t step;
    std::uint64_t seed;
    std::uint64_t refused_births;
    std::uint32_t next_id;
    std::uint32_t tables;
  };

 public:
  /// Empty tables, step 0. The first player will get id 1.
  World(std::shared_ptr<const Schema> schema, std::uint64_t seed);

  [[nodiscard]] const Schema& schema() const { return *schema_; }
  [[nodiscard]] const std::shared_ptr<const Schema>& shared_schema() const { return schema_; }

  /// Number of steps made.
  [[nodiscard]] std::uint64_t step() const { return header().step; }
  [[nodiscard]] std::uint64_t seed() const { return header().seed; }
  /// The same world in a run of another seed, before its first step.
  void set_seed(std::uint64_t seed) {
    EYRIE_ASSERT(step() == 0);
    header().seed = seed;
  }
  /// The id that the next player will get.
  [[nodiscard]] PlayerId next_id() const { return PlayerId{header().next_id}; }
  [[nodiscard]] Census census() const {
    Census there{.next_id = next_id()};
    for (std::uint32_t i = 0; i < header().tables; ++i)
      there.players += counts()[i];
    return there;
  }
  /// How many players could not be born because their table was full.
  [[nodiscard]] std::uint64_t refused_births() const { return header().refused_births; }

  /// Live rows of a table.
  [[nodiscard]] std::uint32_t rows(TableId table) const {
    EYRIE_ASSERT(table.value != 0 && table.value <= schema_->tables().size());
    return counts()[table.value - 1];
  }
  /// The ids of a table, ascending.
  [[nodiscard]] std::span<const PlayerId> ids(TableId table) const {
    return {reinterpret_cast<const PlayerId*>(data() + schema_->table(table).ids), rows(table)};
  }

  /// The live rows of a column, in spawn order.
  template <class Row>
  [[nodiscard]] std::span<Row> rows(Column<Row> column) {
    const ColumnPlace& c = checked(column.index, sizeof(Row));
    return {reinterpret_cast<Row*>(data() + c.offset), counts()[c.table]};
  }
  template <class Row>
  [[nodiscard]] std::span<const Row> rows(Column<Row> column) const {
    const ColumnPlace& c = checked(column.index, sizeof(Row));
    return {reinterpret_cast<const Row*>(data() + c.offset), counts()[c.table]};
  }
  /// The bytes of one row of a byte column.
  [[nodiscard]] std::span<std::byte> bytes(ByteColumn column, std::size_t row) {
    const ColumnInfo& c = schema_->column(column.index);
    EYRIE_ASSERT(row < rows(c.table));
    return {data() + c.offset + row * c.stride, c.stride};
  }
  [[nodiscard]] std::span<const std::byte> bytes(ByteColumn column, std::size_t row) const {
    const ColumnInfo& c = schema_->column(column.index);
    EYRIE_ASSERT(row < rows(c.table));
    return {data() + c.offset + row * c.stride, c.stride};
  }
  /// The live rows of any column as bytes, by its index in the schema.
  [[nodiscard]] std::span<const std::byte> column_bytes(std::uint32_t index) const;

  /// Step, seed, next id, refused births and row counts as bytes.
  [[nodiscard]] std::span<const std::byte> header_bytes() const {
    return {data(), header_bytes(schema_->tables().size())};
  }

  /// The row of a player in a table.
  [[nodiscard]] std::optional<std::uint32_t> row(TableId table, PlayerId who) const {
    const std::span<const PlayerId> players = ids(table);
    if (players.empty() || who < players.front())
      return std::nullopt;
    // ids ascend: none lies farther back than where it would be if nobody had left
    const std::size_t last =
        std::min<std::size_t>(who.value - players.front().value, players.size() - 1);
    if (players[last] == who)
      return static_cast<std::uint32_t>(last);
    return row_of(players.first(last), who);
  }
  /// The table and row of a player.
  [[nodiscard]] std::optional<RowRef> find(PlayerId who) const;

  /// Appends a row of zeros with the next id. Nothing when the table is full or the ids are used
  /// up; that is counted, and the caller must cope. In a step only the commit may do this.
  [[nodiscard]] std::optional<Born> spawn(TableId table);
  /// Marks a row for removal; compact() carries it out. Idempotent. `row` must exist.
  void remove(TableId table, std::uint32_t row);
  /// Takes the marked rows out, keeps the order of the rest and zeroes what is freed. The step
  /// calls it at the end of its commit.
  void compact() {
    if (any_leaving_) [[unlikely]]
      compact_marked();
  }

  /// The same world for another schema, which may have other capacities. Columns of bytes without
  /// a description stay zero where the other's have another size. Nothing if anything else is
  /// otherwise (same_but_for_bytes), or a table has too little room.
  [[nodiscard]] std::optional<World> moved_to(std::shared_ptr<const Schema> schema) const;

  /// Becomes that world, as by assignment, but copies no unused rows if both are of one schema.
  void become(const World& other);

  /// XXH3 over the header and the live rows of all columns but those that are seldom used and all
  /// zero. Independent of capacities.
  [[nodiscard]] std::uint64_t hash() const;
  /// Byte-wise equality of worlds of one schema object or of equal layout and capacities.
  [[nodiscard]] bool same_bytes(const World& other) const;
  /// Whether the invariants hold: counts within capacity, ids ascending, below next_id and in one
  /// table only, no row marked for removal, unused rows zero. For tests and paranoia.
  [[nodiscard]] bool canonical() const;

  /// Bytes that step, seed, next id and the row counts of so many tables take up in the buffer.
  [[nodiscard]] static constexpr std::size_t header_bytes(std::size_t tables) {
    return sizeof(Header) + tables * sizeof(std::uint32_t);
  }

 private:
  friend class Simulation;

  /// Where a player is among ascending ids.
  [[nodiscard]] static std::optional<std::uint32_t> row_of(std::span<const PlayerId> players,
                                                           PlayerId who);

  /// A cache line. A world is made of these, so that assigning one of the same size is one copy
  /// into the bytes that are already there: no allocation, and pointers into it stay good.
  struct alignas(Schema::kAlignment) Line {
    std::array<std::byte, Schema::kAlignment> bytes{};
  };

  [[nodiscard]] std::byte* data() { return reinterpret_cast<std::byte*>(lines_.data()); }
  [[nodiscard]] const std::byte* data() const {
    return reinterpret_cast<const std::byte*>(lines_.data());
  }
  [[nodiscard]] Header& header() { return *reinterpret_cast<Header*>(data()); }
  [[nodiscard]] const Header& header() const { return *reinterpret_cast<const Header*>(data()); }
  [[nodiscard]] std::uint32_t* counts() {
    return reinterpret_cast<std::uint32_t*>(data() + sizeof(Header));
  }
  [[nodiscard]] const std::uint32_t* counts() const {
    return reinterpret_cast<const std::uint32_t*>(data() + sizeof(Header));
  }
  [[nodiscard]] const ColumnPlace& checked(std::uint32_t index, std::size_t row_size) const {
    EYRIE_ASSERT(index < schema_->columns().size());
    EYRIE_ASSERT(schema_->column(index).stride == row_size);
    static_cast<void>(row_size);
    return schema_->place(index);
  }
  [[nodiscard]] std::byte* marks(TableId table);
  [[nodiscard]] const std::byte* marks(TableId table) const;
  void compact_marked();
  void compact(TableId table);

  std::shared_ptr<const Schema> schema_;
  std::vector<Line> lines_;
  bool any_leaving_ = false;  ///< whether a row is marked for removal
};

}  // namespace eyrie::sim
