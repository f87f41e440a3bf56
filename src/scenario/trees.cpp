// SPDX-License-Identifier: MIT
#include "scenario/trees.hpp"

#include <set>

#include "core/text.hpp"
#include "scenario/player_kind.hpp"

namespace eyrie::scenario {
namespace {

/// Far above what anybody writes; a player knows its tree by 16 bits.
constexpr std::size_t kMostTrees = 2000;
/// Of all trees together: a few hundred bytes each.
constexpr std::size_t kMostTreeNodes = 500'000;

/// The files that nodes of a scenario are made of, such as networks: beside the file that names
/// them, or, named by an option, as it was typed. They go into run files as the others do.
class NodeFiles final : public ubf::NodeFiles {
 public:
  explicit NodeFiles(Source& source) : source_(source) {}
  std::optional<std::string> read(const Value& name, Diagnostics& diagnostics) override {
    const std::string asker(name.where.file.text()), path = file_named(name);
    auto bytes = source_.read_bytes(path);
    if (bytes && bytes->size() <= Source::kLargestBytes)
      return bytes;
    return diagnostics.error(name.where,
                             bytes ? fmt::format("{} is larger than {} MB", quote_path(path),
                                                 Source::kLargestBytes >> 20)
                                   : source_.why_unread(path, asker));
  }
  std::string path_of(const Value& name) const override { return file_named(name); }

 private:
  Source& source_;
};

/// Somebody who uses a tree, and where that is said.
struct User {
  std::string name;
  Location where;
};
using Users = std::map<std::string, User>;  // by tree

/// `written` are the orders in the file.
template <class Group>
void note_users(const std::vector<Group>& groups, const std::vector<OrderSpec>& orders,
                const Value* written, Users& users) {
  using Swap = std::pair<std::string, Location>;  // the tree, and where it is named
  std::unordered_multimap<std::string_view, Swap> swaps;
  for (std::size_t i = 0; written && i < std::min(orders.size(), written->items.size()); ++i)
    if (orders[i].swap_tree)
      swaps.emplace(orders[i].player,
                    Swap{*orders[i].swap_tree, written->items[i].where_of("swap_tree")});
  for (const Group& group : groups)
    for (const auto& player : group.players) {
      users.emplace(player.spec.tree, User{player.name, player.place("tree")});
      const auto [first, last] = swaps.equal_range(player.name);
      for (auto order = first; order != last; ++order)
        users.emplace(order->second.first, User{player.name, order->second.second});
    }
}

/// The trees by name.
std::vector<ubf::NamedSpec> named_trees(const Value& map, Diagnostics& diagnostics) {
  std::vector<ubf::NamedSpec> named;
  for (const Value::Entry& e : map.entries) {
    if (const auto problem = identifier_problem(e.key))
      diagnostics.error(e.where, "trees: " + *problem);
    else
      named.push_back({e.key, &e.value});
  }
  return named;
}

std::vector<ubf::NodeChange> changes_of(const ubf::NamedSpec& tree,
                                        const std::vector<TreeChange>& changes) {
  std::vector<ubf::NodeChange> mine;
  for (const TreeChange& one : changes)
    if (one.tree == tree.name)
      mine.push_back(one.change);
  return mine;
}

/// Adds the trees that a value refers to, and what they refer to: those whose fields it renames, or
/// `all`.
void note_references(const Value& value, bool all, const std::vector<ubf::NamedSpec>& named,
                     std::set<std::string>& found) {
  const Value* body = value.tag == ubf::kTreeTag ? &value : value.find(ubf::kTreeReference);
  Diagnostics ignored;
  const auto reference = body ? ubf::read_reference(*body, value.where, ignored) : std::nullopt;
  if (reference && (all || !reference->renames.empty()) && found.insert(reference->name).second)
    for (const ubf::NamedSpec& tree : named)
      if (tree.name == reference->name)
        note_references(*tree.value, true, named, found);
  for (const Value& item : value.items)
    note_references(item, all, named, found);
  for (const Value::Entry& e : value.entries)
    note_references(e.value, all, named, found);
}

/// Whether a tree is part of one that others refer to under other names of state fields: it may be
/// nothing by itself.
bool is_read_renamed(const std::string& tree, const std::vector<ubf::NamedSpec>& named) {
  std::set<std::string> found;
  for (const ubf::NamedSpec& one : named)
    note_references(*one.value, false, named, found);
  return found.contains(tree);
}

/// Whether an order gives a tree to a player of a kind.
bool is_given_to(const PlayerKind& kind, std::string_view tree,
                 const std::vector<OrderSpec>& orders) {
  return std::ranges::any_of(orders, [&](const OrderSpec& order) {
    return order.swap_tree == tree && kind.has(order.player);
  });
}

/// How many words of a tree as written are names of nodes to a registry.
template <class Registry>
std::size_t known_words(const Value& value, const Registry& registry) {
  std::size_t known = value.is_scalar() && registry.find(value.text) ? 1 : 0;
  for (const Value& item : value.items)
    known += known_words(item, registry);
  for (const Value::Entry& e : value.entries)
    known += (registry.find(e.key) ? 1 : 0) + known_words(e.value, registry);
  return known;
}

/// One kind of platform.
template <class Trees, class Registry>
struct Shelf {
  Trees& trees;
  const Registry& registry;
  std::span<const ubf::NamedSpec> all;
  std::string_view platform, agent;  ///< "an aircraft", "pilot"
  const std::vector<TreeChange>& changes;
  ubf::NodeFiles* files;
  std::size_t& nodes;  ///< of all trees so far

  /// Builds and keeps a tree; false after mistakes.
  bool add(const ubf::NamedSpec& spec, Diagnostics& diagnostics) {
    auto tree = registry.build_tree(spec.name, *spec.value, diagnostics, all,
                                    changes_of(spec, changes), files);
    if (!tree)
      return false;
    nodes += tree->size();
    trees.add(std::move(*tree));
    return true;
  }
  [[nodiscard]] bool can_read(const ubf::NamedSpec& spec) const {
    Diagnostics ignored;
    return registry.build_tree(spec.name, *spec.value, ignored, all, {}, files).has_value();
  }
};

/// Adds a tree for who uses it. One that the other platform could use was given to the wrong one:
/// that is one mistake, where it was given.
template <class Own, class Other>
bool add_for(const User& user, const ubf::NamedSpec& spec, Own& own, Other& other,
             bool both_are_there, Diagnostics& diagnostics) {
  Diagnostics found;
  if (own.add(spec, found))
    return true;
  const Diagnostic first = found.sorted().front();
  if (both_are_there && other.can_read(spec))
    diagnostics.error(user.where, "{} is {}, and tree {} is for {}s ({}: {})", user.name,
                      own.platform, quote(spec.name), other.agent, first.where.text(),
                      first.message);
  else
    for (const Diagnostic& d : found.sorted())
      diagnostics.error(d.where, !both_are_there ? d.message
                                                 : fmt::format("{} (in a tree for {}s: {} has it)",
                                                               d.message, own.agent, user.name));
  return false;
}

}  // namespace

TreeBook TreeBook::read(const Value& document, const Plans& plans,
                        const std::vector<OrderSpec>& orders, const Registries& registries,
                        const std::vector<TreeChange>& changes, Diagnostics& diagnostics,
                        Source* source, std::span<const std::unique_ptr<PlayerKind>> kinds) {
  TreeBook book;
  const Value* const map = document.find("trees");
  if (!map)
    return book;
  if (!map->is_map()) {
    diagnostics.error(map->where, "trees: expected a map of trees, got " + map->shown());
    return book;
  }
  Users pilots, drivers;
  const Value* const written = document.find("orders");
  note_users(plans.flights, orders, written, pilots);
  note_users(plans.convoys, orders, written, drivers);

  if (map->entries.size() > kMostTrees) {
    book.too_many_ = true;
    diagnostics.error(map->where, "trees: {} of them; a scenario has at most {}",
                      map->entries.size(), kMostTrees);
    return book;
  }
  std::optional<NodeFiles> node_files;
  ubf::NodeFiles* const files = source ? &node_files.emplace(*source) : nullptr;
  const std::vector<ubf::NamedSpec> named = named_trees(*map, diagnostics);
  std::size_t nodes = 0;
  Shelf<pilot::Trees, pilot::Registry> air{*book.pilots_, registries.pilots, named, "an aircraft",
                                           "pilot",       changes,           files, nodes};
  Shelf<driver::Trees, driver::Registry> ground{
      *book.drivers_, registries.drivers, named, "a vehicle", "driver", changes, files, nodes};
  const bool both = !plans.convoys.empty();
  for (const ubf::NamedSpec& spec : named) {
    book.names_.push_back(spec.name);
    if (diagnostics.full())
      continue;
    if (ubf::needs_arguments(*spec.value)) {
      ubf::check_parameters(spec.name, *spec.value, diagnostics);
      book.templates_.push_back(spec.name);
      continue;
    }
    const auto pilot = pilots.find(spec.name), driver = drivers.find(spec.name);
    bool sound = true;
    if (pilot != pilots.end())
      sound &= add_for(pilot->second, spec, air, ground, both, diagnostics);
    if (driver != drivers.end())
      sound &= add_for(driver->second, spec, ground, air, both, diagnostics);
    bool others_use_it = false;
    for (const auto& kind : kinds)
      if (kind->uses(spec.name) || is_given_to(*kind, spec.name, orders)) {
        others_use_it = true;
        sound &= kind->add_tree(spec, named, changes_of(spec, changes), diagnostics);
      }
    if (pilot == pilots.end() && driver == drivers.end() && !others_use_it) {
      Diagnostics in_air, on_ground;
      // where nobody drives, what flies need not be tried on the ground
      sound = air.add(spec, in_air);
      if (both || !sound)
        sound |= ground.add(spec, on_ground);
      if (!sound && is_read_renamed(spec.name, named)) {
        book.templates_.push_back(spec.name);
        continue;  // who refers to it reads it
      }
      if (!sound)
        diagnostics.merge(known_words(*spec.value, registries.drivers) >
                                  known_words(*spec.value, registries.pilots)
                              ? on_ground
                              : in_air);
    }
    if (!sound)
      book.broken_.push_back(spec.name);
    if (nodes > kMostTreeNodes) {
      book.too_many_ = true;
      diagnostics.error(spec.value->where, "trees: with {} they have more than {} nodes",
                        quote(spec.name), kMostTreeNodes);
      break;
    }
  }
  return book;
}

void TreeBook::missing(const std::string& name, const Location& where,
                       Diagnostics& diagnostics) const {
  const auto has = [&](const std::vector<std::string>& names) {
    return std::ranges::find(names, name) != names.end();
  };
  if (has(templates_))
    diagnostics.error(where, "tree {} needs arguments: fly a tree that refers to it with some",
                      quote(name));
  else if (!has(broken_) && !too_many_)
    diagnostics.error(where, "there is no tree {}{}", quote(name), nearest_or_all(name, names_));
}

}  // namespace eyrie::scenario
