// SPDX-License-Identifier: MIT
#pragma once
/// \file  Places as files say them -> positions in the local frame.
#include <string_view>

#include "core/diagnostics.hpp"
#include "core/frames.hpp"
#include "core/value.hpp"
#include "scenario/spec.hpp"

namespace eyrie::scenario {

/// The point of the local frame `north` and `east` (m) of the reference point whose height above
/// the ellipsoid is `altitude` (m). Exact arithmetic only: the same bits everywhere, and the mirror
/// image of a place is the place of its mirror image.
[[nodiscard]] Vec3 at_altitude(const Reference& reference, double north, double east,
                               double altitude);

/// Resolves a place. One that says neither or both ways, or half of one, is a mistake at `where`;
/// so is a geodetic place more than 500 km from the reference point.
[[nodiscard]] Vec3 resolve(const PlaceSpec& place, double altitude, const Reference& reference,
                           const Location& where, Diagnostics& diagnostics);

}  // namespace eyrie::scenario
