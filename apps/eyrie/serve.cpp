// SPDX-License-Identifier: MIT
/// \file  serve: a mission while it is flown, or the debrief page of a recorded run, for browsers,
/// also those of other machines.
#include <unistd.h>

#include <chrono>
#include <random>
#include <system_error>
#include <thread>

#include "command.hpp"
#include "commands.hpp"
#include "disk/file_system.hpp"
#include "flight.hpp"
#include "live/exercise.hpp"
#include "locate.hpp"
#include "net/web_host.hpp"
#include "say.hpp"

namespace eyrie::app {
namespace {

/// 128 bits that nobody guesses.
std::string new_token() {
  std::random_device draw;
  return fmt::format("{:08x}{:08x}{:08x}{:08x}", draw(), draw(), draw(), draw());
}

/// By which others reach this machine.
std::string name_of_this_machine() {
  char name[256] = "";
  ::gethostname(name, sizeof name - 1);
  return name;
}

/// A host of one page.
net::WebOptions site(const ServeOptions& options, std::string page) {
  net::WebOptions web{.at = {.address = options.address, .port = options.port}};
  if (!web.at.loopback())
    web.token = new_token();
  web.pages["/"] = {"text/html; charset=utf-8", std::move(page)};
  return web;
}

/// Makes what listens there and says how to reach it.
template <class Make>
auto listening(const net::WebOptions& web, Make make) {
  try {
    auto made = make();
    net::Endpoint shown = made->host().at();
    if (shown.address == "0.0.0.0" || shown.address == "::")
      shown.address = name_of_this_machine();
    complain("eyrie: http://{}/{}{} shows it until ^C\n", shown.text(),
             web.token.empty() ? "" : "?token=", web.token);
    return made;
  } catch (const std::system_error& error) {
    refuse("cannot listen at {}: {}", web.at.text(), disk::words_of(error.code().value()));
  }
}

void tell(const net::WebHost::Counts& counts, bool live) {
  complain("eyrie: {} {} sent, ", counts.pages, counts.pages == 1 ? "page" : "pages");
  if (live)
    complain("{} {}, {:.1f} kB to them, {} dropped as too slow, ", counts.viewers,
             counts.viewers == 1 ? "viewer" : "viewers", static_cast<double>(counts.bytes) / 1e3,
             counts.dropped);
  complain("{} refused\n", counts.refused);
}

struct Pages {
  explicit Pages(const net::WebOptions& options) : web(options) {}
  net::WebHost web;
  [[nodiscard]] const net::WebHost& host() const { return web; }
};

int serve_runs(const ServeOptions& options) {
  const FlyOptions& flight = options.flight;
  if (flight.seed || !flight.sets.empty() || flight.real_time || options.paused || flight.workers ||
      !flight.tacview.empty() || !flight.dis.empty())
    refuse("eyrie: {} is a run, which was flown already: such options are for a scenario",
           quote_path(options.what.front()));
  const auto runs = open_runs(options.what, options.plugins);
  listen_for_interrupts();
  const net::WebOptions web = site(options, debrief_text(runs, false));
  const auto pages = listening(web, [&] { return std::make_unique<Pages>(web); });
  while (!interrupted())
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  tell(pages->host().counts(), false);
  return 0;
}

int serve_mission(const ServeOptions& options) {
  const auto scenario = load_scenario(options.what.front(), options.flight.sets, {}, {});
  if (!scenario->plugins.empty())
    refuse("eyrie: {} uses plug-ins, which browsers cannot: 'eyrie fly' flies it",
           quote_path(options.what.front()));
  listen_for_interrupts();
  Flight flight(options.flight, scenario);
  const net::WebOptions web = site(options, live_text(*scenario, flight.seed()));
  const auto exercise = listening(web, [&] {
    return std::make_unique<live::Exercise>(
        flight.mission(), record::run_file_of(*scenario, flight.seed(), version_text()), web,
        live::ExerciseOptions{.rate = options.flight.real_time.value_or(1),
                              .paused = options.paused});
  });
  const int code = flight.fly([&] {
    exercise->fly([&] { return interrupted() || flight.broken(); });
    flight.timing().pacing = exercise->pacing();
  });
  exercise->stay(interrupted);
  tell(exercise->host().counts(), true);
  return code;
}

}  // namespace

int serve(const ServeOptions& options) {
  return options.what.size() > 1 || is_run(options.what.front()) ? serve_runs(options)
                                                                 : serve_mission(options);
}

}  // namespace eyrie::app
