// SPDX-License-Identifier: MIT
/// \file  trust: the plug-ins that scenarios and run files may name without --plugin.

#include <fcntl.h>
#include <sys/file.h>

#include <filesystem>
#include <system_error>

#include "command.hpp"
#include "commands.hpp"
#include "core/diagnostics.hpp"
#include "disk/file_system.hpp"
#include "locate.hpp"
#include "say.hpp"
#include "scenario/plugin_file.hpp"

namespace eyrie::app {
namespace {
namespace fs = std::filesystem;
using scenario::TrustList;

/// $XDG_CONFIG_HOME/eyrie/trusted-plugins, or below ~/.config; "" if the user has no such place.
std::string list_file() {
  const fs::path own = user_folder("XDG_CONFIG_HOME", ".config");
  return own.empty() ? own : own / "trusted-plugins";
}

/// Two that change the list at once do so one after the other, for as long as what this gives
/// lives.
disk::Handle one_at_a_time(const std::string& file) {
  const fs::path folder = fs::path(file).parent_path();
  std::error_code failed;
  fs::create_directories(folder, failed);
  disk::Handle lock(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (lock)  // where it cannot be locked, write() says what is wrong
    static_cast<void>(::flock(lock.get(), LOCK_EX));
  return lock;
}

std::string canonical(const std::string& path) {
  std::error_code failed;
  const fs::path file = fs::weakly_canonical(fs::absolute(path, failed), failed);
  return failed ? path : file.string();
}

/// All of them or none.
void add(TrustList& list, const std::vector<std::string>& paths) {
  for (const std::string& path : paths) {
    const std::string file = canonical(path);
    const disk::FileRead read = scenario::read_plugin_file(file);
    std::string problem =
        read.problem.empty() ? scenario::shared_object_problem(read.bytes) : read.problem;
    if (problem.empty() && file.find_first_of("\n\r") != file.npos)
      problem = "its path holds a line break";
    if (!problem.empty())
      refuse("eyrie: trust {}: {}", quote_path(path), problem);
    list.add({scenario::sha256(read.bytes), file});
  }
}

void remove(TrustList& list, const std::vector<std::string>& paths) {
  for (const std::string& path : paths) {
    const auto known = listed(list.entries(), &TrustList::Entry::path);
    const std::string file = canonical(path);
    if (!list.remove(file))
      refuse("eyrie: trust --remove {}: it is not trusted{}", quote_path(path),
             did_you_mean(file, known));
  }
}

void show(const TrustList& list) {
  for (const TrustList::Entry& entry : list.entries()) {
    const disk::FileRead read = scenario::read_plugin_file(entry.path);
    const char* now = !read.problem.empty()                          ? "  (cannot be read now)"
                      : scenario::sha256(read.bytes) != entry.sha256 ? "  (has changed)"
                                                                     : "";
    say("{}  {}{}\n", entry.sha256, scenario::shell_word(entry.path), now);
  }
}

}  // namespace

scenario::PluginPermission trusted() {
  return [list = std::shared_ptr<TrustList>()](const std::string& path,
                                               const std::string& sha256) mutable -> std::string {
    try {
      if (!list)
        list = std::make_shared<TrustList>(TrustList::read(list_file()));
    } catch (const ConfigError& e) {
      return e.diagnostics().text(1);
    }
    return list->why_not(path, sha256);
  };
}

int trust(const TrustOptions& options) {
  const std::string file = list_file();
  if (file.empty())
    refuse("eyrie: neither XDG_CONFIG_HOME nor HOME is an absolute path: there is no list");
  if (options.list) {
    show(TrustList::read(file));
    return 0;
  }
  const disk::Handle lock = one_at_a_time(file);
  TrustList list = TrustList::read(file);
  remove(list, options.remove);
  add(list, options.add);
  listen_for_interrupts();
  list.write(file);
  for (const std::string& path : options.add)
    say("trusted: {}\n", scenario::shell_word(canonical(path)));
  for (const std::string& path : options.remove)
    say("no longer trusted: {}\n", scenario::shell_word(canonical(path)));
  return 0;
}

}  // namespace eyrie::app
