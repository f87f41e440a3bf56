// SPDX-License-Identifier: MIT
#include "debrief/difference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "debrief/decision.hpp"
#include "record/story.hpp"
#include "sim/difference.hpp"

namespace eyrie::debrief {
namespace {

/// The first player, fleet by fleet and by id, who asks for something else.
PlayerId asks_otherwise(const scenario::Scenario& s, const sim::World& a, const sim::World& b) {
  for (const auto& fleet : s.fleets)
    for (std::uint32_t i = 0; i < fleet->rows(a); ++i) {
      const PlayerId who = fleet->id(a, i);
      const auto j = fleet->row(b, who);
      if (j && !fleet->agents->want_alike(a, i, b, *j))
        return who;
    }
  return {};
}

std::string leader_of(const scenario::Scenario& s, const sim::World& world, PlayerId who) {
  const auto found = s.find(world, who);
  return found ? found->fleet.leader(world, found->row) : "nobody";
}

std::string event_text(std::span<const sim::Event> events, std::size_t i,
                       const scenario::Roster& roster) {
  if (i >= events.size())
    return "nothing";
  const sim::Event& e = events[i];
  const auto whom = e.whom ? " " + roster.name(e.whom) : "";
  return fmt::format("{} {}{}", roster.name(e.who),
                     model::event_name(static_cast<model::EventKind>(e.kind.value)), whom);
}

/// The first event that is not the same, as both have it.
std::optional<std::string> other_event(const Reflight& a, const Reflight& b,
                                       const scenario::Roster& roster) {
  const auto left = a.events(), right = b.events();
  const auto same = [](const sim::Event& x, const sim::Event& y) {
    return std::memcmp(&x, &y, sizeof x) == 0;
  };
  const std::size_t shared = std::min(left.size(), right.size());
  for (std::size_t i = 0; i <= shared; ++i)
    if (i < shared ? !same(left[i], right[i]) : left.size() != right.size())
      return fmt::format("{}, and {} in the other", event_text(left, i, roster),
                         event_text(right, i, roster));
  return std::nullopt;
}

}  // namespace

std::optional<RunDifference> compare(const Recorded& left, const Recorded& right,
                                     std::string& problem) {
  if (left.run.layout_hash != right.run.layout_hash) {
    problem = fmt::format(
        "{} and {} have worlds of other tables: other kinds of players, or trees "
        "that remember more",
        left.file, right.file);
    return std::nullopt;
  }
  const scenario::Scenario& scenario = *left.scenario;
  RunDifference found;
  Reflight a(left), b(right);
  const auto part = [&](std::optional<Parting>& place, std::string text) {
    place = {a.before().step(), a.time(), std::move(text)};
  };
  while (!(found.world && found.action && found.event)) {
    const bool more_left = a.step(), more_right = b.step();
    if (more_left != more_right) {
      const std::string text =
          fmt::format("{} is over, the other goes on", more_left ? right.file : left.file);
      for (auto* place : {&found.world, &found.action, &found.event})
        if (!*place)
          part(*place, text);
      break;
    }
    if (!more_left)
      break;
    ++found.steps;
    if (!found.action) {
      if (const PlayerId who = asks_otherwise(scenario, a.after(), b.after()))
        part(found.action,
             fmt::format("{}: {} leads, and {} in the other", scenario.roster.name(who),
                         leader_of(scenario, a.after(), who),
                         leader_of(*right.scenario, b.after(), who)));
    }
    if (!found.event)
      if (const auto text = other_event(a, b, scenario.roster))
        part(found.event, *text);
    if (!found.world && a.after().hash() != b.after().hash())
      if (const auto difference = sim::first_difference(a.after(), b.after()))
        part(found.world, difference->text());
  }
  return found;
}

}  // namespace eyrie::debrief
