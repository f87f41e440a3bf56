// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "scenario/catalog.hpp"

namespace eyrie::scenario {
namespace {

constexpr std::array kGroups{std::pair{ubf::Kind::behavior, "Behaviors: recommend an action"},
                             std::pair{ubf::Kind::condition, "Conditions: answer a question"},
                             std::pair{ubf::Kind::arbiter, "Arbiters: choose among proposals"},
                             std::pair{ubf::Kind::control, "Control nodes: choose who is asked"},
                             std::pair{ubf::Kind::decorator, "Decorators: change one child"}};

}  // namespace

std::string catalog_text(const Catalog& catalog) {
  std::size_t width = 0;
  for (const ubf::NodeInfo& node : catalog.nodes)
    width = std::max(width, node.name.size());
  for (const ModelKind& kind : catalog.models)
    width = std::max(width, kind.folder.size());

  std::string text;
  const auto line = [&](std::string_view name, std::string_view help) {
    fmt::format_to(std::back_inserter(text), "  {:<{}}  {}\n", name, width, help);
  };
  const auto node_line = [&](const ubf::NodeInfo& node) {
    line(node.name,
         node.origin == "eyrie" ? node.help : fmt::format("{} (of {})", node.help, node.origin));
  };
  for (const auto& [kind, title] : kGroups) {
    text += std::string(title) + "\n";
    for (const ubf::NodeInfo& node : catalog.nodes)
      if (node.kind == kind)
        node_line(node);
    text += "\n";
  }
  text += "State fields: compared by conditions in words, looked at by switch\n";
  for (const ubf::StateFieldInfo& field : catalog.fields)
    line(field.name, field.unit.si_symbol.empty()
                         ? std::string(field.help)
                         : fmt::format("{}, {}", field.unit.si_symbol, field.help));
  for (const OtherKind& kind : catalog.others) {
    text += fmt::format(
        "\nTrees of {}: what they have besides arbiters, control nodes and decorators\n",
        kind.plural);
    for (const ubf::NodeInfo& node : kind.nodes)
      node_line(node);
  }
  text += "\nModels: data/<kind>/<name>.yaml\n";
  for (const ModelKind& kind : catalog.models) {
    line(kind.folder, kind.help);
    std::vector<std::string> names = kind.names;
    for (std::string& name : names)
      if (const auto from = kind.origins.find(name); from != kind.origins.end())
        name += " of " + from->second;
    if (!names.empty())
      line("", fmt::format("({})", fmt::join(names, ", ")));
  }
  return text + "\nEvery parameter with its unit, range and default: eyrie catalog --markdown\n";
}

}  // namespace eyrie::scenario
