// SPDX-License-Identifier: MIT
#include "locate.hpp"

#include <fmt/ranges.h>

#include <cstdlib>
#include <fstream>
#include <iterator>

#include "commands.hpp"
#include "core/diagnostics.hpp"
#include "core/text.hpp"
#include "core/units.hpp"
#include "record/run_file.hpp"
#include "record/story.hpp"
#include "say.hpp"
#include "scenario/plugin_file.hpp"

namespace eyrie::app {
namespace fs = std::filesystem;
namespace {

/// What the environment variable says, or a file that was built or installed with the program; ""
/// if there is none.
std::string named_or_beside_program(const char* variable, const char* built,
                                    const char* installed) {
  if (const char* set = std::getenv(variable))
    return set;
  const fs::path prefix = program_prefix();
  std::error_code missing;  // of a place that is not there
  for (const char* place : {built, installed})
    if (!prefix.empty() && fs::is_regular_file(prefix / place, missing))
      return (prefix / place).string();
  return "";
}

/// A number that begins with a digit: no sign, no inf.
std::optional<double> plain(std::string_view text) {
  const auto value = number_from<double>(text);
  return value && is_digit(text.front()) && std::isfinite(*value) ? value : std::nullopt;
}

/// Of a name that stands there in a file, or that was typed.
[[noreturn]] void refuse_at(const Location& where, const std::string& words) {
  if (where.line > 0)
    throw ConfigError(where, words);
  refuse("eyrie: {}", words);
}

/// What may be meant by the name of a run that is not there: a folder beside it, or a scenario.
std::string run_hint(const std::string& run) {
  std::error_code ignored;
  if (fs::exists(run, ignored))
    return "";
  if (std::string hint = did_you_mean(run, runs_in(fs::path(run).parent_path())); !hint.empty())
    return hint;
  if (const std::string usual = "runs/" + run;
      fs::exists(usual + "/" + record::kRunFileName, ignored))
    return "; did you mean " + quote(usual) + "?";
  return is_scenario(run) ? "; 'eyrie fly' makes a run of this scenario" : "";
}

}  // namespace

fs::path program_prefix() {
  std::error_code failed;
  return fs::read_symlink("/proc/self/exe", failed).parent_path().parent_path();
}

std::string home() {
  const char* set = std::getenv("EYRIE_HOME");
  set = set && *set ? set : nullptr;
  std::string found = set ? set : EYRIE_HOME_DEFAULT;
  std::error_code failed;
  const fs::path prefix = program_prefix(), share = prefix / "share" / "eyrie";
  if (!set && !prefix.empty() && fs::is_directory(share / "scenarios", failed))
    found = share.string();  // installed: beside the program
  if (fs::is_directory(fs::path(found) / "data", failed))
    return found;
  if (set)
    refuse("eyrie: EYRIE_HOME is {}, where there is no folder 'data'", quote_path(found));
  refuse("eyrie: {} has no folder 'data': set EYRIE_HOME to where Eyrie is", quote_path(found));
}

std::string viewer_file() {
  return named_or_beside_program("EYRIE_VIEWER", "viewer/debrief.html", "share/eyrie/debrief.html");
}

std::string playground_file() {
  const std::string viewer = viewer_file();
  return viewer.empty() ? "" : fs::path(viewer).replace_filename("playground.html").string();
}

std::string mpi_library() {
  return named_or_beside_program("EYRIE_MPI", "bin/libeyrie_mpi.so", "lib/eyrie/libeyrie_mpi.so");
}

std::string duckdb_library() {
  const char* set = std::getenv("EYRIE_DUCKDB");
  return set ? set : "libduckdb.so";
}

disk::FileRead read_page(const std::string& file, std::string_view unbuilt) {
  constexpr std::size_t kLargest = std::size_t{64} << 20;
  disk::FileRead read = disk::read_file(file, kLargest);
  if (read.missing)
    read.problem = unbuilt;
  else if (!read.problem.empty())
    read.problem = fmt::format("{} {}", file, read.problem);
  return read;
}

std::string launch_zones() {
  try {
    return scenario::launch_zones(home());
  } catch (const std::exception&) {
    return {};  // whoever needs Eyrie's home says so
  }
}

std::vector<std::string> names_in(const std::string& folder) {
  std::vector<std::string> names;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(fs::path(home()) / folder, ignored))
    if (entry.path().extension() == ".yaml")
      names.push_back(entry.path().stem().string());
  std::ranges::sort(names);
  return names;
}

std::vector<std::string> runs_in(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code ignored;
  for (fs::directory_iterator at(folder.empty() ? "." : folder, ignored); at != end(at);
       at.increment(ignored))
    if (fs::exists(at->path() / record::kRunFileName, ignored))
      names.push_back((folder / at->path().filename()).string());
  std::ranges::sort(names);
  return names;
}

std::string scenario_file(const std::string& name, bool may_be_path) {
  const std::string wanted = name.empty() ? "sweep" : name;
  std::error_code ignored;
  if (may_be_path && fs::is_regular_file(wanted, ignored))
    return wanted;
  const std::string_view own = scenario::Source::kOwn;
  const fs::path shipped = wanted.starts_with(own)
                               ? fs::path(home()) / wanted.substr(own.size())
                               : fs::path(home()) / "scenarios" / (wanted + ".yaml");
  if (!fs::is_regular_file(shipped, ignored))
    return may_be_path ? wanted : "";
  // relative if that is shorter to read
  const fs::path here = fs::current_path(ignored);
  if (ignored)
    refuse("eyrie: the current folder is gone; go to another");
  const fs::path near = fs::relative(shipped, here, ignored);
  return !ignored && near.native().size() < shipped.native().size() ? near.generic_string()
                                                                    : shipped.generic_string();
}

Located locate(const std::string& name, const std::vector<std::string>& includes,
               const Location& where) {
  const std::string there = home();
  std::error_code ignored;
  for (const std::string& folder : includes)
    if (!fs::is_directory(folder, ignored))
      refuse("eyrie: --allow-include {}: there is no such folder", quote_path(folder));
  // a file names one of ours, or a file that its own includes might be
  const std::string asker(where.file.text());
  const std::string file = scenario_file(name, asker.empty() || name.ends_with(".yaml"));
  if (!asker.empty() && !file.empty()) {
    auto source = scenario::Source::disk(there, includes);
    source.confine_to_folder_of(asker);
    if (const std::string whole = fs::absolute(file, ignored).string(); source.is_outside(whole))
      refuse_at(where, source.why_unread(whole, asker));
  }
  const auto is_run = [&](const fs::path& path) {
    return path.filename() == record::kRunFileName && fs::is_regular_file(path, ignored);
  };
  if (is_run(file) || (!file.empty() && is_run(fs::path(file) / record::kRunFileName)))
    refuse_at(where, quote(name) + " is a run, no scenario: 'eyrie replay' flies it again");
  if (fs::is_regular_file(file, ignored))
    return {file, scenario::Source::disk(there, includes)};
  if (const disk::FileRead read = disk::read_file(file, scenario::Source::kLargest); !read.missing)
    refuse_at(where, fmt::format("{} {}", quote_path(name), read.problem));
  std::string meant;
  if (!fs::is_regular_file(file + ".yaml", ignored))
    meant = did_you_mean(fs::path(name).stem().string(), names_in("scenarios"));
  if (meant.empty())
    meant = disk::nearest_file(file);
  if (meant.empty() && name.find_first_of("./") == name.npos)
    meant = nearest_or_all(name, names_in("scenarios"));
  refuse_at(where, fmt::format("there is no scenario {}{}", quote(name), meant));
}

std::string allowances(const std::string& file, const std::set<std::string>& folders) {
  auto source = scenario::Source::disk(home());
  source.confine_to_folder_of(file);
  std::string options;
  for (const std::string& folder : folders)
    if (source.is_outside(folder))
      options += " --allow-include " + scenario::shell_word(folder);
  return options;
}

std::shared_ptr<const scenario::Scenario> load_scenario(const std::string& name,
                                                        const std::vector<std::string>& sets,
                                                        const std::vector<std::string>& plugins,
                                                        const std::vector<std::string>& includes) {
  Located at = locate(name, includes);
  return scenario::load({.file = at.file, .sets = sets, .plugins = plugins, .may_open = trusted()},
                        std::move(at.source));
}

fs::path user_folder(const char* variable, const char* below_home) {
  const auto named = [](const char* name) -> fs::path {
    const char* set = std::getenv(name);
    return set && *set == '/' ? set : "";
  };
  if (const fs::path folder = named(variable); !folder.empty())
    return folder / "eyrie";
  const fs::path home = named("HOME");
  return home.empty() ? home : home / below_home / "eyrie";
}

bool is_run(const std::string& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored) || fs::path(path).extension() == ".eyrie")
    return true;
  if (!fs::is_regular_file(path, ignored))
    return false;
  std::string begin(8, '\0');
  return std::ifstream(path, std::ios::binary).read(begin.data(), 8) && begin == "EYRIERUN";
}

bool is_scenario(const std::string& name) {
  std::error_code ignored;
  return !is_run(name) && fs::is_regular_file(scenario_file(name), ignored);
}

std::vector<debrief::Recorded> open_runs(const std::vector<std::string>& runs,
                                         const std::vector<std::string>& plugins) {
  std::vector<debrief::Recorded> all;
  std::vector<std::string> problems, unused = plugins;
  for (const std::string& run : runs) {
    debrief::Opened opened = debrief::open(run, plugins, version_text(), trusted());
    std::erase_if(unused, [&](const std::string& file) {
      return std::ranges::find(opened.unused, file) == opened.unused.end();
    });
    if (opened.recorded)
      all.push_back(std::move(*opened.recorded));
    for (const std::string& problem : opened.problems)
      if (std::find(runs.data(), &run, run) == &run)  // of one that is named twice, once
        problems.push_back(printable_lines(problem) + run_hint(run));
  }
  for (const std::string& file : unused)
    problems.push_back(fmt::format(
        "{} no plug-in {}",
        runs.size() > 1 ? "--plugin: these runs have"
                        : printable(all.empty() ? runs[0] : all[0].file) + ": the run has",
        quote(fs::path(file).filename().string())));
  if (!problems.empty())
    throw Mistake(fmt::format("{}", fmt::join(problems, "\n")));
  return all;
}

debrief::Recorded open_run(const std::string& run, const std::vector<std::string>& plugins) {
  return std::move(open_runs({run}, plugins).front());
}

bool is_own_folder(const debrief::Recorded& run) {
  return fs::path(run.file).filename() == record::kRunFileName;
}

void demand_other_file(const std::string& out, const std::vector<std::string>& sources) {
  for (const std::string& source : sources)
    if (std::error_code none; fs::equivalent(out, source, none))
      refuse("--out: {} is what it would be made from; name another file", quote_path(out));
}

PlayerId player_named(const scenario::Roster& roster, const std::string& name) {
  if (const auto who = roster.find(name))
    return *who;
  refuse("--player: {}", roster.unknown(name));
}

PlayerId decider_named(const scenario::Roster& roster, const std::string& name) {
  const PlayerId who = player_named(roster, name);
  if (roster.find(who)->remote)
    refuse("{} is flown by another program: nobody knows why", name);
  return who;
}

double period_named(std::string_view option, const std::string& text) {
  const Parsed period = parse_quantity(text, Dimension::time);
  if (!period || period.value <= 0)
    refuse("{}: {}", option, period ? "must be more than 0" : period.error);
  return period.value;
}

double time_named(std::string_view option, const std::string& text) {
  const auto colon = text.find(':');
  const auto seconds = plain(std::string_view(text).substr(colon == text.npos ? 0 : colon + 1));
  if (colon != text.npos) {
    const std::string_view before = std::string_view(text).substr(0, colon);
    const auto minutes = plain(before);
    if (minutes && before.find_first_not_of("0123456789") == before.npos && seconds &&
        *seconds < 60)
      return *minutes * 60 + *seconds;
  } else if (seconds) {
    return *seconds;
  } else if (const auto quantity = parse_quantity(text, Dimension::time);
             quantity && quantity.value >= 0) {
    return quantity.value;
  }
  refuse("{} {}: expected a time such as 312.4, '5 min' or 5:12.4", option, quote(text));
}

double first_shown(const debrief::Recorded& recorded, double time) {
  const double dt = recorded.scenario->simulation->dt(), tenths = time * 10;
  if (time > recorded.until() + 1 || std::fabs(tenths - std::round(tenths)) > 1e-6)
    return time;
  double step = std::max(0.0, std::floor((time - 0.1) / dt));
  while (step * dt < time && record::clock_text(step * dt) != record::clock_text(time))
    ++step;
  return step * dt;
}

void demand_within(const debrief::Recorded& recorded, std::string_view option,
                   const std::string& text, double time) {
  if (time > recorded.until())
    refuse("{} {}: the run ends at {}", option, quote(text), record::clock_text(recorded.until()));
}

}  // namespace eyrie::app
