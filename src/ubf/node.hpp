// SPDX-License-Identifier: MIT
#pragma once
/// \file  Nodes, their types and the trees they make, whatever states and actions they are for.
#include "core/describe.hpp"
#include "ubf/memory.hpp"
#include "ubf/vote_curve.hpp"

namespace eyrie::ubf {

/// What sort of node a type is, for the catalog.
enum class Kind : std::uint8_t { behavior, condition, arbiter, control, decorator };

[[nodiscard]] constexpr std::string_view to_text(Kind kind) {
  constexpr std::string_view kNames[] = {"behavior", "condition", "arbiter", "control",
                                         "decorator"};
  return kNames[static_cast<std::size_t>(kind)];
}

/// How a file writes the children of a node.
enum class Grammar : std::uint8_t {
  none,         ///< it takes none
  list,         ///< `{type: [a, b]}` or `{type: {children: [a, b]}}`
  list_or_one,  ///< also `{type: {child: a}}`
  slots,        ///< `{type: {when: a, child: b}}`; of one slot `{type: a}`
  own,          ///< in its own way, below keys of its own
};

class AnyNode;
class NodeReader;
struct NodeSpec;

/// A type of node at run time, described once.
struct NodeType {
  std::string_view name = "behavior";  ///< under which it is registered
  std::string_view help;
  Kind kind = Kind::behavior;
  Grammar grammar = Grammar::none;
  std::span<const std::string_view> child_keys{};  ///< the slots, or the keys of its own
  /// The parameter whose value may stand alone, as in `holds: range < 10 nmi`; empty for none.
  std::string_view text_key;
  /// What decides between its children in the place of their votes, as "rank"; empty: votes do.
  std::string_view decided_by;
  const Description* parameters = nullptr;
  void* (*object)(AnyNode&) = nullptr;  ///< what `parameters` describes
  /// Of this type; null if code alone can make one.
  std::unique_ptr<AnyNode> (*make)(const NodeType& type) = nullptr;
  /// Reads what only this type understands; null if there is nothing.
  void (*read)(AnyNode&, const NodeSpec&, NodeReader&) = nullptr;
};

/// A node of a tree. Nodes are set up once, then immutable and shared by every agent that uses
/// them; what a node must remember lives in the agent's slab (see WithMemory).
class AnyNode {
 public:
  using Children = std::vector<std::unique_ptr<AnyNode>>;

  AnyNode() = default;
  virtual ~AnyNode() = default;
  AnyNode(const AnyNode&) = delete;
  AnyNode& operator=(const AnyNode&) = delete;

  /// Bytes of slab that this node alone needs; asked once, when the tree is laid out.
  [[nodiscard]] virtual std::size_t memory_bytes() const noexcept { return 0; }
  /// Whether what this node does depends on what it remembers. A node that only notes which child
  /// it has to halt does not, and may serve where every tick is the first.
  [[nodiscard]] virtual bool remembers() const noexcept { return memory_bytes() > 0; }
  /// Whether the node stays open although it answered success or failure, because it asks its
  /// children every time it is asked and their memory goes on: true for arbiters. Asked once, after
  /// the children were asked.
  [[nodiscard]] virtual bool stands() const noexcept { return false; }
  /// Which child is in charge according to a slab, kNone if the node does not remember that.
  [[nodiscard]] virtual NodeIndex active_child(const std::byte* /*slab*/) const noexcept {
    return kNone;
  }
  /// Whether the active child is a phase of the agent, worth telling: true for sequencers.
  [[nodiscard]] virtual bool is_sequencer() const noexcept { return false; }
  /// What is wrong with the parameters taken together, in words; empty if nothing is.
  [[nodiscard]] virtual std::string problem() const { return {}; }

  [[nodiscard]] std::span<const std::unique_ptr<AnyNode>> children() const noexcept {
    return children_;
  }
  /// Pre-order position in the tree; the subtree is [index, end_index).
  [[nodiscard]] NodeIndex index() const noexcept { return index_; }
  [[nodiscard]] NodeIndex end_index() const noexcept { return end_index_; }
  /// What the user called this node; the type's name if he did not.
  [[nodiscard]] std::string_view label() const noexcept { return label_.empty() ? type() : label_; }
  /// The name under which the type is registered.
  [[nodiscard]] std::string_view type() const noexcept { return type_->name; }
  /// Whether a file may give it a vote: not to conditions, which propose nothing.
  [[nodiscard]] bool takes_vote() const {
    return type_->parameters && type_->parameters->find("vote");
  }
  [[nodiscard]] Kind node_kind() const noexcept { return type_->kind; }
  [[nodiscard]] std::string_view decided_by() const noexcept { return type_->decided_by; }
  /// Its parameters that have a value.
  [[nodiscard]] std::vector<ParamValue> values() const;
  /// The value of its parameter `vote`, if it has one.
  [[nodiscard]] std::optional<double> full_vote() const;
  /// Everything that is wrong with it: its parameters, their combination, its children.
  [[nodiscard]] std::vector<std::string> problems() const;

  /// Where the file writes its type; nowhere for one that code made.
  [[nodiscard]] const Location& where() const noexcept { return where_; }

  void set_label(std::string label) { label_ = std::move(label); }
  void set_type(const NodeType& type) { type_ = &type; }

  /// How its vote follows the state; null if it does not.
  [[nodiscard]] const VoteCurve* vote_curve() const noexcept { return vote_curve_.get(); }
  void set_vote_curve(VoteCurve curve) {
    vote_curve_ = std::make_unique<const VoteCurve>(std::move(curve));
    looked_at_ = true;
  }
  /// Its type is a stranger's, which may answer what is no status.
  void distrust() { looked_at_ = true; }

 protected:
  [[nodiscard]] std::size_t memory_begin() const noexcept { return memory_begin_; }
  [[nodiscard]] bool any_child_stands() const noexcept {
    for (const auto& child : children_)
      if (child->stands_)
        return true;
    return false;
  }

  NodeIndex index_ = 0, end_index_ = 1;
  bool stands_ = false;
  bool looked_at_ = false;  ///< its answer, before it is handed on: for its vote curve, or distrust
  std::uint32_t memory_begin_ = 0, memory_end_ = 0;  ///< of the subtree
  std::unique_ptr<const VoteCurve> vote_curve_;
  Children children_;

 private:
  friend class AnyTree;
  friend class NodeReader;
  template <class, class>
  friend class Composite;

  static constexpr NodeType kAny{};
  const NodeType* type_ = &kAny;
  std::string label_;
  Location where_;
};

/// A tree has at most this many nodes, so that an index fits 16 bits and kNone stays free.
inline constexpr std::size_t kMaxNodes = 65'535;
/// No node stands deeper, so that a tick cannot exhaust the stack.
inline constexpr std::size_t kMaxDepth = 64;
/// The slab of one agent has at most this many bytes.
inline constexpr std::size_t kMaxMemory = 1 << 20;

/// Owns the nodes of a tree, numbers them in pre-order and lays out the memory of each agent.
class AnyTree {
 public:
  /// Refuses (std::logic_error) a null root, nodes without the children they need, with parameters
  /// out of their range or that contradict each other, all of them with their paths and reasons,
  /// and a tree beyond kMaxNodes, kMaxDepth or kMaxMemory.
  AnyTree(std::string name, std::unique_ptr<AnyNode> root);

  [[nodiscard]] std::string_view name() const { return name_; }
  [[nodiscard]] std::size_t size() const { return nodes_.size(); }
  /// Bytes of slab per agent, a multiple of 8.
  [[nodiscard]] std::size_t memory_bytes() const { return memory_; }
  [[nodiscard]] const AnyNode& root() const { return *root_; }
  /// Nodes in pre-order: the root is 0.
  [[nodiscard]] const AnyNode& node(NodeIndex index) const { return *nodes_[index].node; }
  /// The label of a node; "nobody" for none.
  [[nodiscard]] std::string label(std::size_t node) const {
    return node < size() ? std::string(nodes_[node].node->label()) : "nobody";
  }
  /// kNone for the root.
  [[nodiscard]] NodeIndex parent(NodeIndex index) const { return nodes_[index].parent; }
  /// The root has depth 0.
  [[nodiscard]] std::size_t depth(NodeIndex index) const { return nodes_[index].depth; }

  /// "root/engage[1]/pursue": labels from the root down; siblings of one label are counted from 0.
  [[nodiscard]] std::string path(NodeIndex index) const;
  /// Those of all its nodes, in pre-order.
  [[nodiscard]] std::vector<std::string> paths() const;
  [[nodiscard]] std::optional<NodeIndex> find(std::string_view path) const;

 protected:
  void put(std::string_view path, std::unique_ptr<AnyNode> node);

 private:
  struct Place {
    AnyNode* node;
    NodeIndex parent;
    std::uint16_t depth;
    NodeIndex among = kNone;  ///< which of the siblings of its label it is, kNone: the only one
  };
  void lay_out();
  void place(AnyNode& node, NodeIndex parent, std::size_t depth);
  [[nodiscard]] std::string path_below(std::string path_of_parent, NodeIndex index) const;

  std::string name_;
  std::unique_ptr<AnyNode> root_;
  std::vector<Place> nodes_;
  std::size_t memory_ = 0;
};

}  // namespace eyrie::ubf
