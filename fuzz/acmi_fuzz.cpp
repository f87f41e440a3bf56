// SPDX-License-Identifier: MIT
/// \file  Any texts as names in a Tacview file: a reader written to the published grammar reads the
/// same objects and events whatever they are called, and the names themselves where nothing in them
/// had to be replaced.
#include <algorithm>
#include <string>

#include "core/text.hpp"
#include "fuzz/named_flight.hpp"
#include "record/acmi.hpp"
#include "support/acmi_reader.hpp"

namespace {

using namespace eyrie;
using fuzz::demand;

bool is_plain(const std::string& text, bool event = false) {
  return printable(text) == text && text.find('\\') == text.npos &&
         (!event || text.find('|') == text.npos);
}

/// It is there, as it was if that may be; nothing in it says more than a text.
void expect_name(const std::string& read, const std::string& name) {
  demand(!is_plain(name) || read == name);
  demand(printable(read) == read);
}

/// All events but bookmarks: a phase is a bookmark if its name is another than that of the last.
std::vector<test::AcmiEvent> facts_of(const test::Acmi& file) {
  std::vector<test::AcmiEvent> facts = file.events;
  std::erase_if(facts, [](const test::AcmiEvent& e) { return e.type == "Bookmark"; });
  return facts;
}

/// The file of the flight, and in `late` what somebody gets who joins at its end.
std::string written_with(fuzz::Texts texts, std::string* late = nullptr) {
  fuzz::flight().rename(texts);
  std::string text;
  record::AcmiWriter writer(fuzz::flight().scenario(),
                            [&](std::string_view lines) { text += lines; });
  fuzz::flight().show(writer);
  if (late)
    *late = writer.whole();
  return text;
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  static_cast<void>(fuzz::flight());
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const test::Acmi plain(written_with({}));
  const fuzz::Texts texts(data, size);
  std::string late;
  const test::Acmi file(written_with(texts, &late));
  for (const auto& [id, object] : test::Acmi(late).objects)
    demand(object.last("CallSign") == file.objects.at(id).last("CallSign"));

  const scenario::Scenario& scenario = fuzz::flight().scenario();
  demand(file.frames == plain.frames && file.globals.size() == plain.globals.size());
  demand(file.globals.at("ReferenceLatitude") == plain.globals.at("ReferenceLatitude"));
  expect_name(file.globals.at("Title"), scenario.spec.name);
  demand(!is_plain(scenario.spec.help_text) ||
         file.globals.at("Comments") == scenario.spec.help_text);
  demand(file.objects.size() == plain.objects.size() && plain.objects.size() > 2);
  for (const auto& [id, object] : file.objects) {
    const test::AcmiObject& same = plain.objects.at(id);
    demand(object.samples.size() == same.samples.size() && object.removed == same.removed);
    if (id > scenario.roster.players.size())
      continue;
    const auto& player = scenario.roster.players[id - 1];
    expect_name(object.last("CallSign"), player.name);
    expect_name(object.last("Name"), player.label);
    expect_name(object.last("Group"), scenario.roster.flights[player.flight].name);
    demand(object.last("Label") == object.last("UbfWinner") + " " + object.last("UbfVote"));
  }
  const auto facts = facts_of(file), plain_facts = facts_of(plain);
  demand(facts.size() == plain_facts.size() && facts.size() > 2);
  for (std::size_t i = 0; i < facts.size(); ++i) {
    const test::AcmiEvent &event = facts[i], &same = plain_facts[i];
    demand(event.type == same.type && event.time == same.time &&
           event.parts.size() == same.parts.size());
    for (std::size_t part = 0; part < event.parts.size(); ++part) {
      const std::string said = texts.in(same.parts[part]);
      demand(!is_plain(said, true) || event.parts[part] == said);
    }
  }
  return 0;
}
