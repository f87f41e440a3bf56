// SPDX-License-Identifier: MIT
#pragma once
/// \file  One scenario document: the file, what it includes, and the overrides from outside.
#include <span>
#include <string>

#include "core/diagnostics.hpp"
#include "core/value.hpp"
#include "scenario/source.hpp"

namespace eyrie::scenario {

/// Reads `file` and merges what its `include:` names: the maps `trees`, `data` and `routes` of the
/// included files (nothing else may stand in them). A name that is defined twice, a file that is
/// missing and a file that includes itself are mistakes.
[[nodiscard]] Value load_document(const std::string& file, Source& source,
                                  Diagnostics& diagnostics);

/// Applies `path.to.key=value` to the document. The value is YAML, so `[1, 2]` is a list. A path
/// goes through maps by key and through lists by index or by the name of the item (a scalar, or the
/// only key of a map). The last key of a path may be new, everything before it must exist. Mistakes
/// stand at "--set:1:column" of the text.
void apply_overrides(Value& document, std::span<const std::string> sets, Diagnostics& diagnostics);

}  // namespace eyrie::scenario
