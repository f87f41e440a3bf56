// SPDX-License-Identifier: MIT
#include "ubf/registry.hpp"

#include <algorithm>
#include <exception>

#include "core/text.hpp"

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

/// What nodes of BehaviorTree.CPP, py_trees and the Unreal Engine are here, by their names without
/// letter case and underscores.
constexpr std::array<std::pair<std::string_view, std::string_view>, 27> kElsewhere{{
    {"alwaysfail", "always_failure"},
    {"alwayssucceed", "always_success"},
    {"asyncfallback", "selector_with_memory"},
    {"asyncsequence", "sequence_with_memory"},
    {"eternalguard", "guard"},
    {"failure", "always_failure"},
    {"failureissuccess", "force_success"},
    {"fallback", "selector"},
    {"keeprunninguntilfailure", "repeat"},
    {"loopdouble", "for_each"},
    {"loopint", "for_each"},
    {"oneshot", "run_once"},
    {"precondition", "guard"},
    {"reactivefallback", "selector"},
    {"reactivesequence", "sequence"},
    {"retryuntilsuccessful", "retry"},
    {"runningisfailure", "force_failure"},
    {"runningissuccess", "force_success"},
    {"scriptcondition", "holds"},
    {"simpleparallel", "parallel"},
    {"sleep", "wait"},
    {"subtree", "tree"},
    {"success", "always_success"},
    {"successisfailure", "force_failure"},
    {"timelimit", "timeout"},
    {"timer", "wait"},
    {"whiledoelse", "while"},
}};

}  // namespace

void AnyRegistry::mark_standard() {
  for (NodeInfo& info : infos_)
    info.standard = true;
}

const NodeInfo* AnyRegistry::find(std::string_view name) const {
  const auto found = by_name_.find(name);
  return found == by_name_.end() ? nullptr : &infos_[found->second];
}

std::string AnyRegistry::did_you_mean(std::string_view wrong) const {
  if (wrong == "SequenceWithMemory")  // goes on after a failure there
    return "; did you mean 'sequence_with_memory', which starts anew after a failure?";
  if (wrong == "Sequence" || wrong == "Fallback")  // resume there, and start anew here
    return fmt::format("; did you mean '{0}', or, as in BehaviorTree.CPP, '{0}_with_memory'?",
                       wrong == "Sequence" ? "sequence" : "selector");
  std::string plain;
  for (const char c : wrong)
    if (c != '_')
      plain += to_small(c);
  for (const auto& [theirs, ours] : kElsewhere)
    if (plain == theirs && (find(ours) || ours == kTreeReference))
      return fmt::format("; did you mean '{}'?", ours);
  std::vector<std::string> names = listed(infos_, &NodeInfo::name);
  names.insert(names.begin(), std::string(kTreeReference));
  return eyrie::did_you_mean(wrong, names);
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
