// SPDX-License-Identifier: MIT
/// \file  explain: a recorded run flown again, with every node's answer.
#include <fmt/ranges.h>

#include <cctype>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "core/units.hpp"
#include "debrief/decision.hpp"
#include "debrief/recorded.hpp"
#include "locate.hpp"
#include "record/json_text.hpp"
#include "record/names.hpp"
#include "record/story.hpp"
#include "say.hpp"
#include "scenario/plugin_file.hpp"

namespace eyrie::app {
namespace {

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

/// The events with the word in them that the player has to do with, and the decisions they come of.
class EventTimes final : public sim::Observer {
 public:
  EventTimes(const scenario::Scenario& scenario, PlayerId who, std::string word)
      : scenario_(scenario),
        who_(who),
        word_(small_letters(std::move(word))),
        story_(scenario, [this](const record::StoryLine& line) {
          if (line.who == scenario_.roster.name(who_) && has_word(line.text))
            found_ = line.decided;
        }) {}

  void observe(const sim::World& world, const sim::StepInfo& info,
               std::span<const sim::Event> events) override {
    found_.reset();
    released_ = false;
    for (const sim::Event& e : events)
      if (e.who == who_ || e.whom == who_) {
        const model::EventKind kind = record::kind_of(e);
        const std::string name(model::event_name(kind));
        names_.insert(name);
        released_ |= kind == model::EventKind::release && e.who == who_;
        if (has_word(name))
          found_ = info.time();
      }
    story_.observe(world, info, events);
  }
  /// When what was found in the last step was decided (s); nothing if nothing was.
  [[nodiscard]] std::optional<double> found() const { return found_; }
  /// Whether the player released a store in the last step.
  [[nodiscard]] bool released() const { return released_; }
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
  std::optional<double> found_;
  bool released_ = false;
};

/// debrief::explain, with where each node stands in the document.
class Explainer {
 public:
  explicit Explainer(const debrief::Recorded& recorded)
      : scenario_(*recorded.scenario), paths_(debrief::tree_paths(recorded)) {}

  std::optional<debrief::Decision> operator()(const debrief::Reflight& flight, PlayerId who) const {
    auto decision =
        debrief::explain(scenario_, flight.before(), flight.after(), who, flight.orders());
    if (decision)
      for (debrief::Answer& node : decision->nodes)
        if (const auto at = paths_.find(node.where.text()); at != paths_.end())
          node.document = at->second;
    return decision;
  }

 private:
  const scenario::Scenario& scenario_;
  std::map<std::string, std::string> paths_;
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
  EventTimes events(*recorded.scenario, who, wanted.event);
  flight.attach(events);
  const Explainer explainer(recorded);
  const auto explain = [&] { return explainer(flight, who); };

  std::optional<debrief::Decision> last;         // for events between two decisions
  std::map<double, debrief::Decision> released;  // s
  std::optional<ubf::NodeIndex> leader;
  std::string label = "nobody";
  while (flight.time() < wanted.to && flight.step()) {
    if (recorded.scenario->find(flight.after(), who))
      found.until = flight.time();
    if (!wanted.event.empty()) {
      if (auto decision = explain())
        last = std::move(decision);
      if (events.released() && last)
        released.insert_or_assign(flight.time(), *last);
      if (!events.found() || !last)
        continue;
      const auto cause = released.find(*events.found());
      const debrief::Decision& decided = cause == released.end() ? *last : cause->second;
      if (found.decisions.empty() || found.decisions.back().step != decided.step)
        found.decisions.push_back(decided);
      continue;
    }
    if (wanted.changes) {
      const ubf::NodeIndex now = recorded.scenario->leader(flight.after(), who);
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

/// What a run turned on: shots, losses, new leads and phases, and the decisions they come of.
struct Moment {
  record::StoryLine line;
  std::optional<debrief::Decision> decision = {};
};

std::vector<Moment> key_moments(const debrief::Recorded& recorded) {
  using model::EventKind;
  const scenario::Scenario& scenario = *recorded.scenario;
  std::vector<Moment> moments;
  record::Story story(scenario, [&](const record::StoryLine& line) {
    constexpr std::array kKeys{EventKind::launch, EventKind::kill,        EventKind::crash,
                               EventKind::loss,   EventKind::lead_change, EventKind::phase};
    if (std::find(kKeys.begin(), kKeys.end(), line.kind) != kKeys.end())
      moments.push_back({line});
  });
  {
    debrief::Reflight flight(recorded);
    flight.attach(story);
    while (flight.step()) {
    }
  }
  constexpr double kLongest = 2;  // s, between two decisions
  const Explainer explain(recorded);
  debrief::Reflight flight(recorded);
  while (flight.step())
    for (Moment& moment : moments)
      if (flight.time() <= moment.line.decided && flight.time() > moment.line.decided - kLongest)
        if (auto decision = explain(flight, moment.line.decider))
          moment.decision = std::move(decision);
  return moments;
}

void say_key_moments(const debrief::Recorded& recorded, const ExplainOptions& options) {
  if (options.json) {
    auto all = nlohmann::ordered_json::array();
    for (const Moment& m : key_moments(recorded))
      all.push_back(
          {{"time", m.line.time},
           {"who", m.line.who},
           {"text", m.line.text},
           {"decision", m.decision ? debrief::decision_json(*m.decision, recorded.scenario->roster)
                                   : nlohmann::ordered_json()}});
    return say("{}\n", Composed{record::json_text(all)});
  }
  for (const Moment& moment : key_moments(recorded)) {
    say("{}  {:<8}  {}\n", record::clock_text(moment.line.time), moment.line.who, moment.line.text);
    if (moment.decision)
      say("    {}:{}", recorded.scenario->roster.name(moment.line.decider),
          Composed{debrief::decision_line(*moment.decision)});
  }
  say("\na decision whole: eyrie explain {} --player NAME --at TIME\n",
      scenario::shell_word(options.run));
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

int explain(const ExplainOptions& options) {
  Wanted wanted{.event = options.event};
  for (const auto& [text, name, place] : {std::tuple(&options.at, "--at", &wanted.from),
                                          std::tuple(&options.from, "--from", &wanted.from),
                                          std::tuple(&options.to, "--to", &wanted.to)}) {
    if (!text->empty())
      *place = time_named(name, *text);
  }
  if (!options.to.empty() && wanted.to <= wanted.from)
    refuse("--to {}: must be after --from", quote(options.to));
  if (!options.event.empty() &&
      std::none_of(options.event.begin(), options.event.end(),
                   [](unsigned char c) { return std::isalpha(c) || c >= 0x80; }))
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
  const PlayerId who = player_named(roster, options.player);
  demand_within(recorded, wanted.once ? "--at" : "--from", wanted.once ? options.at : options.from,
                wanted.from);

  Found found = look(recorded, who, wanted);
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
  if (found.nothing())
    refuse("{}", nothing_text(options, wanted, found));
  return 0;
}

}  // namespace eyrie::app
