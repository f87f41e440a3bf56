// SPDX-License-Identifier: MIT
#include <fmt/ranges.h>

#include "core/bind.hpp"
#include "core/units.hpp"
#include "scenario/catalog.hpp"

namespace eyrie::scenario {

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
  for (const auto& [kind, title, help] : kNodeSections) {
    text += fmt::format("{}: {}\n", title, help);
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

namespace {

/// Beyond this a limit is only that of the integer type, and says nothing to people.
constexpr double kLargestSaid = 1e9;

std::string items_text(const ParamInfo& list) {
  const ParamInfo& item = list.children.front();
  const std::string what = item.kind == ParamKind::group ? "maps" : kind_text(item) + "s";
  constexpr std::size_t kAny = std::numeric_limits<std::size_t>::max();
  if (list.min_items == list.max_items)
    return fmt::format("list of {} {}", list.min_items, what);
  if (list.max_items != kAny)
    return fmt::format("list of {} to {} {}", list.min_items, list.max_items, what);
  return list.min_items ? fmt::format("list of at least {} {}", list.min_items, what)
                        : "list of " + what;
}

std::string table_text(const ParamInfo& table) {
  std::string text;
  for (const TableAxis& axis : table.axes)
    text += (text.empty() ? "" : " and ") + std::string(axis.name);
  return fmt::format("table of {}s over {}", dimension_word(table.unit.dimension), text);
}

}  // namespace

std::string_view dimension_word(Dimension dimension) {
  const std::string_view noun = dimension_noun(dimension);
  return noun.substr(noun.find(' ') + 1);
}

std::string kind_text(const ParamInfo& info) {
  switch (info.kind) {
    case ParamKind::number:
      return info.unit.dimension == Dimension::none
                 ? "number"
                 : std::string(dimension_word(info.unit.dimension));
    case ParamKind::integer:
      return "whole number";
    case ParamKind::boolean:
      return "true or false";
    case ParamKind::text:
      return "text";
    case ParamKind::choice:
      return fmt::format("one of {}", fmt::join(info.choices, ", "));
    case ParamKind::list:
      return items_text(info);
    case ParamKind::table1:
    case ParamKind::table2:
      return table_text(info);
    case ParamKind::group:
      return "map";
    case ParamKind::custom:
      break;
  }
  return info.type_name;
}

std::string range_text(const ParamInfo& info) {
  if (info.kind == ParamKind::text)
    return info.max_items <= kLongestText
               ? fmt::format("{} to {} characters", info.min_items, info.max_items)
               : "";
  const Range& limits = info.limits;
  const auto show = [&](double x) { return exact_quantity(x, info.unit.dimension); };
  const bool low = std::isfinite(limits.min) && limits.min > -kLargestSaid;
  const bool high = std::isfinite(limits.max) && limits.max < kLargestSaid;
  if (low && high && limits.min == limits.max)
    return "only " + show(limits.min);
  if (low && high && limits.exclusive_min)
    return fmt::format("above {}, to {}", show(limits.min), show(limits.max));
  if (low && high)
    return fmt::format("{} to {}", show(limits.min), show(limits.max));
  if (low)
    return fmt::format("{} {}", limits.exclusive_min ? "above" : "at least", show(limits.min));
  return high ? "at most " + show(limits.max) : "";
}

std::string default_text(const ParamInfo& info) {
  if (info.required)
    return "required";
  return info.kind == ParamKind::text && info.default_text.empty() ? "empty" : info.default_text;
}

void each_parameter(std::span<const ParamInfo> parameters,
                    const std::function<void(const std::string&, const ParamInfo&)>& visit,
                    const std::string& prefix) {
  for (const ParamInfo& info : parameters) {
    const std::string path = prefix + info.name;
    visit(path, info);
    if (info.kind == ParamKind::group)
      each_parameter(info.children, visit, path + ".");
    else if (info.kind == ParamKind::list && info.children.front().kind == ParamKind::group)
      each_parameter(info.children.front().children, visit, path + "[].");
  }
}

}  // namespace eyrie::scenario
