// SPDX-License-Identifier: MIT
#pragma once
/// \file  Paths into a document, the same for --set, for factors of campaigns and for what a
/// scenario changes of another: `trees.wall.winner_takes_all.navigate.speed`. They go through maps
/// by key and through lists by index, from 0, or by the name of the item: a scalar, or the only key
/// of a map, which must be the only one of that name. Where children stand below `children:`, that
/// word may be left out. Behind the index of a node stands its name: `0.navigate.vote`. What is set
/// behind the name of a `!tree egress` is an argument. A name with a dot stands in quotes:
/// `trees."break.2".vote`.
#include <map>
#include <optional>
#include <span>

#include "core/value.hpp"

namespace eyrie::scenario {

/// One key of a path, and where it stands.
struct PathKey {
  std::string text;
  Location where;
};

/// The keys of a path that begins at `where`, or nothing after saying that one is empty.
[[nodiscard]] std::optional<std::vector<PathKey>> path_keys(std::string_view path, Location where,
                                                            Diagnostics& diagnostics);

/// The characters before the first '=' that is not in quotes; all if there is none.
[[nodiscard]] std::size_t path_size(std::string_view text);

/// Whether setting one path (or `path=value`) leaves nothing of what another one sets: it is the
/// same or begins it, however the two are spelled: `route."0"` covers `route.00.north`.
[[nodiscard]] bool covers(std::string_view path, std::string_view other);

/// Of paths (or `path=value`) that are set one after the other, each that a later one covers, and
/// the first that does.
struct SetTwice {
  std::size_t first, again;
};
[[nodiscard]] std::vector<SetTwice> set_twice(std::span<const std::string> sets);

/// The list that a key means an item of: the value, or its `children`. Null if it is none.
[[nodiscard]] Value* list_for(Value& at, std::string_view key);

/// The index of the item, or nothing after saying why there is none.
[[nodiscard]] std::optional<std::size_t> item_index(const Value& list, const PathKey& key,
                                                    Diagnostics& diagnostics);

/// The value below `at` that the key names, or null after saying why there is none. Of an item that
/// is named it is what stands behind the name; a bare name becomes a map with nothing: `eagle2` to
/// `{eagle2: {}}`. What is passed on the way goes to `passed`.
[[nodiscard]] Value* step(Value& at, const PathKey& key, Diagnostics& diagnostics,
                          std::vector<const Value*>* passed = nullptr);

/// What a list's item is called; empty if it has no name.
[[nodiscard]] std::string_view item_name(const Value& item);

/// Adds the path of everything below a value, by the place in its file (Location::text()) where
/// its key or name stands.
void paths_below(const Value& at, const std::string& path,
                 std::map<std::string, std::string>& paths);

/// "there is no 'x' here<note>; did you mean 'y'?"
[[nodiscard]] std::string not_here(const Value& at, std::string_view key,
                                   std::string_view note = "");

}  // namespace eyrie::scenario
