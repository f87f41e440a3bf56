// SPDX-License-Identifier: MIT
#pragma once
/// \file  Decisions as rows of tables: typed, one column for each field of an action.
#include "debrief/decision.hpp"
#include "debrief/recorded.hpp"
#include "record/event_table.hpp"

namespace eyrie::tables {

using record::Cell;

/// A field of the actions of some kind of player.
struct ActionColumn {
  std::string name;    ///< "heading"
  std::string column;  ///< "heading_rad", "mode_order": no word that SQL keeps for itself
  std::string unit;    ///< SI, "" for none
  bool is_words = false;
  bool is_real = false;  ///< a quantity; others are orders
};
/// Those of every kind of player in the scenario, each name once.
[[nodiscard]] std::vector<ActionColumn> action_columns(const scenario::Scenario& scenario);
void add_columns(std::span<const ubf::ActionFieldInfo> fields, std::vector<ActionColumn>& columns);

/// What a table of decisions has before the fields of the action.
struct DecisionColumn {
  std::string_view name, unit, help;
  bool is_words;
};
inline constexpr std::array kDecisionColumns = std::to_array<DecisionColumn>({
    {"time_s", "s", "when it was made", false},
    {"step", "", "of the simulation, when it was made", false},
    {"player", "", "whose it is", true},
    {"tree", "", "that decided", true},
    {"status", "", "`running`, `success`, `failure`, of the root", true},
    {"vote", "", "of the root", false},
    {"leader", "", "label of the node whose recommendation led; empty: nobody's", true},
    {"leader_path", "", "its path in the tree", true},
    {"attacks", "", "who its target really is", true},
});
/// A cell for each of them, then one for each field of the action.
[[nodiscard]] std::vector<Cell> decision_row(const debrief::Decision& decision,
                                             const scenario::Roster& roster,
                                             std::span<const ActionColumn> columns);

/// What a node answered.
struct AnswerRow {
  std::string status, why;
  float vote = 0;
  std::uint16_t halts = 0;
  /// The leaf below it whose whole action it hands on; `action` is empty then. kNone: none.
  ubf::NodeIndex hands_on = ubf::kNone;
  std::vector<Cell> action;  ///< by column
  friend bool operator==(const AnswerRow&, const AnswerRow&) = default;
};

/// The answers of every node to one decision, nothing of those that were not asked. `before`: the
/// last ones of the same player and tree, so that of two leaves with the same action the one is
/// named that was named then; may be null.
using Answers = std::vector<std::optional<AnswerRow>>;
[[nodiscard]] Answers answers_of(const debrief::Decision& decision,
                                 std::span<const ActionColumn> columns, const Answers* before);
/// Every field of what came out of the root.
[[nodiscard]] std::vector<Cell> action_of(const debrief::Decision& decision,
                                          std::span<const ActionColumn> columns);

/// Which decisions are wanted.
struct Selection {
  std::optional<PlayerId> who;  ///< nobody: everybody's
  double every = 0;             ///< s, at most one of a player in so much time; 0: all
  /// Only those in which somebody else leads, another tree decides, or an order of the action is
  /// another one than at the decision before. Headings and other quantities alone are no change.
  bool changes_only = false;
};

/// Tells which decisions of a run are wanted, asked about one after the other.
class Chooser {
 public:
  Chooser(const Selection& selection, std::span<const ActionColumn> columns)
      : selection_(selection), columns_(columns.begin(), columns.end()) {}
  [[nodiscard]] bool wants(PlayerId who) const { return !selection_.who || *selection_.who == who; }
  [[nodiscard]] bool wants(const debrief::Decision& decision);

 private:
  struct Last {
    double time = -1;
    std::string tree;
    ubf::NodeIndex leader = ubf::kNone;
    std::vector<Cell> orders;
  };
  Selection selection_;
  std::vector<ActionColumn> columns_;
  std::map<PlayerId, Last> last_;
};

/// Intervals of decisions in which something stayed the same. A row ends when the player's next
/// decision brings another one for its key, or none.
template <class Key, class Row>
class Intervals {
 public:
  struct Interval {
    std::uint64_t from = 0, to = 0;  ///< steps of the first and the last decision
    Row row;
  };
  /// `before`: the step of the player's decision before this one. `done(key, interval)`.
  template <class Done>
  void see(const Key& key, std::uint64_t before, std::uint64_t step, const Row& row, Done done) {
    const auto [at, is_new] = open_.try_emplace(key, Interval{step, step, row});
    if (is_new)
      return;
    Interval& interval = at->second;
    if (interval.to == before && interval.row == row) {
      interval.to = step;
      return;
    }
    done(key, interval);
    interval = {step, step, row};
  }
  template <class Done>
  void finish(Done done) {
    for (const auto& [key, interval] : open_)
      done(key, interval);
    open_.clear();
  }

 private:
  std::map<Key, Interval> open_;
};

/// Flies a run again and shows `use` each decision that is wanted; false if `stop` said so.
bool each_decision(debrief::Reflight& flight, const scenario::Scenario& scenario, Chooser& chooser,
                   const std::function<bool()>& stop,
                   const std::function<void(const debrief::Decision&)>& use);

}  // namespace eyrie::tables
