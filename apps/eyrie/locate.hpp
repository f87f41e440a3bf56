// SPDX-License-Identifier: MIT
#pragma once
/// \file  From what the user typed to a loaded scenario, a recorded run, a player, a time.
#include <filesystem>
#include <set>

#include "debrief/recorded.hpp"
#include "disk/sink.hpp"
#include "scenario/scenario.hpp"

namespace eyrie::app {

/// The page that runs are put into: EYRIE_VIEWER, or the one beside the program; "" if there is
/// none.
[[nodiscard]] std::string viewer_file();
/// The page of the playground, which lies beside that one.
[[nodiscard]] std::string playground_file();
/// One of them without its parts, or why there is none: `problem` is `unbuilt` if it is not there.
[[nodiscard]] disk::FileRead read_page(const std::string& file, std::string_view unbuilt);

/// MPI for campaigns: EYRIE_MPI, or the library beside the program; "" if it was not built.
[[nodiscard]] std::string mpi_library();
/// The library of DuckDB: a file, or a name that the system looks for.
[[nodiscard]] std::string duckdb_library();

/// The launch zones of the shipped missiles, the files of data/zones one behind the other.
[[nodiscard]] std::string launch_zones();

/// The names of the YAML files in a folder of home(), "scenarios", without their ending, sorted.
[[nodiscard]] std::vector<std::string> names_in(const std::string& folder);

/// The run folders in a folder, sorted.
[[nodiscard]] std::vector<std::string> runs_in(const std::filesystem::path& folder);

/// The file that a name means: itself if it may be and is one, or scenarios/<name>.yaml.
[[nodiscard]] std::string scenario_file(const std::string& name, bool may_be_path = true);

/// The same, and what it is read from. Throws Mistake if there is no such file, or ConfigError if a
/// file names it at `where`, which may name no other than ours and what it might include.
struct Located {
  std::string file;
  scenario::Source source;
};
[[nodiscard]] Located locate(const std::string& name, const std::vector<std::string>& includes,
                             const Location& where = {});

/// " --allow-include FOLDER" for each folder that a scenario `file` may not read from otherwise.
[[nodiscard]] std::string allowances(const std::string& file, const std::set<std::string>& folders);

/// Loads it. Throws Mistake or ConfigError.
[[nodiscard]] std::shared_ptr<const scenario::Scenario> load_scenario(
    const std::string& name, const std::vector<std::string>& sets,
    const std::vector<std::string>& plugins, const std::vector<std::string>& includes);
/// The folder with data/ and scenarios/: EYRIE_HOME, or where this program is installed, or the one
/// it was built from. Throws Mistake if it is not there.
[[nodiscard]] std::string home();

/// The folder above the one that this program lies in; "" if nobody knows.
[[nodiscard]] std::filesystem::path program_prefix();

/// The user's folder for Eyrie in the one that an environment variable names, or below his home;
/// "" if there is none. A relative path is none (XDG Base Directory Specification 0.8).
[[nodiscard]] std::filesystem::path user_folder(const char* variable, const char* below_home);

/// Whether it is a run folder or a run file, by its name or what is in it.
[[nodiscard]] bool is_run(const std::string& path);
/// Whether it is a scenario file that is there, or the name of one, as far as its name tells.
[[nodiscard]] bool is_scenario(const std::string& name);
/// Whether what is beside the run file is of this run alone, and is replaced unasked.
[[nodiscard]] bool is_own_folder(const debrief::Recorded& run);
/// Throws Mistake if `out` is one of the files that it is made from: --force may not cost them.
void demand_other_file(const std::string& out, const std::vector<std::string>& sources);
/// Recorded runs: folders or run files. Throws Mistake with everything that is wrong with any.
[[nodiscard]] std::vector<debrief::Recorded> open_runs(const std::vector<std::string>& runs,
                                                       const std::vector<std::string>& plugins);
[[nodiscard]] debrief::Recorded open_run(const std::string& run,
                                         const std::vector<std::string>& plugins);
/// A player by the name that --player gives. Throws Mistake.
[[nodiscard]] PlayerId player_named(const scenario::Roster& roster, const std::string& name);
/// The same of one who decides in this program. Throws Mistake.
[[nodiscard]] PlayerId decider_named(const scenario::Roster& roster, const std::string& name);
/// s: "312.4", "5 min", or "5:12.4" as the story says it. Throws Mistake, which names the option.
[[nodiscard]] double time_named(std::string_view option, const std::string& text);
/// s, of a text such as "1 s", more than 0.
[[nodiscard]] double period_named(std::string_view option, const std::string& text);
/// s: the first step whose clock text is not before that time. Printed times are rounded to a
/// tenth, so this is done for whole tenths; any other time is exact.
[[nodiscard]] double first_shown(const debrief::Recorded& recorded, double time);
/// Throws Mistake if the run has ended by then (s).
void demand_within(const debrief::Recorded& recorded, std::string_view option,
                   const std::string& text, double time);

}  // namespace eyrie::app
