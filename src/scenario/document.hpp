// SPDX-License-Identifier: MIT
#pragma once
/// \file  One scenario document: the file, what it includes, and the overrides from outside.
#include "core/diagnostics.hpp"
#include "core/value.hpp"
#include "scenario/source.hpp"

namespace eyrie::scenario {

/// Reads `file` and merges what its `include:` names: the maps `trees` and `data` and the list
/// `plugins` of the included files (nothing else may stand in them). A file that is reached in two
/// ways is read once. A name that is defined twice, a file that is missing and a file that includes
/// itself are mistakes.
[[nodiscard]] Value load_document(const std::string& file, Source& source,
                                  Diagnostics& diagnostics);

/// Applies `path.to.key=value` to the document. The value is YAML, so `[1, 2]` is a list. A path
/// goes through maps by key and through lists by index, from 0, or by the name of the item (a
/// scalar, or the only key of a map; it must be the only one of that name). The last key of a path
/// may be new, everything before it must exist. No value is null. Mistakes stand in the file
/// "--set <text>", and so do later mistakes in what was set.
void apply_overrides(Value& document, std::span<const std::string> sets, Diagnostics& diagnostics);

}  // namespace eyrie::scenario
