// SPDX-License-Identifier: MIT
#include "web/engine.hpp"

namespace eyrie::web {
namespace {

/// How one question is answered and declared.
struct Question {
  std::string_view name, help;
  Json (*answer)(Engine& engine, const Json& request, std::string& bytes);
  std::string (*declare)(std::map<std::string, std::string>& declared);
};

template <class Request>
Request read(const Json& json) {
  Request request;
  from_json(json, request, "");
  return request;
}

template <class Request, class Answer>
std::string declared(std::map<std::string, std::string>& all, std::string_view with = "",
                     std::string_view besides = "") {
  std::string parameter;
  if constexpr (!std::same_as<Request, Nothing>)
    parameter = "request: " + typescript<Request>(all);
  if (!with.empty())
    parameter += parameter.empty() ? std::string(with) : fmt::format(", {}", with);
  return fmt::format("({}): Promise<{}{}>", parameter, typescript<Answer>(all), besides);
}

/// A question whose request and answer are JSON alone.
template <class Request, class Answer, auto kAsk>
constexpr Question question(std::string_view name, std::string_view help) {
  return {name, help,
          [](Engine& engine, const Json& json, std::string& bytes) {
            bytes.clear();
            const Answer answer = std::invoke(kAsk, engine, read<Request>(json));
            return to_json(answer);
          },
          [](std::map<std::string, std::string>& all) { return declared<Request, Answer>(all); }};
}

/// A question whose answer comes with bytes.
template <class Request, class Answer, auto kAsk>
constexpr Question bytes_question(std::string_view name, std::string_view help) {
  return {name, help,
          [](Engine& engine, const Json& json, std::string& bytes) {
            return to_json(Answer(std::invoke(kAsk, engine, read<Request>(json), bytes)));
          },
          [](std::map<std::string, std::string>& all) {
            return declared<Request, Answer>(all, "", " & { bytes: Uint8Array }");
          }};
}

/// A question that comes with the bytes of a file.
template <class Answer, auto kAsk>
constexpr Question file_question(std::string_view name, std::string_view help) {
  return {name, help,
          [](Engine& engine, const Json& json, std::string& bytes) {
            static_cast<void>(read<Nothing>(json));
            const Answer answer = std::invoke(kAsk, engine, std::string_view(bytes));
            bytes.clear();
            return to_json(answer);
          },
          [](std::map<std::string, std::string>& all) {
            return declared<Nothing, Answer>(all, "file: Uint8Array");
          }};
}

Nothing run_file(Engine& engine, const Nothing&, std::string& bytes) {
  bytes = engine.run_file();
  return {};
}
debrief::Outcome outcome(Engine& engine, const Nothing&) {
  return engine.outcome();
}
Nothing take_zones(Engine&, std::string_view file) {
  Engine::take_zones(file);
  return {};
}
NodeTypes node_types(Engine&, const Nothing&) {
  return Engine::node_types();
}
Problems validate(Engine&, const Texts& texts) {
  return Engine::validate(texts);
}

const std::array kQuestions{
    file_question<Nothing, take_zones>(
        "take_zones", "Launch zones of the shipped missiles, which then need not be flown."),
    question<Nothing, NodeTypes, node_types>("node_types", "What trees may be made of."),
    question<Texts, Problems, validate>("validate", "Every mistake in a scenario and its files."),
    question<Load, About, &Engine::load>("load", "Reads a scenario; fly() begins at its start."),
    question<Until, Flown, &Engine::fly>(
        "fly", "On with what was loaded; when it is over it has become a run."),
    bytes_question<Nothing, Nothing, run_file>("run_file",
                                               "The run file of what was flown to its end."),
    file_question<About, &Engine::open>("open", "Opens a run file."),
    bytes_question<Until, Moment, &Engine::page>("page",
                                                 "The run once more from the start on, every hash "
                                                 "compared with the recorded ones; the bytes are "
                                                 "what src/run/decode.ts reads."),
    file_question<Followed, &Engine::follow>(
        "follow", "Opens a run that others are flying, with what was flown so far; at its start."),
    bytes_question<Advance, Advanced, &Engine::advance>(
        "advance",
        "On with what is followed; the bytes are what came since the last ones "
        "(src/live/grown.ts), none if it is not to be drawn. seek() and the others know what was "
        "flown so far."),
    question<Step, Moment, &Engine::seek>("seek", "Goes to a step of the run."),
    question<Decider, Decided, &Engine::explain>("explain",
                                                 "What a player decided in the step that follows."),
    question<Otherwise, debrief::WhatIf, &Engine::what_if>(
        "what_if",
        "What it would have decided during the whole run, its states being what they were."),
    question<Nothing, debrief::Outcome, outcome>("outcome", "How the run ended."),
    bytes_question<Branch, debrief::Outcome, &Engine::branch>(
        "branch",
        "How it would have ended, flown on from there with other trees and models; the bytes are "
        "as of "
        "page()."),
};

Json error_json(const std::string& message) {
  return {{"error", message}};
}

Json ask(Engine& engine, std::string_view text, std::string& bytes) {
  Json request = Json::parse(text, nullptr, false);
  const auto name = request.is_object() ? request.find("ask") : request.end();
  if (!request.is_object() || name == request.end() || !name->is_string())
    throw BadRequest("expected {\"ask\": QUESTION, ...}");
  const std::string wanted = name->get<std::string>();
  request.erase("ask");
  std::vector<std::string> names;
  for (const Question& question : kQuestions) {
    if (question.name == wanted)
      return question.answer(engine, request, bytes);
    names.emplace_back(question.name);
  }
  throw BadRequest("there is no question " + quote(wanted) + did_you_mean(wanted, names));
}

}  // namespace

std::string answer(Engine& engine, std::string_view request, std::string& bytes) {
  Json result;
  try {
    result = ask(engine, request, bytes);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const ConfigError& e) {
    result = error_json(e.what());
    Problems problems;
    for (const Diagnostic& one : e.diagnostics().sorted())
      problems.problems.push_back(
          {std::string(one.where.file.text()), one.where.line, one.where.column, one.message});
    result.update(to_json(problems));
  } catch (const std::exception& e) {
    result = error_json(e.what());
  }
  return result.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string declarations() {
  std::map<std::string, std::string> declared;
  std::string questions;
  for (const Question& question : kQuestions)
    questions += fmt::format("  /** {} */\n  {}{};\n", question.help, question.name,
                             question.declare(declared));
  std::string text =
      "// SPDX-License-Identifier: MIT\n"
      "// Made from web/messages.hpp and web/questions.cpp: a test writes what has changed.\n\n";
  for (const auto& [name, declaration] : declared)
    text += declaration + "\n";
  return text +
         "/** Numbers are SI, times s of simulated time. A question that cannot be answered is "
         "rejected with an EngineError. */\nexport interface Engine {\n" +
         questions + "}\n";
}

}  // namespace eyrie::web
