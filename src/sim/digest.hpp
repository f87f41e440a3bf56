// SPDX-License-Identifier: MIT
#pragma once
/// \file  A world in a few hundred numbers, enough to say where another world parted from it.
#include <cstdint>
#include <optional>
#include <vector>

#include "core/id.hpp"
#include "sim/difference.hpp"
#include "sim/world.hpp"

namespace eyrie::sim {

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
