// SPDX-License-Identifier: MIT
#include "scenario/document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <string_view>
#include <utility>
#include <vector>

#include "scenario/yaml.hpp"

namespace eyrie::scenario {
namespace {

constexpr std::array<std::string_view, 3> kMergeable{"trees", "data", "plugins"};

Value* find(Value& map, std::string_view key) {
  for (Value::Entry& e : map.entries)
    if (e.key == key)
      return &e.value;
  return nullptr;
}

/// Appends the entries of `from` to the map `into`, refusing what is there already.
void merge_map(Value& into, const Value& from, std::string_view what, bool nested,
               Diagnostics& diagnostics) {
  for (const Value::Entry& e : from.entries) {
    Value* there = find(into, e.key);
    if (!there) {
      into.entries.push_back(e);
    } else if (nested && there->is_map() && e.value.is_map() && from.find_entry(e.key) == &e) {
      merge_map(*there, e.value, what, false, diagnostics);
    } else {
      diagnostics.error(e.where, fmt::format("{} {} is defined twice (also at {})", what,
                                             quote(e.key), there->where.text()));
    }
  }
}

class Includer {
 public:
  Includer(Source& source, Diagnostics& diagnostics) : source_(source), diagnostics_(diagnostics) {}

  Value load(const std::string& file, const Location& from) {
    // "./a.yaml" and "a.yaml" are one file
    const std::string same = std::filesystem::path(file).lexically_normal().generic_string();
    if (const auto open = std::find(stack_.begin(), stack_.end(), same); open != stack_.end()) {
      std::string chain;
      for (auto f = open; f != stack_.end(); ++f)
        chain += *f + " -> ";
      diagnostics_.error(from, fmt::format("'{}' includes itself: {}{}", same, chain, same));
      return {};
    }
    const auto text = source_.read(file);
    if (!text) {
      diagnostics_.error(from, fmt::format("cannot read '{}'", file));
      return {};
    }
    Value document = parse_yaml(*text, file, diagnostics_);
    if (!document.is_map()) {
      if (!document.is_null())
        diagnostics_.error(document.where, "expected a map, got " + document.shown());
      return {};
    }
    stack_.push_back(same);
    const Value* found = document.find("include");
    const Value include = found ? *found : Value{};
    if (include.is_list()) {
      for (const Value& item : include.items)
        merge(document, item, file);
    } else if (include.is_scalar()) {
      merge(document, include, file);
    } else if (found) {
      diagnostics_.error(include.where,
                         "include: expected a file or a list of files, got " + include.shown());
    }
    stack_.pop_back();
    return document;
  }

 private:
  void merge(Value& into, const Value& item, const std::string& file) {
    if (!item.is_scalar()) {
      diagnostics_.error(item.where, "include: expected a file, got " + item.shown());
      return;
    }
    const std::string name = relative_to(file, item.text);
    if (std::find(done_.begin(), done_.end(), name) != done_.end())
      return;  // the same package through two ways is read once
    const Value package = load(name, item.where);
    done_.push_back(name);
    for (const Value::Entry& e : package.entries) {
      if (&package.find_entry(e.key)->value != &e.value)
        diagnostics_.error(e.where,
                           fmt::format("{} is given twice (first at line {})", quote(e.key),
                                       package.find_entry(e.key)->where.line));
      else if (e.key != "include")
        merge_entry(into, e);
    }
  }

  void merge_entry(Value& into, const Value::Entry& e) {
    if (std::find(kMergeable.begin(), kMergeable.end(), e.key) == kMergeable.end()) {
      diagnostics_.error(e.where,
                         fmt::format("an included file holds trees, data and plugins, not {}{}",
                                     quote(e.key), did_you_mean(e.key, kMergeable)));
      return;
    }
    if (e.key == "plugins")
      return merge_plugins(into, e);
    if (!e.value.is_map() && !e.value.is_null()) {
      diagnostics_.error(e.value.where,
                         fmt::format("{}: expected a map, got {}", e.key, e.value.shown()));
      return;
    }
    Value* there = find(into, e.key);
    if (!there)
      into.entries.push_back(e);
    else if (there->is_null())
      *there = e.value;
    else if (there->is_map())  // otherwise whoever reads it says so
      merge_map(*there, e.value, e.key == "data" ? "data" : "tree", e.key == "data", diagnostics_);
  }

  /// One list of all; each item keeps its place, to which its path is relative.
  static void merge_plugins(Value& into, const Value::Entry& e) {
    Value* there = find(into, e.key);
    if (!there)
      return into.entries.push_back(e);
    if (!there->is_list())
      *there = Value::list({*there}, there->where);
    if (e.value.is_list())
      there->items.insert(there->items.end(), e.value.items.begin(), e.value.items.end());
    else
      there->items.push_back(e.value);
  }

  Source& source_;
  Diagnostics& diagnostics_;
  std::vector<std::string> stack_, done_;
};

/// What a list item is called: its text, or the only key of a map.
std::string_view item_name(const Value& item) {
  if (item.is_scalar())
    return item.text;
  if (item.is_map() && item.entries.size() == 1)
    return item.entries[0].key;
  return {};
}

std::vector<std::string> names_in(const Value& v) {
  std::vector<std::string> names;
  for (const Value::Entry& e : v.entries)
    names.push_back(e.key);
  for (const Value& item : v.items)
    if (!item_name(item).empty())
      names.emplace_back(item_name(item));
  return names;
}

/// Moves every place in a parsed override to where the value stands in the --set text.
void place_in_override(Value& v, const std::string& text, std::size_t offset) {
  auto move = [&](Location& where) {
    const int before = where.line <= 1 ? static_cast<int>(offset) : 0;
    where = {"--set " + text, std::max(where.line, 1), before + std::max(where.column, 1)};
  };
  move(v.where);
  for (Value& item : v.items)
    place_in_override(item, text, offset);
  for (Value::Entry& e : v.entries) {
    move(e.where);
    place_in_override(e.value, text, offset);
  }
}

class Override {
 public:
  Override(const std::string& text, Diagnostics& diagnostics)
      : text_(text), diagnostics_(diagnostics) {}

  void apply(Value& document) {
    const auto equals = text_.find('=');
    if (equals == std::string::npos || equals == 0)
      return error(0, "expected path=value");
    const std::string_view after = std::string_view(text_).substr(equals + 1);
    const std::size_t first = after.find_first_not_of(" \t\r\n");
    if (first != after.npos && after[first] == '#')
      return error(equals + 1 + first, "'#' begins a comment; put the value in quotes");
    Diagnostics found;
    Value value = first == after.npos ? Value::null() : parse_yaml(after, "--set", found);
    if (!found.ok())
      return error(equals + 1, found.sorted().front().message);
    place_in_override(value, text_, equals + 1);
    if (text_.substr(0, std::min(equals, text_.find('.'))) == "include")
      return error(0, "files are included before anything is set");
    Value* at = &document;
    std::size_t begin = 0;
    while (at) {
      const std::size_t end = std::min(text_.find('.', begin), equals);
      const std::string key = text_.substr(begin, end - begin);
      if (key.empty())
        return error(begin, "an empty name in the path");
      if (end == equals)
        return put(*at, key, begin, std::move(value));
      at = step(*at, key, begin);
      begin = end + 1;
    }
  }

 private:
  void error(std::size_t offset, const std::string& message) {
    diagnostics_.error({"--set " + text_, 1, static_cast<int>(offset) + 1}, message);
  }

  /// The value below `at` that `key` names, or null after saying why there is none.
  Value* step(Value& at, const std::string& key, std::size_t offset) {
    if (at.is_list())
      return item(at, key, offset);
    Value* next = at.is_map() ? find(at, key) : nullptr;
    if (!next)
      error(offset, fmt::format("there is no {} here{}", quote(key),
                                at.is_map() ? did_you_mean(key, names_in(at))
                                            : fmt::format(", only {}", at.shown())));
    return next;
  }

  Value* item(Value& list, const std::string& key, std::size_t offset) {
    std::size_t index = 0;
    const auto [end, failed] = std::from_chars(key.data(), key.data() + key.size(), index);
    if (failed == std::errc{} && end == key.data() + key.size()) {
      if (index < list.items.size())
        return &list.items[index];
      error(offset, fmt::format("there is no item {} here: the list has {}, counted from 0", key,
                                list.items.size()));
      return nullptr;
    }
    Value* found = nullptr;
    for (Value& one : list.items) {
      if (item_name(one) != key)
        continue;
      if (found) {
        error(offset, fmt::format("{} is in this list more than once; say which by its index, "
                                  "counted from 0",
                                  quote(key)));
        return nullptr;
      }
      found = &one;
    }
    if (!found) {
      error(offset,
            fmt::format("there is no {} here{}", quote(key), did_you_mean(key, names_in(list))));
      return nullptr;
    }
    // a bare name becomes the map that its overrides go to: eagle2 -> {eagle2: {}}
    if (found->is_scalar())
      *found = Value::map({{key, found->where, Value::map({}, found->where)}}, found->where);
    Value& inside = found->entries[0].value;
    return inside.is_null() ? &(inside = Value::map({}, found->where)) : &inside;
  }

  void put(Value& at, const std::string& key, std::size_t offset, Value value) {
    if (at.is_map() && !find(at, key))
      at.entries.push_back(
          {key, {"--set " + text_, 1, static_cast<int>(offset) + 1}, std::move(value)});
    else if (Value* there = step(at, key, offset))
      *there = std::move(value);
  }

  const std::string& text_;
  Diagnostics& diagnostics_;
};

}  // namespace

Value load_document(const std::string& file, Source& source, Diagnostics& diagnostics) {
  return Includer(source, diagnostics).load(file, {file, 0, 0});
}

void apply_overrides(Value& document, std::span<const std::string> sets, Diagnostics& diagnostics) {
  for (const std::string& text : sets)
    Override(text, diagnostics).apply(document);
}

}  // namespace eyrie::scenario
