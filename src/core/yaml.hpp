// SPDX-License-Identifier: MIT
#pragma once
/// \file  YAML text -> the neutral document tree. The only place that knows libyaml.
#include "core/value.hpp"

namespace eyrie {

/// Limits against files that are built to hurt: they are far above what a scenario needs.
struct YamlLimits {
  std::size_t bytes = std::size_t{16} << 20;
  std::size_t nodes = 200'000;  ///< after aliases are expanded; and again of what anchors keep
  std::size_t depth = 256;
};

/// Reads one YAML document. `file` is the name that errors carry. Aliases are expanded (counted
/// against the limits); merge keys `<<`, a second document, NUL bytes and keys that are not scalars
/// are refused: the diagnostics hold the mistake and the result is a null value. A key that a map
/// gives twice and a tag that Eyrie does not know are reported too; the result is the rest.
[[nodiscard]] Value parse_yaml(std::string_view text, std::string_view file,
                               Diagnostics& diagnostics, const YamlLimits& limits = {});

}  // namespace eyrie
