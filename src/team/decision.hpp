// SPDX-License-Identifier: MIT
#pragma once
/// \file  One decision of one agent, with every node's answer, in words and numbers: the same for
/// every platform.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/id.hpp"
#include "ubf/behavior.hpp"

namespace eyrie::team {

/// A value of the state or of an action.
struct Value {
  std::string name;              ///< "heading"
  std::string unit;              ///< SI, "" for none
  std::optional<double> number;  ///< in that unit; none: not a number, or no value
  std::string text;              ///< for people: "045 deg", "follow", "-"
};

/// What one node answered.
struct Answer {
  std::string label, type, path;  ///< path: "root/bvr/pursue"
  std::uint16_t depth = 0, parent = ubf::kNone;
  bool asked = false;
  bool is_leaf = true;
  ubf::Status status = ubf::Status::failure;
  float vote = 0;
  std::uint16_t halts = 0;    ///< how often it was made to forget
  std::string why;            ///< it failed, or what its vote followed: "range 0.53"; may be ""
  std::vector<Value> action;  ///< the fields that it set
};

/// Somebody who proposed a field that another one won.
struct Rival {
  ubf::NodeIndex node = ubf::kNone;
  Value value;
  /// The votes that stood against each other where both were compared: of the branch with the
  /// winner, and of the branch with the rival.
  float against = 0, vote = 0;
};

/// A field of the action that came out of the root.
struct Won {
  Value value;
  ubf::NodeIndex winner = ubf::kNone;
  bool blended = false;       ///< the winner is an arbiter that made it of what its children said
  std::vector<Rival> rivals;  ///< by vote, the highest first; what a blend is made of, too
};

/// Something that the agent believed to be there.
struct Perceived {
  std::string kind;           ///< "target", "track", "radar", "missile", "aircraft"
  std::uint32_t number = 0;   ///< as the agent knows it
  PlayerId truth{};           ///< who it really was, for the debrief
  std::vector<Value> values;  ///< range, bearing, identity ...
  std::string name = {};      ///< "#3 (bogey1)": number and truth, filled in by who knows the names
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
  std::vector<Value> state;
  std::vector<Perceived> perceived;
};

/// A field that would have been another one.
struct Changed {
  std::string name, unit;
  std::string flown, other;          ///< for people; "-" for nothing
  std::optional<double> difference;  ///< other minus flown in SI, directions the short way round
};

}  // namespace eyrie::team
