// SPDX-License-Identifier: MIT
#include "ubf/control/branch.hpp"

namespace eyrie::ubf {
namespace {

/// The value of a field that a case names, or nothing after reporting.
std::optional<double> value_of(const StateFieldInfo& field, const Value::Entry& e,
                               NodeReader& reader) {
  if (field.kind == FieldKind::number) {
    const Parsed parsed = parse_quantity(e.key, field.unit.dimension);
    const std::string problem = parsed ? never(field, field.name, parsed.value, e.key)
                                       : fmt::format("{}: {}", field.name, parsed.error);
    if (problem.empty())
      return parsed.value;
    return reader.diagnostics().error(e.where, problem);
  }
  static constexpr std::array<std::string_view, 2> kTruth{"false", "true"};
  const std::span<const std::string_view> choices =
      field.kind == FieldKind::flag ? std::span<const std::string_view>(kTruth) : field.choices;
  const auto choice = std::ranges::find(choices, e.key);
  if (choice != choices.end())
    return static_cast<double>(choice - choices.begin());
  return reader.diagnostics().error(e.where, "{} is never {}{}", quote(field.name), quote(e.key),
                                    did_you_mean(e.key, choices));
}

}  // namespace

SwitchSpec read_switch(const NodeSpec& spec, NodeReader& reader) {
  SwitchSpec read;
  const Value* name = spec.body->find("on");
  if (name && name->is_scalar())
    read.field = reader.field(*name);
  const Value* cases = spec.body->find("cases");
  if (!cases || !cases->is_map() || cases->entries.empty()) {
    reader.diagnostics().error(cases ? cases->where : spec.where,
                               "switch needs 'cases', a map from values to nodes");
    return read;
  }
  for (const Value::Entry& e : cases->entries) {
    if (read.field)
      if (const auto value = value_of(reader.info(*read.field), e, reader)) {
        if (std::ranges::find(read.values, *value) != read.values.end())
          reader.diagnostics().error(e.where, "there are two cases {}", quote(e.key));
        read.values.push_back(*value);
      }
    if (auto child = reader.read(e.value))
      read.children.push_back(std::move(child));
  }
  if (const Value* other = spec.body->find("default"))
    if (auto child = reader.read(*other))
      read.children.push_back(std::move(child));
  return read;
}

}  // namespace eyrie::ubf
