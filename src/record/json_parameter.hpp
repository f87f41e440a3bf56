// SPDX-License-Identifier: MIT
#pragma once
/// \file  A described parameter as a JSON schema.
#include <nlohmann/json.hpp>

#include "core/param.hpp"

namespace eyrie::record {

using Json = nlohmann::ordered_json;

/// Whether a map must have its required keys. A model with a `base` may leave them to that.
enum class Required { checked, left_to_base };

/// What a file may write for a parameter, with help, unit, range and default in the description.
/// Quantities refer to `#/definitions/<dimension>`.
[[nodiscard]] Json parameter_schema(const ParamInfo& info, Required required = Required::checked);

/// A map of these properties and nothing else.
[[nodiscard]] Json closed_map(Json properties, const std::vector<std::string_view>& required = {});
/// The same of parameters.
[[nodiscard]] Json map_schema(std::span<const ParamInfo> parameters,
                              Required required = Required::checked);

/// The `#/definitions/<dimension>` of every dimension that has units.
[[nodiscard]] Json dimension_definitions();

[[nodiscard]] Json reference_to(const std::string& definition);

}  // namespace eyrie::record
