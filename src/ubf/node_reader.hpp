// SPDX-License-Identifier: MIT
#pragma once
/// \file  From a node as a file writes it to the node: children, parameters and all mistakes.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/bind.hpp"
#include "ubf/composite.hpp"
#include "ubf/expression.hpp"
#include "ubf/spec.hpp"
#include "ubf/subtree.hpp"
#include "ubf/tree.hpp"
#include "ubf/vote_param.hpp"

namespace eyrie::ubf {

template <class State, class Action>
class Registry;

/// Reads one tree. Made by Registry; composites with children of their own grammar get it passed.
template <class State, class Action>
class NodeReader {
 public:
  using Node = Behavior<State, Action>;
  using Child = std::unique_ptr<Node>;
  using Children = std::vector<Child>;

  NodeReader(const Registry<State, Action>& registry, std::span<const NamedSpec> trees,
             Diagnostics& diagnostics, std::span<const NodeChange> changes = {})
      : registry_(registry),
        trees_(trees),
        diagnostics_(diagnostics),
        changes_(changes),
        fields_(state_field_infos<State>()) {}

  /// The node and everything below it, or null after reporting at least one mistake.
  [[nodiscard]] Child read(const Value& value) {
    if (full_)
      return nullptr;
    const std::optional<NodeSpec> spec = read_spec(value, diagnostics_);
    if (!spec)
      return nullptr;
    if (spec->type == kTreeReference)
      return read_reference(*spec);
    if (!within_limits(spec->where))
      return nullptr;
    ++depth_;
    Child node = changes_.empty() ? registry_.make(*spec, *this) : make_changed(*spec);
    --depth_;
    return node;
  }
  /// Reads a named tree, which may not refer to itself.
  [[nodiscard]] Child read_tree(const std::string& name, const Value& value,
                                const std::vector<const Value::Entry*>& arguments = {},
                                const Location& where = {}) {
    std::optional<Value> filled;
    if (value.find(kParametersKey) || !arguments.empty()) {
      filled = instantiate(name, value, arguments, where.line ? where : value.where, diagnostics_);
      if (!filled)
        return nullptr;
    }
    open_.push_back(name);
    Child root = read(filled ? *filled : value);
    open_.pop_back();
    return root;
  }
  /// A condition in words over the state's fields, by the names that hold here; empty after
  /// reporting what is wrong with it.
  [[nodiscard]] Expression<State> expression(const Value& text) {
    auto program = parse_expression(text, fields_, names_, diagnostics_);
    return program ? Expression<State>(std::move(*program)) : Expression<State>();
  }
  /// A condition in words over a proposed action too.
  [[nodiscard]] ActionExpression<State, Action> action_expression(const Value& text) {
    using E = ActionExpression<State, Action>;
    auto program = parse_expression(text, E::fields(), names_, diagnostics_);
    return program ? E(std::move(*program)) : E();
  }
  /// The index of the state's field that a value names here, or nothing after reporting.
  [[nodiscard]] std::optional<std::size_t> field(const Value& name) {
    const std::size_t found = names_.find(fields_, name.text);
    if (found < fields_.size())
      return found;
    error(name.where, fmt::format("there is no state field {}{}", quote(name.text),
                                  did_you_mean(name.text, names_.known(fields_))));
    return std::nullopt;
  }
  [[nodiscard]] Children read_list(std::span<const Value> values) {
    Children children;
    for (const Value& value : values)
      if (Child child = read(value))
        children.push_back(std::move(child));
    return children;
  }

  [[nodiscard]] Diagnostics& diagnostics() { return diagnostics_; }
  void error(const Location& where, std::string message) {
    diagnostics_.error(where, std::move(message));
  }

  /// Makes a node of type B from its spec. Called by the registry.
  template <class B>
  [[nodiscard]] Child make_node(const NodeSpec& spec) {
    if constexpr (requires { B::text_key; })
      if (spec.body->is_scalar()) {
        const Value whole = Value::map({entry(std::string(B::text_key), *spec.body)}, spec.where);
        return make_node<B>({spec.type, spec.where, &whole});
      }
    if (!pending_.empty()) {
      std::string_view only;
      if constexpr (requires { B::slots; })
        only = B::slots.size() == 1 && is_child_alone<B>(*spec.body) ? B::slots.front() : "";
      const Value whole = with_pending(*spec.body, only);
      return make_node<B>({spec.type, spec.where, &whole});
    }
    if (has_vote<B>())
      if (const Value* vote = spec.body->find("vote"); vote && vote->is_map())
        return make_voting<B>(spec, *vote);
    const std::size_t before = diagnostics_.count();
    auto node = ubf::make<B>();
    node->set_label(read_label(*spec.body, diagnostics_));
    if constexpr (requires { B::child_keys; })
      read_own_way(*node, spec);
    else if constexpr (requires { B::slots; })
      read_slots(*node, spec);
    else if constexpr (std::derived_from<B, Composite<State, Action>>)
      read_children(*node, spec);
    else
      read_leaf(*node, spec);
    if constexpr (requires { node->read_words(*spec.body, *this); })
      node->read_words(*spec.body, *this);
    if (diagnostics_.count() != before)
      return nullptr;
    if (const std::string problem = node->problem(); !problem.empty()) {
      error(spec.where, problem);
      return nullptr;
    }
    return node;
  }

 private:
  /// A node whose vote follows the state (ubf/vote_curve.hpp).
  template <class B>
  [[nodiscard]] Child make_voting(const NodeSpec& spec, const Value& text) {
    std::optional<VoteCurve> curve = read_vote(
        text, fields_, [&](const Value& name) { return field(name); }, diagnostics_);
    Value whole = *spec.body;
    std::erase_if(whole.entries, [](const Value::Entry& e) { return e.key == "vote"; });
    if (const Value* most = text.find("most"))
      whole.entries.push_back(entry("vote", *most));
    Child node = make_node<B>({spec.type, spec.where, &whole});
    if (!curve || !node)
      return nullptr;
    const std::optional<float> most = vote_of(static_cast<const B&>(*node));
    if (curve->least > 0 && !(most && curve->least <= static_cast<double>(*most))) {
      error(text.where, most ? fmt::format("vote: 'least' is {}, above the full vote of {}",
                                           curve->least, *most)
                             : "vote: 'least' needs 'most' beside it");
      return nullptr;
    }
    if (most && *most > 0)
      curve->least /= static_cast<double>(*most);
    node->set_vote_curve(std::move(*curve));
    return node;
  }
  [[nodiscard]] bool within_limits(const Location& where) {
    if (depth_ >= kMaxDepth) {
      error(where, fmt::format("nodes are nested more than {} deep", kMaxDepth));
      return false;
    }
    if (++count_ > kMaxNodes) {
      error(where, fmt::format("the tree has more than {} nodes", kMaxNodes));
      full_ = true;
      return false;
    }
    return true;
  }

  /// The node that was read last, with the changes that are meant for it.
  [[nodiscard]] Child make_changed(NodeSpec spec) {
    Value body;
    pending_.clear();
    for (const NodeChange& change : changes_) {
      if (change.node + std::size_t{1} != count_)
        continue;
      if (!change.key.empty()) {
        pending_.push_back(&change);
        continue;
      }
      if (!change.value.is_scalar()) {
        error(change.value.where,
              fmt::format("expected the name of a node, got {}", change.value.shown()));
        return nullptr;
      }
      body = body_for_another_type(*spec.body);
      spec = {change.value.text, change.value.where, &body};
    }
    Child node = registry_.make(spec, *this);
    pending_.clear();
    return node;
  }
  /// A body with the changes of parameters put in; under `slot`, if it is that child alone.
  [[nodiscard]] Value with_pending(const Value& body, std::string_view slot) {
    Value whole = body;
    if (body.is_null())
      whole = Value::map({}, body.where);
    else if (body.is_list())
      whole = Value::map({entry("children", body)}, body.where);
    else if (!slot.empty())
      whole = Value::map({entry(std::string(slot), body)}, body.where);
    for (const NodeChange* change : std::exchange(pending_, {})) {
      const auto there = std::find_if(whole.entries.begin(), whole.entries.end(),
                                      [&](const Value::Entry& e) { return e.key == change->key; });
      if (there != whole.entries.end())
        *there = {change->key, change->where, change->value};
      else
        whole.entries.push_back({change->key, change->where, change->value});
    }
    return whole;
  }

  [[nodiscard]] Child read_reference(const NodeSpec& spec) {
    std::optional<Reference> reference = ubf::read_reference(*spec.body, spec.where, diagnostics_);
    if (!reference)
      return nullptr;
    const std::string& name = reference->name;
    const auto tree = std::find_if(trees_.begin(), trees_.end(),
                                   [&](const NamedSpec& named) { return named.name == name; });
    if (tree == trees_.end()) {
      std::vector<std::string> names;
      if (!diagnostics_.full())
        for (const NamedSpec& named : trees_)
          names.push_back(named.name);
      error(reference->where,
            fmt::format("there is no tree {}{}", quote(name), did_you_mean(name, names)));
      return nullptr;
    }
    if (const auto cycle = cycle_through(open_, name)) {
      error(reference->where, *cycle);
      return nullptr;
    }
    if (open_.size() >= kMaxDepth) {
      error(spec.where, fmt::format("trees refer to one another more than {} deep", kMaxDepth));
      return nullptr;
    }
    names_.push(std::move(reference->renames));
    Child root = read_tree(name, *tree->value, reference->arguments, reference->where);
    for (const FieldRename& rename : names_.pop())
      if (root && !rename.used)
        error(reference->renames_where,
              fmt::format("fields: nothing in tree {} reads {}", quote(name), quote(rename.from)));
    if (root && root->label() == root->type())
      root->set_label(name);
    return root;
  }

  template <class B>
  void read_leaf(B& node, const NodeSpec& spec) {
    static constexpr std::array kKeys{kLabelKey, std::string_view("child"),
                                      std::string_view("children")};
    const bool lists_children = spec.body->is_list();
    const Value* children = spec.body->find("children");
    if (!children)
      children = spec.body->find("child");
    if (lists_children || children) {
      error(children ? children->where : spec.where,
            fmt::format("{} is a {} and takes no children", spec.type,
                        std::derived_from<B, Condition<State, Action>> ? "condition" : "behavior"));
      return;
    }
    bind(node, *spec.body, diagnostics_, std::span(kKeys).first(1));
  }

  /// `{type: [child, ...]}` or `{type: {children: [child, ...], ...}}`
  template <class B>
  void read_children(B& node, const NodeSpec& spec) {
    static constexpr std::array kKeys{kLabelKey, std::string_view("children"),
                                      std::string_view("child")};
    constexpr bool kTakesOne = requires {
      B::takes_one_child;
    };
    const Value* list = spec.body;
    const Value* only = nullptr;
    if (spec.body->is_list()) {
      bind(node, Value::map({}, spec.where), diagnostics_);
    } else {
      if (!refuse_nodes_as_keys(spec))
        return;
      bind(node, *spec.body, diagnostics_, std::span(kKeys).first(kTakesOne ? 3 : 2));
      list = spec.body->find("children");
      only = kTakesOne ? spec.body->find("child") : nullptr;
    }
    if (only && list) {
      error(only->where, fmt::format("{} has either 'child' or 'children'", spec.type));
      return;
    }
    if (only) {
      node.adopt(read_list(std::span(only, 1)));
      return;
    }
    if (list && !list->is_list()) {
      error(list->where, fmt::format("children: expected a list of nodes, got {}", list->shown()));
      return;
    }
    if (!list || list->items.empty()) {
      error(list ? list->where : spec.where, fmt::format("{} needs at least one child", spec.type));
      return;
    }
    node.adopt(read_list(list->items));
  }

  /// `{type: child}` if there is one slot, or `{type: {slot: child, ...}}`
  template <class B>
  void read_slots(B& node, const NodeSpec& spec) {
    static constexpr auto kKeys = [] {
      std::array<std::string_view, B::slots.size() + 1> keys{kLabelKey};
      std::copy(B::slots.begin(), B::slots.end(), keys.begin() + 1);
      return keys;
    }();
    const Value& body = *spec.body;
    if (body.is_list() || body.find("children")) {
      error(spec.where,
            fmt::format("{} takes exactly one '{}'; put several nodes under an arbiter or a "
                        "control node",
                        spec.type, B::slots.back()));
      return;
    }
    if (B::slots.size() == 1 && is_child_alone<B>(body)) {
      bind(node, Value::map({}, spec.where), diagnostics_);
      node.adopt(read_list(std::span(&body, 1)));
      return;
    }
    bind(node, body, diagnostics_, kKeys);
    Children children;
    for (const std::string_view slot : B::slots) {
      if (const Value* child = body.find(slot))
        children.push_back(read(*child));
      else
        error(spec.where, fmt::format("{} needs a '{}'", spec.type, slot));
    }
    node.adopt(std::move(children));
  }
  /// A name, or a map whose only key is none of B's own.
  template <class B>
  [[nodiscard]] static bool is_child_alone(const Value& body) {
    if (body.is_scalar())
      return true;
    if (!body.is_map() || body.entries.size() != 1)
      return false;
    const std::string& key = body.entries.front().key;
    bool own = key == kLabelKey || key == B::slots.front();
    std::apply([&](const auto&... param) { ((own |= key == param.name), ...); }, B::params());
    return !own;
  }

  template <class B>
  void read_own_way(B& node, const NodeSpec& spec) {
    std::vector<std::string_view> keys(B::child_keys.begin(), B::child_keys.end());
    keys.push_back(kLabelKey);
    if (bind(node, *spec.body, diagnostics_, keys) || spec.body->is_map())
      node.read(spec, *this);
  }

  /// `winner_takes_all: {navigate: ..., pursue: ...}` is meant as a list.
  [[nodiscard]] bool refuse_nodes_as_keys(const NodeSpec& spec) {
    for (const auto& entry : spec.body->entries) {
      if (!registry_.find(entry.key))
        continue;
      error(entry.where, fmt::format("{} is a node, not a parameter of {}; write children as a "
                                     "list: {}: [{}, ...]",
                                     quote(entry.key), spec.type, spec.type, entry.key));
      return false;
    }
    return true;
  }

  const Registry<State, Action>& registry_;
  std::span<const NamedSpec> trees_;
  Diagnostics& diagnostics_;
  std::span<const NodeChange> changes_;
  std::vector<const NodeChange*> pending_;  ///< for the node that is being made
  std::vector<StateFieldInfo> fields_;
  FieldNames names_;
  std::vector<std::string> open_;  ///< names of the trees being read, outermost first
  std::size_t depth_ = 0, count_ = 0;
  bool full_ = false;
};

}  // namespace eyrie::ubf
