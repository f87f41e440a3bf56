// SPDX-License-Identifier: MIT
#include "core/value.hpp"

#include <algorithm>
#include <set>
#include <unordered_map>

#include "core/assert.hpp"

namespace eyrie {
namespace {

[[maybe_unused]] bool differ(const std::vector<Value::Entry>& entries) {
  std::set<std::string_view> keys;
  for (const Value::Entry& entry : entries)
    keys.insert(entry.key);
  return keys.size() == entries.size();
}

}  // namespace

Value Value::null(Location where) {
  return {.where = where};
}

Value Value::scalar(std::string text, Location where) {
  return {.kind = Kind::scalar, .where = where, .text = std::move(text)};
}

Value Value::list(std::vector<Value> items, Location where) {
  return {.kind = Kind::list, .where = where, .items = std::move(items)};
}

Value Value::map(std::vector<Entry> entries, Location where) {
  EYRIE_ASSERT(differ(entries));
  return {.kind = Kind::map, .where = where, .entries = std::move(entries)};
}

const Value::Entry* Value::find_entry(std::string_view key) const {
  const auto found = std::ranges::find(entries, key, &Entry::key);
  return found == entries.end() ? nullptr : &*found;
}

const Value* Value::find(std::string_view key) const {
  const Entry* entry = find_entry(key);
  return entry ? &entry->value : nullptr;
}

Value::Entry* Value::find_entry(std::string_view key) {
  return const_cast<Entry*>(std::as_const(*this).find_entry(key));
}

Value* Value::find(std::string_view key) {
  return const_cast<Value*>(std::as_const(*this).find(key));
}

std::size_t Value::count() const {
  std::size_t sum = 1;
  for (const Value& item : items)
    sum += item.count();
  for (const Entry& entry : entries)
    sum += entry.value.count();
  return sum;
}

std::string Value::shown() const {
  switch (kind) {
    case Kind::null:
      return "nothing";
    case Kind::scalar:
      return quote(text);
    case Kind::list:
      return "a list";
    case Kind::map:
      return "a map";
  }
  return {};
}

Value merged(Value base, const Value& over) {
  if (!base.is_map() || !over.is_map())
    return over;
  std::unordered_map<std::string, std::size_t> places;
  for (std::size_t i = 0; i < base.entries.size(); ++i)
    places.emplace(base.entries[i].key, i);
  for (const Value::Entry& e : over.entries) {
    const auto [place, fresh] = places.emplace(e.key, base.entries.size());
    if (fresh) {
      base.entries.push_back(e);
    } else {
      Value::Entry& there = base.entries[place->second];
      there.value = merged(std::move(there.value), e.value);
      there.where = e.where;
    }
  }
  base.where = over.where;
  return base;
}

Value::Entry entry(std::string key, Value value) {
  Location where = value.where;
  return {std::move(key), where, std::move(value)};
}

Value::Entry entry(std::string key, std::string text, Location where) {
  return entry(std::move(key), Value::scalar(std::move(text), where));
}

}  // namespace eyrie
