// SPDX-License-Identifier: MIT
/// \file  Any texts as names in CZML and GeoJSON: both are JSON in ASCII, with as many packets and
/// features whatever they are called, and names that are UTF-8 come back as they were.
#include <algorithm>
#include <string>

#include "core/text.hpp"
#include "fuzz/named_flight.hpp"
#include "record/json_text.hpp"
#include "record/paths.hpp"

namespace {

using namespace eyrie;
using fuzz::demand;
using nlohmann::json;

json read(const std::string& text) {
  for (const char c : text)
    demand((c >= 0x20 && c < 0x7F) || c == '\n');
  return json::parse(text);
}

/// Without the texts: what must not depend on them.
json shape_of(json value) {
  if (value.is_string())
    return "";
  if (value.is_structured())
    for (auto& inner : value)
      inner = shape_of(inner);
  return value;
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  static_cast<void>(fuzz::flight());
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Texts texts(data, size);
  fuzz::flight().rename(texts);
  const scenario::Scenario& scenario = fuzz::flight().scenario();
  record::Paths paths(scenario);
  fuzz::flight().show(paths);
  const json packets = read(record::czml(paths)), map = read(record::geojson(paths));

  const auto is_text = [](std::string_view name) {
    std::size_t length = 1;
    for (; length != 0 && !name.empty(); name.remove_prefix(length))
      length = first_character(name).length;
    return length != 0;
  };
  demand(!is_text(scenario.spec.name) || packets[0]["name"] == scenario.spec.name);
  static const std::size_t count = packets.size(), features = map["features"].size();
  demand(packets.size() == count && count > 3);
  demand(map["features"].size() == features && features > 3);
  for (const auto& player : scenario.roster.players) {
    if (!is_text(player.name))
      continue;
    const auto is_his = [&](const json& j) { return j.value("name", "") == player.name; };
    demand(std::any_of(packets.begin(), packets.end(), is_his));
    demand(std::any_of(map["features"].begin(), map["features"].end(),
                       [&](const json& f) { return is_his(f["properties"]); }));
  }
  static const json first = shape_of(map["features"][0]["geometry"]);
  demand(shape_of(map["features"][0]["geometry"]) == first);
  return 0;
}
