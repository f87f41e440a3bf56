// SPDX-License-Identifier: MIT
#include "ubf/sequencer.hpp"

#include "core/bind.hpp"

namespace eyrie::ubf {
namespace {

constexpr std::string_view kAny = "any";
/// Far above what anybody writes.
constexpr std::size_t kMostTrees = 500;

/// The names in one line of `transitions`.
struct Link {
  static constexpr std::string_view type_name = "transition";
  static constexpr auto params() {
    return Lines{param("from", &Link::from, "the tree that is left, or any").required(),
                 param("to", &Link::to, "the tree that is entered").required()};
  }
  std::string from, to;
};

class Reading {
 public:
  Reading(const NodeSpec& spec, Diagnostics& diagnostics)
      : spec_(spec), diagnostics_(diagnostics) {}

  SequencerSpec read() {
    const std::size_t before = diagnostics_.count();
    if (!read_trees())
      return std::move(result_);
    read_start();
    read_transitions();
    if (diagnostics_.count() == before)
      refuse_unreachable();
    return std::move(result_);
  }

 private:
  /// False if there are too many to look at the rest.
  bool read_trees() {
    const Value* trees = spec_.body->find("trees");
    if (!trees || !trees->is_map() || trees->entries.empty()) {
      diagnostics_.error(trees ? trees->where : spec_.where,
                         "sequencer needs 'trees', a map from names to nodes");
      return true;
    }
    if (trees->entries.size() > kMostTrees) {
      diagnostics_.error(trees->where, "{} trees; a sequencer has at most {}",
                         trees->entries.size(), kMostTrees);
      return false;
    }
    for (const Value::Entry& entry : trees->entries) {
      if (entry.key == kAny)
        diagnostics_.error(entry.where, "a tree cannot be called 'any'");
      else if (const auto problem = label_problem(entry.key))
        diagnostics_.error(entry.where, "the name of a tree " + *problem);
      else if (const Value::Entry* name = own_name(entry.value))
        diagnostics_.error(name->where,
                           "a tree of a sequencer is called by its key, {}, and has no other name",
                           quote(entry.key));
      result_.trees.emplace_back(entry.key, &entry.value);
    }
    return true;
  }
  /// The name that a node itself would have, as in `{navigate: {name: lead_in}}`.
  [[nodiscard]] static const Value::Entry* own_name(const Value& node) {
    const bool one = node.is_map() && node.entries.size() == 1 && node.entries[0].key != "tree";
    return one && node.entries[0].value.is_map() ? node.entries[0].value.find_entry("name")
                                                 : nullptr;
  }
  void read_start() {
    const Value* start = spec_.body->find("start");
    if (start && start->is_scalar())
      result_.start = find(start->text, start->where);
    else
      diagnostics_.error(start ? start->where : spec_.where,
                         "sequencer needs 'start', the name of its first tree");
  }
  void read_transitions() {
    const Value* transitions = spec_.body->find("transitions");
    if (!transitions || transitions->is_null())
      return;
    if (!transitions->is_list()) {
      diagnostics_.error(transitions->where, "transitions: expected a list, got {}",
                         transitions->shown());
      return;
    }
    for (const Value& item : transitions->items)
      read_transition(item);
  }
  void read_transition(const Value& item) {
    static constexpr std::array<std::string_view, 1> kWhen{"when"};
    Link link;
    if (!bind(link, item, diagnostics_, kWhen))
      return;
    const Value* when = item.find("when");
    if (!when) {
      diagnostics_.error(item.where, "transition needs the parameter 'when'");
      return;
    }
    const std::uint16_t from =
        link.from == kAny ? kNone : find(link.from, item.find("from")->where);
    const std::uint16_t to = find(link.to, item.find("to")->where);
    if (link.from == link.to)
      diagnostics_.error(item.where, "a transition from {} to itself", quote(link.to));
    result_.transitions.push_back({from, to, when});
  }
  [[nodiscard]] std::uint16_t find(const std::string& name, const Location& where) {
    const auto& trees = result_.trees;
    for (std::size_t i = 0; i < trees.size(); ++i)
      if (trees[i].first == name)
        return static_cast<std::uint16_t>(i);
    const auto name_of = [](const auto& tree) { return tree.first; };
    diagnostics_.error(where, "the sequencer has no tree {}{}", quote(name),
                       nearest_or_all(name, listed(trees, name_of)));
    return 0;
  }
  void refuse_unreachable() {
    const std::vector<bool> reached =
        entered(result_.trees.size(), result_.transitions, result_.start);
    const Value* trees = spec_.body->find("trees");
    for (std::size_t i = 0; i < reached.size(); ++i)
      if (!reached[i])
        diagnostics_.error(trees->entries[i].where,
                           "tree {} can never be entered: no transition leads to it",
                           quote(result_.trees[i].first));
  }

  const NodeSpec& spec_;
  Diagnostics& diagnostics_;
  SequencerSpec result_;
};

}  // namespace

SequencerSpec read_sequencer(const NodeSpec& spec, Diagnostics& diagnostics) {
  return Reading(spec, diagnostics).read();
}

}  // namespace eyrie::ubf
