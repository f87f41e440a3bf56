// SPDX-License-Identifier: MIT
#pragma once
/// \file  How a file writes a node, as far as that does not depend on which platform it is for.
///
///   navigate                                    a type without parameters
///   navigate: {altitude: 6000 ft, name: home}   with parameters and a label
///   winner_takes_all: [navigate, pursue]        children alone
///   winner_takes_all: {vote_scale: 2, children: [navigate, pursue]}
///   inverter: has_target                        a decorator's child alone
///   timeout: {after: 5 s, child: pursue}
///   tree: ingress                               a copy of the tree of that name
///   tree: {engage: {vote: 40}}                  with arguments
///   range < 10 nmi and not threatened           a condition in words (ubf/expression.hpp)
///
/// Named trees that others refer to may have parameters:
///
///   trees:
///     engage:                                  a tree with parameters and their defaults
///       parameters: {vote: 50, near: }         without a default it must be given
///       root:
///         guard: {when: range < $near, child: {pursue: {vote: $vote}}}
///     pilot:
///       winner_takes_all:
///         - tree: {engage: {near: 10 nmi}}     a copy of it, with arguments
///         - !tree home                         the same as {tree: home}
///
/// `$name` stands for the argument: any value, a node too, or a piece of a longer text. What
/// a default holds may name other parameters; a `$` that no name follows is itself.
#include "ubf/node.hpp"
#include "ubf/state_fields.hpp"

namespace eyrie::ubf {

/// The key that every node may have: its label.
inline constexpr std::string_view kLabelKey = "name";
/// The type of a reference to a named tree.
inline constexpr std::string_view kTreeReference = "tree";
/// The same as a tag: `!tree ingress`.
inline constexpr std::string_view kTreeTag = "!tree";
/// The type of a condition in words.
inline constexpr std::string_view kHolds = "holds";
inline constexpr std::string_view kParametersKey = "parameters", kRootKey = "root";
/// The argument that is none: what names of state fields mean in the tree.
inline constexpr std::string_view kFieldsKey = "fields";
/// The keys of a sequencer (ubf/sequencer.hpp).
inline constexpr std::array<std::string_view, 3> kSequencerKeys{"start", "trees", "transitions"};

/// A tree that `{tree: name}` may refer to. The value must outlive the reading.
struct NamedSpec {
  std::string name;
  const Value* value = nullptr;
};

/// A node as written: the name of its type, and what is written below that name.
struct NodeSpec {
  std::string type;
  Location where;
  const Value* body = nullptr;  ///< a null value if nothing is
};

/// Where to say what is wrong with a node's parameters taken together: at the one that another file
/// or --set has given, or at its type.
[[nodiscard]] Location place_of_problem(const NodeSpec& spec);

/// Something else than what is written, for one node of a tree: another type, which keeps children,
/// label and vote but no other parameter, or another value of a parameter.
struct NodeChange {
  NodeIndex node = 0;  ///< in pre-order
  std::string key;     ///< a parameter; empty: the type
  Value value;
  Location where;  ///< of the key
};

/// What the catalog says of a registered type.
struct NodeInfo {
  std::string name;
  Kind kind = Kind::behavior;
  std::string help;
  std::vector<ParamInfo> parameters;
  /// The keys under which children are written: none, "child", "children", "when" and "child" ...
  std::vector<std::string> child_keys;
  /// The parameter whose value may stand alone, as in `holds: range < 10 nmi`; empty for none.
  std::string text_key;
  std::string origin;     ///< who registered it: "eyrie", or a plug-in
  bool standard = false;  ///< comes with the library, for every kind of platform
};

/// What is left of a node's body for another type, which may have no vote; null: an unknown one.
[[nodiscard]] Value body_for_another_type(const Value& body, const NodeInfo* type);

/// Splits a value into type and body, or reports why it is no node.
[[nodiscard]] std::optional<NodeSpec> read_spec(const Value& value, Diagnostics& diagnostics);

/// Characters of a label.
inline constexpr std::size_t kLongestLabel = 64;
/// What is wrong with a label, in words: it must not be empty, hold what paths use ('/', '[', ']')
/// or what cannot be shown (text_problem() in core/text.hpp), or be longer than that.
[[nodiscard]] std::optional<std::string> label_problem(std::string_view label);

/// Reads the label from a node's body, or reports what is wrong with it. Empty if there is none.
[[nodiscard]] std::string read_label(const Value& body, Diagnostics& diagnostics);

/// A reference as written: to which tree, and with what.
struct Reference {
  std::string name;
  Location where;
  std::vector<const Value::Entry*> arguments;
  std::vector<FieldRename> renames;
  Location renames_where;
};

/// Reads what stands behind `tree:`, or reports what is wrong with it.
[[nodiscard]] std::optional<Reference> read_reference(const Value& body, const Location& where,
                                                      Diagnostics& diagnostics);

/// Whether a tree as written has a parameter without a default, so that it is nothing by itself.
[[nodiscard]] bool needs_arguments(const Value& tree);

/// Reports what is wrong with the parameters of such a tree whatever its arguments will be.
void check_parameters(std::string_view name, const Value& tree, Diagnostics& diagnostics);

/// A tree as written with its arguments put in, or nothing after reporting: an argument that the
/// tree does not take, one that is missing, a parameter that it does not use, a `$name` that is no
/// parameter.
[[nodiscard]] std::optional<Value> instantiate(std::string_view name, const Value& tree,
                                               const std::vector<const Value::Entry*>& arguments,
                                               const Location& where, Diagnostics& diagnostics);

}  // namespace eyrie::ubf
