// SPDX-License-Identifier: MIT
/// \file  What the user reads: header, story, closing table; or one JSON object.
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include "campaigns.hpp"
#include "core/hash.hpp"
#include "core/text.hpp"
#include "core/units.hpp"
#include "debrief/what_if.hpp"
#include "disk/file_system.hpp"
#include "flight.hpp"
#include "record/json_text.hpp"

namespace eyrie::app {
using model::Side;
using record::Tone;

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

void Ends::observe(const sim::World& world, const sim::StepInfo&,
                   std::span<const sim::Event> events) {
  for (const sim::Event& e : events) {
    if (record::kind_of(e) == model::EventKind::launch)
      missiles_[e.who] = fmt::format("{}'s {} from {}", scenario_.roster.name(PlayerId{e.detail}),
                                     record::store_label(scenario_, e.values[1]),
                                     format_range(static_cast<double>(e.values[0])));
    if (record::kind_of(e) == model::EventKind::kill && scenario_.roster.find(e.whom))
      players_[e.whom.value - 1].by =
          e.detail ? missiles_[PlayerId{e.detail}] : scenario_.roster.name(e.who) + "'s gun";
  }
  for (const auto& fleet : scenario_.fleets)
    for (std::uint32_t row = 0; row < fleet->rows(world); ++row)
      if (const PlayerId who = fleet->id(world, row); scenario_.roster.find(who))
        players_[who.value - 1] = {.fuel = fleet->gauges(world, row).fuel,
                                   .by = std::move(players_[who.value - 1].by),
                                   .here = !model::is_nowhere(fleet->motion(world, row))};
}

void Report::table(const record::Tally& tally, const Ends& ends) const {
  std::size_t names = 10, words = 10;  // columns
  for (std::size_t i = 0; i < tally.players().size(); ++i) {
    names = std::max(names, scenario_.roster.players[i].name.size());
    words = std::max(words, tally.players()[i].phase.size());
  }
  say("\n{:<{}} {:<5} {:>5} {:>5}  {:<14} {:>9}  {:<{}} {}\n", "player", names, "side", "shots",
      "kills", "end", "fuel", "phase", words, "by");
  for (std::size_t i = 0; i < tally.players().size(); ++i) {
    const auto& p = tally.players()[i];
    const auto& who = scenario_.roster.players[i];
    const Ends::OfPlayer& end = ends.players()[i];
    const std::string how = p.lost      ? "lost " + record::clock_text(p.end_time)
                            : p.home    ? "home " + record::clock_text(p.end_time)
                            : !end.here ? "not heard of"
                                        : std::string(scenario_.fleets[who.fleet]->words.there);
    const std::string line =
        shown(" {:<5} {:>5} {:>5}  {:<14} {:>9}  {:<{}} {}", scenario::side_name(who.side), p.shots,
              p.kills, how, end.fuel ? format_quantity(*end.fuel, Dimension::mass) : "-", p.phase,
              words, end.by);
    say("{}{}\n",
        paint(fmt::format("{:<{}}", who.name, names),
              who.side == Side::blue ? Tone::blue : Tone::red),
        Composed{line.substr(0, line.find_last_not_of(' ') + 1)});
  }
  std::vector<std::string> phases;
  for (const auto& phase : tally.phases())
    if (scenario_.roster.flights[phase.flight].side == Side::blue)
      phases.push_back(fmt::format("{} {} {}", scenario_.roster.flights[phase.flight].name,
                                   phase.phase, record::clock_text(phase.time)));
  if (!phases.empty())
    say("\n{}\n", fmt::format("{}", fmt::join(phases, "   ")));
}

namespace {

std::string pacing_text(const Timing& timing) {
  const net::Pacing& p = *timing.pacing;
  const net::Histogram& late = p.late();
  std::string text = fmt::format(
      "by the clock: {} of {} frames{} missed; begun late by {:.2f} ms (p50), {:.2f} "
      "(p99), {:.2f} (p99.9), {:.2f} at most; load {:.1f} %, {:.0f} % at most; {} others{}\n",
      p.missed(), p.frames(),
      p.is_of_one_frame() ? fmt::format(" of {:.4g} ms", p.frame() * 1e3) : "",
      late.percentile(0.5) * 1e3, late.percentile(0.99) * 1e3, late.percentile(0.999) * 1e3,
      late.max() * 1e3, 100 * p.load(), 100 * p.greatest_load(),
      timing.came_first ? "before all" : "no sooner than",
      timing.moves == 0 ? ""
                        : fmt::format(", {} on another processor", counted(timing.moves, "time")));
  if (p.stalls())
    text += fmt::format("fell behind {} and gave up {:.1f} s\n", counted(p.stalls(), "time"),
                        p.given_up());
  return text;
}

std::string heard_text(const Broadcast::Counts& counts) {
  const dis::HeardCounts& heard = counts.heard;
  std::string text = fmt::format("DIS: {} heard of {} {}, {} of whom vanished: {}, {}, {}, {}\n",
                                 counted(counts.came->received, "packet"), heard.entities,
                                 heard.entities == 1 ? "entity" : "entities", heard.vanished,
                                 counted(heard.states, "state"), counted(heard.shots, "shot"),
                                 counted(heard.ends, "end"), counted(heard.emissions, "emission"));
  std::vector<std::string> unused;
  if (const auto lost = counts.came->dropped + counts.came->too_long)
    unused.push_back(fmt::format("{} too many or too long", lost));
  for (std::size_t i = 0; i < heard.unused.size(); ++i)
    if (heard.unused[i])
      unused.push_back(
          fmt::format("{} {}", heard.unused[i], dis::words_of(static_cast<dis::Unused>(i))));
  if (!unused.empty())
    text += fmt::format("     not used: {}\n", fmt::join(unused, ", "));
  if (heard.latency.count)
    text += fmt::format("     on their way {:.1f} ms, {:.1f} ms at most\n",
                        1e3 * heard.latency.mean(), 1e3 * heard.latency.max);
  if (heard.error.count)
    text += fmt::format("     dead reckoning was off by {:.2f} m, {:.1f} m at most\n",
                        heard.error.mean(), heard.error.max);
  if (counts.asked)
    text += fmt::format("     {} of {} to start or stop obeyed{}\n", counts.obeyed,
                        counted(counts.asked, "order"), counts.obeyed ? "" : ": --dis-obey does");
  return text;
}

nlohmann::ordered_json heard_json(const Broadcast::Counts& counts) {
  const dis::HeardCounts& heard = counts.heard;
  nlohmann::ordered_json j = {{"packets", counts.came->received},
                              {"dropped", counts.came->dropped + counts.came->too_long},
                              {"entities", heard.entities},
                              {"states", heard.states},
                              {"shots", heard.shots},
                              {"ends", heard.ends},
                              {"emissions", heard.emissions},
                              {"vanished", heard.vanished},
                              {"asked", counts.asked},
                              {"obeyed", counts.obeyed},
                              {"latency_mean_s", heard.latency.mean()},
                              {"latency_max_s", heard.latency.max},
                              {"error_mean_m", heard.error.mean()},
                              {"error_max_m", heard.error.max}};
  for (std::size_t i = 0; i < heard.unused.size(); ++i)
    j["not_used"][std::string(enum_name(static_cast<dis::Unused>(i)))] = heard.unused[i];
  return j;
}

nlohmann::ordered_json pacing_json(const Timing& timing) {
  const net::Pacing& p = *timing.pacing;
  const auto spread = [](const net::Histogram& h) {
    return nlohmann::ordered_json{{"mean", h.mean()},
                                  {"p50", h.percentile(0.5)},
                                  {"p99", h.percentile(0.99)},
                                  {"p999", h.percentile(0.999)},
                                  {"max", h.max()}};
  };
  return {{"frame_s", p.frame()},
          {"frames", p.frames()},
          {"missed", p.missed()},
          {"late_s", spread(p.late())},
          {"work_s", spread(p.work())},
          {"load", p.load()},
          {"stalls", p.stalls()},
          {"given_up_s", p.given_up()},
          {"before_others", timing.came_first},
          {"moves", timing.moves}};
}

}  // namespace

void Report::closing(const scenario::Mission& mission, const record::Tally& tally, const Ends& ends,
                     const Timing& timing, const std::string& run_dir,
                     const std::string& files) const {
  table(tally, ends);
  const double time = mission.run().time();
  say("{}\n", debrief::outcome_text(mission, tally));
  if (const auto refused = mission.run().world().refused_births(); refused > 0)
    say("no room in the world: {} could not be launched or born\n", counted(refused, "player"));
  say("world hash {} after {}", hash_text(mission.run().world().hash()),
      counted(mission.run().world().step(), "step"));
  if (timing.kept_until)
    say("; the run file ends before, at {}", record::clock_text(*timing.kept_until));
  say("\n");
  say("{:.0f} s flown in {:.3f} s, {:.0f} x real time\n", time, timing.wall,
      timing.wall > 0 ? time / timing.wall : 0);
  if (timing.pacing && timing.pacing->frames() > 0)
    say("{}", Composed{pacing_text(timing)});
  if (const auto& t = timing.tacview)
    say("Tacview: {}, {} refused, {} dropped as too slow, {} sent\n", counted(t->joined, "client"),
        t->refused, t->dropped, size_text(t->bytes));
  if (const auto& d = timing.dis) {
    say("DIS: {} sent, {}, {} dropped{}\n", counted(d->sent.sent, "packet"),
        size_text(d->sent.bytes), d->sent.dropped,
        d->sent.failed ? fmt::format(", {} not taken by the system: {}", d->sent.failed,
                                     disk::words_of(d->sent.error))
                       : "");
    if (d->came)
      say("{}", Composed{heard_text(*d)});
  }
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
  if (timing.kept_until)
    j["kept_until_s"] = *timing.kept_until;
  j["refused_births"] = mission.run().world().refused_births();
  j["phases"] = nlohmann::json::array();
  for (const auto& phase : tally.phases())
    j["phases"].push_back({{"flight", scenario.roster.flights[phase.flight].name},
                           {"phase", phase.phase},
                           {"time_s", phase.time}});
  for (const Side side : {Side::blue, Side::red}) {
    auto& own = j["sides"][std::string(scenario::side_name(side))];
    own["players"] = tally.side(side).players;
    own.update(side_json(tally.side(side)));
  }
  j["outcome"] = enum_name(mission.outcome());
  if (const sim::Fault* fault = mission.run().fault())
    j["fault"] =
        scenario::fault_text(*fault, mission.scenario().roster, mission.run().simulation().dt());
  if (timing.pacing)
    j["real_time"] = pacing_json(timing);
  if (const auto& t = timing.tacview)
    j["tacview"] = {{"clients", t->joined},
                    {"refused", t->refused},
                    {"dropped", t->dropped},
                    {"bytes", t->bytes}};
  if (const auto& d = timing.dis) {
    j["dis"] = {{"sent", d->sent.sent},
                {"bytes", d->sent.bytes},
                {"dropped", d->sent.dropped},
                {"failed", d->sent.failed}};
    if (d->came)
      j["dis"]["heard"] = heard_json(*d);
  }
  j["run_dir"] = run_dir;
  return record::json_lines(j);
}

}  // namespace eyrie::app
