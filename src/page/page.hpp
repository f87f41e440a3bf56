// SPDX-License-Identifier: MIT
#pragma once
/// \file  The debrief page: one file with the viewer and one or two runs in it.
#include <span>
#include <string>
#include <string_view>

#include "record/run_file.hpp"

namespace eyrie::page {

/// Where the viewer's page (viewer/build.mjs) takes runs.
inline constexpr std::string_view kPlaceOfRuns = "<!--%RUNS%-->";

/// What a page carries of a run.
struct PageRun {
  /// Whether `bytes` are columns (page_data), otherwise a run file, which the engine in the page
  /// flies again.
  bool columns = false;
  std::string data;  ///< base64 of a zlib stream
};
/// A run file for the page: its hashes say whether it flies as it did, not in which field it does
/// not.
[[nodiscard]] PageRun run_for_page(const record::RunFile& run);

/// Whether the viewer's page has the engine in it.
[[nodiscard]] bool has_engine(std::string_view viewer);
/// The viewer's page with runs in it; empty if it has no place for them.
[[nodiscard]] std::string page_with(std::string_view viewer, std::span<const PageRun> runs);

}  // namespace eyrie::page
