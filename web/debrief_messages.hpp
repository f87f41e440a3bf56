// SPDX-License-Identifier: MIT
#pragma once
/// \file  What a debrief says, as messages.
#include <tuple>

#include "debrief/decision.hpp"
#include "debrief/what_if.hpp"
#include "web/message.hpp"

namespace eyrie::web {

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
