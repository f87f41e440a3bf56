// SPDX-License-Identifier: MIT
#include "locate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "commands.hpp"
#include "core/diagnostics.hpp"
#include "say.hpp"

namespace eyrie::app {
namespace fs = std::filesystem;
namespace {

/// A file that was built or installed with the program, or "".
std::string beside_program(const char* built, const char* installed) {
  std::error_code failed;
  const fs::path program = fs::read_symlink("/proc/self/exe", failed);
  const fs::path prefix = program.parent_path().parent_path();
  for (const char* place : {built, installed})
    if (!failed && fs::is_regular_file(prefix / place, failed))
      return (prefix / place).string();
  return "";
}

}  // namespace

std::string home() {
  if (const char* set = std::getenv("EYRIE_HOME"); set && *set)
    return set;
  // installed: beside the program
  std::error_code failed;
  const fs::path program = fs::read_symlink("/proc/self/exe", failed);
  const fs::path share = program.parent_path().parent_path() / "share" / "eyrie";
  if (!failed && fs::is_directory(share / "scenarios", failed))
    return share.string();
  return EYRIE_HOME_DEFAULT;
}

std::optional<std::string> home_or_complain() {
  const std::string found = home();
  std::error_code ignored;
  if (fs::is_directory(fs::path(found) / "data", ignored))
    return found;
  const char* set = std::getenv("EYRIE_HOME");
  if (set && *set)
    complain("eyrie: EYRIE_HOME is {}, where there is no folder 'data'\n", quote_path(found));
  else
    complain("eyrie: {} has no folder 'data': set EYRIE_HOME to where Eyrie is\n",
             quote_path(found));
  return std::nullopt;
}

std::string viewer_file() {
  if (const char* set = std::getenv("EYRIE_VIEWER"))
    return set;
  return beside_program("viewer/debrief.html", "share/eyrie/debrief.html");
}

std::string playground_file() {
  const std::string viewer = viewer_file();
  return viewer.empty() ? "" : fs::path(viewer).replace_filename("playground.html").string();
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
  std::ifstream file(beside_program("launch_zones.bin", "share/eyrie/launch_zones.bin"),
                     std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string scenario_file(const std::string& name) {
  const std::string wanted = name.empty() ? "sweep" : name;
  std::error_code ignored;
  if (fs::is_regular_file(wanted, ignored))
    return wanted;
  const fs::path shipped = fs::path(home()) / "scenarios" / (wanted + ".yaml");
  if (!fs::is_regular_file(shipped, ignored))
    return wanted;
  // relative if that is shorter to read
  const fs::path near = fs::relative(shipped, ignored);
  return !ignored && near.native().size() < shipped.native().size() ? near.generic_string()
                                                                    : shipped.generic_string();
}

std::shared_ptr<const scenario::Scenario> load_or_complain(
    const std::string& name, const std::vector<std::string>& sets,
    const std::vector<std::string>& plugins, const std::vector<std::string>& includes) {
  const auto there = home_or_complain();
  if (!there)
    return nullptr;
  std::error_code ignored;
  for (const std::string& folder : includes)
    if (!fs::is_directory(folder, ignored)) {
      complain("eyrie: --allow-include {}: there is no such folder\n", quote_path(folder));
      return nullptr;
    }
  const std::string file = scenario_file(name);
  if (!fs::is_regular_file(file, ignored)) {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(fs::path(*there) / "scenarios", ignored))
      if (entry.path().extension() == ".yaml")
        names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    complain("eyrie: there is no scenario {}{}\n", quote(name),
             did_you_mean(fs::path(name).stem().string(), names));
    return nullptr;
  }
  try {
    return scenario::load({.file = file, .sets = sets, .plugins = plugins, .may_open = trusted()},
                          scenario::Source::disk(*there, includes));
  } catch (const ConfigError& e) {
    complain("{}\n", lines(e.diagnostics().text()));
    return nullptr;
  }
}

}  // namespace eyrie::app
