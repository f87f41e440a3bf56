// SPDX-License-Identifier: MIT
#pragma once
/// \file  Names in files -> nodes. Every type is registered once, in one line.
#include <map>
#include <typeindex>

#include "ubf/expression.hpp"
#include "ubf/spec.hpp"
#include "ubf/tree.hpp"

namespace eyrie::ubf {

/// Files that nodes are made of besides the document. Who reads trees says where they come from.
class NodeFiles {
 public:
  virtual ~NodeFiles() = default;
  /// The bytes of the file that a value names, or nothing after reporting why there are none.
  [[nodiscard]] virtual std::optional<std::string> read(const Value& name,
                                                        Diagnostics& diagnostics) = 0;
  /// The path of that file: the same for all nodes that name it.
  [[nodiscard]] virtual std::string path_of(const Value& name) const = 0;
  /// What `make(bytes)` gives, a std::shared_ptr<const Made>, read and made once for all nodes that
  /// name the file; null, after reporting, is not kept.
  template <class Made, class Make>
  [[nodiscard]] std::shared_ptr<const Made> made_of(const Value& name, Diagnostics& diagnostics,
                                                    Make make) {
    std::shared_ptr<const void>& made = made_[{typeid(Made), path_of(name)}];
    if (!made)
      if (auto bytes = read(name, diagnostics))
        made = make(std::move(*bytes));
    return std::static_pointer_cast<const Made>(made);
  }

 private:
  std::map<std::pair<std::type_index, std::string>, std::shared_ptr<const void>> made_;
};

/// What is registered, whatever states and actions it is for.
class AnyRegistry {
 public:
  /// What was added so far comes with the library, for every kind of platform.
  void mark_standard();
  /// Every registered type, in the order of registration.
  [[nodiscard]] std::span<const NodeInfo> catalog() const { return infos_; }
  [[nodiscard]] const NodeInfo* find(std::string_view name) const;
  /// What a name may have been meant to be, also one of another library, as core's did_you_mean.
  [[nodiscard]] std::string did_you_mean(std::string_view wrong) const;

 protected:
  explicit AnyRegistry(std::vector<StateFieldInfo> fields) : fields_(std::move(fields)) {}
  void add(const NodeType& type, std::string origin);
  [[nodiscard]] std::optional<AnyTree> build(const std::string& name, const Value& value,
                                             Diagnostics& diagnostics,
                                             std::span<const NamedSpec> others,
                                             std::span<const NodeChange> changes,
                                             NodeFiles* files) const;

 private:
  friend class NodeReader;

  std::vector<StateFieldInfo> fields_;
  std::vector<NodeInfo> infos_;
  std::vector<const NodeType*> types_;  ///< of `infos_`
  std::map<std::string, std::size_t, std::less<>> by_name_;
};

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
class Registry : public AnyRegistry {
 public:
  using Node = Behavior<State, Action>;
  using TreeType = Tree<State, Action>;

  Registry() : AnyRegistry(state_field_infos<State>()) {}

  /// Refuses (std::logic_error) a name that is taken, a type whose nodes cannot be made, and one
  /// with a default outside of its own range.
  template <std::derived_from<Node>... B>
  void add(const std::string& origin = "eyrie") {
    (AnyRegistry::add(kNodeType<B>, origin), ...);
  }

  /// A type that is made at run time: its nodes are of this state and action, and it outlives this
  /// registry. Refuses what add() does.
  void add_type(const NodeType& type, std::string origin) {
    AnyRegistry::add(type, std::move(origin));
  }

  /// Builds a tree from what a file says. `others` are the trees that `{tree: name}` may refer to.
  /// `changes` are made on the way; `files`: where nodes find theirs. Reports every mistake;
  /// gives nothing if there is any, also of whoever read the text.
  [[nodiscard]] std::optional<TreeType> build_tree(const std::string& name, const Value& value,
                                                   Diagnostics& diagnostics,
                                                   std::span<const NamedSpec> others = {},
                                                   std::span<const NodeChange> changes = {},
                                                   NodeFiles* files = nullptr) const {
    std::optional<AnyTree> tree = build(name, value, diagnostics, others, changes, files);
    if (!tree)
      return std::nullopt;
    return TreeType(std::move(*tree));
  }
};

/// Reads one tree, for a registry. Nodes that understand something of their own get it passed:
///   void read(const NodeSpec& spec, NodeReader& reader);
class NodeReader {
 public:
  using Child = std::unique_ptr<AnyNode>;

  NodeReader(const AnyRegistry& registry, std::span<const NamedSpec> trees,
             Diagnostics& diagnostics, std::span<const NodeChange> changes = {},
             NodeFiles* files = nullptr)
      : registry_(registry),
        trees_(trees),
        diagnostics_(diagnostics),
        changes_(changes),
        files_(files) {}

  /// The node and everything below it, or null after reporting at least one mistake.
  [[nodiscard]] Child read(const Value& value);
  [[nodiscard]] AnyNode::Children read_list(std::span<const Value> values);
  /// Reads a named tree, which may not refer to itself.
  [[nodiscard]] Child read_tree(const std::string& name, const Value& value,
                                const std::vector<const Value::Entry*>& arguments = {},
                                const Location& where = {});
  /// The steps of a condition in words over the fields of the state, or over `fields`, by the names
  /// that hold here; empty after reporting what is wrong with it.
  [[nodiscard]] std::vector<detail::Instruction> expression(const Value& text);
  [[nodiscard]] std::vector<detail::Instruction> expression(const Value& text,
                                                            std::span<const StateFieldInfo> fields);
  /// The index of the state's field that a value names here, or nothing after reporting.
  [[nodiscard]] std::optional<std::size_t> field(const Value& name);
  /// What `make(bytes)` gives of the file that a value names (NodeFiles::made_of); null after
  /// reporting.
  template <class Made, class Make>
  [[nodiscard]] std::shared_ptr<const Made> made_of(const Value& name, Make make) {
    if (files_)
      return files_->made_of<Made>(name, diagnostics_, make);
    error(name.where,
          fmt::format("there is no file {}: nodes of this tree have no files", quote(name.text)));
    return nullptr;
  }
  [[nodiscard]] const StateFieldInfo& info(std::size_t field) const {
    return registry_.fields_[field];
  }

  [[nodiscard]] Diagnostics& diagnostics() { return diagnostics_; }
  std::nullopt_t error(const Location& where, std::string message) {
    return diagnostics_.error(where, std::move(message));
  }

 private:
  [[nodiscard]] bool within_limits(const Location& where);
  [[nodiscard]] Child read_reference(const NodeSpec& spec);
  [[nodiscard]] Child make_changed(NodeSpec spec);
  [[nodiscard]] Child make(const NodeSpec& spec);
  [[nodiscard]] bool is_flag(std::string_view name) {
    const std::size_t field = names_.find(registry_.fields_, name);
    return field < registry_.fields_.size() && info(field).kind == FieldKind::flag;
  }
  [[nodiscard]] Child make(const NodeType& type, const NodeSpec& spec);
  void read_below_unknown(const Value& body);
  [[nodiscard]] Child make_voting(const NodeType& type, const NodeSpec& spec, const Value& vote);
  [[nodiscard]] Value with_pending(const NodeType& type, const Value& body);
  bool bind(AnyNode& node, const Value& body, std::vector<std::string_view> also);
  void read_leaf(AnyNode& node, const NodeSpec& spec);
  void read_children(AnyNode& node, const NodeSpec& spec);
  void read_slots(AnyNode& node, const NodeSpec& spec);
  [[nodiscard]] bool refuse_nodes_as_keys(const AnyNode& node, const NodeSpec& spec);

  const AnyRegistry& registry_;
  std::span<const NamedSpec> trees_;
  Diagnostics& diagnostics_;
  std::span<const NodeChange> changes_;
  NodeFiles* files_;
  std::vector<const NodeChange*> pending_;  ///< for the node that is being made
  FieldNames names_;
  std::vector<std::string> open_;  ///< names of the trees being read, outermost first
  std::size_t depth_ = 0, count_ = 0;
  bool full_ = false;
};

}  // namespace eyrie::ubf
