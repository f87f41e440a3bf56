// SPDX-License-Identifier: MIT
/// \file  A run is opened from the disk, with the plug-ins that it needs.
#include <filesystem>
#include <system_error>

#include "debrief/recorded.hpp"

namespace eyrie::debrief {
namespace {
namespace fs = std::filesystem;

/// Why a plug-in of the run cannot be used; empty if it can. `unasked`: the run file alone names
/// it.
std::string plugin_problem(const scenario::PluginFile& plugin, const std::string& file,
                           bool unasked, const scenario::PluginPermission& may_open) {
  const std::string shown = scenario::shell_word(file);
  const std::string name = scenario::shell_word(fs::path(plugin.path).filename().string());
  std::error_code failed;
  if (unasked && !fs::path(file).is_absolute())
    return fmt::format(
        "the run needs the plug-in {}, at no absolute path; --plugin (in Python plugins=) says "
        "where it is",
        shown);
  if (!fs::exists(file, failed))
    return fmt::format(
        "the run needs the plug-in {}, which is not there; --plugin (in Python plugins=) says "
        "where it is now",
        shown);
  const disk::FileRead read = scenario::read_allowed(fs::weakly_canonical(file, failed).string(),
                                                     unasked ? &may_open : nullptr, file);
  if (!read.problem.empty())
    return fmt::format("the run needs the plug-in {}: {}", shown, read.problem);
  if (scenario::hash_of(read.bytes) != plugin.hash)
    return fmt::format("{} is not the {} of the run: it has other bytes", shown, name);
  return {};
}

/// Where the plug-ins of a run are, in its order: the file among `given` that has its bytes, or its
/// name, or else where the run file says, if that one may be opened. What is missing or another one
/// is a problem. What is not of the run stays in `given`.
std::vector<std::string> find_plugins(const record::RunFile& run, std::vector<std::string>& given,
                                      const scenario::PluginPermission& may_open,
                                      std::vector<std::string>& problems) {
  std::vector<std::string> found;
  for (const scenario::PluginFile& plugin : run.plugins) {
    const auto is_named = [&](const std::string& file) {
      return fs::path(file).filename() == fs::path(plugin.path).filename();
    };
    auto typed = std::ranges::find_if(given, [&](const std::string& file) {
      return scenario::hash_of(scenario::read_plugin_file(file).bytes) == plugin.hash;
    });
    if (typed == given.end())
      typed = std::ranges::find_if(given, is_named);
    const bool unasked = typed == given.end();
    found.push_back(unasked ? plugin.path : *typed);
    if (!unasked)
      given.erase(typed);
    if (auto problem = plugin_problem(plugin, found.back(), unasked, may_open); !problem.empty())
      problems.push_back(std::move(problem));
  }
  return found;
}

}  // namespace

Opened open(const std::string& path, std::vector<std::string> plugins, std::string_view build,
            const scenario::PluginPermission& may_open, const scenario::AddNodes& add) {
  std::error_code ignored;
  const std::string file =
      fs::is_directory(path, ignored) ? (fs::path(path) / "run.eyrie").string() : path;
  Opened result;
  if (record::Decoded decoded = record::read_run_file(file); !decoded.error.empty()) {
    result.problems.push_back(std::move(decoded.error));
  } else {
    std::vector<std::string> found = find_plugins(decoded.run, plugins, may_open, result.problems);
    if (result.problems.empty())
      result = open(std::move(decoded.run), file, std::move(found), build, add);
    result.unused = std::move(plugins);
  }
  constexpr std::size_t kWhole = 300;  // a longer path is shortened
  for (std::string& problem : result.problems)
    problem = fmt::format("{}: {}", file.size() > kWhole ? quote(file) : file, problem);
  return result;
}

}  // namespace eyrie::debrief
