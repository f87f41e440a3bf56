// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "record/paths.hpp"

namespace eyrie::record {

/// Paths, routes and ends on a map: RFC 7946. Positions are longitude and latitude in degrees, then
/// metres above the ellipsoid; times (s) stand beside them in `properties.times_s`. A path over the
/// 180th meridian is cut there (section 3.1.9).
[[nodiscard]] std::string geojson(const Paths& paths);

}  // namespace eyrie::record
