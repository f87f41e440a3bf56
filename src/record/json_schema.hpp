// SPDX-License-Identifier: MIT
#pragma once
/// \file  The JSON schema of scenario files, for editors and validators.
#include <nlohmann/json.hpp>

#include "core/param.hpp"
#include "scenario/catalog.hpp"

namespace eyrie::record {

/// JSON Schema draft-07. The root describes a scenario, whole or on top of another, and what
/// scenarios include; `#/definitions/model.<folder>` a file in data/<folder>. It is for YAML 1.2:
/// there `1e-6` is a number and `on` a text.
///
/// It knows shapes, names of keys and nodes, units and the ranges of plain numbers. What needs a
/// look elsewhere only the program finds: names of trees and models, ranges of quantities, flights
/// without a lead. In one way it is stricter: a text that looks like a number needs quotes.
[[nodiscard]] std::string catalog_json_schema(const scenario::Catalog& catalog);

// of a described parameter

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
