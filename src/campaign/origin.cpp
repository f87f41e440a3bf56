// SPDX-License-Identifier: MIT
/// \file  What a campaign was begun with, against what it would go on with.
#include <fmt/ranges.h>

#include <algorithm>

#include "campaign/store.hpp"
#include "core/text.hpp"
#include "core/yaml.hpp"

namespace eyrie::campaign {
namespace {

/// The next line of a text, which is taken from it.
std::string_view take_line(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return line;
}

std::string changed(const std::string& name, std::string_view was, std::string_view is) {
  std::size_t line = 1;
  std::string_view before, now;
  do {
    before = take_line(was);
    now = take_line(is);
  } while (before == now && ++line);
  // of a long line what is around the first difference
  constexpr std::size_t kAround = 20;
  const auto same = static_cast<std::size_t>(
      std::mismatch(before.begin(), before.end(), now.begin(), now.end()).first - before.begin());
  const std::size_t skipped = same > kAround ? same - kAround : 0;
  return fmt::format("{}, line {}, column {}: was {}, is {}", quote_path(name), line, same + 1,
                     quote(before.substr(skipped)), quote(now.substr(skipped)));
}

bool same(const Value& a, const Value& b) {
  const auto same_entry = [](const Value::Entry& x, const Value::Entry& y) {
    return x.key == y.key && same(x.value, y.value);
  };
  return a.kind == b.kind && a.text == b.text && a.quoted == b.quoted && a.tag == b.tag &&
         std::ranges::equal(a.items, b.items, same) &&
         std::ranges::equal(a.entries, b.entries, same_entry);
}

/// What a campaign's file says, but for how many replicates there are.
Value without_numbers(const Spec& spec) {
  Diagnostics none;
  Value document = parse_yaml(spec.text, spec.file, none);
  const auto is_number = [](const Value::Entry& entry) {
    return entry.key == "replicates" || entry.key == "budget" || entry.key == "most";
  };
  std::erase_if(document.entries, is_number);
  for (Value::Entry& entry : document.entries)
    if (entry.key == "stop")
      std::erase_if(entry.value.entries, is_number);
  return document;
}

/// The difference between two files of a campaign; "" if what has been flown by the first is the
/// beginning of what the second says: it says the same of more replicates, or of a larger budget.
std::string difference(const std::string& before, const std::string& now) {
  const std::string all = changed(kCampaignText, before, now);
  try {
    const Spec was = parse_spec(before, kCampaignText), is = parse_spec(now, kCampaignText);
    const auto grown = [](const auto& a, const auto& b) { return !b || (a && *a <= *b); };
    const std::uint64_t most = most_replicates(is), cells = cells_of(is).size();
    if (most < most_replicates(was) || !grown(was.budget.replicates, is.budget.replicates) ||
        !grown(was.budget.time, is.budget.time) || !same(without_numbers(was), without_numbers(is)))
      return all;
    if (most == most_replicates(was))
      return "";
    if (!is.seeds.paired && cells > 1)
      return all + ": with seeds that are not paired, other ones would have been flown";
    if (is.budget.replicates && *is.budget.replicates < most * cells)
      return all + ": the budget would have been spent on other replicates";
    return "";
  } catch (const ConfigError&) {
    return all;
  }
}

std::vector<std::string> differences(const Origin& before, const Origin& now) {
  std::vector<std::string> all;
  for (const auto& [name, text] : before)
    if (const auto found = now.find(name); found == now.end())
      all.push_back(fmt::format("{} is used no more", quote_path(name)));
    else if (found->second != text && name != kCampaignText)
      all.push_back(changed(name, text, found->second));
    else if (found->second != text && !difference(text, found->second).empty())
      all.push_back(difference(text, found->second));
  for (const auto& item : now)
    if (!before.contains(item.first))
      all.push_back(fmt::format("{} was not used", quote_path(item.first)));
  return all;
}

}  // namespace

Origin origin_of(Origin whole, const Part& part) {
  if (part.of > 1)
    whole["the part"] = part.text();
  return whole;
}

bool begun(Database& database) {
  return database.prepare("SELECT 1 FROM sqlite_master WHERE name = 'campaign'").step();
}

void demand_the_same(Database& database, const Origin& origin, const std::string& folder) {
  Origin before;
  Statement stored = database.prepare("SELECT name, text FROM origin");
  while (stored.step())
    before[stored.text(0)] = stored.text(1);
  if (const auto all = differences(before, origin); !all.empty())
    throw disk::Refused(
        "{} was begun with something else; undo that, or begin anew with another --out\n  {}",
        quote_path(folder), fmt::join(all, "\n  "));
}

}  // namespace eyrie::campaign
