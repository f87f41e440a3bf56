// SPDX-License-Identifier: MIT
/// \file  new behavior NAME: a copy of examples/plugin under another name.
#include <fmt/ranges.h>

#include <filesystem>
#include <system_error>

#include "command.hpp"
#include "commands.hpp"
#include "core/diagnostics.hpp"
#include "disk/file_system.hpp"
#include "disk/output.hpp"
#include "disk/sink.hpp"
#include "locate.hpp"
#include "pilot/state.hpp"
#include "say.hpp"
#include "scenario/plugins.hpp"

namespace eyrie::app {
namespace {
namespace fs = std::filesystem;

constexpr std::size_t kLongestName = 40;

/// "Break Turn-2" -> "break_turn_2": a name that may be used, or "" if nothing is left of it.
std::string usable(std::string_view wanted) {
  std::string name;
  for (const char c : wanted) {
    if (is_capital(c) && !name.empty() && is_small(name.back()))
      name += '_';
    if (is_letter(c) || (is_digit(c) && !name.empty()))
      name += to_small(c);
    else if (!name.empty() && name.back() != '_')
      name += '_';
  }
  name.resize(std::min(name.size(), kLongestName));
  while (name.ends_with('_'))
    name.pop_back();
  return name;
}

/// "break_turn" -> "BreakTurn"
std::string camel(std::string_view name) {
  std::string type;
  bool begins = true;
  for (const char c : name) {
    if (c != '_')
      type += begins ? to_capital(c) : c;
    begins = c == '_';
  }
  return type;
}

std::string name_problem(const std::string& name) {
  if (const std::string better = usable(name); better != name || name.empty())
    return fmt::format(
        "{} is no name for a behavior: a small letter, then small letters, digits and '_'{}",
        quote(name), better.empty() ? "" : fmt::format("; perhaps {}?", quote(better)));
  if (std::ranges::find(scenario::kReservedWords, name) != scenario::kReservedWords.end())
    return fmt::format("{} means something else in a scenario; perhaps '{}_it'?", quote(name),
                       name);
  const scenario::Plugins none;
  if (const auto* there = none.registries().pilots.find(name))
    return fmt::format("there is already a node {} (of {})", quote(name), there->origin);
  for (const auto& field : ubf::StateFields<pilot::State>::all())
    if (field.info.name == name)
      return fmt::format("{} is what a state says; perhaps '{}_it'?", quote(name), name);
  std::error_code ignored;
  if (fs::exists(fs::symlink_status(name, ignored)))
    return fmt::format("{} exists already; nothing was written", quote(name));
  return {};
}

std::string replaced(std::string text, std::string_view from, std::string_view to) {
  for (std::size_t at = text.find(from); at != text.npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

/// The prefix of the package that this program belongs to: where it is installed, or what
/// ./eyrie has put beside the build. Empty if there is none.
std::string package() {
  std::error_code failed;
  const fs::path prefix = program_prefix();
  for (const fs::path& place : {prefix, prefix / "package"})
    if (!prefix.empty() && fs::exists(place / "lib/cmake/Eyrie/EyrieConfig.cmake", failed))
      return place.string();
  return {};
}

/// The files of `from` under the other name: name -> text. Throws disk::Failed.
std::map<std::string, std::string> renamed(const fs::path& from, const std::string& name) {
  constexpr std::size_t kLargest = std::size_t{1} << 20;
  std::map<std::string, std::string> files;
  std::error_code failed;
  for (const auto& entry : fs::directory_iterator(from, failed)) {
    if (!entry.is_regular_file())
      continue;
    disk::FileRead read = disk::read_file(entry.path(), kLargest);
    if (!read.problem.empty())
      throw disk::Failed("{} {}", entry.path().string(), read.problem);
    std::string text =
        replaced(replaced(std::move(read.bytes), "dodge", name), "Dodge", camel(name));
    if (const std::string prefix = package(); !prefix.empty())
      text = replaced(std::move(text), "$ENV{HOME}/eyrie", prefix);
    files[replaced(entry.path().filename(), "dodge", name)] = std::move(text);
  }
  if (failed)
    throw disk::Failed("cannot read {}: {}", quote_path(from.string()), failed.message());
  return files;
}

}  // namespace

int new_behavior(const NewOptions& options) {
  const std::string& name = options.name;
  if (const std::string problem = name_problem(name); !problem.empty())
    refuse("eyrie: {}", problem);
  const auto files = renamed(fs::path(home()) / "examples" / "plugin", name);
  std::vector<const char*> names;
  for (const auto& [file, text] : files)
    names.push_back(file.c_str());
  listen_for_interrupts();
  disk::OutputFolder folder({.path = name, .names = names});
  finish(folder, files);
  say("{}/: {}\n", name, fmt::format("{}", fmt::join(names, ", ")));
  if (package().empty())
    say("Say in {}/CMakeLists.txt where Eyrie is installed.\n", name);
  say("cd {} && cmake -B build && cmake --build build && ctest --test-dir build\n", name);
  say("Then: eyrie fly {}.yaml --plugin build/lib{}.so\n", name, name);
  return 0;
}

}  // namespace eyrie::app
