// SPDX-License-Identifier: MIT
#pragma once
/// \file  A world on disk. In memory no function is needed: a snapshot is `World kept = world;`,
/// a rollback is `world = kept;`, a branch is a second World and a Workspace of its own.
#include <iosfwd>

#include "sim/world.hpp"

namespace eyrie::sim {

/// Version of the format that save() writes and load() accepts.
inline constexpr std::uint32_t kSnapshotVersion = 1;

/// Writes the header and the live rows of a world: magic "EYRIEWLD", version, byte-order mark,
/// layout hash, size, data, XXH3 of all that. False if the stream failed (disk full, not writable).
/// A world with rows still marked for removal throws std::logic_error.
[[nodiscard]] bool save(const World& world, std::ostream& out);

/// A world, or why there is none: exactly one of the two.
struct Loaded {
  std::optional<World> world;
  std::string error;  ///< one line for people
};

/// Reads what save() wrote and not a byte more, so worlds may stand inside larger files. The error
/// says what is wrong with a file that is cut, corrupt, of another format version, byte order or
/// layout, or that has more rows than `schema` has room for. Never throws for a bad file, and
/// allocates no more than a World of this schema, whatever the file claims.
[[nodiscard]] Loaded load(std::shared_ptr<const Schema> schema, std::istream& in);

}  // namespace eyrie::sim
