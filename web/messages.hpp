// SPDX-License-Identifier: MIT
#pragma once
/// \file  The questions that the engine answers in a page, and its answers. questions.hpp says what
/// each does; numbers are SI, times are s of simulated time.
#include "debrief/decision.hpp"
#include "debrief/what_if.hpp"
#include "web/message.hpp"

namespace eyrie::web {

// what a debrief says

template <>
inline constexpr auto described<debrief::Changed> =
    Description{"Changed", "A field that would have been another.",
                Member{"name", &debrief::Changed::name, "Such as heading."},
                Member{"flown", &debrief::Changed::flown, "For people; - for nothing."},
                Member{"other", &debrief::Changed::other, "For people; - for nothing."}};
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
           "s, from the first to the last of other decisions in a row."},
    Member{"until", &debrief::WhatIf::until, "s, when the player was last there."},
    Member{"fault", &debrief::WhatIf::fault,
           "Why nothing was asked from there on; empty: it was asked to the end."}};
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

// what is asked and answered

struct Texts {
  std::map<std::string, std::string> files;
  std::string scenario;
  std::optional<std::vector<std::string>> sets;
  static constexpr Description kMessage{
      "Texts", "A scenario and what it includes.",
      Member{"files", &Texts::files, "Texts by name: data/KIND/NAME.yaml, packages, scenarios."},
      Member{"scenario", &Texts::scenario, "Which of them is flown."},
      Member{"sets", &Texts::sets, "Overrides as `--set` takes them: PATH=VALUE."}};
};
struct Load {
  Texts texts;
  std::optional<std::string> seed;
  static constexpr Description kMessage{
      "Load", "A scenario to be flown.", Member{"texts", &Load::texts, "What it is made of."},
      Member{"seed", &Load::seed, "In digits; the scenario's own without it."}};
};
struct Until {
  std::optional<double> until;
  static constexpr Description kMessage{
      "Until", "How far.",
      Member{"until", &Until::until, "s of simulated time; to the end without it."}};
};
struct Step {
  std::uint64_t step = 0;
  static constexpr Description kMessage{
      "Step", "A moment of a run.",
      Member{"step", &Step::step, "Steps made before it: 0 is the start."}};
};
struct Decider {
  std::string player;
  static constexpr Description kMessage{"Decider", "Who decided.",
                                        Member{"player", &Decider::player, "Whose name."}};
};
struct Otherwise {
  std::string player;
  std::vector<std::string> sets;
  static constexpr Description kMessage{
      "Otherwise", "Other trees.",
      Member{"player", &Otherwise::player,
             "Whose, where a path names none; whose states are meant."},
      Member{"sets", &Otherwise::sets, "What is other, as `eyrie whatif --set` takes it."}};
};
struct Nothing {
  static constexpr Description kMessage{"Nothing", "No parameters."};
};

struct Player {
  std::string name, side;
  static constexpr Description kMessage{"Player", "Somebody in the scenario.",
                                        Member{"name", &Player::name, "As the scenario says."},
                                        Member{"side", &Player::side, "blue or red."}};
};
struct About {
  std::string scenario, seed;
  double until = 0, latitude = 0, longitude = 0;
  std::vector<Player> players;
  static constexpr Description kMessage{
      "About",
      "What was loaded.",
      Member{"scenario", &About::scenario, "Its name."},
      Member{"seed", &About::seed, "In digits."},
      Member{"until", &About::until, "s, when it ends, at the latest if it was not flown yet."},
      Member{"latitude", &About::latitude, "deg, of the middle of the map."},
      Member{"longitude", &About::longitude, "deg, of the same."},
      Member{"players", &About::players, "In the order of their ids, which count from 1."}};
};
struct Line {
  double time = 0;
  std::string who, text;
  static constexpr Description kMessage{
      "Line", "A line of the story.", Member{"time", &Line::time, "s."},
      Member{"who", &Line::who, "Who does it."}, Member{"text", &Line::text, "What happens."}};
};
struct Flown {
  double time = 0;
  std::string hash;
  std::optional<debrief::Outcome> result;
  std::string fault;
  std::vector<Line> story;
  static constexpr Description kMessage{
      "Flown",
      "How far a flight is.",
      Member{"time", &Flown::time, "s."},
      Member{"hash", &Flown::hash, "Of the world, as the terminal prints it."},
      Member{"result", &Flown::result, "How it ended, once it is over."},
      Member{"fault", &Flown::fault, "Why, if a fault has ended it."},
      Member{"story", &Flown::story, "What happened since the last answer."}};
};
struct Moment {
  std::uint64_t step = 0;
  double time = 0;
  std::string hash;
  static constexpr Description kMessage{
      "Moment", "Where the run is looked at.",
      Member{"step", &Moment::step, "Steps made before it."}, Member{"time", &Moment::time, "s."},
      Member{"hash", &Moment::hash, "Of the world, as the terminal prints it."}};
};
struct Followed {
  About about;
  Moment flown;
  static constexpr Description kMessage{
      "Followed", "A run that others are flying.", Member{"about", &Followed::about, "What it is."},
      Member{"flown", &Followed::flown, "How far they were; advance() comes there."}};
};
struct Advance {
  std::uint64_t step = 0;
  std::vector<std::string> orders;
  std::string hash, outcome;
  bool draw = false;
  static constexpr Description kMessage{
      "Advance",
      "How far what is followed may go on.",
      Member{"step", &Advance::step, "Steps made by then."},
      Member{"orders", &Advance::orders, "From outside, by step: base64 of 48 bytes each."},
      Member{"hash", &Advance::hash, "Of the world there, as others have it; empty: unknown."},
      Member{"outcome", &Advance::outcome, "Of the run, as others have it."},
      Member{"draw", &Advance::draw, "Whether it is drawn."}};
};
struct Advanced {
  Moment moment;
  bool agrees = true;
  static constexpr Description kMessage{
      "Advanced", "How far it is.", Member{"moment", &Advanced::moment, "Where."},
      Member{"agrees", &Advanced::agrees, "Whether the world is the one that others have."}};
};
struct Decided {
  std::optional<Json> decision;

  static constexpr Description kMessage{
      "Decided", "A decision, if one was due.",
      Member{"decision", &Decided::decision, "As `eyrie explain --json` prints it."}};
};

struct Problem {
  std::string file;
  int line = 0, column = 0;
  std::string message;
  static constexpr Description kMessage{
      "Problem",
      "A mistake in a text.",
      Member{"file", &Problem::file, "Whose."},
      Member{"line", &Problem::line, "From 1; 0: unknown."},
      Member{"column", &Problem::column, "From 1; 0: unknown."},
      Member{"message", &Problem::message, "What is wrong, and the nearest right name."}};
};
struct Problems {
  std::vector<Problem> problems;
  static constexpr Description kMessage{
      "Problems", "Every mistake that was found.",
      Member{"problems", &Problems::problems,
             "In the order of the texts; empty: it can be flown."}};
};
struct Parameter {
  std::string name, kind, unit, help, standard;
  std::optional<double> min, max;
  std::vector<std::string> choices;
  static constexpr Description kMessage{
      "Parameter",
      "Of a type of node.",
      Member{"name", &Parameter::name, "As files write it."},
      Member{"kind", &Parameter::kind, "number, flag, choice or other."},
      Member{"unit", &Parameter::unit, "A unit of its dimension; empty for none."},
      Member{"help", &Parameter::help, "What it means."},
      Member{"standard", &Parameter::standard,
             "What it is if nobody says; empty if it must be said."},
      Member{"min", &Parameter::min, "The least number, in SI, if there is one."},
      Member{"max", &Parameter::max, "The greatest number, in SI, if there is one."},
      Member{"choices", &Parameter::choices, "If it is one of several words."}};
};
struct NodeType {
  std::string name, kind, help;
  bool takes_children = false;
  std::vector<Parameter> parameters;
  static constexpr Description kMessage{
      "NodeType",
      "What a tree may be made of.",
      Member{"name", &NodeType::name, "As files write it."},
      Member{"kind", &NodeType::kind, "behavior, condition, arbiter, control or decorator."},
      Member{"help", &NodeType::help, "What it does."},
      Member{"takes_children", &NodeType::takes_children,
             "Whether it may have any number of children."},
      Member{"parameters", &NodeType::parameters, "Besides its children."}};
};
struct NodeTypes {
  std::vector<NodeType> aircraft, vehicle;
  static constexpr Description kMessage{
      "NodeTypes", "Every type of node.",
      Member{"aircraft", &NodeTypes::aircraft, "Of trees of pilots."},
      Member{"vehicle", &NodeTypes::vehicle, "Of trees of drivers."}};
};

}  // namespace eyrie::web
