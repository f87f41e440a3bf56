// SPDX-License-Identifier: MIT
#include "ubf/node.hpp"

#include <algorithm>
#include <map>

#include "ubf/spec.hpp"

namespace eyrie::ubf {

std::vector<ParamValue> AnyNode::values() const {
  std::vector<ParamValue> all;
  if (type_->parameters)
    eyrie::detail::list_values(*type_->parameters, type_->object(const_cast<AnyNode&>(*this)), "",
                               all);
  return all;
}

std::optional<double> AnyNode::full_vote() const {
  for (const ParamValue& value : values())
    if (value.name == "vote")
      return value.number;
  return std::nullopt;
}

std::vector<std::string> AnyNode::problems() const {
  std::vector<std::string> problems;
  if (type_->parameters)
    eyrie::detail::check_values(*type_->parameters, type_->object(const_cast<AnyNode&>(*this)), "",
                                problems);
  if (type_ == &kAny)
    problems.push_back("has no type: nodes are made by make<...>()");
  if (vote_curve_)
    if (std::string own = vote_curve_->problem(); !own.empty())
      problems.push_back(std::move(own));
  if (!label_.empty())
    if (const auto wrong = label_problem(label_))
      problems.push_back("its label " + *wrong);
  const std::size_t count = children_.size(), slots = type_->child_keys.size();
  if (std::find(children_.begin(), children_.end(), nullptr) != children_.end())
    problems.push_back("a child is missing");
  else if (type_->grammar == Grammar::slots && count != slots)
    problems.push_back(fmt::format("takes exactly '{}', but has {} {}",
                                   fmt::join(type_->child_keys, "', '"), count,
                                   count == 1 ? "child" : "children"));
  else if (node_kind() >= Kind::arbiter && count == 0)
    problems.push_back("needs at least one child");
  else if (std::string own = problem(); !own.empty())
    problems.push_back(std::move(own));
  return problems;
}

AnyTree::AnyTree(std::string name, std::unique_ptr<AnyNode> root)
    : name_(std::move(name)), root_(std::move(root)) {
  EYRIE_THROW_UNLESS(root_ != nullptr, "a tree needs a root");
  lay_out();
}

void AnyTree::lay_out() {
  nodes_.clear();
  memory_ = 0;
  place(*root_, kNone, 0);
  std::string refused;
  for (std::size_t i = 0; i < size(); ++i)
    for (const std::string& problem : nodes_[i].node->problems())
      refused += fmt::format("\n  {}: {}: {}", path(static_cast<NodeIndex>(i)),
                             nodes_[i].node->type(), problem);
  if (!refused.empty())
    throw std::logic_error(fmt::format("tree {} cannot be made{}", quote(name_), refused));
  // depends on the children, which stand behind their parents
  for (auto place = nodes_.rbegin(); place != nodes_.rend(); ++place)
    place->node->stands_ = place->node->stands();
}

void AnyTree::place(AnyNode& node, NodeIndex parent, std::size_t depth) {
  EYRIE_THROW_UNLESS(depth < kMaxDepth, "the tree is deeper than 64 levels");
  EYRIE_THROW_UNLESS(nodes_.size() < kMaxNodes, "the tree has more than 65535 nodes");
  node.index_ = static_cast<NodeIndex>(nodes_.size());
  nodes_.push_back({&node, parent, static_cast<std::uint16_t>(depth)});
  node.memory_begin_ = static_cast<std::uint32_t>(memory_);
  memory_ += slab_bytes(node.memory_bytes());
  EYRIE_THROW_UNLESS(memory_ <= kMaxMemory, "the tree needs more than 1 MiB per agent");
  for (const auto& child : node.children())
    if (child)
      place(*child, node.index_, depth + 1);
  std::map<std::string_view, std::vector<NodeIndex>> alike;
  for (const auto& child : node.children())
    if (child)
      alike[child->label()].push_back(child->index());
  for (const auto& [label, siblings] : alike)
    for (std::size_t i = 0; siblings.size() > 1 && i < siblings.size(); ++i)
      nodes_[siblings[i]].among = static_cast<NodeIndex>(i);
  node.end_index_ = static_cast<NodeIndex>(nodes_.size());
  node.memory_end_ = static_cast<std::uint32_t>(memory_);
}

std::string AnyTree::path(NodeIndex index) const {
  if (index == 0)
    return "root";
  return path_below(path(nodes_[index].parent), index);
}

std::string AnyTree::path_below(std::string above, NodeIndex index) const {
  const Place& it = nodes_[index];
  above += '/';
  above += it.node->label();
  return it.among == kNone ? above : fmt::format("{}[{}]", above, it.among);
}

std::optional<NodeIndex> AnyTree::find(std::string_view path) const {
  for (std::size_t i = 0; i < size(); ++i)
    if (this->path(static_cast<NodeIndex>(i)) == path)
      return static_cast<NodeIndex>(i);
  return std::nullopt;
}

std::vector<std::string> AnyTree::paths() const {
  std::vector<std::string> all;
  for (std::size_t i = 0; i < size(); ++i)
    all.push_back(i == 0 ? "root" : path_below(all[nodes_[i].parent], static_cast<NodeIndex>(i)));
  return all;
}

void AnyTree::put(std::string_view path, std::unique_ptr<AnyNode> by) {
  const std::optional<NodeIndex> at = find(path);
  if (!at)
    throw std::logic_error(fmt::format("tree {} has no node {}{}", quote(name_), quote(path),
                                       did_you_mean(path, paths())));
  EYRIE_THROW_UNLESS(by != nullptr, "a child is missing");
  if (by->label_.empty())
    by->set_label(std::string(node(*at).label()));
  std::unique_ptr<AnyNode>* place = &root_;
  while (*at > (*place)->index()) {
    auto& children = (*place)->children_;
    place = &*std::ranges::find_if(children,
                                   [&](const auto& child) { return child->end_index() > *at; });
  }
  place->swap(by);
  try {
    lay_out();
  } catch (...) {
    place->swap(by);
    lay_out();
    throw;
  }
}

}  // namespace eyrie::ubf
