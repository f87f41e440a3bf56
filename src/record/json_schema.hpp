// SPDX-License-Identifier: MIT
#pragma once
/// \file  The JSON schema of scenario files, for editors and validators.
#include "scenario/catalog.hpp"

namespace eyrie::record {

/// JSON Schema draft-07. The root describes a scenario file; `#/definitions/package` what a
/// scenario includes, and `#/definitions/model.<folder>` a file in data/<folder>. It is for
/// YAML 1.2: there `1e-6` is a number and `on` a text.
///
/// It knows shapes, names of keys and nodes, units and the ranges of plain numbers. What needs a
/// look elsewhere only the program finds: names of trees and models, ranges of quantities, flights
/// without a lead. In one way it is stricter: a text that looks like a number needs quotes.
[[nodiscard]] std::string catalog_json_schema(const scenario::Catalog& catalog);

}  // namespace eyrie::record
