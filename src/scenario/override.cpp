// SPDX-License-Identifier: MIT
#include <algorithm>

#include "scenario/changes.hpp"
#include "scenario/path.hpp"
#include "scenario/source.hpp"

namespace eyrie::scenario {
namespace {

/// What mistakes in an override carry for a file.
std::string named(const std::string& text) {
  return "--set " + text;
}

class Override {
 public:
  Override(const std::string& text, Diagnostics& diagnostics)
      : text_(text), diagnostics_(diagnostics) {}

  void apply(Value& document) {
    const std::size_t equals = path_size(text_);
    if (equals == text_.size() && std::ranges::count(text_, '"') % 2)
      return error(text_.rfind('"'), "a quote without an end");
    if (equals == text_.size() || equals == 0)
      return error(0, "expected path=value");
    const std::string_view after = std::string_view(text_).substr(equals + 1);
    const std::size_t first = after.find_first_not_of(" \t\r\n");
    if (first != after.npos && after[first] == '#')
      return error(equals + 1 + first, "'#' begins a comment; put the value in quotes");
    Diagnostics found;
    Value value = first == after.npos ? Value::null() : parse_yaml(after, "--set", found);
    if (!found.ok())
      return error(equals + 1, "{}", found.sorted().front().message);
    place_in_override(value, text_, equals + 1);
    const auto keys =
        path_keys(std::string_view(text_).substr(0, equals), {named(text_), 1, 1}, diagnostics_);
    if (!keys)
      return;
    if (is_done_before_sets(keys->front().text))
      return error(0, "'{}' is carried out before anything is set", keys->front().text);
    const std::string& first_key = keys->front().text;
    if (keys->size() > 1 &&
        did_you_mean(first_key, listed(document.entries, &Value::Entry::key)).empty())
      return error(0, "there is no {} here; what is new is set whole, as in {}={}",
                   quote(first_key), first_key,
                   number_from<std::size_t>((*keys)[1].text)
                       ? "[...]"
                       : fmt::format("{{{}: ...}}", (*keys)[1].text));
    Value* at = &document;
    for (std::size_t i = 0; at && i + 1 < keys->size(); ++i)
      at = step(*at, (*keys)[i], diagnostics_);
    if (!at)
      return;
    const PathKey& last = keys->back();
    const Value* list = list_for(*at, last.text);
    const bool names_child = list && std::ranges::any_of(list->items, [&](const Value& item) {
                               return item_name(item) == last.text;
                             });
    if (at->is_map() && !at->find(last.text) && !names_child)
      at->entries.push_back({last.text, last.where, std::move(value)});
    else if (Value* there = step(*at, last, diagnostics_))
      *there = std::move(value);
  }

 private:
  template <class... T>
  void error(std::size_t offset, fmt::format_string<T...> words, T&&... values) {
    diagnostics_.error({named(text_), 1, static_cast<int>(offset) + 1}, "{}",
                       fmt::format(words, std::forward<T>(values)...));
  }

  const std::string& text_;
  Diagnostics& diagnostics_;
};

}  // namespace

void place_in_override(Value& v, const std::string& text, std::size_t offset) {
  auto move = [&](Location& where) {
    const int before = where.line <= 1 ? static_cast<int>(offset) : 0;
    where = {named(text), std::max(where.line, 1), before + std::max(where.column, 1)};
  };
  move(v.where);
  for (Value& item : v.items)
    place_in_override(item, text, offset);
  for (Value::Entry& e : v.entries) {
    move(e.where);
    place_in_override(e.value, text, offset);
  }
}

void apply_overrides(Value& document, std::span<const std::string> sets, Diagnostics& diagnostics) {
  for (const std::string& text : sets)
    Override(text, diagnostics).apply(document);
}

}  // namespace eyrie::scenario
