// SPDX-License-Identifier: MIT
/// \file  serve: the home page, a mission while it is flown, or the debrief page of a recorded run,
/// for browsers, also those of other machines.
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <random>
#include <system_error>
#include <thread>
#include <utility>

#include "command.hpp"
#include "commands.hpp"
#include "disk/file_system.hpp"
#include "flight.hpp"
#include "home.hpp"
#include "live.hpp"
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

/// Where this program is reached, as long as it runs.
struct Place {
  explicit Place(const ServeOptions& options)
      : at{.address = options.address, .port = options.port},
        token(at.loopback() ? "" : new_token()) {}
  net::Endpoint at;
  std::string token;
  bool told = false;
};

net::WebOptions site(const Place& place, std::string page) {
  net::WebOptions web{.at = place.at, .token = place.token};
  web.pages["/"] = {"text/html; charset=utf-8", std::move(page)};
  return web;
}

/// Makes what listens there, and says once how to reach it.
template <class Make>
auto listening(Place& place, Make make) {
  try {
    auto made = make();
    place.at = made->host().at();
    if (std::exchange(place.told, true))
      return made;
    net::Endpoint shown = place.at;
    if (shown.address == "0.0.0.0" || shown.address == "::")
      shown.address = name_of_this_machine();
    complain("eyrie: http://{}/{}{} shows it until ^C\n", shown.text(),
             place.token.empty() ? "" : "?token=", place.token);
    return made;
  } catch (const std::system_error& error) {
    refuse("cannot listen at {}: {}", place.at.text(), disk::words_of(error.code().value()));
  }
}

void tell(const net::WebHost::Counts& counts, bool live) {
  complain("eyrie: {} sent, ", counted(counts.pages, "page"));
  if (live)
    complain("{}, {:.1f} kB to them, {} dropped as too slow, ", counted(counts.viewers, "viewer"),
             static_cast<double>(counts.bytes) / 1e3, counts.dropped);
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
  Place place(options);
  const net::WebOptions web = site(place, debrief_text(runs, false));
  const auto pages = listening(place, [&] { return std::make_unique<Pages>(web); });
  while (!interrupted())
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  tell(pages->host().counts(), false);
  return 0;
}

/// The other programs of an exercise, if there are any.
live::Outside outside(Flight& flight, const scenario::Scenario& scenario, const FlyOptions& asked) {
  if (asked.dis.empty() || !(scenario.remote || asked.dis_obey))
    return {};
  return [&flight] {
    std::vector<sim::Order> orders = flight.listen();
    return live::Heard{.orders = std::move(orders), .frozen = flight.frozen()};
  };
}

/// Until ^C, or, if it was chosen there, until somebody asks for the home page after its end.
int serve_mission(Place& place, const ServeOptions& options, const FlyOptions& asked,
                  const std::shared_ptr<const scenario::Scenario>& scenario, bool from_home) {
  Flight flight(asked, scenario);
  std::atomic<bool> over = false, kept = false, leave = false;
  net::WebOptions web = site(place, live_text(*scenario, flight.seed(), from_home));
  if (from_home)
    web.made = [&](std::string_view target) -> std::optional<net::WebPage> {
      if (target != "/home" || !over)
        return {};
      leave = kept.load();  // else he asks again: the run is being written
      return net::WebPage{
          "text/html",
          fmt::format("<meta http-equiv=\"refresh\" content=\"1; url=/{}\">", leave ? "" : "home")};
    };
  const auto exercise = listening(place, [&] {
    return std::make_unique<live::Exercise>(
        flight.mission(), record::run_file_of(*scenario, flight.seed(), version_text()), web,
        live::ExerciseOptions{.rate = asked.real_time.value_or(1),
                              .paused = options.paused,
                              .outside = outside(flight, *scenario, asked),
                              .ended = [&] { over = true; }});
  });
  const int code = flight.fly([&] {
    exercise->fly([&] { return interrupted() || flight.broken(); });
    flight.timing().pacing = exercise->pacing();
    flight.timing().note(exercise->precedence());
  });
  kept = true;
  exercise->stay([&] { return interrupted() || leave; });
  if (leave)
    std::this_thread::sleep_for(std::chrono::milliseconds(200));  // the answer is on its way
  tell(exercise->host().counts(), true);
  return code;
}

int serve_scenario(const ServeOptions& options) {
  const std::string& name = options.what.front();
  FlyOptions flight = options.flight;
  flight.scenario = name;
  const auto scenario = load_scenario(flight);
  if (!scenario->plugins.empty())
    refuse("eyrie: {} uses plug-ins, which browsers cannot: 'eyrie fly' flies it",
           quote_path(name));
  listen_for_interrupts();
  Place place(options);
  return serve_mission(place, options, options.flight, scenario, false);
}

/// The home page, and what is chosen there, one after the other.
int serve_home(const ServeOptions& options) {
  if (options.flight.seed || !options.flight.sets.empty())
    refuse("eyrie: --seed and --set are for a scenario; the home page asks for them");
  demand_viewer();
  demand_others(options.flight);
  demand_place_for_runs();
  listen_for_interrupts();
  Place place(options);
  Home home(!options.flight.dis.empty(), overrides(options.flight));
  std::string problem;
  for (int code = 0;;) {
    net::WebOptions web = site(place, "");
    home.furnish(web, problem);
    problem.clear();
    std::optional<Choice> chosen;
    {
      const auto pages = listening(place, [&] { return std::make_unique<Pages>(web); });
      chosen = home.ask(pages->web);
    }
    if (!chosen)
      return code;
    FlyOptions flight = options.flight;
    flight.seed = chosen->seed;
    try {
      code = serve_mission(place, options, flight, chosen->scenario, true);
    } catch (const std::exception& error) {  // such as a port that somebody else has taken since
      problem = words_for(error);
      complain("{}\n", problem);
    }
  }
}

}  // namespace

int serve(const ServeOptions& options) {
  if (options.what.size() > 1 && is_scenario(options.what.front()))
    refuse("eyrie: serve has no use for {}: it flies one scenario, or compares two runs",
           quote_path(options.what.back()));
  if (options.what.size() > 1 || (!options.what.empty() && is_run(options.what.front())))
    return serve_runs(options);
  if (!options.plugins.empty())
    refuse("eyrie: --plugin is for a run: browsers fly along, and have no plug-ins");
  return options.what.empty() ? serve_home(options) : serve_scenario(options);
}

}  // namespace eyrie::app
