// SPDX-License-Identifier: MIT
#pragma once
/// \file  The neutral document tree: what every loader produces and every binder reads.
#include "core/diagnostics.hpp"

namespace eyrie {

/// One node of a document: nothing, a scalar (still text), a list or a map. Knows its place.
struct Value {
  enum class Kind { null, scalar, list, map };
  struct Entry;

  Kind kind = Kind::null;
  Location where;
  std::string text;            ///< scalar: as written, without quotes
  bool quoted = false;         ///< scalar: written in quotes
  std::string tag;             ///< the document's own type tag, usually empty
  std::vector<Value> items;    ///< list
  std::vector<Entry> entries;  ///< map: in file order, no key twice

  [[nodiscard]] static Value null(Location where = {});
  [[nodiscard]] static Value scalar(std::string text, Location where = {});
  [[nodiscard]] static Value list(std::vector<Value> items, Location where = {});
  [[nodiscard]] static Value map(std::vector<Entry> entries, Location where = {});

  [[nodiscard]] bool is_null() const { return kind == Kind::null; }
  [[nodiscard]] bool is_scalar() const { return kind == Kind::scalar; }
  [[nodiscard]] bool is_list() const { return kind == Kind::list; }
  [[nodiscard]] bool is_map() const { return kind == Kind::map; }

  /// The first entry of that key, or null. Null for everything that is not a map.
  [[nodiscard]] const Value* find(std::string_view key) const;
  [[nodiscard]] Value* find(std::string_view key);
  [[nodiscard]] const Entry* find_entry(std::string_view key) const;
  [[nodiscard]] Entry* find_entry(std::string_view key);
  /// Where the value of that key stands; if there is none, where this stands.
  [[nodiscard]] const Location& where_of(std::string_view key) const {
    const Value* value = find(key);
    return value ? value->where : where;
  }

  /// How many values it is, with all below it.
  [[nodiscard]] std::size_t count() const;
  /// The items of a list; of anything else itself: for what may be said once or several times.
  [[nodiscard]] std::span<const Value> as_list() const {
    return is_list() ? std::span(items) : std::span(this, 1);
  }
  /// What stands here, for an error: "nothing", "a list", "a map" or the quoted scalar.
  [[nodiscard]] std::string shown() const;
};

/// A key, where the key stands, and its value.
struct Value::Entry {
  std::string key;
  Location where;
  Value value;
};

/// `over` on top of `base`: maps are merged key by key, everything else is replaced.
[[nodiscard]] Value merged(Value base, const Value& over);

/// An entry whose key stands where its value stands: `entry("vote", Value::scalar("2"))`.
[[nodiscard]] Value::Entry entry(std::string key, Value value);
/// An entry with a scalar: `entry("vote", "2")`.
[[nodiscard]] Value::Entry entry(std::string key, std::string text, Location where = {});

}  // namespace eyrie
