// SPDX-License-Identifier: MIT
#include <thread>

#include "command.hpp"
#include "commands.hpp"
#include "core/assert.hpp"
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

}  // namespace

int fly(const FlyOptions& options) {
  Flown flown;
  return options.watch ? fly_and_watch(options) : fly(options, flown);
}

int fly(const FlyOptions& options, Flown& flown) {
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

}  // namespace eyrie::app
