// SPDX-License-Identifier: MIT
#pragma once
/// \file  Named trees that others refer to, with parameters.
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
/// `$name` stands for the argument: any value, a node too, or a piece of a longer text.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/diagnostics.hpp"
#include "core/value.hpp"
#include "ubf/state_fields.hpp"

namespace eyrie::ubf {

inline constexpr std::string_view kParametersKey = "parameters", kRootKey = "root";
/// The argument that is none: what names of state fields mean in the tree.
inline constexpr std::string_view kFieldsKey = "fields";

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

/// A tree as written with its arguments put in, or nothing after reporting: an argument that the
/// tree does not take, one that is missing, a parameter that it does not use, a `$name` that is no
/// parameter.
[[nodiscard]] std::optional<Value> instantiate(std::string_view name, const Value& tree,
                                               const std::vector<const Value::Entry*>& arguments,
                                               const Location& where, Diagnostics& diagnostics);

}  // namespace eyrie::ubf
