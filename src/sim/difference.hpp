// SPDX-License-Identifier: MIT
#pragma once
/// \file  Where two worlds part: the first difference, and digests of worlds that are compared
/// later.
#include "sim/event.hpp"
#include "sim/world.hpp"

namespace eyrie::sim {

/// The first place at which two worlds, or two digests, are not the same.
struct Difference {
  std::uint64_t step = 0;  ///< of the left world
  std::string table{};     ///< empty: in the header of the world
  std::string column{};
  std::optional<std::uint32_t> row{};
  PlayerId player{};    ///< none if it is not about one row
  std::string field{};  ///< empty if only the row is known
  std::string left{};   ///< empty if the values are not known (digests)
  std::string right{};
  std::string rule{};  ///< who broke which rule of a step, if that was found (sim/check.hpp)

  /// `step 120: aircraft.kinematics.position.x of player 4 (row 3) is 1.5, and 1.25 in the other`
  [[nodiscard]] std::string text() const;
};

/// Nothing if the worlds are equal: header first, then tables, columns, rows and fields in the
/// order of the schema. Values are compared by their bits. The capacities may differ; worlds of
/// different layouts throw std::logic_error.
[[nodiscard]] std::optional<Difference> first_difference(const World& left, const World& right);

/// Nothing if the rows that both have are the same in one column.
[[nodiscard]] std::optional<Difference> first_difference(const World& left, const World& right,
                                                         std::uint32_t column);

/// Nothing if both steps gave the same events; `step` is only put into the answer.
[[nodiscard]] std::optional<Difference> first_difference(std::uint64_t step,
                                                         std::span<const Event> left,
                                                         std::span<const Event> right);

/// 16-bit digests of a world by field and by row. A run file keeps one in a while, so that a replay
/// by another build, which has no second world to look into, can still name the table, column,
/// field and row at fault. Whether two worlds are equal is for World::hash() to say; of two that
/// are not, 16 bits take a field that differs for the same once in 65,536 times.
struct Digest {
  struct Row {
    std::uint32_t table = 0;  ///< TableId::value
    PlayerId player{};
    std::uint16_t hash = 0;
    friend bool operator==(const Row&, const Row&) = default;
  };

  std::uint64_t step = 0;
  std::uint16_t header = 0;             ///< step, seed, next id, refused births, row counts
  std::vector<std::uint16_t> fields{};  ///< every field of every column, in the schema's order
  std::vector<Row> rows{};              ///< every live row, table by table
  friend bool operator==(const Digest&, const Digest&) = default;
};

/// 16 bits of a hash.
[[nodiscard]] constexpr std::uint16_t fold(std::uint64_t hash) {
  hash ^= hash >> 32;
  return static_cast<std::uint16_t>(hash ^ (hash >> 16));
}

[[nodiscard]] Digest digest(const World& world);
/// The same into one that is there: its memory is used again.
void digest(const World& world, Digest& out);

/// Nothing if they are equal. Names the first field and the first row that differ; values are not
/// known. Both digests must come from worlds of this schema's layout: the numbers of fields are
/// compared and a mismatch is reported, the layout hash is the caller's to check.
[[nodiscard]] std::optional<Difference> compare(const Schema& schema, const Digest& left,
                                                const Digest& right);

}  // namespace eyrie::sim
