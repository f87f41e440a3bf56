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
                         : fmt::format("{}, {}", shown_symbol(field.unit.dimension), field.help));
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
  const std::string_view what = dimension_word(table.unit.dimension);
  return fmt::format("table of {}{} over {}", what, what.ends_with('s') ? "es" : "s", text);
}

/// As a file may write it: what it needs, and a few of its parameters as they are if nothing is
/// said.
std::string example(const ubf::NodeInfo& node) {
  constexpr std::size_t kFew = 3;
  constexpr std::array kOwn{
      // their defaults alone make no sense
      "commitment: {margin: 5, children: [navigate, follow_lead]}",
      "verify: {bounds: {altitude: {min: 1000 ft}}, fallback: true, children: [navigate, "
      "follow_lead]}",
      "sequencer: {start: ingress, trees: {ingress: navigate, fight: pursue}, transitions: "
      "[{from: ingress, to: fight, when: {hostile_track: {within: 40 nmi}}}]}",
      "switch: {on: rank, cases: {1: navigate, 2: follow_lead}, default: navigate}"};
  for (const std::string_view own : kOwn)
    if (own.starts_with(node.name + ":"))
      return std::string(own);
  std::vector<std::string> words;
  for (const ParamInfo& p : node.parameters) {
    const bool short_default = !p.default_text.empty() && p.default_text != "null";
    if (p.required)
      words.push_back(fmt::format("{}: <{}>", p.name, kind_text(p)));
    else if (short_default && words.size() < kFew && p.kind != ParamKind::list)
      words.push_back(fmt::format("{}: {}", p.name, p.default_text));
  }
  const bool many = std::ranges::find(node.child_keys, "children") != node.child_keys.end();
  const auto below = [](std::string_view key) {
    return key == "children"              ? "[navigate, follow_lead]"
           : key == "when" || key == "if" ? "range < 5 nmi"
           : key == "by"                  ? "pursue"
           : key == "else"                ? "follow_lead"
                                          : "navigate";
  };
  for (const std::string& key : node.child_keys)
    if (key != "child" || !many)
      words.push_back(fmt::format("{}: {}", key, below(key)));
  return words.empty() ? node.name : fmt::format("{}: {{{}}}", node.name, fmt::join(words, ", "));
}

std::string node_text(const ubf::NodeInfo& node, std::string_view trees_of) {
  std::size_t width = 0;
  each_parameter(node.parameters, [&](const std::string& path, const ParamInfo&) {
    width = std::max(width, path.size());
  });
  std::string text = fmt::format("{} ({}{}{}): {}\n", node.name, to_text(node.kind),
                                 trees_of.empty() ? "" : " in trees of ", trees_of, node.help);
  each_parameter(node.parameters, [&](const std::string& path, const ParamInfo& p) {
    std::string what = kind_text(p);
    if (const std::string range = range_text(p); !range.empty())
      what += ", " + range;
    if (const std::string value = default_text(p); !value.empty())
      what += (p.required ? ", " : ", default ") + value;
    fmt::format_to(std::back_inserter(text), "  {:<{}}  {} ({})\n", path, width, p.help, what);
  });
  return text + fmt::format("in a tree\n  {}\n", example(node));
}

template <class Visit>
void each_node(const Catalog& catalog, Visit visit) {
  for (const ubf::NodeInfo& node : catalog.nodes)
    visit(node, std::string_view());
  for (const OtherKind& kind : catalog.others)
    for (const ubf::NodeInfo& node : kind.nodes)
      visit(node, std::string_view(kind.plural));
}

}  // namespace

std::string_view dimension_word(Dimension dimension) {
  const std::string_view noun = dimension_noun(dimension);
  return noun.substr(noun.find(' ') + 1);
}

std::string_view shown_symbol(Dimension dimension) {
  for (const UnitInfo& unit : units())
    if (unit.dimension == dimension && unit.symbol.starts_with("°"))
      return unit.symbol;
  return Unit(dimension).si_symbol;
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
  const auto show = [&](double x) {
    const bool bare = x == 0 && info.unit.dimension != Dimension::temperature;
    return bare ? "0" : with_degree_signs(exact_quantity(x, info.unit.dimension));
  };
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
  if (info.kind == ParamKind::text)
    return info.default_text.empty() ? "empty" : info.default_text;
  return with_degree_signs(info.default_text);
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

std::optional<std::string> node_text(const Catalog& catalog, std::string_view name) {
  std::string text;
  each_node(catalog, [&](const ubf::NodeInfo& node, std::string_view trees_of) {
    if (node.name == name)
      text += (text.empty() ? "" : "\n") + node_text(node, trees_of);
  });
  return text.empty() ? std::nullopt : std::optional(text);
}

std::vector<std::string_view> node_names(const Catalog& catalog) {
  std::vector<std::string_view> names;
  each_node(catalog,
            [&](const ubf::NodeInfo& node, std::string_view) { names.push_back(node.name); });
  return names;
}

}  // namespace eyrie::scenario
