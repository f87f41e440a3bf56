// SPDX-License-Identifier: MIT
#pragma once
/// \file  A recorded run as the debrief page reads it.
#include <functional>
#include <string>

#include "debrief/recorded.hpp"

namespace eyrie::page {

/// Called now and then while the run is flown again; false gives up.
using Progress = std::function<bool(const debrief::Reflight&)>;

/// With more players than this decisions are kept when they are other ones than before, and once a
/// second, motions once a second, and what is seen every five seconds.
inline constexpr std::size_t kManyPlayers = 16;
/// With more simulated time than this, summed over the players (s), all of that is kept so much
/// less often that it stays as large as here; and of other decisions ten where one would be kept
/// anyway.
inline constexpr double kManyPlayerSeconds = 60'000;

/// Flies the run again with tracing and gives what the page shows, as viewer/src/run/decode.ts
/// describes it. Empty if `progress` gave up. `plenty` is for tests.
[[nodiscard]] std::string page_bytes(const debrief::Recorded& recorded,
                                     const Progress& progress = {},
                                     double plenty = kManyPlayerSeconds);
/// The same as a page without the engine carries it: base64 of a zlib stream.
[[nodiscard]] std::string page_data(const debrief::Recorded& recorded,
                                    const Progress& progress = {},
                                    double plenty = kManyPlayerSeconds);

}  // namespace eyrie::page
