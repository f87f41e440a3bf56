// SPDX-License-Identifier: MIT
#pragma once
/// \file  What is asked of an aircraft from outside: a person or a policy at its controls, weapons
/// tight, points to fly to, other votes.
#include "model/columns.hpp"
#include "pilot/state.hpp"
#include "team/outside.hpp"

namespace eyrie::pilot {

/// Orders that pilots carry out.
enum class OrderKind : std::uint16_t {
  none = 0,
  swap_tree = 1,
  manual = 16,   ///< model::Manual: take over, steer, shoot; with Seat::tree: hand back
  vote = 17,     ///< model::VoteChange; a negative vote: as the file says
  weapons = 18,  ///< one byte: 1 is weapons tight
  point = 19,    ///< model::PointToFly; `more` of 2 forgets all of them
};

/// A point is reached within so many metres along the ground.
inline constexpr double kPointReached = 2000;
/// As a Manual's `store`: the missile of the shortest reach in whose zone the target is.
inline constexpr std::uint8_t kAnyStore = 255;

/// Puts what a person asks for into an action: his numbers are flown by hold or, with a climb, as a
/// direction, and he alone shoots. Target, radar and decoys that he says nothing of stay as they
/// are.
void fly_by_hand(const model::Manual& manual, const State& state, Action& action);

/// See team::NoOutside.
struct Outside {
  using Asked = model::Tasking;
  static constexpr auto column = &model::AircraftColumns::tasking;
  static constexpr std::array orders{
      sim::OrderKind(OrderKind::manual), sim::OrderKind(OrderKind::vote),
      sim::OrderKind(OrderKind::weapons), sim::OrderKind(OrderKind::point)};

  static team::Obeyed obey(const sim::Order& order, Asked& asked, const team::Flown& flown);
  /// 1 for who takes over and for tight, 0 for who hands back and for free; a node; points.
  static double detail(const sim::Order& order);
  static bool sleeps(const Asked& asked) { return asked.manual.seat == model::Seat::remote; }
  static team::NodeVotes<Asked::kVotes> votes(const Asked& asked) {
    team::NodeVotes<Asked::kVotes> votes;
    for (const model::VoteChange& change : asked.votes) {
      if (change.number == 0) [[likely]]
        break;
      votes.votes[votes.size++] = {static_cast<ubf::NodeIndex>(change.number - 1), change.vote};
    }
    return votes;
  }
  static void forget_votes(Asked& asked) { asked.votes = {}; }
  static bool says(const Asked& asked) {
    return asked.manual.seat != model::Seat::tree || asked.manual.said != 0 || asked.tight ||
           asked.points_left > 0;
  }
  /// A person's numbers are flown instead of the tree's, by hold or, with a climb, as a direction;
  /// a point instead of the route or of the place beside the lead.
  static void overrule(const Asked& asked, const State& state, Action& action);
  /// Forgets what was asked for once, and a point that is reached.
  static void done(Asked& asked, const State& state);
};

}  // namespace eyrie::pilot
