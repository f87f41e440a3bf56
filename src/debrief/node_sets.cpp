// SPDX-License-Identifier: MIT
#include "debrief/node_sets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>

#include "core/yaml.hpp"

namespace eyrie::debrief {
namespace {

/// The nodes of one tree by their paths, in pre-order.
using Paths = std::vector<std::string>;

/// Of the tree of that name, whoever uses it, or else nothing.
std::optional<Paths> paths_of(const scenario::Scenario& scenario, const std::string& name) {
  for (const auto& fleet : scenario.fleets)
    if (const ubf::TreeOutline* tree = ubf::find(fleet->trees, name)) {
      Paths paths;
      for (const ubf::NodeOutline& node : tree->nodes)
        paths.push_back(node.path);
      return paths;
    }
  return std::nullopt;
}

/// The tree that a player begins with.
std::string tree_of(const scenario::Scenario& scenario, PlayerId who) {
  const auto found = scenario.find(*scenario.start, who);
  if (!found)
    return "";
  const auto tree = found->fleet.agents->last_decision(*scenario.start, found->row).tree;
  return tree < found->fleet.trees.size() ? found->fleet.trees[tree].name : "";
}

class Reader {
 public:
  Reader(const scenario::Scenario& scenario, PlayerId who, const std::string& text,
         Diagnostics& diagnostics)
      : scenario_(scenario), who_(who), text_(text), diagnostics_(diagnostics) {}

  /// False if this is no path of a node.
  bool read(Overrides& out) {
    const std::size_t equals = text_.find('=');
    std::string path = text_.substr(0, equals);
    std::string tree;
    if (const std::size_t colon = path.find(':'); colon != std::string::npos) {
      tree = path.substr(0, colon);
      begin_ = colon + 1;
      path = path.substr(begin_);
    }
    if (equals == std::string::npos || !is_path(path))
      return false;
    if (tree.empty())
      tree = tree_of(scenario_, who_);
    const auto paths = paths_of(scenario_, tree);
    if (!paths) {
      error(0, fmt::format("there is no tree {}", quote(tree)));
      return true;
    }
    change(*paths, tree, path, equals, out);
    return true;
  }

 private:
  [[nodiscard]] static bool is_path(std::string_view path) {
    return path.substr(0, 4) == "root" && (path.size() == 4 || path[4] == '/' || path[4] == '.');
  }
  [[nodiscard]] Location at(std::size_t offset) const {
    return {"--set " + text_, 1, static_cast<int>(offset) + 1};
  }
  void error(std::size_t offset, std::string message) {
    diagnostics_.error(at(offset), std::move(message));
  }

  void change(const Paths& paths, const std::string& tree, const std::string& path,
              std::size_t equals, Overrides& out) {
    std::string node = path, key;
    auto found = std::find(paths.begin(), paths.end(), node);
    const std::size_t point = path.rfind('.');
    if (found == paths.end() && point != std::string::npos) {
      node = path.substr(0, point);
      key = path.substr(point + 1);
      found = std::find(paths.begin(), paths.end(), node);
    }
    if (found == paths.end())
      return error(begin_, fmt::format("tree {} has no node {}{}", quote(tree), quote(node),
                                       did_you_mean(node, paths)));
    if (point != std::string::npos && node != path && key.empty())
      return error(begin_ + path.size(), "a parameter is missing behind the point");
    Diagnostics wrong;
    eyrie::Value value = eyrie::parse_yaml(text_.substr(equals + 1), "--set", wrong);
    if (!wrong.ok())
      return error(equals + 1, wrong.sorted().front().message);
    value.where = at(equals + 1);
    const auto index = static_cast<ubf::NodeIndex>(found - paths.begin());
    out.changes.push_back({tree,
                           {.node = index,
                            .key = key,
                            .value = std::move(value),
                            .where = at(begin_ + (key.empty() ? 0 : point + 1))}});
  }

  const scenario::Scenario& scenario_;
  PlayerId who_;
  const std::string& text_;
  Diagnostics& diagnostics_;
  std::size_t begin_ = 0;  ///< of the path
};

}  // namespace

Overrides read_overrides(const scenario::Scenario& scenario, PlayerId who,
                         const std::vector<std::string>& texts, Diagnostics& diagnostics) {
  Overrides out;
  for (const std::string& text : texts)
    if (!Reader(scenario, who, text, diagnostics).read(out))
      out.sets.push_back(text);
  return out;
}

}  // namespace eyrie::debrief
