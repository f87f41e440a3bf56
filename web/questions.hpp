// SPDX-License-Identifier: MIT
#pragma once
/// \file  Everything that the module can be asked.
#include "web/engine.hpp"

namespace eyrie::web {

/// Bytes besides the JSON: those of a file that comes with the question, or of the answer.
enum class Bytes { none, asked, answered };

/// How one question is called, and who answers it.
template <class RequestType, class AnswerType, Bytes with, auto answers>
struct Question {
  using Request = RequestType;
  using Answer = AnswerType;
  static constexpr Bytes kBytes = with;
  static constexpr auto kAnswers = answers;
  std::string_view name, help;
};

inline constexpr std::tuple kQuestions{
    Question<Nothing, Nothing, Bytes::asked, &Engine::take_zones>{
        "take_zones", "Launch zones of the shipped missiles, which then need not be flown."},
    Question<Nothing, NodeTypes, Bytes::none, &Engine::node_types>{"node_types",
                                                                   "What trees may be made of."},
    Question<Texts, Problems, Bytes::none, &Engine::validate>{
        "validate", "Every mistake in a scenario and its files."},
    Question<Load, About, Bytes::none, &Engine::load>{
        "load", "Reads a scenario; fly() begins at its start."},
    Question<Until, Flown, Bytes::none, &Engine::fly>{
        "fly", "On with what was loaded; when it is over it has become a run."},
    Question<Nothing, Flown, Bytes::none, &Engine::end_flight>{
        "end_flight", "Ends what was loaded where it is, as a run that was stopped."},
    Question<Nothing, Nothing, Bytes::answered, &Engine::run_file>{
        "run_file", "The run file of what was flown to its end, or so far."},
    Question<Nothing, About, Bytes::asked, &Engine::open>{"open", "Opens a run file."},
    Question<Until, Moment, Bytes::answered, &Engine::page>{
        "page",
        "The run once more from the start on, every hash compared with the recorded ones; the "
        "bytes are what src/run/decode.ts reads."},
    Question<Nothing, Followed, Bytes::asked, &Engine::follow>{
        "follow", "Opens a run that others are flying, with what was flown so far; at its start."},
    Question<Advance, Advanced, Bytes::answered, &Engine::advance>{
        "advance",
        "On with what is followed; the bytes are what came since the last ones "
        "(src/live/grown.ts), none if it is not to be drawn. seek() and the others know what was "
        "flown so far."},
    Question<Step, Moment, Bytes::none, &Engine::seek>{"seek", "Goes to a step of the run."},
    Question<Decider, Decided, Bytes::none, &Engine::explain>{
        "explain", "What a player decided in the step that follows."},
    Question<Otherwise, debrief::WhatIf, Bytes::none, &Engine::what_if>{
        "what_if",
        "What it would have decided during the whole run, its states being what they were."},
    Question<Nothing, debrief::Outcome, Bytes::none, &Engine::outcome>{"outcome",
                                                                       "How the run ended."},
    Question<Otherwise, debrief::Outcome, Bytes::answered, &Engine::branch>{
        "branch",
        "How it would have ended, flown on from the moment of seek() with other trees and models; "
        "the bytes are as of page()."},
};

}  // namespace eyrie::web
