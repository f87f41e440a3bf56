// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "record/paths.hpp"

namespace eyrie::record {

/// The run for Cesium: a packet per player and missile with its path over time, its attitude along
/// the velocity, and a label that says which behavior leads, with its vote. Times count from
/// 2026-01-01T12:00:00Z, as in the Tacview file.
/// https://github.com/AnalyticalGraphicsInc/czml-writer/wiki/CZML-Guide (as of 2025).
[[nodiscard]] std::string czml(const Paths& paths);

}  // namespace eyrie::record
