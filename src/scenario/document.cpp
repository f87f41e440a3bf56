// SPDX-License-Identifier: MIT
#include "scenario/source.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <iterator>
#include <unordered_map>
#include <unordered_set>

#include "core/text.hpp"
#include "core/version.hpp"
#include "core/yaml.hpp"
#include "scenario/changes.hpp"
#include "scenario/data.hpp"
#include "scenario/plugins.hpp"
#include "scenario/trees.hpp"

namespace eyrie::scenario {
namespace {

constexpr std::array<std::string_view, 3> kMergeable{"trees", "data", "plugins"};

/// Far above what anybody needs: how deep includes include, how many files there are, and how many
/// values in all of them.
constexpr std::size_t kLongestChain = 50, kMostFiles = 1000, kMostValues = 500'000;

bool is_mergeable(std::string_view key) {
  return std::ranges::find(kMergeable, key) != kMergeable.end();
}

/// Adds what included files hold to the document, and before that the scenario's own words to what
/// it extends. It remembers where each key stands, so that many files with many names cost no more
/// than their sum.
class Merger {
 public:
  Merger(Value& document, FileName own, Diagnostics& diagnostics)
      : document_(document), own_(own), diagnostics_(diagnostics) {}

  void add(Value package) {
    for (Value::Entry& e : package.entries)
      if (e.key != "include")
        add_entry(std::move(e));
  }

  /// Trees, data, plug-ins, flights and convoys are added to those there are; everything else takes
  /// the place of what the extended scenario says.
  void add_own(const Value& own) {
    for (const Value::Entry& e : own.entries) {
      if (is_done_before_sets(e.key))
        continue;
      if (is_mergeable(e.key)) {
        add_entry(e);
        continue;
      }
      Value* there = document_.find(e.key);
      if ((e.key == "blue" || e.key == "red") && there && there->is_map() && e.value.is_map())
        add_side(*there, e);
      else
        put(document_, e);
    }
  }

 private:
  using Index = std::unordered_map<std::string, std::size_t>;

  static void put(Value& map, const Value::Entry& e) {
    if (Value* there = map.find(e.key))
      *there = e.value;
    else
      map.entries.push_back(e);
  }
  void add_side(Value& side, const Value::Entry& own) {
    for (const Value::Entry& e : own.value.entries) {
      Value* there = side.find(e.key);
      if (e.key != "home" && there && there->is_map() && e.value.is_map())
        add_map(*there, e.value, own.key + "." + e.key);
      else
        put(side, e);
    }
  }

  void add_entry(Value::Entry e) {
    if (!is_mergeable(e.key)) {
      diagnostics_.error(e.where, "an included file holds trees, data and plugins, not {}{}",
                         quote(e.key), did_you_mean(e.key, kMergeable));
      return;
    }
    Value* there = document_.find(e.key);
    if (e.key == "plugins")
      return there ? add_plugins(*there, std::move(e.value))
                   : document_.entries.push_back(std::move(e));
    if (!e.value.is_map()) {
      diagnostics_.error(e.value.where, "{}: expected a map, got {}", e.key, e.value.shown());
      return;
    }
    if (!there)
      document_.entries.push_back(std::move(e));
    else if (there->is_map())  // otherwise whoever reads it says so
      add_map(*there, std::move(e.value), e.key);
  }

  /// Appends the entries of `from` to the map `into`, refusing what is there already. `section`:
  /// "trees", "data", "data.radars" or "blue.flights".
  void add_map(Value& into, Value from, const std::string& section) {
    const bool kinds = section == "data";
    Index& index = index_of(into, section);
    for (Value::Entry& e : from.entries) {
      const auto [place, fresh] = index.emplace(e.key, into.entries.size());
      if (fresh) {
        into.entries.push_back(std::move(e));
        continue;
      }
      Value::Entry& there = into.entries[place->second];
      if (kinds && there.value.is_map() && e.value.is_map())
        add_map(there.value, std::move(e.value), section + "." + e.key);
      else
        refuse(e, there, section);
    }
  }
  /// Whoever writes a name that what he builds on has already means to change that.
  void refuse(const Value::Entry& added, const Value::Entry& there, const std::string& section) {
    const bool is_own = there.where.file == own_;
    const Value::Entry& mine = is_own ? there : added;
    const Value::Entry& other = is_own ? added : there;
    const std::string path = section + "." + mine.key;
    if (mine.where.file == own_)
      diagnostics_.error(mine.where,
                         "{} is defined already, at {}; change that one by its path, as in "
                         "'replace: {{{}: ...}}', or with 'insert' and 'remove'",
                         quote(path), other.where.text(), path);
    else
      diagnostics_.error(added.where, "{} is defined twice (also at {})", quote(path),
                         there.where.text());
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
  FileName own_;
  Diagnostics& diagnostics_;
  std::map<std::string, Index> indices_;  ///< by section: where each key is
};

/// Reads a scenario with all that it extends and includes, and changes that as it asks.
class Composer {
 public:
  Composer(Source& source, Diagnostics& diagnostics, std::vector<Removed>& removed)
      : source_(source), diagnostics_(diagnostics), removed_(removed) {}

  Value load(const std::string& named) {
    const std::string file = source_.named_by("", named);
    Value own = read(file, {file, 0, 0});
    source_.confine_to_folder_of(file);
    return whole(std::move(own), file);
  }

 private:
  /// No document, and it has been reported why.
  static Value none(std::nullopt_t) { return {}; }

  /// The document of a scenario as if one file said it all.
  Value whole(Value own, const std::string& file) {
    chain_.push_back(normal(file));
    Value document;
    if (const Value* extended = own.find("extends"))
      document = base(*extended, file);
    const bool has_base = !document.is_null();
    if (!has_base) {
      document = own;
      std::erase_if(document.entries, [](const Value::Entry& e) {
        return e.key != "include" && is_done_before_sets(e.key);
      });
    }
    Merger merger(document, own.where.file, diagnostics_);
    if (has_base)
      merger.add_own(own);
    if (const Value* found = own.find("include"))
      follow(*found, file, merger);
    chain_.pop_back();
    if (diagnostics_.ok())
      make_changes(document, own, removed_, diagnostics_);
    return document;
  }

  /// The scenario that another extends; null after saying why there is none.
  Value base(const Value& name, const std::string& file) {
    if (!name.is_scalar() || name.text.empty())
      return none(
          diagnostics_.error(name.where, "extends: expected a scenario, got " + name.shown()));
    const bool is_shipped = name.text.find_first_of("./") == name.text.npos;
    const std::string base_file = is_shipped ? source_.shipped(name.text)
                                             : source_.named_by(file, relative_to(file, name.text));
    if (base_file.empty())
      return none(diagnostics_.error(
          name.where,
          "there is no scenario {} (a file is named with its ending, as in '{}.yaml'){}",
          quote(name.text), printable(name.text, 40),
          did_you_mean(name.text, source_.shipped_names())));
    if (refuse_cycle(normal(base_file), "extends", name.where) || !fits(base_file, name.where))
      return {};
    Value own = read(base_file, name.where);
    if (own.is_null())
      return {};
    if (is_package(own))
      return none(diagnostics_.error(name.where, "{} is no scenario but a package: 'include' it",
                                     quote_path(base_file)));
    return whole(std::move(own), base_file);
  }

  bool refuse_cycle(const std::string& same, std::string_view does, const Location& where) {
    const auto open = std::ranges::find(chain_, same);
    if (open == chain_.end())
      return false;
    std::string chain;
    for (auto f = open; f != chain_.end(); ++f)
      chain += *f + " -> ";
    diagnostics_.error(where, "'{}' {} itself: {}{}", same, does, chain, same);
    return true;
  }

  /// "./a.yaml" and "a.yaml" are one file, but not in data/ (Source::named_by).
  static std::string normal(const std::string& file) {
    return (file.starts_with("./data/") ? "./" : "") +
           std::filesystem::path(file).lexically_normal().generic_string();
  }

  /// The document in a file; null after saying why there is none.
  Value read(const std::string& file, const Location& from) {
    const auto text = source_.read(file);
    if (!text)
      return none(
          diagnostics_.error(from, source_.why_unread(file, std::string(from.file.text()))));
    const std::size_t before = diagnostics_.count();
    Value document = parse_yaml(*text, file, diagnostics_);
    if (document.is_null() && diagnostics_.count() != before)
      return {};
    values_ += document.count();
    if (values_ > kMostValues) {
      stopped_ = true;
      return none(diagnostics_.error(from, "with {} the scenario has more than {} values",
                                     quote_path(file), kMostValues));
    }
    if (const auto other = other_format(document))
      return none(diagnostics_.error(other->where, other->message));
    if (document.is_map())
      return document;
    return none(diagnostics_.error(document.is_null() ? Location{file, 1, 1} : document.where,
                                   "expected a map, got " + document.shown()));
  }

  void follow(const Value& include, const std::string& file, Merger& merger) {
    if (!include.is_list() && !include.is_scalar())
      return void(diagnostics_.error(
          include.where, "include: expected a file or a list of files, got " + include.shown()));
    for (const Value& item : include.as_list())
      one(item, file, merger);
  }

  void one(const Value& item, const std::string& file, Merger& merger) {
    if (stopped_)
      return;
    if (!item.is_scalar() || item.text.empty()) {
      diagnostics_.error(item.where, "include: expected a file, got " + item.shown());
      return;
    }
    const std::string name = source_.named_by(file, relative_to(file, item.text));
    const std::string same = normal(name);
    if (refuse_cycle(same, "includes", item.where) || !known_.insert(same).second ||
        !fits(same, item.where))
      return;  // the same package through two ways is read once
    Value package = read(name, item.where);
    const Value* found = package.find("include");
    const Value include = found ? *found : Value{};
    merger.add(std::move(package));
    chain_.push_back(same);
    if (found)
      follow(include, name, merger);
    chain_.pop_back();
  }

  /// False after saying that there are too many files, or one behind the other.
  bool fits(const std::string& same, const Location& where) {
    const bool many = known_.size() > kMostFiles, long_chain = chain_.size() > kLongestChain;
    if (many || long_chain) {
      stopped_ = true;
      diagnostics_.error(
          where, many
                     ? fmt::format("a scenario includes at most {} files", kMostFiles)
                     : fmt::format("includes in includes, more than {} deep: {} -> {} -> ... -> {}",
                                   kLongestChain, quote_path(chain_[0]), quote_path(chain_[1]),
                                   quote_path(same)));
    }
    return !stopped_;
  }

  Source& source_;
  Diagnostics& diagnostics_;
  std::vector<Removed>& removed_;
  std::vector<std::string> chain_;         ///< files that are being read, the scenario first
  std::unordered_set<std::string> known_;  ///< included files
  std::size_t values_ = 0;
  bool stopped_ = false;  ///< a limit is said once
};

}  // namespace

bool is_package(const Value& document) {
  return std::ranges::all_of(document.entries, [](const Value::Entry& e) {
    return e.key == "include" || is_mergeable(e.key);
  });
}

std::optional<Diagnostic> other_format(const Value& document) {
  const Value* const said = document.find("eyrie");
  const auto format = said ? number_from<std::int64_t>(said->text) : std::nullopt;
  if (!format || *format == kFileFormat)
    return std::nullopt;
  const std::string what =
      *format > kFileFormat
          ? fmt::format("this file is of format {}, which needs a newer program; this one", *format)
          : fmt::format("there is no format {}; this program", *format);
  return Diagnostic{said->where,
                    fmt::format("eyrie: {}, {}, reads format {}", what, kVersion, kFileFormat)};
}

std::string what_else(const Value& document, const std::string& file) {
  if (is_package(document))
    return "a package of trees and data: fly a scenario that includes it";
  if (document.find("optimize"))
    return "this is a search: eyrie optimize " + quote_path(file);
  if (document.find("measures"))
    return "this is a campaign: eyrie campaign " + quote_path(file);
  const std::string_view model = model_in(document);
  return model.empty() ? ""
                       : fmt::format(
                             "this is a model ({}): fly a scenario that names it "
                             "(docs/howto/add-a-model.md)",
                             model);
}

Value load_document(const std::string& file, Source& source, Diagnostics& diagnostics,
                    std::vector<Removed>* removed) {
  std::vector<Removed> nobody_asks;
  return Composer(source, diagnostics, removed ? *removed : nobody_asks).load(file);
}

std::optional<std::size_t> check_package(const LoadRequest& request, Source source) {
  Diagnostics diagnostics;
  Plugins plugins;
  load_plugins(request, plugins, source, diagnostics);
  const Value document = load_document(request.file, source, diagnostics);
  diagnostics.throw_if_any();
  if (!is_package(document))
    return std::nullopt;
  if (const Value* v = document.find("plugins"))
    load_plugins(*v, request.may_open, plugins, source, diagnostics);
  diagnostics.throw_if_any();
  static_cast<void>(
      TreeBook::read(document, {}, {}, plugins.registries(), {}, diagnostics, &source));
  model::Library library;
  static_cast<void>(DataLoader(library, document.find("data"), source, diagnostics));
  diagnostics.throw_if_any();
  const Value* const trees = document.find("trees");
  return trees ? trees->entries.size() : 0;
}

}  // namespace eyrie::scenario
