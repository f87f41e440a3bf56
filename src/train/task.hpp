// SPDX-License-Identifier: MIT
#pragma once
/// \file  What is learned: a scenario, who learns in it, what he sees, does and is rewarded for;
/// and what one decision of his was worth.
#include "scenario/scenario.hpp"

namespace eyrie::train {

/// What is rewarded. Of a term of an event a weight is for each one; of one "per second" it is for
/// a second, and the term is in [0, 1] or [-1, 1]. The enemy is the nearest one that lives. Unlike
/// what is observed, these are the truth.
enum class Term : std::uint8_t {
  win,        ///< the episode is over, no enemy is left, somebody of the own side is
  loss,       ///< over, somebody of the other side lives, nobody of the own
  draw,       ///< over, otherwise
  kill,       ///< an enemy is killed by the learner
  killed,     ///< the learner is killed, crashes or is lost
  hit,        ///< a missile or a step of gun fire hits somebody, fired by the learner
  hit_by,     ///< the learner is hit
  launch,     ///< the learner launches a missile
  rounds,     ///< a round that the learner fires
  alive,      ///< per second: 1
  nose_on,    ///< per second: 1 with the enemy on the nose, 0 with him behind
  advantage,  ///< per second: the enemy's angle off his nose less the own one off the nose, over
              ///< 180°
  closeness,  ///< per second: 1 within `low` m of the enemy, 0 from `high` on
  closing,    ///< per second: the rate of closing (m/s) over `high`, in [-1, 1]
  low,        ///< per second: 1 below `low` m of altitude, 0 from `high` on
  formation,  ///< per second: 1 within `low` m of the place in the formation, 0 from `high` on
};
constexpr auto names_of(Term) {
  return names_from_zero<Term>("win", "loss", "draw", "kill", "killed", "hit", "hit_by", "launch",
                               "rounds", "alive", "nose_on", "advantage", "closeness", "closing",
                               "low", "formation");
}

/// Whether a term goes by the `low` and `high` of its reward.
[[nodiscard]] constexpr bool has_range(Term term) {
  return term == Term::nose_on || term == Term::advantage || term == Term::closeness ||
         term == Term::closing || term == Term::low || term == Term::formation;
}

/// A term with its weight. nose_on and advantage have a range too, if `high` is above `low`: they
/// count in full within `low` m of the enemy and not from `high` on.
struct Reward {
  Term term = Term::win;
  double weight = 1;
  double low = 0, high = 0;
};

/// Instead of controls: the votes of the children of an arbiter, in order, at most eight.
struct Votes {
  std::string arbiter;  ///< its path in the learner's tree, "root/fight"
  double most = 100;    ///< the vote of an action of 1; -1 is 0
};

/// Who flies by one of several trees of the scenario, drawn anew for each episode.
struct Opponent {
  std::string player;
  std::vector<std::string> trees;
};

/// A task: a value, so that a user changes one of the table or writes his own.
struct TaskSpec {
  std::string name, help;
  std::string scenario;                ///< a file
  std::vector<std::string> sets = {};  ///< overrides, as `--set`
  std::vector<std::string> learners;   ///< names of aircraft of one observation and action
  std::string observation;             ///< text of a pilot::Observation
  std::string controls = {};           ///< text of a pilot::Controls, unless there are votes
  std::optional<Votes> votes = {};
  std::vector<Reward> rewards;
  std::vector<Opponent> opponents = {};
};

/// The tasks that come with the library: merge, bvr, sweep, formation, intercept.
[[nodiscard]] std::span<const TaskSpec> tasks();
/// One of them; throws std::invalid_argument with the nearest name.
[[nodiscard]] const TaskSpec& task(std::string_view name);

/// Of the last decision of one learner.
struct Merit {
  bool alive = true;        ///< after it
  bool home = false;        ///< not alive because it came home
  std::uint32_t kills = 0;  ///< of enemies
  std::uint32_t hits = 0, hits_by = 0, launches = 0;
  std::uint32_t rounds = 0;  ///< by what is left in the drum: a burst may end later, or never
};

/// Notes in `merit` what an event means for a player.
void note(const sim::Event& event, PlayerId who, const scenario::Roster& roster, Merit& merit);

/// The sum of the terms. `over`: the episode is. `seconds`: since the decision before.
[[nodiscard]] double reward(std::span<const Reward> terms, const scenario::Scenario& scenario,
                            const sim::World& world, PlayerId who, const Merit& merit, bool over,
                            double seconds);

}  // namespace eyrie::train
