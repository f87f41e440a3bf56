// SPDX-License-Identifier: MIT
#include "debrief/look.hpp"

#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include "core/text.hpp"
#include "record/json_text.hpp"
#include "record/names.hpp"

namespace eyrie::debrief {
namespace {

/// A line of the story.
std::string line_text(double time, std::string_view who, std::string_view text) {
  return fmt::format("{}  {:<8}  {}", record::clock_text(time), printable(who), printable(text));
}

/// The events with the word in them that the player has to do with, and the decisions they come of.
class EventTimes final : public sim::Observer {
 public:
  EventTimes(const scenario::Scenario& scenario, PlayerId who, std::string word)
      : scenario_(scenario),
        who_(who),
        word_(to_small(std::move(word))),
        story_(scenario, [this](const record::StoryLine& line) {
          if (line.who != scenario_.roster.name(who_))
            return;
          // a missile's event is its shooter's too
          const std::string name(model::event_name(line.kind));
          names_.insert(name);
          if (has_word(line.text) || has_word(name))
            find(line.decided, line.time, line.text);
        }) {}

  void observe(const sim::World& world, const sim::StepInfo& info,
               std::span<const sim::Event> events) override {
    found_.reset();
    lines_.clear();
    released_ = false;
    std::string unnamed;
    for (const sim::Event& e : events)
      if (e.who == who_ || e.whom == who_) {
        const model::EventKind kind = record::kind_of(e);
        const std::string name(model::event_name(kind));
        names_.insert(name);
        released_ |= kind == model::EventKind::release && e.who == who_;
        if (has_word(name))
          unnamed = name;
      }
    story_.observe(world, info, events);
    if (!found_ && !unnamed.empty())  // the story does not tell it
      find(info.time(), info.time(), unnamed);
  }
  /// When what was found in the last step was decided (s); nothing if nothing was.
  [[nodiscard]] std::optional<double> found() const { return found_; }
  /// What was found in the last step, as the story tells it.
  [[nodiscard]] const std::vector<std::string>& lines() const { return lines_; }
  /// Whether the player released a store in the last step.
  [[nodiscard]] bool released() const { return released_; }
  /// Of every event so far that the player had to do with.
  [[nodiscard]] const std::set<std::string>& names() const { return names_; }

 private:
  /// Whether a word of the text begins so.
  [[nodiscard]] bool has_word(const std::string& text) const {
    const std::string small = to_small(text);
    for (auto at = small.find(word_); at != small.npos; at = small.find(word_, at + 1))
      if (at == 0 || !is_letter(small[at - 1]))
        return true;
    return false;
  }
  void find(double decided, double time, const std::string& text) {
    found_ = decided;
    lines_.push_back(line_text(time, scenario_.roster.name(who_), text));
  }
  const scenario::Scenario& scenario_;
  PlayerId who_;
  std::string word_;
  record::Story story_;
  std::set<std::string> names_;
  std::optional<double> found_;
  std::vector<std::string> lines_;
  bool released_ = false;
};

/// explain(flight, who), with where each node stands in the document.
auto explainer(const Recorded& recorded) {
  return [&scenario = *recorded.scenario, paths = tree_paths(recorded)](const Reflight& flight,
                                                                        PlayerId who) {
    auto decision = explain(scenario, flight.before(), flight.after(), who, flight.orders());
    if (decision)
      for (Answer& node : decision->nodes)
        if (const auto at = paths.find(node.where.text()); at != paths.end())
          node.document = at->second;
    return decision;
  };
}

team::LastDecision last_decision(const scenario::Scenario& scenario, const sim::World& world,
                                 PlayerId who) {
  const auto found = scenario.find(world, who);
  return found ? found->fleet.agents->last_decision(world, found->row) : team::LastDecision{};
}

}  // namespace

Found look(const Recorded& recorded, PlayerId who, const Wanted& wanted,
           const std::function<void(const Change&)>& use, const std::function<bool()>& stop) {
  Found found;
  const auto hand_on = [&](const Change& change) {
    ++found.count;
    use(change);
  };
  Reflight flight(recorded);
  EventTimes events(*recorded.scenario, who, wanted.event);
  flight.attach(events);
  const auto explain = [&, of = explainer(recorded)] { return of(flight, who); };

  std::optional<Decision> last;         // for events between two decisions
  std::map<double, Decision> released;  // s
  std::optional<team::LastDecision> leader;
  std::string tree, label = "nobody";
  std::optional<std::uint64_t> handed_on;  // a step
  while (!stop() && flight.time() < wanted.to && flight.step()) {
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
      const Decision& decided = cause == released.end() ? *last : cause->second;
      if (handed_on != decided.step)
        hand_on({.now = decided, .events = events.lines()});
      handed_on = decided.step;
      continue;
    }
    if (wanted.changes) {
      const team::LastDecision now = last_decision(*recorded.scenario, flight.after(), who);
      if (leader && leader->tree == now.tree && leader->node == now.node)
        continue;
      auto decision = explain();
      if (!decision)
        continue;
      Change change{.now = std::move(*decision), .why = "the first decision"};
      change.to = label_of(change.now, now.node);
      if (leader && leader->tree != now.tree) {
        change.from = label;
        change.why = fmt::format("tree {} was swapped for {}", tree, change.now.tree);
      } else if (leader) {
        change.why = why_not(change.now, leader->node);
        if (change.from = label; change.from == change.to) {  // of another branch
          change.from = branch_of(change.now, leader->node);
          change.to = branch_of(change.now, now.node);
          if (change.from == change.to) {
            change.from = change.now.nodes[leader->node].path;
            change.to = change.now.nodes[now.node].path;
          }
        }
      }
      leader = now;
      tree = change.now.tree;
      label = label_of(change.now, now.node);
      if (flight.time() >= wanted.from - 1e-9)
        hand_on(change);
      continue;
    }
    if (flight.time() < wanted.from - 1e-9)
      continue;
    if (auto decision = explain()) {
      hand_on({.now = std::move(*decision)});
      if (wanted.once)
        break;
    }
  }
  found.events = events.names();
  return found;
}

std::string found_text(const Change& found, const Wanted& wanted, const scenario::Roster& roster) {
  if (wanted.changes)
    return change_text(found);
  if (!wanted.once && wanted.event.empty())
    return decision_line(found.now);
  std::string text;
  for (const std::string& event : found.events)
    text += event + '\n';
  return text + decision_text(found.now, roster);
}

nlohmann::ordered_json found_json(const Change& found, const Wanted& wanted,
                                  const scenario::Roster& roster) {
  if (wanted.changes)
    return change_json(found, roster);
  nlohmann::ordered_json decision = decision_json(found.now, roster);
  if (!wanted.event.empty())
    decision["events"] = found.events;
  return decision;
}

std::string nothing_text(const std::string& player, const Wanted& wanted, const Found& found) {
  if (!wanted.event.empty())
    return fmt::format(
        "{} had no such event in this run; it had {}", player,
        found.events.empty() ? "none" : fmt::format("{}", fmt::join(found.events, ", ")));
  const bool to_the_end = !wanted.changes && wanted.to > found.until + 1e-9;
  if (wanted.from > found.until || to_the_end)
    return fmt::format("{} made no decision from {} on: it was there until {}", player,
                       record::clock_text(wanted.from), record::clock_text(found.until));
  if (wanted.changes)
    return fmt::format("{}: no other behavior took the lead in that time", player);
  return fmt::format("{} made no decision in that time", player);
}

std::vector<Moment> key_moments(const Recorded& recorded, const std::function<bool()>& stop) {
  using model::EventKind;
  const scenario::Scenario& scenario = *recorded.scenario;
  std::vector<Moment> moments;
  record::Story story(scenario, [&](const record::StoryLine& line) {
    constexpr std::array kKeys{EventKind::launch, EventKind::kill,        EventKind::crash,
                               EventKind::loss,   EventKind::lead_change, EventKind::phase};
    if (std::ranges::find(kKeys, line.kind) != kKeys.end())
      moments.push_back({line});
  });
  {
    Reflight flight(recorded);
    flight.attach(story);
    while (!stop() && flight.step()) {
    }
  }
  constexpr double kLongest = 2;  // s, between two decisions
  const auto explain = explainer(recorded);
  Reflight flight(recorded);
  while (!stop() && flight.step())
    for (Moment& moment : moments)
      if (flight.time() <= moment.line.decided && flight.time() > moment.line.decided - kLongest)
        if (auto decision = explain(flight, moment.line.decider))
          moment.decision = std::move(decision);
  return moments;
}

std::string moments_text(std::span<const Moment> moments, const scenario::Roster& roster) {
  std::string text;
  for (const Moment& m : moments) {
    text += line_text(m.line.time, m.line.who, m.line.text) + '\n';
    if (m.decision)
      text += fmt::format("    {}:{}", printable(roster.name(m.line.decider)),
                          decision_line(*m.decision));
  }
  return text;
}

std::string moments_json(std::span<const Moment> moments, const scenario::Roster& roster) {
  auto all = nlohmann::ordered_json::array();
  for (const Moment& m : moments)
    all.push_back(
        {{"time", m.line.time},
         {"who", m.line.who},
         {"text", m.line.text},
         {"decision", m.decision ? decision_json(*m.decision, roster) : nlohmann::ordered_json()}});
  return record::json_text(all);
}

}  // namespace eyrie::debrief
