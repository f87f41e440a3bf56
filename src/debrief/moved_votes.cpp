// SPDX-License-Identifier: MIT
/// \file  Votes in a scenario with other trees.
#include <algorithm>

#include "debrief/what_if.hpp"
#include "pilot/outside.hpp"

namespace eyrie::debrief {
namespace {

using model::VoteChange;

/// The node with the path of node `number` - 1 of a flown tree, as a number in the other one; 0 if
/// there is none.
std::uint16_t moved(const scenario::Scenario& flown, const scenario::Scenario& other,
                    std::size_t tree, std::uint16_t number) {
  const auto &mine = flown.fleets.front()->trees, &theirs = other.fleets.front()->trees;
  if (number == 0 || tree >= mine.size() || tree >= theirs.size() || number > mine[tree]->size())
    return number;
  const auto node = theirs[tree]->find(mine[tree]->path(static_cast<ubf::NodeIndex>(number - 1)));
  return node ? static_cast<std::uint16_t>(*node + 1) : 0;
}

/// A vote for a node of a tree, if it names both.
std::optional<VoteChange> vote_in(const sim::Order& order) {
  if (order.kind != sim::OrderKind(pilot::OrderKind::vote))
    return {};
  const auto vote = order.as<VoteChange>();
  return vote.tree > 0 && vote.number > 0 ? std::optional(vote) : std::nullopt;
}

}  // namespace

sim::Order moved_vote(const scenario::Scenario& flown, const scenario::Scenario& other,
                      const sim::Order& order) {
  auto vote = vote_in(order);
  if (!vote)
    return order;
  vote->number = moved(flown, other, vote->tree - 1U, vote->number);
  return sim::order_for(order.step, order.player, pilot::OrderKind::vote, *vote);
}

void move_votes(const scenario::Scenario& flown, const scenario::Scenario& other,
                sim::World& world) {
  const auto agents = world.rows(other.pilots.agent);
  const auto asked = world.rows(other.aircraft.tasking);
  for (std::size_t row = 0; row < asked.size(); ++row) {
    auto& votes = asked[row].votes;
    for (VoteChange& vote : votes)
      vote.number = moved(flown, other, agents[row].tree, vote.number);
    const auto kept = std::stable_partition(votes.begin(), votes.end(),
                                            [](const VoteChange& v) { return v.number != 0; });
    std::fill(kept, votes.end(), VoteChange{});
  }
}

std::vector<std::string> votes_left_out(const Recorded& recorded, const scenario::Scenario& other) {
  std::vector<std::string> paths;
  for (const sim::Order& order : recorded.run.orders)
    if (const auto vote = vote_in(order);
        vote && moved(*recorded.scenario, other, vote->tree - 1U, vote->number) == 0)
      paths.push_back(recorded.scenario->fleets.front()->trees[vote->tree - 1U]->path(
          static_cast<ubf::NodeIndex>(vote->number - 1)));
  return paths;
}

}  // namespace eyrie::debrief
