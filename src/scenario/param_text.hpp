// SPDX-License-Identifier: MIT
#pragma once
/// \file  A described parameter in words, for the generated references.
#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "core/param.hpp"

namespace eyrie::scenario {

/// What a file may write: "length", "whole number", "one of follow, lead", "list of 3 lengths",
/// "table of forces over mach and altitude".
[[nodiscard]] std::string kind_text(const ParamInfo& info);

/// Its limits as a file would write them: "0 m to 50 km", "at least 1 s", "above 0"; "" for none.
/// A list has the limits of its items.
[[nodiscard]] std::string range_text(const ParamInfo& info);

/// "required", or the default as a file would write it; "" where that is no short text.
[[nodiscard]] std::string default_text(const ParamInfo& info);

/// Calls `visit(path, info)` for every parameter and, behind it, for those inside it:
/// "start.altitude"; "stations[].store" inside the items of a list.
void each_parameter(std::span<const ParamInfo> parameters,
                    const std::function<void(const std::string&, const ParamInfo&)>& visit);

/// The noun of a dimension without its article: "length". For none: "plain number".
[[nodiscard]] std::string_view dimension_word(Dimension dimension);

}  // namespace eyrie::scenario
