// SPDX-License-Identifier: MIT
/// \file  Any texts as names in CZML and GeoJSON: both are JSON in ASCII, the same whatever they
/// are called, and names that are UTF-8 come back as they were.
#include <string>

#include "core/text.hpp"
#include "fuzz/named_flight.hpp"
#include "record/json_text.hpp"
#include "record/paths.hpp"

namespace {

using namespace eyrie;
using fuzz::demand, fuzz::demand_same;
using nlohmann::json;

json read(const std::string& text) {
  for (const char c : text)
    demand((c >= 0x20 && c < 0x7F) || c == '\n');
  return json::parse(text);
}

struct Globe {
  json packets, map;
};
Globe written_with(fuzz::Texts texts) {
  fuzz::flight().rename(texts);
  record::Paths paths(fuzz::flight().scenario());
  fuzz::flight().show(paths);
  Globe globe{read(record::czml(paths)), read(record::geojson(paths))};
  for (json& packet : globe.packets)  // behaviors of one name in a row are one text
    if (packet.contains("label"))
      packet["label"].erase("text");
  return globe;
}

bool is_text(std::string_view text) {
  std::size_t length = 1;
  for (; length != 0 && !text.empty(); text.remove_prefix(length))
    length = first_character(text).length;
  return length != 0;
}

void expect_same(const json& value, const json& plain, const fuzz::Texts& texts) {
  if (value.is_structured()) {
    demand(value.size() == plain.size());
    for (auto at = value.begin(), same = plain.begin(); at != value.end(); ++at, ++same) {
      demand(!value.is_object() || at.key() == same.key());
      expect_same(*at, *same, texts);
    }
  } else if (plain.is_string()) {
    const std::string text = texts.in(plain.get<std::string>());
    if (is_text(text))
      demand_same(value.get<std::string>(), text);
  } else {
    demand(value == plain);
  }
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  static_cast<void>(fuzz::flight());
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Globe plain = written_with({});
  const fuzz::Texts texts(data, size);
  const Globe globe = written_with(texts);
  demand(globe.packets.size() > 3 && globe.map["features"].size() > 3);
  expect_same(globe.packets, plain.packets, texts);
  expect_same(globe.map, plain.map, texts);
  return 0;
}
