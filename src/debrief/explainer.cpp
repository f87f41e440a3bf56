// SPDX-License-Identifier: MIT
#include "debrief/explainer.hpp"

#include <algorithm>

#include "debrief/nodes.hpp"
#include "debrief/values.hpp"
#include "model/track.hpp"

namespace eyrie::debrief {
namespace {

template <class Action>
std::vector<Value> values_of(const Action& action) {
  std::vector<Value> values;
  ubf::for_each_field<Action>([&](const auto& f, auto) {
    if (action.*f.member)
      values.push_back(action_value(f.name, f.unit, *(action.*f.member)));
  });
  return values;
}

template <class State, class Action>
std::vector<Answer> answers(std::vector<Answer> all, const ubf::Tree<State, Action>& tree,
                            const ubf::Trace<Action>& trace) {
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto index = static_cast<ubf::NodeIndex>(i);
    const auto& row = trace.row(index);
    Answer& answer = all[i];
    answer.asked = row.ticked;
    answer.status = row.status;
    answer.vote = row.proposal.vote;
    answer.halts = row.halts;
    answer.action = values_of(row.proposal.action);
    const ubf::VoteCurve* curve = tree.node(index).vote_curve();
    if (row.ticked && row.status != ubf::Status::failure && curve)
      answer.why = curve->text(trace.scores(index), ubf::state_field_infos<State>());
    else if (!row.ticked || row.status != ubf::Status::failure)
      answer.why.clear();
    else if (const char* why = trace.why(index))
      answer.why = why;
  }
  return all;
}

/// Who won each field of the root's action, and against whom.
template <class Action>
std::vector<Won> contest(const std::vector<Answer>& nodes, const ubf::Trace<Action>& trace) {
  std::vector<Won> all;
  const auto& root = trace.row(0);
  ubf::for_each_field<Action>([&](const auto& f, auto i) {
    if (!(root.proposal.action.*f.member))
      return;
    Won won{.value = action_value(f.name, f.unit, *(root.proposal.action.*f.member)),
            .winner = root.supplier[i],
            .blended = !nodes[root.supplier[i]].is_leaf,
            .rivals = {}};
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      const auto node = static_cast<ubf::NodeIndex>(n);
      const auto& proposed = trace.row(node).proposal.action.*f.member;
      if (node == won.winner || !nodes[n].is_leaf || !proposed)
        continue;
      const auto [its, mine] = parting(nodes, node, won.winner);
      won.rivals.push_back({.node = node,
                            .value = action_value(f.name, f.unit, *proposed),
                            .against = nodes[mine].vote,
                            .vote = nodes[its].vote});
    }
    std::sort(won.rivals.begin(), won.rivals.end(), [](const Rival& a, const Rival& b) {
      return a.vote != b.vote ? a.vote > b.vote : a.node < b.node;
    });
    all.push_back(std::move(won));
  });
  return all;
}

/// "#3 (bogey1)": as the agent knows it, and who it really was.
std::string debrief_name(std::uint32_t id, PlayerId truth, const scenario::Scenario& scenario) {
  if (!truth)
    return fmt::format("#{}", id);
  return scenario.roster.find(truth) ? fmt::format("#{} ({})", id, scenario.roster.name(truth))
                                     : fmt::format("#{} (missile {})", id, truth.value);
}

std::vector<Perceived> perceived(const pilot::State& s, const scenario::Scenario& scenario) {
  std::vector<Perceived> all;
  for (const pilot::Seen& seen : s.tracks_seen()) {
    const bool chosen = s.target() == &seen;
    all.push_back({chosen ? "target" : "track",
                   debrief_name(seen.id().value, seen.track->truth, scenario),
                   {action_value("identity", {}, seen.track->identity),
                    number_value("range", "m", seen.range),
                    number_value("bearing", "rad", wrap_tau(pilot::bearing_of(seen.ned))),
                    number_value("altitude", "m", pilot::altitude_of(s.own, seen.ned)),
                    number_value("closing", "m/s", s.closing_on(seen)),
                    number_value("age", "s", s.time - seen.track->time)}});
  }
  for (std::uint32_t i = 0; i < s.rwr.count; ++i) {
    const model::RwrWarning& warning = s.rwr.warnings[i];
    all.push_back({"radar",
                   debrief_name(i + 1, warning.emitter, scenario),
                   {action_value("kind", {}, warning.kind),
                    number_value("bearing", "rad", wrap_tau(warning.bearing)),
                    number_value("known for", "s", s.time - warning.first_time)}});
  }
  for (std::uint32_t i = 0; i < s.threats.count; ++i) {
    const model::InboundMissile& m = s.threats.missiles[i];
    all.push_back({"missile",
                   debrief_name(i + 1, m.truth, scenario),
                   {number_value("bearing", "rad", wrap_tau(m.bearing)),
                    number_value("range", "m", m.has_position ? m.range : ubf::kNoValue),
                    number_value("known for", "s", s.time - m.first_time)}});
  }
  return all;
}

std::vector<Perceived> perceived(const driver::State& s, const scenario::Scenario& scenario) {
  std::vector<Perceived> all;
  std::uint32_t number = 0;
  for (const model::Sighted& seen : s.lookout.all())
    all.push_back(
        {"aircraft",
         debrief_name(++number, seen.truth, scenario),
         {action_value("identity", {}, seen.identity), number_value("range", "m", s.range_to(seen)),
          number_value("bearing", "rad", wrap_tau(s.bearing_to(seen.position))),
          number_value("age", "s", s.time - seen.time)}});
  return all;
}

template <class State, class Action>
Decision decision_of(const team::Moment<State>& m, const ubf::Tree<State, Action>& tree,
                     const ubf::Tree<State, Action>& flown, ubf::Trace<Action>& trace,
                     const std::vector<Answer>& blank, const scenario::Scenario& scenario) {
  auto memory = team::memory_for(tree, flown, m);
  const auto out = team::ask_again(tree, m, reinterpret_cast<std::byte*>(memory.data()), &trace);
  Decision d;
  d.status = trace.row(0).status;
  d.step = m.info.step;
  d.time = m.info.time();
  d.player = m.who;
  d.tree = tree.name();
  d.vote = out.vote;
  d.leader = out.leader;
  d.nodes = answers(blank, tree, trace);
  d.action = contest(d.nodes, trace);
  d.state = state_values(m.state);
  d.perceived = perceived(m.state, scenario);
  return d;
}

}  // namespace

Explainer::Explainer(const scenario::Scenario& scenario, const scenario::Scenario& asked)
    : scenario_(scenario),
      asked_(asked),
      pilots_(find_system<pilot::PilotSystem>(*scenario.simulation)),
      drivers_(find_system<driver::DriverSystem>(*scenario.simulation)),
      pilot_trace_(asked.trees->max_size()),
      driver_trace_(asked.driver_trees->max_size()) {
  for (const auto& tree : *asked.trees)
    pilot_nodes_.push_back(unanswered(tree));
  for (const auto& tree : *asked.driver_trees)
    driver_nodes_.push_back(unanswered(tree));
}

std::optional<Decision> Explainer::explain(const sim::World& before, const sim::World& after,
                                           PlayerId who, std::span<const sim::Order> orders) {
  std::optional<Decision> decision;
  const auto* player = scenario_.roster.find(who);
  if (player && player->platform == scenario::Platform::vehicle && drivers_)
    drivers_->revisit(before, after, who, orders, [&](const team::Moment<driver::State>& m) {
      const auto tree = m.state.agent.tree;
      decision = decision_of(m, (*asked_.driver_trees)[tree], (*scenario_.driver_trees)[tree],
                             driver_trace_, driver_nodes_[tree], scenario_);
    });
  else
    pilots_->revisit(before, after, who, orders, [&](const team::Moment<pilot::State>& m) {
      const auto tree = m.state.agent.tree;
      decision = decision_of(m, (*asked_.trees)[tree], (*scenario_.trees)[tree], pilot_trace_,
                             pilot_nodes_[tree], scenario_);
    });
  return decision;
}

ubf::NodeIndex Explainer::leader(const sim::World& world, PlayerId who) const {
  if (const auto row = world.row(scenario_.aircraft.table, who))
    return world.rows(scenario_.pilots.agent)[*row].node;
  if (scenario_.vehicles)
    if (const auto row = world.row(scenario_.vehicles->table, who))
      return world.rows(scenario_.drivers.agent)[*row].node;
  return ubf::kNone;
}

std::string Explainer::leader_label(const sim::World& world, PlayerId who) const {
  const auto label = [](const auto& trees, const auto& agent) {
    return agent.tree < trees.size() && agent.node < trees[agent.tree].size()
               ? std::string(trees[agent.tree].node(agent.node).label())
               : "nobody";
  };
  if (const auto row = world.row(scenario_.aircraft.table, who))
    return label(*scenario_.trees, world.rows(scenario_.pilots.agent)[*row]);
  if (scenario_.vehicles)
    if (const auto row = world.row(scenario_.vehicles->table, who))
      return label(*scenario_.driver_trees, world.rows(scenario_.drivers.agent)[*row]);
  return "nobody";
}

}  // namespace eyrie::debrief
