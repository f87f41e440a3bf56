// SPDX-License-Identifier: MIT
#include "scenario/source.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <iterator>
#include <unordered_map>
#include <unordered_set>

#include "core/yaml.hpp"

namespace eyrie::scenario {
namespace {

constexpr std::array<std::string_view, 3> kMergeable{"trees", "data", "plugins"};

/// Far above what anybody needs: how deep includes include, how many files there are, and how many
/// values in all of them.
constexpr std::size_t kLongestChain = 50, kMostFiles = 1000, kMostValues = 500'000;

Value* find(Value& map, std::string_view key) {
  for (Value::Entry& e : map.entries)
    if (e.key == key)
      return &e.value;
  return nullptr;
}

std::size_t values_in(const Value& v) {
  std::size_t count = 1;
  for (const Value& item : v.items)
    count += values_in(item);
  for (const Value::Entry& e : v.entries)
    count += values_in(e.value);
  return count;
}

/// Adds what included files hold to the document. It remembers where each key stands, so that many
/// files with many names cost no more than their sum.
class Merger {
 public:
  Merger(Value& document, Diagnostics& diagnostics)
      : document_(document), diagnostics_(diagnostics) {}

  void add(Value package) {
    for (Value::Entry& e : package.entries)
      if (e.key != "include")
        add_entry(std::move(e));
  }

 private:
  using Index = std::unordered_map<std::string, std::size_t>;

  void add_entry(Value::Entry e) {
    if (std::find(kMergeable.begin(), kMergeable.end(), e.key) == kMergeable.end()) {
      diagnostics_.error(e.where,
                         fmt::format("an included file holds trees, data and plugins, not {}{}",
                                     quote(e.key), did_you_mean(e.key, kMergeable)));
      return;
    }
    Value* there = find(document_, e.key);
    if (e.key == "plugins")
      return there ? add_plugins(*there, std::move(e.value))
                   : document_.entries.push_back(std::move(e));
    if (!e.value.is_map() && !e.value.is_null()) {
      diagnostics_.error(e.value.where,
                         fmt::format("{}: expected a map, got {}", e.key, e.value.shown()));
      return;
    }
    if (!there)
      document_.entries.push_back(std::move(e));
    else if (there->is_null())
      *there = std::move(e.value);
    else if (there->is_map())  // otherwise whoever reads it says so
      add_map(*there, std::move(e.value), e.key);
  }

  /// Appends the entries of `from` to the map `into`, refusing what is there already. `section`:
  /// "trees", "data", or "data/radars".
  void add_map(Value& into, Value from, const std::string& section) {
    const bool kinds = section == "data";
    Index& index = index_of(into, section);
    for (Value::Entry& e : from.entries) {
      const auto [place, fresh] = index.emplace(e.key, into.entries.size());
      if (fresh) {
        into.entries.push_back(std::move(e));
        continue;
      }
      Value& there = into.entries[place->second].value;
      if (kinds && there.is_map() && e.value.is_map())
        add_map(there, std::move(e.value), section + "/" + e.key);
      else
        diagnostics_.error(e.where, fmt::format("{} {} is defined twice (also at {})",
                                                section == "trees" ? "tree" : "data", quote(e.key),
                                                there.where.text()));
    }
  }
  Index& index_of(const Value& map, const std::string& section) {
    const auto [found, fresh] = indices_.try_emplace(section);
    for (std::size_t i = 0; fresh && i < map.entries.size(); ++i)
      found->second.emplace(map.entries[i].key, i);
    return found->second;
  }

  /// One list of all; each item keeps its place, to which its path is relative.
  static void add_plugins(Value& there, Value more) {
    if (!there.is_list())
      there = Value::list({there}, there.where);
    if (more.is_list())
      std::move(more.items.begin(), more.items.end(), std::back_inserter(there.items));
    else
      there.items.push_back(std::move(more));
  }

  Value& document_;
  Diagnostics& diagnostics_;
  std::map<std::string, Index> indices_;  ///< by section: where each key is
};

class Includer {
 public:
  Includer(Source& source, Diagnostics& diagnostics)
      : source_(source), diagnostics_(diagnostics), merger_(document_, diagnostics) {}

  Value load(const std::string& file) {
    document_ = read(file, {file, 0, 0});
    source_.confine_to_folder_of(file);
    const Value* found = document_.find("include");
    if (found)
      follow(Value(*found), file, normal(file));
    return std::move(document_);
  }

 private:
  /// "./a.yaml" and "a.yaml" are one file.
  static std::string normal(const std::string& file) {
    return std::filesystem::path(file).lexically_normal().generic_string();
  }

  /// The document in a file; null after saying why there is none.
  Value read(const std::string& file, const Location& from) {
    const auto text = source_.read(file);
    if (!text) {
      diagnostics_.error(from, source_.is_outside(file)
                                   ? fmt::format("{} is outside the folder of the scenario and "
                                                 "the installation; --allow-include DIR allows it",
                                                 quote_path(file))
                                   : "cannot read " + quote_path(file) +
                                         source_.nearest(file, std::string(from.file.text())));
      return {};
    }
    const std::size_t before = diagnostics_.count();
    Value document = parse_yaml(*text, file, diagnostics_);
    if (document.is_null() && diagnostics_.count() != before)
      return {};
    values_ += values_in(document);
    if (values_ > kMostValues) {
      stopped_ = true;
      diagnostics_.error(from, fmt::format("with {} the scenario has more than {} values",
                                           quote_path(file), kMostValues));
      return {};
    }
    if (document.is_map())
      return document;
    diagnostics_.error(document.is_null() ? Location{file, 1, 1} : document.where,
                       "expected a map, got " + document.shown());
    return {};
  }

  void follow(const Value& include, const std::string& file, const std::string& same) {
    chain_.push_back(same);
    if (include.is_list()) {
      for (const Value& item : include.items)
        one(item, file);
    } else if (include.is_scalar()) {
      one(include, file);
    } else {
      diagnostics_.error(include.where,
                         "include: expected a file or a list of files, got " + include.shown());
    }
    chain_.pop_back();
  }

  void one(const Value& item, const std::string& file) {
    if (stopped_)
      return;
    if (!item.is_scalar()) {
      diagnostics_.error(item.where, "include: expected a file, got " + item.shown());
      return;
    }
    const std::string name = relative_to(file, item.text), same = normal(name);
    if (const auto open = std::find(chain_.begin(), chain_.end(), same); open != chain_.end()) {
      std::string chain;
      for (auto f = open; f != chain_.end(); ++f)
        chain += *f + " -> ";
      diagnostics_.error(item.where, fmt::format("'{}' includes itself: {}{}", same, chain, same));
      return;
    }
    if (!known_.insert(same).second)
      return;  // the same package through two ways is read once
    if (known_.size() > kMostFiles || chain_.size() > kLongestChain) {
      stopped_ = true;
      diagnostics_.error(
          item.where,
          known_.size() > kMostFiles
              ? fmt::format("a scenario includes at most {} files", kMostFiles)
              : fmt::format("includes in includes, more than {} deep: {} -> {} -> ... -> {}",
                            kLongestChain, quote_path(chain_[0]), quote_path(chain_[1]),
                            quote_path(same)));
      return;
    }
    Value package = read(name, item.where);
    const Value* found = package.find("include");
    const Value include = found ? *found : Value{};
    merger_.add(std::move(package));
    if (found)
      follow(include, name, same);
  }

  Source& source_;
  Diagnostics& diagnostics_;
  Value document_;
  Merger merger_;
  std::vector<std::string> chain_;         ///< files that are being read, the scenario first
  std::unordered_set<std::string> known_;  ///< included files
  std::size_t values_ = 0;
  bool stopped_ = false;  ///< a limit is said once
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

/// What mistakes in an override carry for a file.
std::string named(const std::string& text) {
  return "--set " + text;
}

/// Moves every place in a parsed override to where the value stands in the --set text.
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
    diagnostics_.error({named(text_), 1, static_cast<int>(offset) + 1}, message);
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
          {key, {named(text_), 1, static_cast<int>(offset) + 1}, std::move(value)});
    else if (Value* there = step(at, key, offset))
      *there = std::move(value);
  }

  const std::string& text_;
  Diagnostics& diagnostics_;
};

}  // namespace

Value load_document(const std::string& file, Source& source, Diagnostics& diagnostics) {
  return Includer(source, diagnostics).load(file);
}

void apply_overrides(Value& document, std::span<const std::string> sets, Diagnostics& diagnostics) {
  for (const std::string& text : sets)
    Override(text, diagnostics).apply(document);
}

}  // namespace eyrie::scenario
