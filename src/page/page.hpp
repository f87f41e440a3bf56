// SPDX-License-Identifier: MIT
#pragma once
/// \file  The debrief page: one file with the viewer and one or two runs in it.
#include <span>
#include <string>
#include <string_view>

namespace eyrie::page {

/// Where the viewer's page (viewer/build.mjs) takes runs.
inline constexpr std::string_view kPlaceOfRuns = "<!--%RUNS%-->";

/// The viewer's page with runs (page_data) in it; empty if it has no place for them.
[[nodiscard]] std::string page_with(std::string_view viewer, std::span<const std::string> runs);

}  // namespace eyrie::page
