// SPDX-License-Identifier: MIT
#include "live/request.hpp"

#include <nlohmann/json.hpp>

namespace eyrie::live {
namespace {

using Json = nlohmann::json;

constexpr const char* kSteps = "steps: a whole number from 1 to 5000";
constexpr const char* kRate = "rate: a number from 0.1 to 100, or \"max\"";

/// What is wrong with the members of a request; "" if nothing is.
std::string read(const Json& json, Request& request) {
  std::size_t members = 1;
  if (request.what == Request::What::step && json.contains("steps")) {
    const Json& steps = json["steps"];
    if (!steps.is_number_unsigned() || steps < 1u || steps > kMostSteps)
      return kSteps;
    request.steps = steps;
    ++members;
  }
  if (request.what == Request::What::rate) {
    const Json rate = json.value("rate", Json());
    const bool fits = rate.is_number() && rate >= kSlowest && rate <= kFastest;
    if (!fits && rate != "max")
      return kRate;
    request.rate = fits ? rate.get<double>() : 0;
    ++members;
  }
  return request.what == Request::What::order || json.size() == members ? ""
                                                                        : "more than is asked for";
}

}  // namespace

Said request_of(const scenario::Scenario& scenario, net::ViewerId who, std::string_view text) {
  static const std::map<std::string, Request::What, std::less<>> kWords{
      {"play", Request::What::play},
      {"pause", Request::What::pause},
      {"step", Request::What::step},
      {"rate", Request::What::rate},
      {"order", Request::What::order}};
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object())
    return {.request = {}, .garbage = "no JSON object"};
  const auto word = json.find("do");
  const auto known = word != json.end() && word->is_string() ? kWords.find(word->get<std::string>())
                                                             : kWords.end();
  if (known == kWords.end())
    return {.request = {}, .garbage = "do: play, pause, step, rate or order"};
  Said said{.request = {.who = who, .what = known->second}, .garbage = {}};
  said.garbage = read(json, said.request);
  if (said.garbage.empty() && said.request.what == Request::What::order)
    said.request.order = scenario::orders_from_json(scenario, text, 0);
  return said;
}

}  // namespace eyrie::live
