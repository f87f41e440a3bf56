// SPDX-License-Identifier: MIT
/// \file  Any lines as overrides of a scenario, PATH=VALUE each: a document that was changed, the
/// same once more when they are given twice, or mistakes that stand in the override and that a
/// terminal can show. What is bound from it afterwards is for the scenario fuzzer.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "core/diagnostics.hpp"
#include "core/text.hpp"
#include "core/yaml.hpp"
#include "fuzz/demand.hpp"
#include "scenario/source.hpp"

namespace {

using namespace eyrie;
using fuzz::demand;

constexpr std::string_view kScenario = R"(eyrie: 1
name: small
until: 2 s
orders: [{at: 1 s, player: eagle1, lose: true}]
trees:
  cruise: {winner_takes_all: [avoid_ground: {vote: 100}, navigate: {vote: 10}, navigate]}
blue:
  flights: {eagle: {aircraft: f15c, players: [eagle1, eagle2: {fuel: 3000 kg}], loadout: [aim9]}}
)";

bool equal(const Value& a, const Value& b) {
  if (a.kind != b.kind || a.text != b.text || a.quoted != b.quoted || a.tag != b.tag ||
      a.items.size() != b.items.size() || a.entries.size() != b.entries.size())
    return false;
  for (std::size_t i = 0; i < a.items.size(); ++i)
    if (!equal(a.items[i], b.items[i]))
      return false;
  for (std::size_t i = 0; i < a.entries.size(); ++i)
    if (a.entries[i].key != b.entries[i].key || !equal(a.entries[i].value, b.entries[i].value))
      return false;
  return true;
}

void check(const Diagnostics& found) {
  for (const Diagnostic& one : found.sorted()) {
    demand(!one.message.empty() && one.where.file.text().starts_with("--set "));
    demand(one.where.line >= 1 && one.where.column >= 1);
    demand(one.text().size() < 5000 && printable(one.text()) == one.text());
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::vector<std::string> sets;
  std::istringstream lines(std::string(reinterpret_cast<const char*>(data), size));
  for (std::string line; std::getline(lines, line) && sets.size() < 8;)
    sets.push_back(line);
  Diagnostics none;
  Value document = eyrie::parse_yaml(kScenario, "small.yaml", none);
  demand(none.ok());
  for (const std::string& set : sets) {
    Diagnostics found, again;
    scenario::apply_overrides(document, {&set, 1}, found);
    check(found);
    if (!found.ok())
      continue;
    Value twice = document;
    scenario::apply_overrides(twice, {&set, 1}, again);
    demand(again.ok() && equal(twice, document));
  }
  return 0;
}
