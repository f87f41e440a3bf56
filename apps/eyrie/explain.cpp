// SPDX-License-Identifier: MIT
/// \file  explain: a recorded run flown again, with every node's answer.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <optional>
#include <set>

#include "commands.hpp"
#include "core/units.hpp"
#include "debrief/decision.hpp"
#include "debrief/recorded.hpp"
#include "debrief/report.hpp"
#include "record/names.hpp"
#include "record/story.hpp"
#include "say.hpp"

namespace eyrie::app {
namespace {

/// A number that begins with a digit: no sign, no inf.
std::optional<double> plain(std::string_view text) {
  double value = 0;
  const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool digit = !text.empty() && std::isdigit(static_cast<unsigned char>(text.front()));
  return digit && failed == std::errc{} && end == text.data() + text.size() && std::isfinite(value)
             ? std::optional(value)
             : std::nullopt;
}
bool whole(std::string_view text) {
  return std::all_of(text.begin(), text.end(),
                     [](unsigned char c) { return std::isdigit(c) != 0; });
}

std::string small_letters(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// What was asked for.
struct Wanted {
  double from = 0, to = 1e9;  ///< s
  bool once = false;          ///< only the first decision in that time
  bool changes = false;
  std::string event;
};

/// The times (s) at which the player has to do with an event that has the word in it.
class EventTimes final : public sim::Observer {
 public:
  EventTimes(const scenario::Scenario& scenario, PlayerId who, std::string word)
      : scenario_(scenario),
        who_(who),
        word_(small_letters(std::move(word))),
        story_(scenario, [this](const record::StoryLine& line) {
          if (line.who == scenario_.roster.name(who_) && has_word(line.text))
            found_ = true;
        }) {}

  void observe(const sim::World& world, const sim::StepInfo& info,
               std::span<const sim::Event> events) override {
    found_ = false;
    for (const sim::Event& e : events)
      if (e.who == who_ || e.whom == who_) {
        const std::string name(model::event_name(record::kind_of(e)));
        names_.insert(name);
        found_ = found_ || has_word(name);
      }
    story_.observe(world, info, events);
  }
  /// In the last step.
  [[nodiscard]] bool found() const { return found_; }
  /// Of every event so far that the player had to do with.
  [[nodiscard]] const std::set<std::string>& names() const { return names_; }

 private:
  [[nodiscard]] bool has_word(const std::string& text) const {
    return small_letters(text).find(word_) != std::string::npos;
  }
  const scenario::Scenario& scenario_;
  PlayerId who_;
  std::string word_;
  record::Story story_;
  std::set<std::string> names_;
  bool found_ = false;
};

struct Found {
  std::vector<debrief::Decision> decisions;
  std::vector<debrief::Change> changes;
  std::set<std::string> events;  ///< the names of those that the player had
  double until = 0;              ///< s, when the player was last there

  [[nodiscard]] bool nothing() const { return decisions.empty() && changes.empty(); }
};

Found look(const debrief::Recorded& recorded, PlayerId who, const Wanted& wanted) {
  Found found;
  debrief::Reflight flight(recorded);
  debrief::Explainer explainer(*recorded.scenario);
  EventTimes events(*recorded.scenario, who, wanted.event);
  flight.attach(events);
  const auto explain = [&] {
    return explainer.explain(flight.before(), flight.after(), who, flight.orders());
  };

  std::optional<debrief::Decision> last;  // for events between two decisions
  std::optional<ubf::NodeIndex> leader;
  std::string label = "nobody";
  while (flight.time() < wanted.to && flight.step()) {
    if (recorded.scenario->find(flight.after(), who))
      found.until = flight.time();
    if (!wanted.event.empty()) {
      if (auto decision = explain())
        last = std::move(decision);
      if (events.found() && last &&
          (found.decisions.empty() || found.decisions.back().step != last->step))
        found.decisions.push_back(*last);
      continue;
    }
    if (wanted.changes) {
      const ubf::NodeIndex now = explainer.leader(flight.after(), who);
      if (leader == now)
        continue;
      auto decision = explain();
      if (!decision)
        continue;
      debrief::Change change{.now = std::move(*decision), .why = "the first decision"};
      change.to = debrief::label_of(change.now, now);
      if (leader) {
        change.why = debrief::why_not(change.now, *leader);
        if (change.from = label; change.from == change.to) {  // of another branch
          change.from = debrief::branch_of(change.now, *leader);
          change.to = debrief::branch_of(change.now, now);
        }
      }
      leader = now;
      label = debrief::label_of(change.now, now);
      if (flight.time() >= wanted.from - 1e-9)
        found.changes.push_back(std::move(change));
      continue;
    }
    if (flight.time() < wanted.from - 1e-9)
      continue;
    if (auto decision = explain()) {
      found.decisions.push_back(std::move(*decision));
      if (wanted.once)
        break;
    }
  }
  found.events = events.names();
  return found;
}

/// Why nothing was found.
std::string nothing_text(const ExplainOptions& options, const Wanted& wanted, const Found& found) {
  if (!wanted.event.empty())
    return fmt::format(
        "--event {}: {} had no such event in this run; it had {}", quote(wanted.event),
        options.player,
        found.events.empty() ? "none" : fmt::format("{}", fmt::join(found.events, ", ")));
  if (wanted.from > found.until)
    return fmt::format("{} made no decision from {} on: it was there until {}", options.player,
                       record::clock_text(wanted.from), record::clock_text(found.until));
  return fmt::format("{} made no decision in that time", options.player);
}

}  // namespace

std::optional<PlayerId> player_or_complain(const scenario::Roster& roster,
                                           const std::string& name) {
  if (const auto who = roster.find(name))
    return who;
  std::vector<std::string> names;
  for (const auto& player : roster.players)
    names.push_back(player.name);
  complain("--player: there is no player {}{}\n", quote(name), did_you_mean(name, names));
  return std::nullopt;
}

std::optional<double> time_of(const std::string& text) {
  if (const auto colon = text.find(':'); colon != std::string::npos) {
    const std::string_view before = std::string_view(text).substr(0, colon);
    const auto minutes = plain(before);
    const auto seconds = plain(std::string_view(text).substr(colon + 1));
    return minutes && whole(before) && seconds && *seconds < 60
               ? std::optional(*minutes * 60 + *seconds)
               : std::nullopt;
  }
  if (const auto seconds = plain(text))
    return seconds;
  const auto quantity = parse_quantity(text, Dimension::time);
  return quantity && quantity.value >= 0 ? std::optional(quantity.value) : std::nullopt;
}

int explain(const ExplainOptions& options) {
  Wanted wanted{.event = options.event};
  for (const auto& [text, name, place] : {std::tuple(&options.at, "--at", &wanted.from),
                                          std::tuple(&options.from, "--from", &wanted.from),
                                          std::tuple(&options.to, "--to", &wanted.to)}) {
    if (text->empty())
      continue;
    const auto time = time_of(*text);
    if (!time)
      return complain("{} {}: expected a time such as 312.4, '5 min' or 5:12.4\n", name,
                      quote(*text)),
             2;
    *place = *time;
  }
  if (!options.to.empty() && wanted.to <= wanted.from)
    return complain("--to {}: must be after --from\n", quote(options.to)), 2;
  if (!options.event.empty() &&
      std::none_of(options.event.begin(), options.event.end(),
                   [](unsigned char c) { return std::isalpha(c) || c >= 0x80; }))
    return complain("--event {}: expected a word, such as break\n", quote(options.event)), 2;
  wanted.once = !options.at.empty();
  const bool window = !options.from.empty() || !options.to.empty();
  wanted.changes =
      options.changes || (!options.csv && !wanted.once && !window && wanted.event.empty());

  const auto recorded = open_or_complain(options.run, options.plugins);
  if (!recorded)
    return 2;
  const scenario::Roster& roster = recorded->scenario->roster;
  const auto who = player_or_complain(roster, options.player);
  if (!who)
    return 2;

  const double length =
      static_cast<double>(recorded->last_step()) * recorded->scenario->simulation->dt();
  if (wanted.from > length)
    return complain("{} {}: the run ends at {}\n", wanted.once ? "--at" : "--from",
                    quote(wanted.once ? options.at : options.from), record::clock_text(length)),
           2;

  const Found found = look(*recorded, *who, wanted);
  if (options.csv) {
    say("{}", Composed{debrief::decisions_csv(found.decisions, roster)});
  } else if (options.json) {
    say("{}", Composed{wanted.changes ? debrief::changes_json(found.changes, roster)
                                      : debrief::decisions_json(found.decisions, roster)});
  } else if (wanted.changes) {
    for (const debrief::Change& change : found.changes)
      say("{}", Composed{debrief::change_text(change)});
  } else {
    const bool whole = wanted.once || !wanted.event.empty();
    for (std::size_t i = 0; i < found.decisions.size(); ++i)
      say("{}{}", Composed{whole && i > 0 ? "\n" : ""},
          Composed{whole ? debrief::decision_text(found.decisions[i], roster)
                         : debrief::decision_line(found.decisions[i])});
  }
  if (!found.nothing())
    return 0;
  complain("{}\n", nothing_text(options, wanted, found));
  return 2;
}

}  // namespace eyrie::app
