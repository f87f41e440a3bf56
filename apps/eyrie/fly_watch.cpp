// SPDX-License-Identifier: MIT
/// \file  fly --watch: a scenario flown again whenever one of its files changes.
#include <chrono>
#include <filesystem>
#include <set>
#include <thread>

#include "command.hpp"
#include "commands.hpp"
#include "core/diagnostics.hpp"
#include "locate.hpp"
#include "say.hpp"

namespace eyrie::app {
namespace {
namespace fs = std::filesystem;

using Stamp = std::pair<fs::file_time_type, std::uintmax_t>;

/// When each was written, and its size: a file in the current folder or in Eyrie's home.
std::map<std::string, Stamp> stamps(const std::set<std::string>& files) {
  std::map<std::string, Stamp> all;
  std::error_code missing;
  for (const std::string& file : files) {
    const std::string& own = scenario::Source::kOwn;
    const std::string name = file.starts_with(own) ? file.substr(own.size()) : file;
    const fs::path there =
        name == file && fs::exists(file, missing) ? fs::path(file) : fs::path(home()) / name;
    all[file] = {fs::last_write_time(there, missing), fs::file_size(there, missing)};
  }
  return all;
}

}  // namespace

int fly_and_watch(const FlyOptions& options) {
  FlyOptions again = options;
  const std::string file = scenario_file(options.scenario);
  std::set<std::string> files{file};
  std::error_code ignored;
  for (bool first = true;; first = false) {
    auto before = stamps(files);
    Flown flown;
    bool in_files = false;  // a mistake that a change of them may mend
    const int code = attempt([&] {
      try {
        return fly(again, flown);
      } catch (const ConfigError& error) {
        in_files = true;
        for (const Diagnostic& wrong : error.diagnostics().sorted())
          files.insert(std::string(wrong.where.file.text()));
        throw;
      }
    });
    // later, the scenario may be away for a moment: editors rename it
    if (code == 2 && first && !(in_files && fs::exists(file, ignored)))
      return code;
    if (!flown.folder.empty()) {  // the next ones go to the same place
      again.out = flown.folder;
      again.force = true;
    }
    files.insert(flown.files.begin(), flown.files.end());
    before.merge(stamps(files));  // those that were known stay as they were before the flight
    listen_for_interrupts();
    complain("eyrie: waiting for a change of {} or what it includes; ^C ends it\n", file);
    while (!interrupted() && stamps(files) == before)
      std::this_thread::sleep_for(std::chrono::milliseconds(200));
    if (interrupted())
      return 0;
  }
}

}  // namespace eyrie::app
