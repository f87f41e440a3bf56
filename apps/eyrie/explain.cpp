// SPDX-License-Identifier: MIT
/// \file  explain: a recorded run flown again, with every node's answer.
#include <cctype>

#include "commands.hpp"
#include "core/units.hpp"
#include "debrief/look.hpp"
#include "locate.hpp"
#include "record/json_text.hpp"
#include "say.hpp"
#include "scenario/plugin_file.hpp"

namespace eyrie::app {
namespace {

void say_key_moments(const debrief::Recorded& recorded, const ExplainOptions& options) {
  const std::vector<debrief::Moment> moments = debrief::key_moments(recorded);
  if (options.json)
    return say("{}\n", Composed{debrief::moments_json(moments, recorded.scenario->roster)});
  say("{}", Composed{debrief::moments_text(moments, recorded.scenario->roster)});
  say("{}  {}\n", record::clock_text(recorded.until()), recorded.run.outcome);
  say("\na decision whole: eyrie explain {} --player NAME --at TIME\n",
      scenario::shell_word(options.run));
}

}  // namespace

int explain(const ExplainOptions& options) {
  debrief::Wanted wanted{.event = options.event};
  for (const auto& [text, name, place] : {std::tuple(&options.at, "--at", &wanted.from),
                                          std::tuple(&options.from, "--from", &wanted.from),
                                          std::tuple(&options.to, "--to", &wanted.to)}) {
    if (!text->empty())
      *place = time_named(name, *text);
  }
  if (!options.to.empty() && wanted.to <= wanted.from)
    refuse("--to {}: must be after --from", quote(options.to));
  if (!options.event.empty() && std::ranges::none_of(options.event, [](unsigned char c) {
        return std::isalpha(c) || c >= 0x80;
      }))
    refuse("--event {}: expected a word, such as break", quote(options.event));
  wanted.once = !options.at.empty();
  const bool window = !options.from.empty() || !options.to.empty();
  wanted.changes =
      options.changes || (!options.csv && !wanted.once && !window && wanted.event.empty());

  const debrief::Recorded recorded = open_run(options.run, options.plugins);
  const scenario::Roster& roster = recorded.scenario->roster;
  if (options.player.empty()) {
    say_key_moments(recorded, options);
    return 0;
  }
  const PlayerId who = decider_named(roster, options.player);
  wanted.from = first_shown(recorded, wanted.from);
  demand_within(recorded, wanted.once ? "--at" : "--from", wanted.once ? options.at : options.from,
                wanted.from);

  const bool whole = wanted.once || !wanted.event.empty();
  record::JsonList list;
  bool first = true;
  const auto tell = [&](const debrief::Change& found) {
    if (options.csv)
      say("{}", Composed{debrief::decision_csv(found.now, roster)});
    else if (options.json)
      say("{}", Composed{list.next(debrief::found_json(found, wanted, roster))});
    else
      say("{}{}", Composed{whole && !first ? "\n" : ""},
          Composed{debrief::found_text(found, wanted, roster)});
    first = false;
  };
  if (options.csv)
    say("{}", Composed{std::string(debrief::kDecisionCsv)});
  const debrief::Found found =
      debrief::look(recorded, who, wanted, tell, [] { return lost_output() != 0; });
  if (options.json)
    say("{}", Composed{list.end()});
  if (found.count == 0 && lost_output() == 0)
    refuse("{}{}", wanted.event.empty() ? "" : fmt::format("--event {}: ", quote(options.event)),
           debrief::nothing_text(options.player, wanted, found));
  return 0;
}

}  // namespace eyrie::app
