// SPDX-License-Identifier: MIT
#include "scenario/changes.hpp"

#include <algorithm>
#include <array>
#include <map>

#include "scenario/path.hpp"

namespace eyrie::scenario {
namespace {

/// Far above what anybody writes in one file.
constexpr std::size_t kMostChanges = 1000;
constexpr std::string_view kInsert = "insert", kReplace = "replace", kRemove = "remove";

struct Change {
  enum class What { insert, replace, remove };
  What what = What::insert;
  std::string path;
  Location where;
  Value value = {};
  std::vector<const Value*> passed = {};  ///< from the document to the map or list
  Value* in = nullptr;                    ///< the map or list
  std::size_t at = 0;    ///< of an item or entry; what goes to the end: behind that
  std::string key = {};  ///< of the entry that is new
};

class Changer {
 public:
  Changer(Value& document, FileName own, std::vector<Removed>& removed, Diagnostics& diagnostics)
      : document_(document), own_(own), removed_(removed), diagnostics_(diagnostics) {}

  void read(const Value& own) {
    read(own, kInsert, Change::What::insert);
    read(own, kReplace, Change::What::replace);
    if (const Value* removals = own.find(kRemove))
      for (const Value& item : removals->as_list()) {
        if (item.is_scalar())
          add(Change::What::remove, item.text, item.where, {});
        else
          error(item.where, "remove: expected a path or a list of paths, got {}", item.shown());
      }
  }

  void make() {
    refuse_conflicts();
    if (!sound_)
      return;
    // deep ones first: a map or list that changes moves what is below it
    std::ranges::stable_sort(changes_, std::ranges::greater(),
                             [](const Change& c) { return c.passed.size(); });
    for (auto first = changes_.begin(); first != changes_.end();) {
      const auto last = std::stable_partition(
          first, changes_.end(), [in = first->in](const Change& c) { return c.in == in; });
      if (first->in->is_list())
        change_list(*first->in, {first, last});
      else
        change_map(*first->in, {first, last});
      first = last;
    }
  }

 private:
  template <class... T>
  void error(const Location& where, fmt::format_string<T...> words, T&&... values) {
    sound_ = false;
    diagnostics_.error(where, "{}", fmt::format(words, std::forward<T>(values)...));
  }

  void read(const Value& own, std::string_view key, Change::What what) {
    const Value* changes = own.find(key);
    if (!changes)
      return;
    if (!changes->is_map())
      return error(changes->where, "{}: expected a map from paths to values, got {}", key,
                   changes->shown());
    for (const Value::Entry& e : changes->entries)
      add(what, e.key, e.where, e.value);
  }

  void add(Change::What what, const std::string& written, const Location& where,
           const Value& value) {
    if (changes_.size() == kMostChanges)
      return error(where, "more than {} changes", kMostChanges);
    Change change{.what = what, .path = written, .where = where, .value = value};
    std::string_view side;
    if (what == Change::What::insert)
      for (const std::string_view word : {"before ", "after "})
        if (written.starts_with(word))
          side = word;
    static constexpr std::array<std::string_view, 2> kSides{"before", "after"};
    const std::string_view word = std::string_view(written).substr(0, written.find(' '));
    if (what == Change::What::insert && side.empty() && word.size() < written.size())
      if (const std::string hint = did_you_mean(word, kSides); !hint.empty())
        return error(where, "{} is no place to insert at{}", quote(word), hint);
    change.path.erase(0, side.size());
    Location place = where;
    place.column += static_cast<int>(side.size());
    const std::size_t before = diagnostics_.count();
    const auto keys = path_keys(change.path, place, diagnostics_);
    if (keys && is_done_before_sets(keys->front().text))
      return error(place, "'{}' is carried out before anything is changed", keys->front().text);
    if (keys && resolve(*keys, change))
      finish(std::move(change), side, keys->back());
    sound_ &= diagnostics_.count() == before;
  }

  /// Finds the map or list that the last key is for.
  bool resolve(const std::vector<PathKey>& keys, Change& change) {
    change.in = &document_;
    change.passed.push_back(change.in);
    for (std::size_t i = 0; change.in && i + 1 < keys.size(); ++i)
      change.in = step(*change.in, keys[i], diagnostics_, &change.passed);
    if (!change.in)
      return false;
    const PathKey& last = keys.back();
    Value* list = list_for(*change.in, last.text);
    const bool is_new_key = change.what == Change::What::insert && list != change.in &&
                            (!list || !has_item(*list, last));
    if (!change.in->is_map() && !list) {
      error(last.where, "{}", not_here(*change.in, last.text));
      return false;
    }
    if (list && list != change.in && !is_new_key) {
      change.in = list;
      change.passed.push_back(list);
    }
    return true;
  }
  /// `winner_takes_all: [...]`: a node that is its children's list alone has no second key.
  static bool is_composite(const Value& map) {
    return map.entries.size() == 1 && map.entries[0].value.is_list() &&
           map.entries[0].key != "children" && map.entries[0].key != "players";
  }
  static bool has_item(const Value& list, const PathKey& key) {
    Diagnostics ignored;
    return item_index(list, key, ignored).has_value();
  }

  /// Finds the place in the map or list.
  void finish(Change change, std::string_view side, const PathKey& last) {
    Value& in = *change.in;
    const bool inserts = change.what == Change::What::insert;
    if (in.is_list()) {
      if (inserts && side.empty())
        return append(std::move(change), last);
      const auto index = item_index(in, last, diagnostics_);
      if (!index)
        return;
      change.at = *index + (side == "after " ? 1 : 0);
      return keep(std::move(change), inserts ? nullptr : &in.items[*index]);
    }
    const auto entry = std::ranges::find(in.entries, last.text, &Value::Entry::key);
    const bool there = entry != in.entries.end();
    change.at = static_cast<std::size_t>(entry - in.entries.begin());
    if (!side.empty())
      error(last.where, "{} is for items of lists; in a map the order does not count",
            quote(side.substr(0, side.size() - 1)));
    else if (inserts && there && !entry->value.is_null())
      append(std::move(change), last);
    else if (!inserts && !there)
      error(last.where, "{}",
            not_here(in, last.text,
                     change.what == Change::What::replace ? " ('insert' adds what is new)" : ""));
    else if (!there && is_composite(in))
      error(last.where, "{}", not_here(in, last.text));
    else if (!there) {
      change.key = last.text;
      keep(std::move(change), nullptr);
    } else {
      if (inserts)  // in the place of nothing
        change.what = Change::What::replace;
      keep(std::move(change), &entry->value);
    }
  }

  /// Something goes to the end of the list that the whole path means.
  void append(Change change, const PathKey& last) {
    Value* list = step(*change.in, last, diagnostics_, &change.passed);
    if (Value* children = list && list->is_map() ? list_for(*list, "") : nullptr)
      change.passed.push_back(list = children);
    if (!list)
      return;
    if (!list->is_list()) {
      const bool maps = list->is_map() && change.value.is_map() && !change.value.entries.empty();
      return error(last.where, "{} is there already ({}), and no list; {}", quote(last.text),
                   list->where.text(),
                   maps ? fmt::format("'insert' each new key by its own path, which ends in {}",
                                      quote(last.text + "." + change.value.entries[0].key))
                        : "'replace' puts something else in its place");
    }
    change.in = list;
    change.at = list->items.size() + 1;
    keep(std::move(change), nullptr);
  }

  void keep(Change change, const Value* target) {
    if (target && target->where.file == own_)
      return error(change.where, "{} stands in this file, at {}: change it there",
                   quote(change.path), target->where.text());
    if (target) {
      const auto [other, fresh] = targets_.emplace(target, changes_.size());
      if (!fresh)
        return error(change.where, "{} is changed twice (also at {})", quote(change.path),
                     changes_[other->second].where.text());
    }
    changes_.push_back(std::move(change));
  }

  void refuse_conflicts() {
    for (const Change& change : changes_)
      for (const Value* value : change.passed)
        if (const auto target = targets_.find(value); target != targets_.end())
          error(change.where, "{} is inside of what another change takes away (at {})",
                quote(change.path), changes_[target->second].where.text());
  }

  static void put(const Change& change, std::vector<Value>& items) {
    if (change.value.is_list())
      items.insert(items.end(), change.value.items.begin(), change.value.items.end());
    else
      items.push_back(change.value);
  }

  void change_list(Value& list, std::span<const Change> changes) {
    std::vector<Value> items;
    for (std::size_t i = 0; i <= list.items.size() + 1; ++i) {
      const Change* instead = nullptr;
      for (const Change& change : changes)
        if (change.at == i && change.what == Change::What::insert)
          put(change, items);
        else if (change.at == i)
          instead = &change;
      if (instead && instead->what == Change::What::replace)
        items.push_back(instead->value);
      else if (instead)
        note_removal(std::string(item_name(list.items[i])), *instead, list, list.items[i]);
      else if (i < list.items.size())
        items.push_back(std::move(list.items[i]));
    }
    list.items = std::move(items);
  }

  void change_map(Value& map, std::span<const Change> changes) {
    std::vector<std::string> gone;
    for (const Change& change : changes) {
      if (change.what == Change::What::replace) {
        map.entries[change.at].value = change.value;
      } else if (change.what == Change::What::remove) {
        gone.push_back(map.entries[change.at].key);
        note_removal(gone.back(), change, map, map.entries[change.at].value);
      } else if (map.find(change.key)) {
        error(change.where, "{} is inserted twice", quote(change.path));
      } else {
        map.entries.push_back({change.key, change.where, change.value});
      }
    }
    std::erase_if(map.entries, [&](const Value::Entry& e) {
      return std::ranges::find(gone, e.key) != gone.end();
    });
  }

  void note_removal(std::string name, const Change& change, const Value& from, const Value& what) {
    removed_.push_back(
        {std::move(name), change.where, from.where, listed(what.entries, &Value::Entry::key)});
  }

  Value& document_;
  FileName own_;
  std::vector<Removed>& removed_;
  Diagnostics& diagnostics_;
  std::vector<Change> changes_;
  std::map<const Value*, std::size_t> targets_;  ///< what is replaced or removed, by which change
  bool sound_ = true;
};

}  // namespace

bool is_done_before_sets(std::string_view key) {
  static constexpr std::array<std::string_view, 5> kWords{"extends", "include", kInsert, kReplace,
                                                          kRemove};
  return std::ranges::find(kWords, key) != kWords.end();
}

void make_changes(Value& document, const Value& own, std::vector<Removed>& removed,
                  Diagnostics& diagnostics) {
  Changer changer(document, own.where.file, removed, diagnostics);
  changer.read(own);
  changer.make();
}

Diagnostics blame_removals(const Diagnostics& found, const std::vector<Removed>& removed) {
  Diagnostics result;
  std::vector<bool> said(removed.size());  // who is missed once is missed everywhere
  for (const Diagnostic& d : found.sorted()) {
    const auto says = [&d](const std::string& name) {
      return !name.empty() && d.message.find(quote(name)) != d.message.npos;
    };
    const auto guilty = std::ranges::find_if(removed, [&](const Removed& one) {
      return !(d.where.file == one.where.file) &&
             (d.where == one.from || says(one.name) || std::ranges::any_of(one.held, says));
    });
    if (guilty == removed.end()) {
      result.error(d.where, d.message);
      continue;
    }
    const auto index = static_cast<std::size_t>(guilty - removed.begin());
    if (!said[index])
      result.error(guilty->where, "{} cannot be removed: {}",
                   guilty->name.empty() ? "it" : quote(guilty->name),
                   d.text().substr(0, d.text().find("; did you mean")));
    said[index] = true;
  }
  return result;
}

}  // namespace eyrie::scenario
