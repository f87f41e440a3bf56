// SPDX-License-Identifier: MIT
#pragma once
/// \file  What an agent would have decided with another tree or other parameters: its recorded
/// states are arbitrated again, without flying.
#include "core/diagnostics.hpp"
#include "debrief/decision.hpp"
#include "debrief/recorded.hpp"
#include "record/story.hpp"
#include "scenario/mission.hpp"
#include "scenario/scenario.hpp"

namespace eyrie::debrief {

/// A decision that would have been another one.
struct Otherwise {
  std::uint64_t step = 0;
  double time = 0;           ///< s
  std::string flown, other;  ///< who led
  std::vector<Changed> fields;
};

struct WhatIf {
  std::uint64_t decisions = 0;  ///< looked at
  std::uint64_t different = 0;  ///< whose action would have been another one
  std::optional<Otherwise> first;
  std::vector<std::uint64_t> steps;     ///< of the world, by decision
  std::vector<ubf::NodeIndex> leaders;  ///< who would have led then; kNone for nobody
  /// Times (s) from the first to the last of decisions in a row that would have been different.
  std::vector<std::pair<double, double>> spans;
  double until = 0;  ///< s, when the player was last there
  /// Why nothing was asked from there on: a run with the other trees would have ended so, as
  /// scenario::fault_text says it. "": it was asked to the end.
  std::string fault = {};
};

/// Asks the trees of `other`, which is the scenario of the run with overrides and has as many,
/// about every state that an agent perceived. They remember what they were asked from the start on;
/// decisions before `from` (s) are not counted.
[[nodiscard]] WhatIf what_if(const Recorded& recorded, const scenario::Scenario& other,
                             PlayerId who, double from);

/// Who would have been the first to decide otherwise: a tree is often flown by others, too, and
/// what is flown on from there is the run that the change makes.
struct First {
  PlayerId who;
  Otherwise decision;
};
/// At or after `from` (s); of several in one step `asked` if it is one of them. Looks no further.
[[nodiscard]] std::optional<First> first_otherwise(const Recorded& recorded,
                                                   const scenario::Scenario& other, PlayerId asked,
                                                   double from);

/// How a run ended, for comparisons.
struct Outcome {
  std::string outcome;  ///< a name of scenario::Outcome
  double time = 0;      ///< s
  record::Tally::OfSide blue, red;
};

/// Of a flight that was watched by `tally`.
[[nodiscard]] Outcome outcome_of(const scenario::Mission& mission, const record::Tally& tally);
/// "blue is home, 3 of 4; losses: blue 1, red 2"
[[nodiscard]] std::string outcome_text(const scenario::Mission& mission,
                                       const record::Tally& tally);
/// The run as it was recorded.
[[nodiscard]] Outcome outcome_of(const Recorded& recorded);
/// The same, with its end at hand.
[[nodiscard]] Outcome outcome_of(const Recorded& recorded, const Past& end);
/// When flights are over that are compared with this run, which ended as `flown` (s): with it
/// unless its sides ended it, which says nothing of the others: as the scenario says.
[[nodiscard]] std::optional<double> limit_of(const Recorded& recorded, const Outcome& flown);
/// A run flown on from one of its worlds with the trees and models of another scenario.
class Branch {
 public:
  /// `past.world` is one of `other`; `until` (s) is when it ends at the latest if it is given,
  /// instead of the scenario's own. The recording must outlive it.
  Branch(const Recorded& recorded, std::shared_ptr<const scenario::Scenario> other,
         const Past& past, std::optional<double> until);

  /// It must outlive the last step.
  void attach(sim::Observer& observer) { mission_->run().attach(observer); }
  /// One step; false when it is over.
  bool step();
  [[nodiscard]] const sim::World& before() const { return before_; }
  [[nodiscard]] const sim::World& after() const { return mission_->run().world(); }
  /// Those of the step.
  [[nodiscard]] std::span<const sim::Order> orders() const {
    return mission_->run().orders_for(before_.step());
  }
  /// As of now, with what had happened before.
  [[nodiscard]] Outcome outcome() const { return outcome_of(*mission_, tally_); }
  /// Steps to the end.
  Outcome fly();

 private:
  record::Tally tally_;
  std::optional<scenario::Mission> mission_;
  sim::World before_;
};

/// Flown as recorded up to `past`, and from there on with `other`, whose trees remember what they
/// would if they had been asked about everything before. Null if that has another world, such as
/// trees that remember more: `problem` says so.
[[nodiscard]] std::unique_ptr<Branch> branch(const Recorded& recorded,
                                             std::shared_ptr<const scenario::Scenario> other,
                                             const Past& past, std::optional<double> until,
                                             std::string& problem);

// Votes that were given to nodes from outside, in a scenario with other trees: they go to the nodes
// of the same paths.

/// An order of a recording; if it is a vote, for the node that has the path in `other`, and for
/// none if no node has it.
[[nodiscard]] sim::Order moved_vote(const scenario::Scenario& flown,
                                    const scenario::Scenario& other, const sim::Order& order);

/// Likewise those that were given before, in a world of `other` that was flown with other trees.
void move_votes(const scenario::Scenario& flown, const scenario::Scenario& other,
                sim::World& world);

/// The paths of nodes that were given another vote and that the other trees do not have.
[[nodiscard]] std::vector<std::string> votes_left_out(const Recorded& recorded,
                                                      const scenario::Scenario& other);

// Overrides by the path of a node: `root/bvr=fusion`, `root/bvr/pursue.vote=70`.

/// Overrides of the scenario's file and of nodes, told apart.
struct Overrides {
  std::vector<std::string> sets;
  std::vector<scenario::TreeChange> changes;
};

/// A path as `explain` writes it, of the tree that the player begins with, or of another one as
/// `patrol:root/bvr`. Before `=` stands the node, for another type, or the node, a point and a
/// parameter. Everything else is an override of the file. Mistakes stand in "--set <text>".
[[nodiscard]] Overrides read_overrides(const scenario::Scenario& scenario, PlayerId who,
                                       const std::vector<std::string>& texts,
                                       Diagnostics& diagnostics);

}  // namespace eyrie::debrief
