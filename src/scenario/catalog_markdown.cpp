// SPDX-License-Identifier: MIT
#include <fmt/ranges.h>

#include "core/text.hpp"
#include "core/units.hpp"
#include "scenario/catalog.hpp"
#include "ubf/spec.hpp"

namespace eyrie::scenario {
namespace {

constexpr std::string_view kHead =
    "# Reference\n"
    "\n"
    "<!-- Generated from the program's own descriptions; do not edit. Make it anew with\n"
    "     ./eyrie catalog --markdown > docs/reference.md -->\n"
    "\n"
    "What files may say: every key, node, model and parameter, as this program reads them. The\n"
    "same as a JSON schema for editors: `./eyrie catalog --json-schema`.\n"
    "\n"
    "A quantity is a number and its unit, `6000 ft`; only 0 may go without. Degrees are `30 deg` "
    "or\n"
    "`30°`. A parameter that is not given has its default; where that is `null`, the meaning says\n"
    "what then happens.\n"
    "`[]` in a name stands for each item of a list.\n";

constexpr std::string_view kModels =
    "\nA model is a file `data/<kind>/<name>.yaml`, or stands in a scenario or an included file\n"
    "under `data: {<kind>: {<name>: {...}}}`, which wins over a file of that name. In both,\n"
    "`base: <name>` takes from another model of the kind what this one does not say (also what\n"
    "is required), and `source:` is free text on where the numbers come from.\n"
    "\n"
    "A table is written `{mach: [0, 0.9], value: [0.02, 0.03]}`; one over two variables has a\n"
    "row of values per breakpoint of the first. `units: {altitude: ft, value: lbf}` gives a\n"
    "whole axis its unit.\n";

constexpr std::string_view kTrees =
    "\nEach entry of `trees` is a node. A node is a name, a name with its parameters, or a name\n"
    "with its children:\n"
    "\n"
    "```yaml\n"
    "trees:\n"
    "  one: navigate                             # without parameters\n"
    "  two: {navigate: {speed: 480 kt}}\n"
    "  three: {winner_takes_all: [navigate, {tree: two}]}   # a copy of another tree\n"
    "  four: {winner_takes_all: {vote: 3, children: [navigate, egress]}}\n"
    "  five: {inverter: bingo}                   # a decorator with its child\n"
    "  six: {guard: {when: range < 10 nmi and not threatened, child: pursue}}   # a condition in "
    "words\n"
    "  seven:                                    # a tree with parameters\n"
    "    parameters: {vote: 40, near: }          # without a default it must be given\n"
    "    root: {guard: {when: range < $near, child: {pursue: {vote: $vote}}}}\n"
    "  eight: {tree: {seven: {near: 10 nmi}}}    # a copy of it, with arguments\n"
    "  nine: !tree one                           # the same as {tree: one}\n"
    "```\n"
    "\n"
    "Every node may also have a `name`, which reports and traces show.\n";

constexpr char kOtherTrees[] =
    "\n## Trees of {}\n\n"
    "A tree of a {} is made of the arbiters, control nodes and decorators above and of these. One\n"
    "of what several kinds of players have, such as `navigate`, serves them all.\n";

constexpr char kOtherFields[] =
    "\n### State fields of {}\n\n| field | unit | meaning |\n|---|---|---|\n";

constexpr std::string_view kFields =
    "\n### State fields\n"
    "\n"
    "What a condition in words compares, and what `switch` looks at. Comparisons are `<`, `<=`,\n"
    "`>`, `>=`, `==` and `!=` with a quantity or another field; a flag stands alone; `not`, "
    "`and`,\n"
    "`or` and parentheses put them together. Every comparison with a field that has no value now,\n"
    "such as the range of no target, is false. `{tree: {name: {fields: {theirs: ours}}}}` gives\n"
    "the fields other names in one copy of a tree.\n"
    "\n"
    "| field | unit | meaning |\n|---|---|---|\n";

constexpr std::string_view kSequencer =
    "\n```yaml\n"
    "sequencer:\n"
    "  start: ingress                            # required\n"
    "  trees: {ingress: {tree: ingress}, egress: egress}    # required: nodes by name\n"
    "  transitions:                              # asked in this order, at most one per tick\n"
    "    - {from: ingress, to: egress, when: bingo}         # `from: any` is every tree\n"
    "```\n";

/// Helps begin small; here each begins a sentence.
std::string sentence(std::string text) {
  if (!text.empty())
    text[0] = to_capital(text[0]);
  return text + ".";
}

std::string cell(std::string_view text) {
  std::string result;
  for (const char c : text)
    result += c == '|' ? std::string("\\|") : std::string(1, c);
  return result;
}

class Writer {
 public:
  explicit Writer(const Catalog& catalog) : catalog_(catalog) {}

  std::string write() {
    text_ += kHead;
    text_ += "\n## Scenario file\n";
    for (const FilePart& part : catalog_.file)
      file_part(part);
    text_ += "\n## Trees\n";
    text_ += kTrees;
    for (const NodeSection& section : kNodeSections)
      nodes(section);
    text_ += kFields;
    fields(catalog_.fields);
    for (const OtherKind& kind : catalog_.others) {
      add(kOtherTrees, kind.plural, kind.group);
      for (const ubf::NodeInfo& node : kind.nodes)
        node_entry(node);
      add(kOtherFields, kind.plural);
      fields(kind.fields);
    }
    text_ += "\n## Models\n";
    text_ += kModels;
    for (const ModelKind& kind : catalog_.models)
      model(kind);
    units();
    return std::move(text_);
  }

 private:
  template <class... Args>
  void add(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Args>(args)...);
  }

  void table(std::span<const ParamInfo> parameters) {
    if (parameters.empty())
      return;
    text_ += "\n| parameter | what | range | default | meaning |\n|---|---|---|---|---|\n";
    each_parameter(parameters, [&](const std::string& path, const ParamInfo& info) {
      const std::string by_default = default_text(info);
      const bool code = !by_default.empty() && by_default != "required" && by_default != "empty";
      add("| `{}` | {} | {} | {} | {} |\n", path, cell(kind_text(info)), cell(range_text(info)),
          code ? "`" + cell(by_default) + "`" : by_default, cell(info.help));
    });
  }

  void file_part(const FilePart& part) {
    if (part.path.empty())
      add("\n### Top level\n\n{}\n", sentence(part.help));
    else
      add("\n### {}\n\n`{}`: {}.\n", part.name, part.path, part.help);
    table(part.parameters);
  }

  void nodes(const NodeSection& section) {
    add("\n### {}\n\n{}\n", section.title, section.help);
    for (const ubf::NodeInfo& node : catalog_.nodes) {
      if (node.kind == section.kind)
        node_entry(node);
    }
  }
  void node_entry(const ubf::NodeInfo& node) {
    add("\n#### {}\n\n{}{}\n", node.name, sentence(node.help), children(node));
    if (node.origin != "eyrie")
      add("\nFrom the plug-in `{}`.\n", node.origin);
    if (is_sequencer(node))
      text_ += kSequencer;
    table(node.parameters);
  }
  void fields(std::span<const ubf::StateFieldInfo> all) {
    for (const ubf::StateFieldInfo& field : all)
      add("| `{}` | {} | {} |\n", field.name,
          field.kind == ubf::FieldKind::flag     ? "flag"
          : field.kind == ubf::FieldKind::choice ? fmt::format("{}", fmt::join(field.choices, ", "))
                                                 : std::string(shown_symbol(field.unit.dimension)),
          field.help);
  }
  static bool is_sequencer(const ubf::NodeInfo& node) {
    return std::ranges::equal(node.child_keys, ubf::kSequencerKeys);
  }
  static std::string children(const ubf::NodeInfo& node) {
    if (node.child_keys.empty() || is_sequencer(node))
      return {};
    std::string keys;
    for (const std::string& key : node.child_keys)
      keys += fmt::format("{}`{}`",
                          keys.empty()                       ? ""
                          : node.child_keys[0] == "children" ? " or "
                                                             : ", ",
                          key);
    return fmt::format(" Below it: {}.", keys);
  }

  void model(const ModelKind& kind) {
    add("\n### {}\n\n`data/{}/<name>.yaml`: {}.\n", kind.type_name, kind.folder, kind.help);
    if (!kind.names.empty())
      add("\nThere are `{}`.\n", fmt::join(kind.names, "`, `"));
    for (const auto& [name, origin] : kind.origins)
      add("\n`{}` is from the plug-in `{}`.\n", name, origin);
    table(kind.parameters);
  }

  void units() {
    text_ += "\n## Units\n\n| what | units, the first is SI |\n|---|---|\n";
    for (std::size_t i = 0; i < eyrie::units().size(); ++i) {
      const Dimension dimension = eyrie::units()[i].dimension;
      if (i > 0 && eyrie::units()[i - 1].dimension == dimension)
        continue;
      add("| {} |", dimension_word(dimension));
      for (const UnitInfo& unit : eyrie::units())
        if (unit.dimension == dimension)
          add(" `{}`", unit.symbol);
      text_ += " |\n";
    }
  }

  const Catalog& catalog_;
  std::string text_;
};

}  // namespace

std::string catalog_markdown(const Catalog& catalog) {
  return Writer(catalog).write();
}

}  // namespace eyrie::scenario
