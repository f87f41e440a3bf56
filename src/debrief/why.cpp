// SPDX-License-Identifier: MIT
/// \file  Who won in a decision, and because of what.
#include <fmt/ranges.h>

#include "debrief/decision.hpp"

namespace eyrie::debrief {
namespace {

/// What those say that count: a node itself, or what is below one that has no words of its own.
template <class Counts, class Say>
std::vector<std::string> told(const Decision& now, ubf::NodeIndex node, const Counts& counts,
                              const Say& say) {
  const Answer& answer = now.nodes[node];
  if (!answer.asked || !counts(answer))
    return {};
  std::vector<std::string> all;
  if (answer.label == answer.type)
    for (std::size_t n = node; n < now.nodes.size(); ++n)
      if (now.nodes[n].parent == node)
        std::ranges::move(told(now, static_cast<ubf::NodeIndex>(n), counts, say),
                          std::back_inserter(all));
  return all.empty() ? std::vector<std::string>{say(answer)} : all;
}

/// Which conditions made a node hold.
std::vector<std::string> conditions(const Decision& now, ubf::NodeIndex node) {
  return told(
      now, node,
      [](const Answer& a) { return a.status == ubf::Status::success && a.action.empty(); },
      [](const Answer& a) { return a.label; });
}

/// What failed: "in_sight does not hold", "pursue failed: no target".
std::vector<std::string> unmet(const Decision& now, ubf::NodeIndex node) {
  return told(
      now, node, [](const Answer& a) { return a.status == ubf::Status::failure; },
      [](const Answer& a) {
        return a.label + " " + (a.why == "does not hold" ? a.why : words(a));
      });
}

/// Because of what a node was not asked: what the sibling that was asked last has to say, if that
/// failed, or else the node above; a node that goes on, or was chosen, says so itself.
std::string because_of(const Decision& now, ubf::NodeIndex left, ubf::NodeIndex parent) {
  std::vector<std::string> failed;
  for (std::size_t n = parent + 1U; n < left; ++n)
    if (now.nodes[n].parent == parent && now.nodes[n].asked)
      failed = unmet(now, static_cast<ubf::NodeIndex>(n));
  const Answer& above = now.nodes[parent];
  if (failed.empty() && above.status == ubf::Status::failure && !above.why.empty())
    failed = {above.label + " " + words(above)};
  return failed.empty() ? "" : fmt::format(": {}", fmt::join(failed, ", "));
}

/// Where a sequencer went, and because of what: " for wvr: in_sight holds".
std::string transition(const Decision& now, ubf::NodeIndex sequencer) {
  std::string to, because;
  for (std::size_t n = sequencer; n < now.nodes.size(); ++n) {
    const Answer& child = now.nodes[n];
    if (child.parent != sequencer || !child.asked)
      continue;
    if (child.vote > 0)
      to = " for " + child.label;
    else
      for (const std::string& condition : conditions(now, static_cast<ubf::NodeIndex>(n)))
        because += fmt::format("{}{} holds", because.empty() ? ": " : ", ", condition);
  }
  return to + because;
}

/// What decided in the place of votes.
std::string decided(const std::string& by, const std::string& set_aside) {
  return !set_aside.empty() ? ", " + set_aside
         : by.empty()       ? ", and votes did not decide"
                            : ", and " + by + " decided";
}

}  // namespace

std::string reason(const Won& won) {
  if (won.held)
    return "held from an earlier decision";
  if (won.rivals.empty())
    return "nobody else asked for it";
  const Rival& next = won.rivals.front();
  if (next.blended)
    return fmt::format("blended of {}", std::ranges::count_if(won.rivals, &Rival::blended));
  if (!next.came_up)
    return "nobody else's came up to it";
  const bool beaten =
      next.against > next.vote || (next.against == next.vote && won.winner < next.node);
  if (!next.decided_by.empty() || !next.set_aside.empty() || !beaten)
    return fmt::format("{:g} against {:g}{}", next.against, next.vote,
                       decided(next.decided_by, next.set_aside));
  return next.against > next.vote
             ? fmt::format("voted {:g} against {:g}", next.against, next.vote)
             : fmt::format("voted {:g} as the other did, and comes first", next.vote);
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
    return fmt::format("{} was not asked{}", now.nodes[left].label,
                       parent == ubf::kNone ? "" : because_of(now, left, parent));
  }
  if (then.status == ubf::Status::failure)
    return fmt::format("{} {}", then.label, words(then));
  if (now.leader == ubf::kNone ||
      now.nodes[parting(now.nodes, now.leader, before).second].status == ubf::Status::failure) {
    ubf::NodeIndex keeper = then.parent;  // the first that did not hand it on
    while (keeper != ubf::kNone && !now.nodes[keeper].action.empty())
      keeper = now.nodes[keeper].parent;
    if (keeper == ubf::kNone || then.action.empty())
      return fmt::format("{} proposed nothing", then.label);
    const Answer& by = now.nodes[keeper];
    return fmt::format("{} was kept back by {}{}", then.label, by.label,
                       by.why.empty() ? "" : ": " + by.why);
  }
  const auto [mine, its] = parting(now.nodes, now.leader, before);
  const ubf::NodeIndex lost = team::lost_in(now.nodes, before, its);
  const float voted = now.nodes[its].counted(), against = now.nodes[mine].counted();
  const std::string& by = team::decided_by(now.nodes, {mine, its});
  const std::string& set_aside = now.nodes[its].set_aside;
  const bool beaten = voted < against || (voted == against && mine < its);
  return fmt::format(
      "{}{} voted {:g} against {:g}{}", then.label,
      lost == ubf::kNone ? "" : fmt::format(" lost in {}, which", now.nodes[lost].label), voted,
      against,
      !by.empty() || !set_aside.empty() || !beaten ? decided(by, set_aside)
      : voted == against                           ? ", and comes later"
                                                   : "");
}

}  // namespace eyrie::debrief
