// SPDX-License-Identifier: MIT
#pragma once
/// \file  What an agent decided, and why, in words and numbers for people.
#include "ubf/behavior.hpp"
#include "ubf/state_fields.hpp"

namespace eyrie::team {

/// A value of the state or of an action.
struct Value {
  std::string name;              ///< "heading"
  std::string unit;              ///< SI, "" for none
  std::optional<double> number;  ///< in that unit; none: not a number, or no value
  std::string text;              ///< for people: "045°", "follow", "-"
  bool held = false;             ///< of a node's answer: it was proposed in an earlier decision
  /// Of a node's answer: who supplied it, a leaf or the arbiter that blended it.
  ubf::NodeIndex supplier = ubf::kNone;
};

/// What one node answered.
struct Answer {
  std::string label, type, path;  ///< path: "root/bvr/pursue"
  Location where;                 ///< of its type in the file
  std::string document;  ///< "trees.bvr.per_field.pursue", as --set and replace have it; may be ""
  std::string decided_by;  ///< what decides between its children; empty: their votes
  std::uint16_t depth = 0, parent = ubf::kNone;
  bool asked = false;
  bool is_leaf = true;
  ubf::Status status = ubf::Status::failure;
  float vote = 0;
  std::optional<float> given = {};  ///< the vote that its arbiter put in the place of its own
  std::uint16_t halts = 0;          ///< how often it was made to forget
  std::string why;             ///< it failed, or what its vote followed: "range 0.53"; may be ""
  std::string set_aside = {};  ///< why the node above did not take it: "refused: ..."; may be ""
  std::vector<Value> action;   ///< the fields that it set

  /// The vote by which it was compared.
  [[nodiscard]] float counted() const { return given.value_or(vote); }
};

/// Somebody who proposed a field that another one won.
struct Rival {
  ubf::NodeIndex node = ubf::kNone;
  Value value;
  /// The votes that stood against each other where both were compared: of the branch with the
  /// winner, and of the branch with the rival.
  float against = 0, vote = 0;
  std::string decided_by;  ///< what decided there; empty: these votes
  /// Its branch brought the field up to there, neither lost it below nor abstained.
  bool came_up = true;
  bool blended = false;        ///< the winner made its value of this one and others
  std::string set_aside = {};  ///< why its branch was not compared at all; empty: it was
};

/// A field of the action that came out of the root.
struct Won {
  Value value;
  ubf::NodeIndex winner = ubf::kNone;
  bool blended = false;     ///< the winner is an arbiter that made it of what its children said
  bool held = false;        ///< the winner proposed it earlier, and a node above holds it
  std::string undone = {};  ///< why the player does not do it although it is asked for
  /// What a blend is made of, then those that came up, then the others; by vote, the highest first.
  std::vector<Rival> rivals;
};

/// Something that the agent believed to be there.
struct Perceived {
  std::string kind;           ///< "target", "track", "radar", "missile", "aircraft"
  std::uint32_t number = 0;   ///< as the agent knows it
  PlayerId truth{};           ///< who it really was, for the debrief
  std::vector<Value> values;  ///< range, bearing, identity ...
  std::string name = {};      ///< "#3 (bogey1)": number and truth, filled in by who knows the names
};

/// A field that would have been another one.
struct Changed {
  std::string name, unit;
  std::string flown, other;          ///< for people; "-" for nothing
  std::optional<double> difference;  ///< other minus flown in SI, directions the short way round
};

struct Decision {
  std::uint64_t step = 0;  ///< of the world
  double time = 0;         ///< s
  PlayerId player{};
  std::string tree;
  ubf::Status status = ubf::Status::failure;
  float vote = 0;
  ubf::NodeIndex leader = ubf::kNone;  ///< whose recommendation led; kNone: nobody's
  std::vector<Answer> nodes;           ///< pre-order
  std::vector<Won> action;
  /// What was carried out otherwise, because somebody outside asked for it.
  std::vector<Changed> overruled;
  std::vector<Value> state;
  std::vector<Perceived> perceived;
  PlayerId attacks{};  ///< whom it attacks from then on, in truth; nobody if it has no target
};

/// As what a number of this name reads: "height" is in feet however large it is, "climb" in feet
/// per minute, "direction" from 000 to 359; "quantity" as its dimension does.
[[nodiscard]] inline std::string_view form_of(std::string_view name, Dimension dimension) {
  const auto is_one_of = [&](auto... names) { return (... || (name == names)); };
  return name.find("altitude") != name.npos || name.find("above") != name.npos        ? "height"
         : is_one_of("climb_rate", "excess_power")                                    ? "climb"
         : dimension == Dimension::angle && is_one_of("heading", "bearing", "course") ? "direction"
                                                                                      : "quantity";
}

/// "045°", "6000 ft", "467 kt"; "-" for no value, "never" for infinity. With so many more decimals.
[[nodiscard]] inline std::string number_text(std::string_view name, Dimension dimension,
                                             double number, int more = 0) {
  if (std::isnan(number))
    return "-";
  if (std::isinf(number))
    return "never";
  const std::string_view form = form_of(name, dimension);
  return form == "height"      ? format_height(number, more)
         : form == "climb"     ? format_climb(number, more)
         : form == "direction" ? format_direction(number, more)
                               : format_quantity(number, dimension, more);
}

[[nodiscard]] inline Value number_value(std::string_view name, const Unit& unit, double number) {
  return {std::string(name), std::string(unit.si_symbol),
          std::isfinite(number) ? std::optional(number) : std::nullopt,
          number_text(name, unit.dimension, number)};
}

/// A bearing (rad) from the nose in the plane of the horizon, positive to the right.
[[nodiscard]] inline Value side_value(std::string_view name, double bearing) {
  return {std::string(name), "rad", bearing, format_side(bearing)};
}

/// The value of a field of an action.
template <class T>
[[nodiscard]] Value action_value(std::string_view name, const Unit& unit, const T& value) {
  if constexpr (std::is_same_v<T, bool>)
    return {std::string(name), "", value ? 1 : 0, value ? "true" : "false"};
  else if constexpr (std::is_arithmetic_v<T>)
    return number_value(name, unit, static_cast<double>(value));
  else if constexpr (NamedEnum<T>)
    return {std::string(name), "", std::nullopt, std::string(enum_name(value))};
  else if constexpr (requires { to_text(value); })
    return {std::string(name), "", std::nullopt, to_text(value)};
  else
    return {std::string(name), "", static_cast<double>(value.value),
            value ? fmt::format("#{}", value.value) : "nobody"};
}

/// Every named field of a state.
template <class State>
[[nodiscard]] std::vector<Value> state_values(const State& state) {
  std::vector<Value> values;
  for (const auto& field : ubf::StateFields<State>::all()) {
    Value value = number_value(field.info.name, field.info.unit, field.read(state));
    if (field.info.kind == ubf::FieldKind::flag)
      value.text = value.number == 1 ? "yes" : "no";
    if (field.info.kind == ubf::FieldKind::choice && value.number)
      value.text = field.info.choices[static_cast<std::size_t>(*value.number)];
    values.push_back(std::move(value));
  }
  return values;
}

}  // namespace eyrie::team
