// SPDX-License-Identifier: MIT
#include "ubf/registry.hpp"

#include <algorithm>
#include <exception>

namespace eyrie::ubf {
namespace {

/// The keys under which a type's children are written.
std::vector<std::string> child_keys(const NodeType& type) {
  if (type.grammar == Grammar::list)
    return {"children"};
  if (type.grammar == Grammar::list_or_one)
    return {"children", "child"};
  return {type.child_keys.begin(), type.child_keys.end()};
}

}  // namespace

void AnyRegistry::mark_standard() {
  for (NodeInfo& info : infos_)
    info.standard = true;
}

const NodeInfo* AnyRegistry::find(std::string_view name) const {
  const auto found = by_name_.find(name);
  return found == by_name_.end() ? nullptr : &infos_[found->second];
}

void AnyRegistry::add(const NodeType& type, std::string origin) {
  if (type.name == kTreeReference)
    throw std::logic_error(fmt::format("{} is no name for a node", quote(type.name)));
  if (const NodeInfo* there = find(type.name))
    throw std::logic_error(
        fmt::format("there is already a node {} (of {})", quote(type.name), there->origin));
  const auto refuse = [&type](std::string_view why) {
    throw std::logic_error(fmt::format("node {} {}", quote(type.name), why));
  };
  if (!type.make)
    refuse("cannot be made without arguments, as files do");
  // of a type that is made at run time only its nodes know the defaults
  std::shared_ptr<void> fresh;
  std::unique_ptr<AnyNode> node;
  try {
    if (type.parameters->fresh)
      fresh = type.parameters->fresh();
    else
      node = type.make(type);
  } catch (const std::bad_alloc&) {  // nobody's mistake
    throw;
  } catch (const std::exception& e) {
    refuse(fmt::format("could not be made: {}", e.what()));
  }
  const void* const defaults = fresh ? fresh.get() : type.object(*node);
  std::vector<std::string> problems;
  eyrie::detail::check_values(*type.parameters, defaults, "", problems, true);
  if (!problems.empty())
    refuse("has a default that is none: " + problems.front());
  by_name_.emplace(type.name, infos_.size());
  types_.push_back(&type);
  infos_.push_back({.name = std::string(type.name),
                    .kind = type.kind,
                    .help = std::string(type.help),
                    .parameters = eyrie::detail::parameters(*type.parameters, defaults),
                    .child_keys = child_keys(type),
                    .text_key = std::string(type.text_key),
                    .origin = std::move(origin)});
}

std::optional<AnyTree> AnyRegistry::build(const std::string& name, const Value& value,
                                          Diagnostics& diagnostics,
                                          std::span<const NamedSpec> others,
                                          std::span<const NodeChange> changes,
                                          NodeFiles* files) const {
  if (value.is_null() && !diagnostics.ok())  // a text that could not be read
    return std::nullopt;
  NodeReader reader(*this, others, diagnostics, changes, files);
  std::unique_ptr<AnyNode> root = reader.read_tree(name, value);
  if (!root || !diagnostics.ok())
    return std::nullopt;
  const auto total_memory = [](const auto& self, const AnyNode& node) -> std::size_t {
    std::size_t bytes = slab_bytes(node.memory_bytes());
    for (const auto& child : node.children())
      bytes += self(self, *child);
    return bytes;
  };
  if (const std::size_t bytes = total_memory(total_memory, *root); bytes > kMaxMemory)
    return diagnostics.error(value.where,
                             "tree {} needs {} bytes of memory per agent, the most is {}",
                             quote(name), bytes, kMaxMemory);
  try {
    return AnyTree(name, std::move(root));
  } catch (const std::bad_alloc&) {  // nobody's mistake
    throw;
  } catch (const std::exception& e) {  // such as a default that its own range does not hold
    std::string_view lines = e.what();
    while (!lines.empty()) {
      const std::size_t end = std::min(lines.find('\n'), lines.size());
      diagnostics.error(value.where, std::string(lines.substr(0, end)));
      lines.remove_prefix(std::min(end + 1, lines.size()));
      lines.remove_prefix(std::min(lines.find_first_not_of(' '), lines.size()));
    }
    return std::nullopt;
  }
}

}  // namespace eyrie::ubf
