// SPDX-License-Identifier: MIT
#include "model/library.hpp"

#include <functional>

#include "core/text.hpp"
#include "sim/system.hpp"

namespace eyrie::model {

std::vector<LibraryProblem> problems_of(const Library& library, double dt) {
  std::vector<LibraryProblem> problems;
  const auto look = [&](std::string_view kind, const auto& shelf, std::string_view parameter,
                        auto rate) {
    for (std::size_t i = 0; i < shelf.size(); ++i)
      if (const sim::Period period = sim::period_steps(std::invoke(rate, shelf[i]), dt); !period)
        problems.push_back({kind, shelf.name(i), parameter, period.error});
  };
  look("radars", library.radars, "scan_rate", &Radar::scan_rate);
  look("radars", library.radars, "track_rate", &Radar::track_rate);
  look("irsts", library.irsts, "rate", &Irst::rate);
  look("rwr", library.rwrs, "search_rate", &Rwr::search_rate);
  look("rwr", library.rwrs, "seeker_rate", &Rwr::seeker_rate);
  look("visual", library.visuals, "rate", &Visual::rate);
  look("trackers", library.trackers, "rate", &Tracker::rate);
  look("datalinks", library.datalinks, "rate", &Datalink::rate);
  look("missiles", library.missiles, "seeker.look_rate",
       [](const MissileType& type) { return type.seeker.look_rate; });
  for (std::size_t i = 0; i < library.aircraft.size(); ++i)
    if (const sim::Period usual = sim::period_steps(Tracker{}.rate, dt);
        !usual && !library.aircraft[i].index.tracker)
      problems.push_back(
          {"aircraft", library.aircraft.name(i), "tracker", "without one, " + usual.error});
  for (std::size_t i = 0; i < library.datalinks.size(); ++i)
    if (const std::string_view problem = library.datalinks[i].problem(); !problem.empty())
      problems.push_back({"datalinks", library.datalinks.name(i), "delay", std::string(problem)});
  for (std::size_t i = 0; i < library.jammers.size(); ++i)
    if (library.jammers[i].power <= 0 && !library.jammers[i].pull_off)
      problems.push_back({"jammers", library.jammers.name(i), "power",
                          "it radiates neither noise nor false echoes (pull_off)"});
  for (std::size_t i = 0; i < library.aircraft.size(); ++i) {
    const auto& index = library.aircraft[i].index;
    if (index.jammer && library.jammers[*index.jammer].when_tracked && !index.rwr)
      problems.push_back({"aircraft", library.aircraft.name(i), "jammer",
                          "it radiates when it is tracked (when_tracked), which nobody without a "
                          "warning receiver (rwr) knows"});
  }
  for (std::size_t i = 0; i < library.missiles.size(); ++i)
    if (library.missiles[i].locks_before_launch() && library.missiles[i].guidance.loft)
      problems.push_back(
          {"missiles", library.missiles.name(i), "guidance.loft",
           "an infrared missile flies by its seeker from the start: it never lofts"});
  const auto name = [&](std::string_view kind, const auto& shelf, std::string_view parameter,
                        auto text, auto parsed, std::string_view wanted) {
    for (std::size_t i = 0; i < shelf.size(); ++i)
      if (!parsed(shelf[i].*text))
        problems.push_back({kind, shelf.name(i), parameter,
                            fmt::format("'{}' is not {}", printable(shelf[i].*text), wanted)});
  };
  const auto type = [&](std::string_view kind, const auto& shelf, auto text) {
    name(kind, shelf, "entity_type", text, entity_type_of,
         "two to seven numbers between dots, such as 1.2.225.1.5.3 (the third at most 65535, the "
         "others 255)");
  };
  type("aircraft", library.aircraft, &AircraftType::entity_type);
  type("vehicles", library.vehicles, &VehicleType::entity_type);
  type("missiles", library.missiles, &MissileType::entity_type);
  type("guns", library.guns, &GunType::entity_type);
  constexpr std::string_view kNumber = "a number up to 65535";
  name("radars", library.radars, "emitter", &Radar::emitter, emitter_of, kNumber);
  name("missiles", library.missiles, "emitter", &MissileType::emitter, emitter_of, kNumber);
  return problems;
}

}  // namespace eyrie::model
