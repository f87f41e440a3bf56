// SPDX-License-Identifier: MIT
#include "debrief/decision.hpp"

#include <fmt/format.h>

namespace eyrie::debrief {
namespace {

/// Where a sequencer went, and because of what: " for wvr: in_sight holds".
std::string transition(const Decision& now, ubf::NodeIndex sequencer) {
  std::string to, because;
  for (const Answer& child : now.nodes) {
    if (child.parent != sequencer || !child.asked)
      continue;
    if (child.vote > 0)
      to = " for " + child.label;
    else if (child.status == ubf::Status::success && child.action.empty())
      because += fmt::format("{}{} holds", because.empty() ? ": " : ", ", child.label);
  }
  return to + because;
}

}  // namespace

std::string reason(const Won& won) {
  if (won.rivals.empty())
    return "nobody else asked for it";
  if (won.blended)
    return fmt::format("blended of {}", won.rivals.size());
  const Rival& next = won.rivals.front();
  return next.against > next.vote ? fmt::format("voted {:g} against {:g}", next.against, next.vote)
         : next.against == next.vote
             ? fmt::format("voted {:g} as the other did, and comes first", next.vote)
             : fmt::format("{:g} against {:g}, by its place in the tree", next.against, next.vote);
}

std::string words(const Answer& answer) {
  if (!answer.asked)
    return "not asked";
  if (answer.status == ubf::Status::failure)
    return answer.why.empty() ? "failed" : "failed: " + answer.why;
  std::string text(ubf::to_text(answer.status));
  if (answer.vote > 0)
    text += fmt::format(", votes {:g}", answer.vote);
  return answer.why.empty() ? text : fmt::format("{} ({})", text, answer.why);
}

std::string why_not(const Decision& now, ubf::NodeIndex before) {
  if (before >= now.nodes.size())
    return "nobody led";
  const Answer& then = now.nodes[before];
  if (!then.asked) {
    ubf::NodeIndex left = before;  // the highest node that was not asked
    while (now.nodes[left].parent != ubf::kNone && !now.nodes[now.nodes[left].parent].asked)
      left = now.nodes[left].parent;
    const ubf::NodeIndex parent = now.nodes[left].parent;
    if (parent != ubf::kNone && now.nodes[parent].type == "sequencer")
      return now.nodes[left].label + " was left" + transition(now, parent);
    return fmt::format("{} was not asked", now.nodes[left].label);
  }
  if (then.status == ubf::Status::failure)
    return fmt::format("{} {}", then.label, words(then));
  if (now.leader == ubf::kNone)
    return fmt::format("{} proposed nothing", then.label);
  const auto [mine, its] = parting(now.nodes, now.leader, before);
  return fmt::format("{} voted {:g} against {:g}", then.label, now.nodes[its].vote,
                     now.nodes[mine].vote);
}

namespace {

/// "#3 (bogey1)": as the agent knows it, and who it really was.
std::string debrief_name(const Perceived& one, const scenario::Roster& roster) {
  if (!one.truth)
    return fmt::format("#{}", one.number);
  return roster.find(one.truth) ? fmt::format("#{} ({})", one.number, roster.name(one.truth))
                                : fmt::format("#{} (missile {})", one.number, one.truth.value);
}

}  // namespace

std::optional<Decision> Explainer::explain(const sim::World& before, const sim::World& after,
                                           PlayerId who, std::span<const sim::Order> orders) const {
  std::optional<Decision> decision;
  if (const auto found = scenario_.find(before, who))
    found->fleet.agents->look_again(before, after, who, orders, [&](const team::AnyMoment& m) {
      decision = m.decision(*asked_.fleet_of(who).agents);
      for (Perceived& one : decision->perceived)
        one.name = debrief_name(one, scenario_.roster);
    });
  return decision;
}

ubf::NodeIndex Explainer::leader(const sim::World& world, PlayerId who) const {
  const auto found = scenario_.find(world, who);
  return found ? found->fleet.agents->last_decision(world, found->row).node : ubf::kNone;
}

std::string Explainer::leader_label(const sim::World& world, PlayerId who) const {
  const auto found = scenario_.find(world, who);
  return found ? found->fleet.leader(world, found->row) : "nobody";
}

}  // namespace eyrie::debrief
