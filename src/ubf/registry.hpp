// SPDX-License-Identifier: MIT
#pragma once
/// \file  Names in files -> nodes. Every type is registered once, in one line.
#include <exception>
#include <map>
#include <memory>
#include <new>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ubf/node_reader.hpp"

namespace eyrie::ubf {

/// The node types of one kind of platform.
///
///   Registry<State, Action> registry;
///   add_standard_nodes(registry);
///   registry.add<Pursue>();
///
/// A type has `type_name`, `help` and, if it has parameters, `params()` (core/describe.hpp). What
/// it derives from says what it is: a Condition, a Composite (`kind` then says whether it is an
/// arbiter, a control node or a decorator), or else a behavior.
template <class State, class Action>
class Registry {
 public:
  using Node = Behavior<State, Action>;
  using TreeType = Tree<State, Action>;
  using Reader = NodeReader<State, Action>;

  /// Refuses (std::logic_error) a name that is taken.
  template <std::derived_from<Node> B>
  void add(std::string origin = "eyrie") {
    EYRIE_THROW_UNLESS(B::type_name != kTreeReference && !find(B::type_name),
                       "two types of node have the same name");
    add({.name = std::string(B::type_name),
         .kind = ubf::kind_of<B>(),
         .help = std::string(B::help),
         .parameters = parameters<B>(),
         .child_keys = child_keys_of<B>(),
         .text_key = text_key_of<B>(),
         .origin = std::move(origin)},
        [](const NodeSpec& spec, Reader& reader) { return reader.template make_node<B>(spec); });
  }

  /// What was added so far comes with the library, for every kind of platform.
  void mark_standard() {
    for (NodeInfo& info : infos_)
      info.standard = true;
  }

  /// Builds a tree from what a file says. `others` are the trees that `{tree: name}` may refer to.
  /// `changes` are made on the way. Reports every mistake, then gives nothing.
  [[nodiscard]] std::optional<TreeType> build_tree(const std::string& name, const Value& value,
                                                   Diagnostics& diagnostics,
                                                   std::span<const NamedSpec> others = {},
                                                   std::span<const NodeChange> changes = {}) const {
    const std::size_t before = diagnostics.count();
    Reader reader(*this, others, diagnostics, changes);
    std::unique_ptr<Node> root = reader.read_tree(name, value);
    if (diagnostics.count() != before)
      return std::nullopt;
    if (const std::size_t bytes = total_memory(*root); bytes > kMaxMemory) {
      diagnostics.error(value.where, fmt::format("tree {} needs {} bytes of memory per agent, the "
                                                 "most is {}",
                                                 quote(name), bytes, kMaxMemory));
      return std::nullopt;
    }
    try {
      return TreeType(name, std::move(root));
    } catch (const std::bad_alloc&) {  // nobody's mistake
      throw;
    } catch (const std::exception& e) {
      diagnostics.error(value.where,
                        fmt::format("tree {} could not be laid out: {}", quote(name), e.what()));
      return std::nullopt;
    }
  }

  /// Every registered type, in the order of registration.
  [[nodiscard]] std::span<const NodeInfo> catalog() const { return infos_; }
  [[nodiscard]] const NodeInfo* find(std::string_view name) const {
    const auto found = by_name_.find(name);
    return found == by_name_.end() ? nullptr : &infos_[found->second];
  }

  /// For readers: the node that a spec describes, or null after reporting why there is none.
  [[nodiscard]] std::unique_ptr<Node> make(const NodeSpec& spec, Reader& reader) const {
    const auto found = by_name_.find(spec.type);
    if (found != by_name_.end()) {
      try {
        return entries_[found->second](spec, reader);
      } catch (const std::bad_alloc&) {  // nobody's mistake
        throw;
      } catch (const std::exception& e) {
        reader.error(spec.where,
                     fmt::format("node {} (of {}) could not be made: {}", quote(spec.type),
                                 infos_[found->second].origin, e.what()));
        return nullptr;
      }
    }
    std::vector<std::string_view> names{kTreeReference};
    for (const NodeInfo& info : infos_)
      names.push_back(info.name);
    reader.error(spec.where, fmt::format("there is no node {}{}", quote(spec.type),
                                         did_you_mean(spec.type, names)));
    return nullptr;
  }

 private:
  using Maker = std::unique_ptr<Node> (*)(const NodeSpec&, Reader&);

  void add(NodeInfo info, Maker maker) {
    by_name_.emplace(info.name, entries_.size());
    infos_.push_back(std::move(info));
    entries_.push_back(maker);
  }

  template <class B>
  [[nodiscard]] static std::vector<std::string> child_keys_of() {
    if constexpr (requires { B::child_keys; })
      return {B::child_keys.begin(), B::child_keys.end()};
    else if constexpr (requires { B::slots; })
      return {B::slots.begin(), B::slots.end()};
    else if constexpr (requires { B::takes_one_child; })
      return {"children", "child"};
    else if constexpr (std::derived_from<B, Composite<State, Action>>)
      return {"children"};
    else
      return {};
  }
  template <class B>
  [[nodiscard]] static std::string text_key_of() {
    if constexpr (requires { B::text_key; })
      return std::string(B::text_key);
    else
      return {};
  }
  [[nodiscard]] static std::size_t total_memory(const Node& node) {
    std::size_t bytes = slab_bytes(node.memory_bytes());
    for (const auto& child : node.children())
      bytes += total_memory(*child);
    return bytes;
  }

  std::vector<NodeInfo> infos_;
  std::vector<Maker> entries_;
  std::map<std::string, std::size_t, std::less<>> by_name_;
};

}  // namespace eyrie::ubf
