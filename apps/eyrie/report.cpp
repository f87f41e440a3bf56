// SPDX-License-Identifier: MIT
#include "report.hpp"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "core/units.hpp"
#include "record/json_text.hpp"

namespace eyrie::app {
using model::Side;
using record::Tone;

std::string outcome_text(const scenario::Mission& mission, const record::Tally& tally) {
  const auto blue = tally.side(Side::blue), red = tally.side(Side::red);
  std::string text;
  switch (mission.outcome()) {
    case scenario::Outcome::blue_home:
      text = blue.players ? fmt::format("blue is home, {} of {}", blue.home, blue.players)
                          : "blue has arrived";
      break;
    case scenario::Outcome::blue_lost:
      text = "no blue player is left";
      break;
    case scenario::Outcome::red_lost:
      text = "no red player is left";
      break;
    case scenario::Outcome::time:
      text = fmt::format("time is up at {}", record::clock_text(mission.run().time()));
      break;
    case scenario::Outcome::fault:
      text = fmt::format("a fault ended it at {}", record::clock_text(mission.run().time()));
      break;
    default:
      text = fmt::format("stopped at {}", record::clock_text(mission.run().time()));
      break;
  }
  return fmt::format("{}; losses: blue {}, red {}", text, blue.losses, red.losses);
}

Composed Report::paint(const std::string& text, Tone tone) const {
  const std::string fit = printable(text);
  if (!color_ || tone == Tone::plain)
    return {fit};
  const char* code = tone == Tone::blue   ? "34"
                     : tone == Tone::red  ? "31"
                     : tone == Tone::kill ? "1;33"
                                          : "1;36";
  return {fmt::format("\x1b[{}m{}\x1b[0m", code, fit)};
}

void Report::header(std::uint64_t seed) const {
  say("{}", scenario_.spec.name);
  if (!scenario_.spec.help_text.empty())
    say(": {}", lines(scenario_.spec.help_text));
  say("\nseed {}", seed);
  for (const auto& flight : scenario_.roster.flights) {
    const auto& lead = scenario_.roster.players[flight.members.front().value - 1];
    say(", {}", paint(fmt::format("{} {} {} x {}", scenario::side_name(flight.side), flight.name,
                                  flight.members.size(), lead.label),
                      flight.side == Side::blue ? Tone::blue : Tone::red));
  }
  say("\n\n");
}

void Report::line(const record::StoryLine& line) const {
  say("{:>8}  {}  {}\n", record::clock_text(line.time),
      paint(fmt::format("{:<9}", line.who), line.tone), line.text);
}

void Report::table(const scenario::Mission& mission, const record::Tally& tally) const {
  say("\n{:<10} {:<5} {:>5} {:>5}  {:<20} {:>9}  {}\n", "player", "side", "shots", "kills", "end",
      "fuel kg", "phase");
  const auto& world = mission.run().world();
  for (std::size_t i = 0; i < tally.players().size(); ++i) {
    const auto& p = tally.players()[i];
    const auto& who = scenario_.roster.players[i];
    const scenario::Fleet& fleet = *scenario_.fleets[who.fleet];
    const auto row = fleet.row(world, PlayerId{static_cast<std::uint32_t>(i + 1)});
    const auto fuel = row ? fleet.gauges(world, *row).fuel : std::nullopt;
    const std::string end = p.lost   ? "lost " + record::clock_text(p.end_time)
                            : p.home ? "home " + record::clock_text(p.end_time)
                                     : std::string(fleet.words.there);
    say("{} {:<5} {:>5} {:>5}  {:<20} {:>9}  {}\n",
        paint(fmt::format("{:<10}", who.name), who.side == Side::blue ? Tone::blue : Tone::red),
        scenario::side_name(who.side), p.shots, p.kills, end,
        fuel ? fmt::format("{:.0f}", *fuel) : "-", p.phase);
  }
  say("\n");
  for (const auto& phase : tally.phases())
    if (scenario_.roster.flights[phase.flight].side == Side::blue)
      say("{} {} {}   ", scenario_.roster.flights[phase.flight].name, phase.phase,
          record::clock_text(phase.time));
  say("\n");
}

void Report::closing(const scenario::Mission& mission, const record::Tally& tally,
                     const Timing& timing, const std::string& run_dir,
                     const std::string& files) const {
  table(mission, tally);
  const double time = mission.run().time();
  say("{}\n", outcome_text(mission, tally));
  if (const auto refused = mission.run().world().refused_births(); refused > 0)
    say("no room in the world: {} {} could not be launched or born\n", refused,
        refused == 1 ? "player" : "players");
  say("world hash {} after {} steps\n", hash_text(mission.run().world().hash()),
      mission.run().world().step());
  say("{:.0f} s flown in {:.3f} s, {:.0f} x real time\n", time, timing.wall,
      timing.wall > 0 ? time / timing.wall : 0);
  if (timing.paced)
    say("paced by the clock: {} of {} deadlines missed, the worst by {:.1f} ms\n", timing.missed,
        timing.deadlines, timing.worst_late * 1000);
  say("written to {}: {}\n", run_dir, files);
}

std::string json_report(const scenario::Mission& mission, const record::Tally& tally,
                        std::uint64_t seed, const Timing& timing, const std::string& run_dir) {
  const auto& scenario = mission.scenario();
  const double time = mission.run().time();
  nlohmann::ordered_json j;
  j["scenario"] = scenario.spec.name;
  j["seed"] = seed;
  j["steps"] = mission.run().world().step();
  j["sim_time_s"] = time;
  j["wall_time_s"] = timing.wall;
  j["realtime_factor"] = timing.wall > 0 ? time / timing.wall : 0;
  j["hash"] = hash_text(mission.run().world().hash());
  j["refused_births"] = mission.run().world().refused_births();
  j["phases"] = nlohmann::json::array();
  for (const auto& phase : tally.phases())
    j["phases"].push_back({{"flight", scenario.roster.flights[phase.flight].name},
                           {"phase", phase.phase},
                           {"time_s", phase.time}});
  for (const Side side : {Side::blue, Side::red}) {
    const auto s = tally.side(side);
    j["sides"][std::string(scenario::side_name(side))] = {{"players", s.players},
                                                          {"losses", s.losses},
                                                          {"shots", s.shots},
                                                          {"kills", s.kills},
                                                          {"home", s.home}};
  }
  j["outcome"] = enum_name(mission.outcome());
  if (const sim::Fault* fault = mission.run().fault())
    j["fault"] =
        scenario::fault_text(*fault, mission.scenario().roster, mission.run().simulation().dt());
  if (timing.paced)
    j["deadlines"] = {{"total", timing.deadlines},
                      {"missed", timing.missed},
                      {"worst_late_s", timing.worst_late}};
  j["run_dir"] = run_dir;
  return record::json_lines(j);
}

}  // namespace eyrie::app
