// SPDX-License-Identifier: MIT
#pragma once
/// \file  What a debrief says, as messages.
#include <tuple>

#include "debrief/decision.hpp"
#include "debrief/what_if.hpp"
#include "web/message.hpp"

namespace eyrie::web {

template <>
struct Message<debrief::Value> {
  using T = debrief::Value;
  static constexpr std::string_view name = "Value", help = "A value of the state or of an action.";
  static constexpr std::tuple members{
      Member{"name", &T::name, "Such as heading."}, Member{"unit", &T::unit, "SI; empty for none."},
      Member{"number", &T::number, "In that unit, if it is a number."},
      Member{"text", &T::text, "For people."}};
};
template <>
struct Message<debrief::Rival> {
  using T = debrief::Rival;
  static constexpr std::string_view name = "Rival",
                                    help = "Somebody who proposed a field that another one won.";
  static constexpr std::tuple members{
      Member{"node", &T::node, "Which node."}, Member{"value", &T::value, "What it proposed."},
      Member{"against", &T::against, "The vote of the branch with the winner."},
      Member{"vote", &T::vote, "The vote of the branch with the rival."}};
};
template <>
struct Message<debrief::Won> {
  using T = debrief::Won;
  static constexpr std::string_view name = "Won", help = "A field of the action of the root.";
  static constexpr std::tuple members{
      Member{"value", &T::value, "What came out."}, Member{"winner", &T::winner, "Which node's."},
      Member{"blended", &T::blended, "The winner made it of what its children said."},
      Member{"rivals", &T::rivals, "The highest vote first."}};
};
template <>
struct Message<debrief::Answer> {
  using T = debrief::Answer;
  static constexpr std::string_view name = "Answer", help = "What one node answered.";
  static constexpr std::tuple members{
      Member{"label", &T::label, "Its label."},
      Member{"type", &T::type, "Its type."},
      Member{"path", &T::path, "From the root, as `eyrie explain` writes it."},
      Member{"depth", &T::depth, "Below the root."},
      Member{"asked", &T::asked, "Whether it was asked."},
      Member{"status", &T::status, "0 failure, 1 running, 2 success."},
      Member{"vote", &T::vote, "Its vote."},
      Member{"why", &T::why, "Why it failed."},
      Member{"action", &T::action, "What it proposed."}};
};
template <>
struct Message<debrief::Perceived> {
  using T = debrief::Perceived;
  static constexpr std::string_view name = "Perceived",
                                    help = "Something that the agent believed to be there.";
  static constexpr std::tuple members{
      Member{"kind", &T::kind, "target, track, radar, missile or aircraft."},
      Member{"name", &T::name, "As the agent knows it; in brackets the truth."},
      Member{"values", &T::values, "Range, bearing, identity ..."}};
};
template <>
struct Message<debrief::Decision> {
  using T = debrief::Decision;
  static constexpr std::string_view name = "Decision", help = "What an agent decided, and why.";
  static constexpr std::tuple members{
      Member{"step", &T::step, "Of the world."},
      Member{"time", &T::time, "s."},
      Member{"tree", &T::tree, "Its name."},
      Member{"vote", &T::vote, "Of the root."},
      Member{"leader", &T::leader, "Whose recommendation led; 65535: nobody's."},
      Member{"nodes", &T::nodes, "Every node, in pre-order."},
      Member{"action", &T::action, "Who won each field, and against whom."},
      Member{"state", &T::state, "What it was decided on."},
      Member{"perceived", &T::perceived, "What it believed to be there."}};
};
template <>
struct Message<debrief::Changed> {
  using T = debrief::Changed;
  static constexpr std::string_view name = "Changed",
                                    help = "A field that would have been another.";
  static constexpr std::tuple members{
      Member{"name", &T::name, "Such as heading."}, Member{"unit", &T::unit, "SI."},
      Member{"flown", &T::flown, "For people; - for nothing."},
      Member{"other", &T::other, "For people; - for nothing."},
      Member{"difference", &T::difference, "Other minus flown, directions the short way round."}};
};
template <>
struct Message<debrief::Otherwise> {
  using T = debrief::Otherwise;
  static constexpr std::string_view name = "FirstOther", help = "The first other decision.";
  static constexpr std::tuple members{
      Member{"step", &T::step, "Of the world."}, Member{"time", &T::time, "s."},
      Member{"flown", &T::flown, "Who led."}, Member{"other", &T::other, "Who would have led."},
      Member{"fields", &T::fields, "What would have been another."}};
};
template <>
struct Message<debrief::WhatIf> {
  using T = debrief::WhatIf;
  static constexpr std::string_view name = "WhatIf", help = "What other trees would have decided.";
  static constexpr std::tuple members{
      Member{"decisions", &T::decisions, "Looked at."},
      Member{"different", &T::different, "Whose action would have been another one."},
      Member{"first", &T::first, "The first of them."},
      Member{"steps", &T::steps, "Of the world, by decision."},
      Member{"leaders", &T::leaders, "By decision the node that would have led; 65535: nobody."},
      Member{"spans", &T::spans, "s, from the first to the last of other decisions in a row."}};
};
template <>
struct Message<debrief::Outcome::Score> {
  using T = debrief::Outcome::Score;
  static constexpr std::string_view name = "Tally", help = "How a side fared.";
  static constexpr std::tuple members{
      Member{"losses", &T::losses, "Players lost."}, Member{"shots", &T::shots, "Missiles shot."},
      Member{"kills", &T::kills, "Enemies killed."}, Member{"home", &T::home, "Came home."}};
};
template <>
struct Message<debrief::Outcome> {
  using T = debrief::Outcome;
  static constexpr std::string_view name = "Outcome", help = "How a run ended.";
  static constexpr std::tuple members{
      Member{"outcome", &T::outcome, "Why it was over."}, Member{"time", &T::time, "s."},
      Member{"blue", &T::blue, "Of blue."}, Member{"red", &T::red, "Of red."}};
};

}  // namespace eyrie::web
