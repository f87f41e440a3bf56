// SPDX-License-Identifier: MIT
#pragma once
/// \file  A recorded run as the debrief page reads it.
#include <functional>
#include <string>

#include "debrief/recorded.hpp"

namespace eyrie::page {

/// Called with the simulated time (s) that has been flown again; false gives up.
using Progress = std::function<bool(double)>;

/// Flies the run again with tracing and packs what the page shows: base64 of a zlib stream, whose
/// inside viewer/src/run/decode.ts describes. With more than kManyPlayers decisions are kept when
/// they are other ones than before, and once a second, motions once a second, and what is seen
/// every five seconds. Empty if `progress` gave up.
[[nodiscard]] std::string page_data(const debrief::Recorded& recorded,
                                    const Progress& progress = {});

inline constexpr std::size_t kManyPlayers = 16;

}  // namespace eyrie::page
