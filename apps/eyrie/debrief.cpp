// SPDX-License-Identifier: MIT
/// \file  debrief: a recorded run as a page that explains every decision.
#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "commands.hpp"
#include "disk/file_system.hpp"
#include "disk/output.hpp"
#include "locate.hpp"
#include "page/page.hpp"
#include "record/run_file.hpp"
#include "say.hpp"

namespace eyrie::app {
namespace {
namespace fs = std::filesystem;

constexpr const char* kNoViewer =
    "the debrief page is not built: it needs npm and its packages; './eyrie fly' builds it when it "
    "can";

/// The page without its data, or why there is none.
disk::FileRead viewer() {
  return read_page(viewer_file(), kNoViewer);
}

/// The engine in the page flies the run again; columns it is where that cannot be. Without data if
/// it was interrupted.
page::Part data_of(const debrief::Recorded& recorded, const std::string& shell, bool columns) {
  if (!columns && recorded.run.plugins.empty() && page::has_engine(shell))
    return page::run_file_part(recorded.run);
  Progress progress("seconds of the page", static_cast<std::uint64_t>(recorded.until()));
  std::string data = page::page_data(recorded, [&](double time) {
    progress.at(static_cast<std::uint64_t>(time));
    return !interrupted();
  });
  return {"run", std::move(data)};
}

/// The page with the data of its runs. Throws disk::Failed if that cannot be.
std::string page_of(const std::string& shell, std::vector<page::Part> parts) {
  if (parts.front().type != "run")
    parts.push_back(page::part_of("zones", launch_zones()));
  std::string page = page::page_with(shell, parts);
  if (page.empty())
    throw disk::Failed("{} is no debrief page of this version; build it again", viewer_file());
  return page;
}

}  // namespace

std::string demand_viewer() {
  disk::FileRead shell = viewer();
  if (!shell.problem.empty())
    throw disk::Failed(shell.problem);
  return std::move(shell.bytes);
}

PageWritten write_page(const debrief::Recorded& recorded, const std::string& file) {
  const disk::FileRead shell = viewer();
  if (!shell.problem.empty())
    return {.failed = !shell.missing, .problem = shell.problem};
  try {
    disk::OutputFile out(file, false);
    page::Part run = data_of(recorded, shell.bytes, false);
    if (run.data.empty())
      return {.problem = "the debrief page was interrupted; 'eyrie debrief' makes it"};
    out.sink().write(page_of(shell.bytes, {std::move(run)}));
    out.commit();
    return {.written = true};
  } catch (const std::exception& e) {
    return {.failed = true, .problem = words_for(e) + "; the run is kept without its debrief page"};
  }
}

std::string debrief_text(const std::vector<debrief::Recorded>& runs, bool columns) {
  const std::string shell = demand_viewer();
  std::vector<page::Part> data;
  for (const debrief::Recorded& run : runs)
    if (!interrupted())
      data.push_back(data_of(run, shell, columns));
  return interrupted() ? "" : page_of(shell, std::move(data));
}

std::string live_text(const scenario::Scenario& scenario, std::uint64_t seed, bool home) {
  const std::string shell = demand_viewer();
  const std::string about = nlohmann::json{
      {"scenario", scenario.spec.name},
      {"seed", std::to_string(seed)},
      {"home", home}}.dump();
  const std::array parts{page::part_of("live", about), page::part_of("zones", launch_zones())};
  return page::live_page(shell, parts);
}

int debrief_page(const DebriefOptions& options) {
  const auto runs = open_runs(options.runs, options.plugins);
  const fs::path folder = fs::path(runs.front().file).parent_path();
  const std::string file =
      options.out.empty()
          ? (folder / (runs.size() > 1 ? record::kPageOfTwoName : record::kPageName)).string()
          : options.out;
  for (const debrief::Recorded& run : runs)
    demand_other_file(file, {run.file});
  listen_for_interrupts();
  const bool of_one = options.out.empty() && runs.size() == 1;
  disk::OutputFile out(file, options.force || (of_one && is_own_folder(runs.front())));
  out.sink().write(debrief_text(runs, options.columns));
  finish(out);
  return 0;
}

}  // namespace eyrie::app
