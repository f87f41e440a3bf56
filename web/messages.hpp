// SPDX-License-Identifier: MIT
#pragma once
/// \file  The questions that the engine answers in a page, and its answers. engine.hpp says what
/// each does; numbers are SI, times are s of simulated time.
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "web/debrief_messages.hpp"

namespace eyrie::web {

struct Texts {
  std::map<std::string, std::string> files;
  std::string scenario;
  std::optional<std::vector<std::string>> sets;
};
struct Load {
  Texts texts;
  std::optional<std::string> seed;
  std::optional<double> until;
};
struct Until {
  std::optional<double> until;
};
struct Step {
  std::uint64_t step = 0;
};
struct Table {
  std::string table;
};
struct Who {
  std::string player;
};
struct Otherwise {
  std::string player;
  std::vector<std::string> sets;
  std::optional<double> from;
};
struct Branch {
  std::vector<std::string> sets;
  std::string player;
  std::optional<double> until;
};
struct Nothing {};

struct Player {
  std::string name, side, type;
};
struct About {
  std::string scenario, help, seed, build;
  double dt = 0, until = 0;
  std::vector<Player> players;
  std::vector<std::string> tables;
};
struct Line {
  double time = 0;
  std::string who, text;
};
struct Flown {
  std::uint64_t step = 0;
  double time = 0;
  std::string hash, outcome;
  std::optional<debrief::Outcome> result;
  std::vector<Line> story;
};
struct Moment {
  std::uint64_t step = 0;
  double time = 0;
  std::string hash;
};
struct Column {
  std::string name, unit;
  std::vector<double> values;
};
struct Rows {
  std::vector<std::uint64_t> ids;
  std::vector<Column> columns;
};
struct Decided {
  std::optional<debrief::Decision> decision;
};
struct Problem {
  std::string file;
  int line = 0, column = 0;
  std::string message;
};
struct Problems {
  std::vector<Problem> problems;
};
struct Parameter {
  std::string name, kind, unit, help, standard;
  std::optional<double> min, max;
  std::vector<std::string> choices;
};
struct NodeType {
  std::string name, kind, help;
  bool takes_children = false;
  std::vector<Parameter> parameters;
};
struct NodeTypes {
  std::vector<NodeType> aircraft, vehicle;
};

template <>
struct Message<Nothing> {
  static constexpr std::string_view name = "Nothing", help = "No parameters.";
  static constexpr std::tuple<> members{};
};
template <>
struct Message<Texts> {
  static constexpr std::string_view name = "Texts", help = "A scenario and what it includes.";
  static constexpr std::tuple members{
      Member{"files", &Texts::files, "Texts by name: data/KIND/NAME.yaml, packages, scenarios."},
      Member{"scenario", &Texts::scenario, "Which of them is flown."},
      Member{"sets", &Texts::sets, "Overrides as `--set` takes them: PATH=VALUE."}};
};
template <>
struct Message<Load> {
  static constexpr std::string_view name = "Load", help = "A scenario to be flown.";
  static constexpr std::tuple members{
      Member{"texts", &Load::texts, "What it is made of."},
      Member{"seed", &Load::seed, "In digits; the scenario's own without it."},
      Member{"until", &Load::until, "s, when it ends at the latest, instead of the scenario's."}};
};
template <>
struct Message<Until> {
  static constexpr std::string_view name = "Until", help = "How far.";
  static constexpr std::tuple members{
      Member{"until", &Until::until, "s of simulated time; to the end without it."}};
};
template <>
struct Message<Step> {
  static constexpr std::string_view name = "Step", help = "A moment of a run.";
  static constexpr std::tuple members{
      Member{"step", &Step::step, "Steps made before it: 0 is the start."}};
};
template <>
struct Message<Table> {
  static constexpr std::string_view name = "Table", help = "A table of the world.";
  static constexpr std::tuple members{
      Member{"table", &Table::table, "Its name, such as aircraft or missiles."}};
};
template <>
struct Message<Who> {
  static constexpr std::string_view name = "Who", help = "A player.";
  static constexpr std::tuple members{Member{"player", &Who::player, "Its name."}};
};
template <>
struct Message<Otherwise> {
  static constexpr std::string_view name = "Otherwise", help = "Other trees for a player's states.";
  static constexpr std::tuple members{
      Member{"player", &Otherwise::player, "Whose."},
      Member{"sets", &Otherwise::sets, "What is other, as `eyrie whatif --set` takes it."},
      Member{"from", &Otherwise::from, "s, from when on; from the start without it."}};
};
template <>
struct Message<Branch> {
  static constexpr std::string_view name = "Branch",
                                    help = "Another future, from the moment of seek() on.";
  static constexpr std::tuple members{
      Member{"sets", &Branch::sets,
             "What is other from there on, as `eyrie whatif --set` takes it."},
      Member{"player", &Branch::player, "Whose tree is meant where a path names none."},
      Member{"until", &Branch::until, "s, when it ends at the latest, instead of the scenario's."}};
};
template <>
struct Message<Player> {
  static constexpr std::string_view name = "Player", help = "Somebody in the scenario.";
  static constexpr std::tuple members{Member{"name", &Player::name, "As the scenario says."},
                                      Member{"side", &Player::side, "blue or red."},
                                      Member{"type", &Player::type, "Of aircraft or vehicle."}};
};
template <>
struct Message<About> {
  static constexpr std::string_view name = "About", help = "What was loaded.";
  static constexpr std::tuple members{
      Member{"scenario", &About::scenario, "Its name."},
      Member{"help", &About::help, "What it says of itself."},
      Member{"seed", &About::seed, "In digits."},
      Member{"build", &About::build, "Who recorded it; empty before it was flown."},
      Member{"dt", &About::dt, "s per step."},
      Member{"until", &About::until, "s, when it ends, at the latest if it was not flown yet."},
      Member{"players", &About::players, "In the order of their ids, which count from 1."},
      Member{"tables", &About::tables, "What rows() can be asked for."}};
};
template <>
struct Message<Line> {
  static constexpr std::string_view name = "Line", help = "A line of the story.";
  static constexpr std::tuple members{Member{"time", &Line::time, "s."},
                                      Member{"who", &Line::who, "Who does it."},
                                      Member{"text", &Line::text, "What happens."}};
};
template <>
struct Message<Flown> {
  static constexpr std::string_view name = "Flown", help = "How far a flight is.";
  static constexpr std::tuple members{
      Member{"step", &Flown::step, "Steps made."},
      Member{"time", &Flown::time, "s."},
      Member{"hash", &Flown::hash, "Of the world, as the terminal prints it."},
      Member{"outcome", &Flown::outcome, "running, or why it is over."},
      Member{"result", &Flown::result, "How it ended, once it is over."},
      Member{"story", &Flown::story, "What happened since the last answer."}};
};
template <>
struct Message<Moment> {
  static constexpr std::string_view name = "Moment", help = "Where the run is looked at.";
  static constexpr std::tuple members{
      Member{"step", &Moment::step, "Steps made before it."}, Member{"time", &Moment::time, "s."},
      Member{"hash", &Moment::hash, "Of the world, as the terminal prints it."}};
};
template <>
struct Message<Column> {
  static constexpr std::string_view name = "Column", help = "One number of every row.";
  static constexpr std::tuple members{
      Member{"name", &Column::name, "COLUMN.FIELD, with [i] if the field has several numbers."},
      Member{"unit", &Column::unit, "SI; empty for none."},
      Member{"values", &Column::values, "By row."}};
};
template <>
struct Message<Rows> {
  static constexpr std::string_view name = "Rows", help = "A table of the world, at a moment.";
  static constexpr std::tuple members{Member{"ids", &Rows::ids, "Of the players, row by row."},
                                      Member{"columns", &Rows::columns, "Whatever they keep."}};
};
template <>
struct Message<Problem> {
  static constexpr std::string_view name = "Problem", help = "A mistake in a text.";
  static constexpr std::tuple members{
      Member{"file", &Problem::file, "Whose."},
      Member{"line", &Problem::line, "From 1; 0: unknown."},
      Member{"column", &Problem::column, "From 1; 0: unknown."},
      Member{"message", &Problem::message, "What is wrong, and the nearest right name."}};
};
template <>
struct Message<Problems> {
  static constexpr std::string_view name = "Problems", help = "Every mistake that was found.";
  static constexpr std::tuple members{Member{"problems", &Problems::problems,
                                             "In the order of the texts; empty: it can be flown."}};
};
template <>
struct Message<Parameter> {
  static constexpr std::string_view name = "Parameter", help = "Of a type of node.";
  static constexpr std::tuple members{
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
template <>
struct Message<NodeType> {
  static constexpr std::string_view name = "NodeType", help = "What a tree may be made of.";
  static constexpr std::tuple members{
      Member{"name", &NodeType::name, "As files write it."},
      Member{"kind", &NodeType::kind, "behavior, condition, arbiter, control or decorator."},
      Member{"help", &NodeType::help, "What it does."},
      Member{"takes_children", &NodeType::takes_children,
             "Whether it may have any number of children."},
      Member{"parameters", &NodeType::parameters, "Besides its children."}};
};
template <>
struct Message<NodeTypes> {
  static constexpr std::string_view name = "NodeTypes", help = "Every type of node.";
  static constexpr std::tuple members{
      Member{"aircraft", &NodeTypes::aircraft, "Of trees of pilots."},
      Member{"vehicle", &NodeTypes::vehicle, "Of trees of drivers."}};
};
template <>
struct Message<Decided> {
  static constexpr std::string_view name = "Decided", help = "A decision, if one was due.";
  static constexpr std::tuple members{Member{"decision", &Decided::decision, "The decision."}};
};
}  // namespace eyrie::web
