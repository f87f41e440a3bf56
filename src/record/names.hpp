// SPDX-License-Identifier: MIT
#pragma once
/// \file  What events mean in names: phases, stores, behaviors.
#include "model/events.hpp"
#include "scenario/scenario.hpp"
#include "sim/event.hpp"

namespace eyrie::record {

[[nodiscard]] inline model::EventKind kind_of(const sim::Event& e) {
  return static_cast<model::EventKind>(e.kind.value);
}

/// "132.30", or "132.296" where hundredths do not tell it; with zeros before it to `width`.
[[nodiscard]] inline std::string seconds_text(double seconds, int width = 0) {
  std::string text = fmt::format("{:0{}.3f}", seconds, width);
  if (text.ends_with('0'))
    text.pop_back();
  return text;
}
/// The whole steps in so many seconds, at least one.
[[nodiscard]] inline std::uint64_t steps_in(double seconds, double dt) {
  return std::max<std::uint64_t>(1, static_cast<std::uint64_t>(seconds / dt + 0.5));
}

/// Whether both are players, and of one side.
[[nodiscard]] inline bool same_side(const scenario::Roster& roster, PlayerId a, PlayerId b) {
  const auto *one = roster.find(a), *other = roster.find(b);
  return one && other && one->side == other->side;
}

/// Of an event whose values are of a tree (EventValue::is_of_tree): that tree, null if there is
/// none.
[[nodiscard]] const ubf::AnyTree* tree_of(const scenario::Scenario& scenario, const sim::Event& e);
/// Of a phase event: whether its sequencer is the outermost one of the player's tree.
[[nodiscard]] bool is_outermost(const scenario::Scenario& scenario, const sim::Event& phase);
/// Label of a node of the tree that an event names, "" if there is none.
[[nodiscard]] std::string node_label(const scenario::Scenario& scenario, const sim::Event& e,
                                     float node);
/// Of a phase event: label of a child of its sequencer, "" if there is none.
[[nodiscard]] std::string child_label(const scenario::Scenario& scenario, const sim::Event& phase,
                                      float child);
/// Of a phase event: the name of the tree that was entered, such as "ingress".
[[nodiscard]] std::string phase_name(const scenario::Scenario& scenario, const sim::Event& phase);
/// Of an order event: "swap_tree", "take_over", as tables have it.
[[nodiscard]] std::string_view order_word(const sim::Event& order);
/// Of an order event: "flies by tree patrol from now on".
[[nodiscard]] std::string order_sentence(const scenario::Scenario& scenario,
                                         const sim::Event& order);
/// Label of a missile type by its index in the library, "?" if there is none.
[[nodiscard]] std::string store_label(const scenario::Scenario& scenario, float index);

/// A player's name; "AIM-120 #7 of eagle1" of a missile that flies in this world, "missile 7" of
/// one that does not.
[[nodiscard]] std::string name_in(const scenario::Scenario& scenario, const sim::World& world,
                                  PlayerId id);

/// Every missile since its launch.
class Missiles {
 public:
  struct Missile {
    PlayerId shooter, target;
    std::string label;  ///< of its type
  };
  explicit Missiles(const scenario::Scenario& scenario) : scenario_(&scenario) {}

  /// To be told every event, before its missile is asked for.
  void note(const sim::Event& e);
  [[nodiscard]] const Missile* find(PlayerId id) const;
  /// "AIM-120 #7 of eagle1", of anybody else its name in the roster.
  [[nodiscard]] std::string name(PlayerId id) const;

 private:
  const scenario::Scenario* scenario_;
  std::map<PlayerId, Missile> all_;
};

// Who leaves the run by an event, and how.

struct Fate {
  PlayerId who;
  std::string_view end;  ///< "lost", "home"; of a missile "kill", "miss", "trashed"
};

/// Nothing for an event by which nobody leaves.
[[nodiscard]] inline std::optional<Fate> fate_of(const sim::Event& e) {
  using model::EventKind;
  switch (kind_of(e)) {
    case EventKind::detonation:  // the draw was below the kill probability; -1: others decide
      return Fate{e.who, e.values[2] >= 0 && e.values[2] < e.values[1] ? "kill" : "miss"};
    case EventKind::timeout:
      return Fate{e.who, "trashed"};
    case EventKind::kill:
      return Fate{e.whom, "lost"};
    case EventKind::crash:
    case EventKind::loss:
      return Fate{e.who, "lost"};
    case EventKind::home:
      return Fate{e.who, "home"};
    default:
      return std::nullopt;
  }
}

}  // namespace eyrie::record
