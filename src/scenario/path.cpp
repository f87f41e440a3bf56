// SPDX-License-Identifier: MIT
#include "scenario/path.hpp"

#include <algorithm>

#include "core/text.hpp"

namespace eyrie::scenario {
namespace {

std::vector<std::string> names_in(const Value& v) {
  std::vector<std::string> names = listed(v.entries, &Value::Entry::key);
  for (const Value& item : v.items)
    if (!item_name(item).empty())
      names.emplace_back(item_name(item));
  return names;
}

/// A name as a path has it.
std::string in_path(std::string_view name) {
  const bool plain = name.find_first_of(".=") == name.npos || name.find('"') != name.npos;
  return plain ? std::string(name) : fmt::format("\"{}\"", name);
}

/// A bare name becomes a map with nothing, `eagle2` to `{eagle2: {}}`; a tag stays.
void open_name(Value& item) {
  item.entries = {{std::exchange(item.text, {}), item.where, Value::map({}, item.where)}};
  item.kind = Value::Kind::map;
  item.quoted = false;
}

/// The keys of a path as each spelling of it has them: an index without zeros before it, no
/// `children` between two others.
std::vector<std::string> plain_keys(std::string_view path) {
  Diagnostics ignored;
  std::vector<std::string> plain;
  const auto keys = path_keys(path.substr(0, path_size(path)), {}, ignored);
  for (std::size_t i = 0; keys && i < keys->size(); ++i) {
    const std::string& key = (*keys)[i].text;
    const auto index = number_from<std::size_t>(key);
    if (key != "children" || i + 1 == keys->size())
      plain.push_back(index ? std::to_string(*index) : key);
  }
  return plain;
}

}  // namespace

bool covers(std::string_view path, std::string_view other) {
  const std::vector<std::string> keys = plain_keys(path), below = plain_keys(other);
  return !keys.empty() && keys.size() <= below.size() &&
         std::equal(keys.begin(), keys.end(), below.begin());
}

std::vector<SetTwice> set_twice(std::span<const std::string> sets) {
  std::vector<SetTwice> all;
  for (std::size_t i = 0; i < sets.size(); ++i) {
    const auto again = std::find_if(sets.begin() + static_cast<std::ptrdiff_t>(i) + 1, sets.end(),
                                    [&](const auto& later) { return covers(later, sets[i]); });
    if (again != sets.end())
      all.push_back({i, static_cast<std::size_t>(again - sets.begin())});
  }
  return all;
}

std::size_t path_size(std::string_view text) {
  bool in_quotes = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    in_quotes ^= text[i] == '"';
    if (text[i] == '=' && !in_quotes)
      return i;
  }
  return text.size();
}

std::optional<std::vector<PathKey>> path_keys(std::string_view path, Location where,
                                              Diagnostics& diagnostics) {
  std::vector<PathKey> keys;
  for (std::size_t begin = 0, end = 0; end != path.npos; begin = end + 1) {
    Location place = where;
    place.column += static_cast<int>(begin);
    const auto close = path.substr(begin, 1) == "\"" ? path.find('"', begin + 1) : path.npos;
    end = path.find('.', close == path.npos ? begin : close);
    std::string_view key = path.substr(begin, end - begin);
    if (close != path.npos && close == begin + key.size() - 1)
      key = key.substr(1, key.size() - 2);
    keys.push_back({std::string(key), place});
    if (key.empty())
      return diagnostics.error(place, "an empty name in the path");
  }
  return keys;
}

std::string_view item_name(const Value& item) {
  if (item.is_scalar())
    return item.text;
  if (item.is_map() && item.entries.size() == 1)
    return item.entries[0].key;
  return {};
}

std::string not_here(const Value& at, std::string_view key, std::string_view note) {
  std::string rest = at.is_map() || at.is_list() ? nearest_or_all(key, names_in(at))
                                                 : fmt::format(", only {}", at.shown());
  if (at.is_scalar() && is_identifier(at.text) && !number_from<std::size_t>(at.text))
    rest += fmt::format(" ({} if that is a node)", quote(fmt::format("{}.{}", at.text, key)));
  return fmt::format("there is no {} here{}{}", quote(key), note, rest);
}

void paths_below(const Value& at, const std::string& path,
                 std::map<std::string, std::string>& paths) {
  paths.emplace(at.where.text(), path);
  for (const Value::Entry& e : at.entries) {
    const std::string below = e.key == "children" ? path : path + "." + in_path(e.key);
    paths[e.where.text()] = below;
    paths_below(e.value, below, paths);
  }
  for (std::size_t i = 0; i < at.items.size(); ++i) {
    const Value& item = at.items[i];
    const std::string_view name = item_name(item);
    // one that --set can type
    const bool is_named = !name.empty() && name.find_first_of(" \"") == name.npos &&
                          !number_from<std::size_t>(name) &&
                          std::ranges::count_if(at.items, [&](const Value& other) {
                            return item_name(other) == name;
                          }) == 1;
    const std::string below =
        fmt::format("{}.{}", path, is_named ? in_path(name) : std::to_string(i));
    if (is_named && item.is_map()) {
      paths[item.entries[0].where.text()] = below;
      paths_below(item.entries[0].value, below, paths);
    } else {
      paths[item.where.text()] = below;
      paths_below(item, below, paths);
    }
  }
}

Value* list_for(Value& at, std::string_view key) {
  if (at.is_list())
    return &at;
  Value* children = at.find(key) ? nullptr : at.find("children");
  return children && children->is_list() ? children : nullptr;
}

std::optional<std::size_t> item_index(const Value& list, const PathKey& key,
                                      Diagnostics& diagnostics) {
  if (const auto index = number_from<std::size_t>(key.text)) {
    if (*index < list.items.size())
      return index;
    return diagnostics.error(key.where, "there is no item {} here: the list has {}, counted from 0",
                             key.text, list.items.size());
  }
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < list.items.size(); ++i) {
    if (item_name(list.items[i]) != key.text)
      continue;
    if (found)
      return diagnostics.error(
          key.where, "{} is in this list more than once; say which by its index, counted from 0",
          quote(key.text));
    found = i;
  }
  return found ? found : diagnostics.error(key.where, not_here(list, key.text));
}

Value* step(Value& at, const PathKey& key, Diagnostics& diagnostics,
            std::vector<const Value*>* passed) {
  const auto pass = [&](Value* value) {
    if (passed && value)
      passed->push_back(value);
    return value;
  };
  if (at.is_scalar() && at.text == key.text)  // an item by its index, and then its name
    open_name(at);
  if (at.is_list() && key.text == "children")  // `winner_takes_all: [...]` is its list
    return &at;
  Value* list = list_for(at, key.text);
  if (!list) {
    Value* next = at.find(key.text);
    if (!next)
      diagnostics.error(key.where, not_here(at, key.text));
    return pass(next);
  }
  if (list != &at)
    pass(list);
  const auto index = item_index(*list, key, diagnostics);
  if (!index)
    return nullptr;
  Value& item = *pass(&list->items[*index]);
  if (number_from<std::size_t>(key.text))
    return &item;
  if (item.is_scalar())
    open_name(item);
  Value& inside = *pass(&item.entries[0].value);
  if (inside.is_null())
    inside = Value::map({}, item.where);
  return &inside;
}

}  // namespace eyrie::scenario
