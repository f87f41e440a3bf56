// SPDX-License-Identifier: MIT
#include "web/questions.hpp"

namespace eyrie::web {
namespace {

template <class Asked>
Json answer_to(Engine& engine, const Json& json, std::string& bytes) {
  typename Asked::Request request;
  from_json(json, request, "");
  const std::string file = std::exchange(bytes, {});
  const auto answer = [&]() -> typename Asked::Answer {
    if constexpr (Asked::kBytes == Bytes::asked)
      return std::invoke(Asked::kAnswers, engine, file);
    else if constexpr (Asked::kBytes == Bytes::answered)
      return std::invoke(Asked::kAnswers, engine, request, bytes);
    else
      return std::invoke(Asked::kAnswers, engine, request);
  };
  return to_json(answer());
}

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
  std::vector<std::string_view> names;
  std::optional<Json> answered;
  const auto try_one = [&]<class Asked>(const Asked& question) {
    names.push_back(question.name);
    if (question.name == wanted)
      answered = answer_to<Asked>(engine, request, bytes);
  };
  std::apply([&](const auto&... question) { (try_one(question), ...); }, kQuestions);
  if (answered)
    return *answered;
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
    result.update(to_json(problems_of(e)));
  } catch (const std::exception& e) {
    result = error_json(e.what());
  }
  return result.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace eyrie::web
