// SPDX-License-Identifier: MIT
#pragma once
/// \file  Every name that Eyrie gives to a file in the folder of a run. A folder that has another
/// one is not replaced.
#include <array>

namespace eyrie::record {

inline constexpr const char* kRunFileName = "run.eyrie";
inline constexpr const char* kEventsName = "events.csv";
inline constexpr const char* kFlightName = "flight.acmi";
inline constexpr const char* kPageName = "debrief.html";
inline constexpr const char* kPageOfTwoName = "debrief-two.html";
inline constexpr const char* kCzmlName = "run.czml";
inline constexpr const char* kGeojsonName = "run.geojson";
inline constexpr const char* kDecisionsName = "decisions.csv";

inline constexpr std::array kRunFolderNames{kRunFileName, kEventsName,    kFlightName,
                                            kPageName,    kPageOfTwoName, kCzmlName,
                                            kGeojsonName, kDecisionsName};

}  // namespace eyrie::record
