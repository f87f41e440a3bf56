// SPDX-License-Identifier: MIT
#pragma once
/// \file  Places as files say them -> positions in the local frame.
#include <string_view>

#include "core/diagnostics.hpp"
#include "core/value.hpp"
#include "model/frames.hpp"
#include "scenario/spec.hpp"

namespace eyrie::scenario {

/// The point of the local frame `north` and `east` (m) of the reference point whose height above
/// the ellipsoid is `altitude` (m). No libm: the same bits everywhere. What lies as far west
/// instead of east gets the same bits, too.
[[nodiscard]] Vec3 at_altitude(const Reference& reference, double north, double east,
                               double altitude);

/// Resolves a place. One that says neither or both ways, or half of one, is a mistake at `where`;
/// so is a place more than 500 km from the reference point.
[[nodiscard]] Vec3 resolve(const PlaceSpec& place, double altitude, const Reference& reference,
                           const Location& where, Diagnostics& diagnostics);

}  // namespace eyrie::scenario
