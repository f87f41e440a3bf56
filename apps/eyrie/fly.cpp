// SPDX-License-Identifier: MIT
#include <chrono>
#include <filesystem>
#include <set>
#include <thread>

#include "command.hpp"
#include "commands.hpp"
#include "core/assert.hpp"
#include "core/diagnostics.hpp"
#include "core/units.hpp"
#include "flight.hpp"
#include "locate.hpp"
#include "net/precedence.hpp"
#include "say.hpp"

namespace eyrie::app {
namespace {

void listen(Flight& flight) {
  for (const sim::Order& order : flight.listen())
    EYRIE_DEMAND(flight.mission().run().submit(order).empty(), "an order for the next step");
}

/// Or until it cannot be recorded any more.
void fly_to_the_end(Flight& flight, const FlyOptions& options) {
  using net::Clock;
  scenario::Mission& mission = flight.mission();
  auto& pacing = flight.timing().pacing;
  Clock::time_point begun = Clock::now();
  const bool live = !options.tacview.empty() || !options.dis.empty();
  if (const double rate = options.real_time.value_or(live ? 1 : 0); rate > 0)
    pacing.emplace(mission.run().simulation().dt() / rate, begun);
  net::Precedence precedence;
  for (;;) {
    if (pacing) {
      precedence.sleep_until(pacing->due(), interrupted);
      begun = Clock::now();
      precedence.ask(pacing->is_kept(begun));
    }
    listen(flight);
    if (flight.frozen()) {
      for (; flight.frozen() && !interrupted(); listen(flight))
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
      begun = Clock::now();  // to stand still is no delay
      if (pacing)
        pacing->go_on(pacing->frame(), begun);
    }
    if (!mission.step())
      break;
    if (pacing)
      pacing->made(begun, Clock::now());
    if (interrupted() || flight.broken())
      mission.stop();
  }
  flight.timing().note(precedence);
}

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

/// What came of a flight.
struct Flown {
  std::string folder;
  std::vector<std::string> files;  ///< of the scenario
};

int fly_once(const FlyOptions& options, Flown& flown) {
  std::optional<double> until;
  if (!options.until.empty()) {
    const Parsed time = parse_quantity(options.until, Dimension::time);
    if (!time)
      refuse("--until: {}", time.error);
    until = time.value;
  }
  const auto scenario = load_scenario(options);
  if (const auto problem = until ? scenario::until_problem(scenario->spec, *until) : std::nullopt)
    refuse("--until: {}", *problem);
  for (const auto& [name, text] : scenario->files)
    flown.files.push_back(name);
  if (!options.seeds.empty())
    return fly_seeds(options, scenario, until);
  listen_for_interrupts();
  Flight flight(options, scenario, until);
  const int code = flight.fly([&] { fly_to_the_end(flight, options); });
  flown.folder = flight.folder();
  return code;
}

/// Until it is interrupted.
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
        return fly_once(again, flown);
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

}  // namespace

int fly(const FlyOptions& options) {
  Flown flown;
  return options.watch ? fly_and_watch(options) : fly_once(options, flown);
}

}  // namespace eyrie::app
