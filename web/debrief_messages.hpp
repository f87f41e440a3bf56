// SPDX-License-Identifier: MIT
#pragma once
/// \file  What a debrief says, as messages.
#include <tuple>

#include "debrief/decision.hpp"
#include "debrief/what_if.hpp"
#include "web/message.hpp"

namespace eyrie::web {

template <>
inline constexpr auto described<debrief::Value> =
    Description{"Value",
                "A value of the state or of an action.",
                Member{"name", &debrief::Value::name, "Such as heading."},
                Member{"unit", &debrief::Value::unit, "SI; empty for none."},
                Member{"number", &debrief::Value::number, "In that unit, if it is a number."},
                Member{"text", &debrief::Value::text, "For people."}};
template <>
inline constexpr auto described<debrief::Rival> = Description{
    "Rival",
    "Somebody who proposed a field that another one won.",
    Member{"node", &debrief::Rival::node, "Which node."},
    Member{"value", &debrief::Rival::value, "What it proposed."},
    Member{"against", &debrief::Rival::against, "The vote of the branch with the winner."},
    Member{"vote", &debrief::Rival::vote, "The vote of the branch with the rival."}};
template <>
inline constexpr auto described<debrief::Won> = Description{
    "Won",
    "A field of the action of the root.",
    Member{"value", &debrief::Won::value, "What came out."},
    Member{"winner", &debrief::Won::winner, "Which node's."},
    Member{"blended", &debrief::Won::blended, "The winner made it of what its children said."},
    Member{"rivals", &debrief::Won::rivals, "The highest vote first."}};
template <>
inline constexpr auto described<debrief::Answer> = Description{
    "Answer",
    "What one node answered.",
    Member{"label", &debrief::Answer::label, "Its label."},
    Member{"type", &debrief::Answer::type, "Its type."},
    Member{"path", &debrief::Answer::path, "From the root, as `eyrie explain` writes it."},
    Member{"depth", &debrief::Answer::depth, "Below the root."},
    Member{"asked", &debrief::Answer::asked, "Whether it was asked."},
    Member{"status", &debrief::Answer::status, "0 failure, 1 running, 2 success."},
    Member{"vote", &debrief::Answer::vote, "Its vote."},
    Member{"why", &debrief::Answer::why, "Why it failed."},
    Member{"action", &debrief::Answer::action, "What it proposed."}};
template <>
inline constexpr auto described<debrief::Perceived> = Description{
    "Perceived", "Something that the agent believed to be there.",
    Member{"kind", &debrief::Perceived::kind, "target, track, radar, missile or aircraft."},
    Member{"name", &debrief::Perceived::name, "As the agent knows it; in brackets the truth."},
    Member{"values", &debrief::Perceived::values, "Range, bearing, identity ..."}};
template <>
inline constexpr auto described<debrief::Decision> = Description{
    "Decision",
    "What an agent decided, and why.",
    Member{"step", &debrief::Decision::step, "Of the world."},
    Member{"time", &debrief::Decision::time, "s."},
    Member{"tree", &debrief::Decision::tree, "Its name."},
    Member{"vote", &debrief::Decision::vote, "Of the root."},
    Member{"leader", &debrief::Decision::leader, "Whose recommendation led; 65535: nobody's."},
    Member{"nodes", &debrief::Decision::nodes, "Every node, in pre-order."},
    Member{"action", &debrief::Decision::action, "Who won each field, and against whom."},
    Member{"state", &debrief::Decision::state, "What it was decided on."},
    Member{"perceived", &debrief::Decision::perceived, "What it believed to be there."}};
template <>
inline constexpr auto described<debrief::Changed> =
    Description{"Changed",
                "A field that would have been another.",
                Member{"name", &debrief::Changed::name, "Such as heading."},
                Member{"unit", &debrief::Changed::unit, "SI."},
                Member{"flown", &debrief::Changed::flown, "For people; - for nothing."},
                Member{"other", &debrief::Changed::other, "For people; - for nothing."},
                Member{"difference", &debrief::Changed::difference,
                       "Other minus flown, directions the short way round."}};
template <>
inline constexpr auto described<debrief::Otherwise> =
    Description{"FirstOther",
                "The first other decision.",
                Member{"step", &debrief::Otherwise::step, "Of the world."},
                Member{"time", &debrief::Otherwise::time, "s."},
                Member{"flown", &debrief::Otherwise::flown, "Who led."},
                Member{"other", &debrief::Otherwise::other, "Who would have led."},
                Member{"fields", &debrief::Otherwise::fields, "What would have been another."}};
template <>
inline constexpr auto described<debrief::WhatIf> = Description{
    "WhatIf",
    "What other trees would have decided.",
    Member{"decisions", &debrief::WhatIf::decisions, "Looked at."},
    Member{"different", &debrief::WhatIf::different, "Whose action would have been another one."},
    Member{"first", &debrief::WhatIf::first, "The first of them."},
    Member{"steps", &debrief::WhatIf::steps, "Of the world, by decision."},
    Member{"leaders", &debrief::WhatIf::leaders,
           "By decision the node that would have led; 65535: nobody."},
    Member{"spans", &debrief::WhatIf::spans,
           "s, from the first to the last of other decisions in a row."}};
template <>
inline constexpr auto described<record::Tally::OfSide> =
    Description{"Tally",
                "How a side fared.",
                Member{"losses", &record::Tally::OfSide::losses, "Players lost."},
                Member{"shots", &record::Tally::OfSide::shots, "Missiles shot."},
                Member{"kills", &record::Tally::OfSide::kills, "Enemies killed."},
                Member{"home", &record::Tally::OfSide::home, "Came home."}};
template <>
inline constexpr auto described<debrief::Outcome> =
    Description{"Outcome",
                "How a run ended.",
                Member{"outcome", &debrief::Outcome::outcome, "Why it was over."},
                Member{"time", &debrief::Outcome::time, "s."},
                Member{"blue", &debrief::Outcome::blue, "Of blue."},
                Member{"red", &debrief::Outcome::red, "Of red."}};

}  // namespace eyrie::web
