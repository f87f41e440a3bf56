// SPDX-License-Identifier: MIT
#include "ubf/spec.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/text.hpp"
#include "ubf/expression.hpp"

namespace eyrie::ubf {
namespace {

const Value kNothing;

void refuse(const Value& value, Diagnostics& diagnostics) {
  diagnostics.error(value.where,
                    fmt::format("expected a node, such as 'navigate' or {{navigate: {{...}}}}, "
                                "got {}",
                                value.shown()));
}

}  // namespace

std::optional<NodeSpec> read_spec(const Value& value, Diagnostics& diagnostics) {
  if (value.tag == kTreeTag)
    return NodeSpec{std::string(kTreeReference), value.where, &value};
  switch (value.kind) {
    case Value::Kind::scalar:
      if (looks_like_expression(value.text))
        return NodeSpec{std::string(kHolds), value.where, &value};
      return NodeSpec{value.text, value.where, &kNothing};
    case Value::Kind::map:
      break;
    case Value::Kind::null:
    case Value::Kind::list:
      refuse(value, diagnostics);
      return std::nullopt;
  }
  if (value.entries.empty()) {
    refuse(value, diagnostics);
    return std::nullopt;
  }
  if (value.entries.size() > 1) {
    // most often the parameters are not indented far enough
    diagnostics.error(
        value.entries[1].where,
        fmt::format("a node is one name with its parameters below it, but beside {} there is {}; "
                    "a parameter must be indented further than its node",
                    quote(value.entries[0].key), quote(value.entries[1].key)));
    return std::nullopt;
  }
  const Value::Entry& only = value.entries.front();
  return NodeSpec{only.key, only.where, &only.value};
}

Value body_for_another_type(const Value& body) {
  if (!body.is_map())
    return body;
  Value kept = Value::map({}, body.where);
  for (const Value::Entry& e : body.entries)
    if (e.key == kLabelKey || e.key == "children" || e.key == "vote" || e.key == "vote_scale")
      kept.entries.push_back(e);
  return kept;
}

std::optional<std::string> label_problem(std::string_view label) {
  if (label.empty())
    return "must not be empty";
  if (label.find_first_of("/[]") != label.npos)
    return fmt::format("{} must not contain '/', '[' or ']'", quote(label));
  if (const auto held = text_problem(label))
    return fmt::format("{} holds {}", quote(label), *held);
  if (const std::size_t size = characters(label); size > kLongestLabel)
    return fmt::format("{} has {} characters, at most {} fit", quote(label), size, kLongestLabel);
  return std::nullopt;
}

std::string read_label(const Value& body, Diagnostics& diagnostics) {
  const Value* label = body.find(kLabelKey);
  if (!label)
    return {};
  if (!label->is_scalar()) {
    diagnostics.error(label->where, fmt::format("name: expected a text, got {}", label->shown()));
    return {};
  }
  if (const auto problem = label_problem(label->text)) {
    diagnostics.error(label->where, "name: " + *problem);
    return {};
  }
  return label->text;
}

std::optional<std::string> cycle_through(std::span<const std::string> open, std::string_view name) {
  const auto first = std::find(open.begin(), open.end(), name);
  if (first == open.end())
    return std::nullopt;
  std::string text = fmt::format("tree {} refers to itself: ", quote(name));
  for (auto tree = first; tree != open.end(); ++tree)
    text += *tree + " -> ";
  return text.append(name);
}

}  // namespace eyrie::ubf
