// SPDX-License-Identifier: MIT
/// \file  Runs: flown, opened, looked at, kept.
#include "common.hpp"
#include "core/hash.hpp"
#include "debrief/look.hpp"
#include "debrief/what_if.hpp"
#include "disk/output.hpp"
#include "record/acmi.hpp"
#include "record/json_text.hpp"
#include "record/story.hpp"
#include "tables/decision_rows.hpp"
#include "tables/track_rows.hpp"

namespace eyrie::python {
namespace {

/// The run, and why it could not be flown on; "" if it could.
std::tuple<Recorded, std::string> fly(const Scenario& scenario, std::optional<std::uint64_t> seed,
                                      std::optional<double> until, unsigned workers) {
  const auto& loaded = scenario.loaded;
  if (const auto problem = until ? scenario::until_problem(loaded->spec, *until) : std::nullopt)
    refuse("until: {}", *problem);
  const std::uint64_t its_seed = seed.value_or(loaded->spec.seed);
  std::string fault;
  record::RunFile run = without_gil([&](const auto& stop) {
    record::RunFile file = record::run_file_of(*loaded, its_seed, version_text());
    record::Tally tally(*loaded);
    sim::TrailRecorder trail;
    scenario::Mission mission(loaded, its_seed, until, {.workers = workers});
    mission.run().attach(tally);
    mission.run().attach(trail);
    while (!stop() && mission.step()) {
    }
    mission.run().finish();
    file.trail = trail.trail();
    file.orders.assign(mission.run().orders().begin(), mission.run().orders().end());
    file.outcome = debrief::outcome_text(mission, tally);
    if (const sim::Fault* why = mission.run().fault())
      fault = printable_lines(
          scenario::fault_text(*why, loaded->roster, mission.run().simulation().dt()));
    return file;
  });
  return {Recorded{.file = printable(loaded->spec.name),
                   .run = std::move(run),
                   .plugins = listed(loaded->plugins, &scenario::PluginFile::path),
                   .scenario = loaded},
          fault};
}

Recorded open(const std::string& path, std::vector<std::string> plugins,
              const std::vector<Behavior>& behaviors) {
  const GilReleased released;
  debrief::Opened opened =
      debrief::open(path, std::move(plugins), version_text(), {}, adds(behaviors));
  for (const std::string& file : opened.unused)
    opened.problems.push_back(fmt::format("{}: the run has no plug-in {}", path, quote(file)));
  if (!opened.problems.empty())
    raise("RunError", fmt::format("{}", fmt::join(opened.problems, "\n")));
  return {std::move(*opened.recorded)};
}

/// Flies the run again to its end: calls `use(flight)` at its start and after each step.
template <class Use>
void fly_again(const Recorded& r, Use use) {
  without_gil([&](const auto& stop) {
    debrief::Reflight flight(r);
    do
      use(flight);
    while (!stop() && flight.step());
    return true;
  });
}

Columns events(const Recorded& r) {
  TableBuilder table;
  add_event_columns(table);
  record::EventTable names(*r.scenario);
  fly_again(r, [&](const debrief::Reflight& flight) {
    const auto [info, events] = flight.happened();
    for (const sim::Event& event : events)
      table.row(names.row(event, info));
  });
  return table.take();
}

Columns tracks(const Recorded& r, const std::optional<std::string>& player,
               std::optional<double> every) {
  const scenario::Scenario& scenario = *r.scenario;
  const tables::TrackRates rates =
      every ? tables::TrackRates{*every, *every} : tables::TrackRates{};
  const auto who = player ? std::optional(player_named(scenario.roster, *player)) : std::nullopt;
  TableBuilder table;
  table.column("player", "", "whose: a player, or a missile as in events", ColumnKind::words);
  table.column("player_id", "", "its number", ColumnKind::integer);
  for (const tables::TrackColumn& column : tables::kTrackColumns)
    table.column(column.name, column.unit, column.help, ColumnKind::number);
  record::Missiles missiles(scenario);
  fly_again(r, [&](const debrief::Reflight& flight) {
    for (const sim::Event& event : flight.events())
      missiles.note(event);
    tables::each_track(
        scenario, flight.after(), rates, [&](PlayerId id, const tables::TrackRow& row) {
          if (who && *who != id)
            return;
          std::vector<record::Cell> cells{missiles.name(id), static_cast<double>(id.value)};
          cells.insert(cells.end(), row.begin(), row.end());
          table.row(cells);
        });
  });
  return table.take();
}

Columns decisions(const Recorded& r, const std::optional<std::string>& player, double every,
                  bool changes) {
  const scenario::Scenario& scenario = *r.scenario;
  const auto actions = tables::action_columns(scenario);
  TableBuilder table;
  for (const tables::DecisionColumn& column : tables::kDecisionColumns)
    table.column(column.name, column.unit, column.help,
                 column.is_words         ? ColumnKind::words
                 : column.name == "step" ? ColumnKind::integer
                                         : ColumnKind::number);
  for (const tables::ActionColumn& column : actions)
    table.column(column.column, column.unit, "what it asks for; NaN or empty: nothing",
                 column.is_words ? ColumnKind::words : ColumnKind::number);
  tables::Selection selection{.every = every, .changes_only = changes};
  if (player)
    selection.who = player_named(scenario.roster, *player);
  without_gil([&](const auto& stop) {
    debrief::Reflight flight(r);
    tables::Chooser chooser(selection, actions);
    return tables::each_decision(flight, scenario, chooser, stop, [&](const auto& decision) {
      table.row(tables::decision_row(decision, scenario.roster, actions));
    });
  });
  return table.take();
}

/// (text for people, JSON)
std::tuple<std::string, std::string> explain(const Recorded& r, const std::string& player,
                                             std::optional<double> at, double from, double to,
                                             bool changes, const std::string& event) {
  const scenario::Roster& roster = r.scenario->roster;
  const PlayerId who = player_named(roster, player);
  const debrief::Wanted wanted{.from = at.value_or(from),
                               .to = to,
                               .once = at.has_value(),
                               .changes = changes,
                               .event = event};
  if (wanted.from > r.until())
    refuse("{:g} s: the run ends at {:g} s", wanted.from, r.until());
  const bool whole = wanted.once || !wanted.event.empty();
  std::string text, json;
  record::JsonList list;
  const auto use = [&](const debrief::Change& found) {
    text += (whole && !text.empty() ? "\n" : "") + debrief::found_text(found, wanted, roster);
    json += list.next(debrief::found_json(found, wanted, roster));
  };
  const debrief::Found found =
      without_gil([&](const auto& stop) { return debrief::look(r, who, wanted, use, stop); });
  if (found.count == 0)
    refuse("{}", debrief::nothing_text(player, wanted, found));
  return {printable_lines(text), json + list.end()};
}

std::tuple<std::string, std::string> key_moments(const Recorded& r) {
  const scenario::Roster& roster = r.scenario->roster;
  const auto moments = without_gil([&](const auto& stop) { return debrief::key_moments(r, stop); });
  return {debrief::moments_text(moments, roster), debrief::moments_json(moments, roster)};
}

/// (s, who, what), as `eyrie fly` tells it.
std::vector<std::tuple<double, std::string, std::string>> story(const Recorded& r) {
  std::vector<std::tuple<double, std::string, std::string>> lines;
  record::Story story(*r.scenario, [&](const record::StoryLine& line) {
    lines.emplace_back(line.time, printable(line.who), printable(line.text));
  });
  fly_again(r, [&](const debrief::Reflight& flight) {
    const auto [info, events] = flight.happened();
    story.observe(flight.after(), info, events);
  });
  return lines;
}

/// The folder that `eyrie fly --out` makes, without its page. Gives where it
/// is.
std::string save(const Recorded& r, const std::string& folder, bool replace) {
  return without_gil([&](const auto& stop) {
    disk::OutputFolder out({.path = folder,
                            .names = record::kRunFolderNames,
                            .sign = record::kRunFileName,
                            .replace = replace,
                            .to_replace = "say replace=True"});
    disk::Sink run = out.file(record::kRunFileName), events = out.file(record::kEventsName),
               acmi = out.file(record::kFlightName);
    run.write(record::encode(r.run));
    record::EventsCsv csv(*r.scenario, events);
    record::AcmiWriter writer(*r.scenario, [&](std::string_view lines) { acmi.write(lines); });
    debrief::Reflight flight(r);
    flight.attach(csv);
    flight.attach(writer);
    while (!stop() && flight.step()) {
    }
    csv.finish(flight.after());
    writer.finish(flight.after());
    if (stop())
      return std::string();
    for (disk::Sink* sink : {&run, &events, &acmi})
      if (!sink->close())
        throw disk::Failed(sink->error());
    static_cast<void>(out.commit());
    return out.path();
  });
}

}  // namespace

void add_run(nb::module_& m) {
  using nb::arg;
  m.def("fly", &fly, arg("scenario"), arg("seed").none(), arg("until").none(), arg("workers"),
        "Flies a scenario to its end; gives the run, and the fault that ended "
        "it or an empty text.");
  m.def("open", &open, arg("path"), arg("plugins"), arg("behaviors"),
        "Opens a run folder or a run file.");
  nb::class_<Recorded>(m, "Recorded", "A run, to be flown again: eyrie.Run says more.")
      .def_prop_ro("scenario", [](const Recorded& r) { return Scenario{r.scenario}; })
      .def_prop_ro("seed", [](const Recorded& r) { return r.run.seed; })
      .def_prop_ro("steps", [](const Recorded& r) { return r.last_step(); })
      .def_prop_ro("until", [](const Recorded& r) { return r.until(); })
      .def_prop_ro("hash", [](const Recorded& r) { return hash_text(r.run.trail.last_hash); })
      .def_prop_ro("outcome", [](const Recorded& r) { return printable(r.run.outcome); })
      .def_prop_ro("build", [](const Recorded& r) { return printable(r.run.build); })
      .def("events", &events, "Everything that happened, as columns.")
      .def("tracks", &tracks, arg("player").none(), arg("every").none(),
           "Where one or everybody was, as columns.")
      .def("decisions", &decisions, arg("player").none(), arg("every"), arg("changes"),
           "What one or everybody decided, as columns.")
      .def("explain", &explain, arg("player"), arg("at").none(), arg("start"), arg("end"),
           arg("changes"), arg("event"), "Decisions with every answer: (text, JSON).")
      .def("key_moments", &key_moments, "On which decisions the run turned: (text, JSON).")
      .def("story", &story, "(s, who, what) of everything worth telling.")
      .def("save", &save, arg("folder"), arg("replace"), "Writes a run folder; gives where.");
}

}  // namespace eyrie::python
