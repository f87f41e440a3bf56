// SPDX-License-Identifier: MIT
#include "core/describe.hpp"

#include <algorithm>

#include "core/bind.hpp"

namespace eyrie {

const Parameter* Description::find(std::string_view name) const {
  const auto found = std::ranges::find(parameters, name, &Parameter::name);
  return found == parameters.end() ? nullptr : &*found;
}

namespace detail {
namespace {

double number_in(const ValueType& type, const void* value) {
  const std::uint64_t bits = type.load(value);
  if (type.kind == ParamKind::number)
    return std::bit_cast<double>(bits);
  return type.least < 0 ? static_cast<double>(static_cast<std::int64_t>(bits))
                        : static_cast<double>(bits);
}
/// "" if it is none of the choices.
std::string_view choice_in(const ValueType& type, const void* value) {
  const auto found = std::ranges::find(type.values, type.load(value));
  return found == type.values.end()
             ? ""
             : type.names[static_cast<std::size_t>(found - type.values.begin())];
}

/// A value as a file would write it.
std::string value_text(const ValueType& type, const void* value, Dimension dimension) {
  switch (type.kind) {
    case ParamKind::number: {
      const double x = number_in(type, value);
      return type.is_float ? exact_quantity(static_cast<float>(x), dimension)
                           : exact_quantity(x, dimension);
    }
    case ParamKind::integer: {
      const std::uint64_t bits = type.load(value);
      return type.least < 0 ? std::to_string(static_cast<std::int64_t>(bits))
                            : std::to_string(bits);
    }
    case ParamKind::boolean:
      return type.load(value) ? "true" : "false";
    case ParamKind::text:
      return *static_cast<const std::string*>(value);
    case ParamKind::choice:
      return std::string(choice_in(type, value));
    case ParamKind::list:
      break;
    default:
      return {};
  }
  if (type.is_optional)
    return type.size(value) ? value_text(*type.part, type.at(value, 0), dimension) : "null";
  std::string text;
  for (std::size_t i = 0; i < type.size(value); ++i)
    text += (text.empty() ? "" : ", ") + value_text(*type.part, type.at(value, i), dimension);
  return "[" + text + "]";
}

/// Fills in what follows from the type, and of groups the children; without a value as they are by
/// default.
void describe(ParamInfo& info, const ValueType& type, const void* value) {
  if (type.is_optional) {
    info.optional = true;
    describe(info, *type.part, value && type.size(value) ? type.at(value, 0) : nullptr);
    return;
  }
  info.kind = type.kind;
  if (type.kind == ParamKind::custom) {
    if (type.describe)
      type.describe(info, value);
  } else if (type.kind == ParamKind::integer) {
    info.limits.min = std::max(info.limits.min, static_cast<double>(type.least));
    info.limits.max = std::min(info.limits.max, static_cast<double>(type.most));
  } else if (type.kind == ParamKind::choice) {
    info.choices.assign(type.names.begin(), type.names.end());
  } else if (type.kind == ParamKind::list) {
    if (type.fixed != 0)
      info.min_items = info.max_items = type.fixed;
    ParamInfo item;
    item.unit = info.unit;
    item.limits = info.limits;
    describe(item, *type.part, nullptr);
    info.children.push_back(std::move(item));
  } else if (type.kind == ParamKind::group) {
    info.type_name = type.group->type_name;
    const std::shared_ptr<void> fresh = value ? nullptr : type.group->fresh();
    info.children = parameters(*type.group, value ? value : fresh.get());
  }
}

void append_word(std::string& out, std::uint64_t word) {
  for (int shift = 0; shift < 64; shift += 8)
    out.push_back(static_cast<char>(word >> shift));
}
void append_numbers(std::string& out, std::span<const double> numbers) {
  append_word(out, numbers.size());
  for (const double x : numbers)
    append_word(out, std::bit_cast<std::uint64_t>(x));
}
void check_value(const ValueType& type, const void* value, const ParamInfo& rule,
                 std::vector<std::string>& problems) {
  const bool is_number = type.kind == ParamKind::number || type.kind == ParamKind::integer;
  const bool is_vector = type.kind == ParamKind::list && !type.is_optional && type.fixed == 0;
  if (is_number) {
    const double x = number_in(type, value);
    if (!std::isfinite(x))
      problems.push_back(fmt::format("{} is {}", rule.name, x));
    else if (!rule.limits.contains(x))
      problems.push_back(fmt::format("{}: {} is {}", rule.name,
                                     with_degree_signs(exact_quantity(x, rule.unit.dimension)),
                                     limits_text(rule.limits, rule.unit.dimension)));
  } else if (type.kind == ParamKind::choice && choice_in(type, value).empty()) {
    problems.push_back(fmt::format("{} is none of its choices", rule.name));
  } else if (type.kind == ParamKind::text || is_vector) {
    const std::size_t size =
        is_vector ? type.size(value) : static_cast<const std::string*>(value)->size();
    if (size < rule.min_items || size > rule.max_items)
      problems.push_back(fmt::format("{} has {} {}, not {} to {}", rule.name, size,
                                     is_vector ? "items" : "characters", rule.min_items,
                                     rule.max_items));
  } else if (type.kind == ParamKind::group) {
    check_values(*type.group, value, rule.name + ".", problems);
  }
  if (type.kind == ParamKind::list)
    for (std::size_t i = 0; i < type.size(value); ++i)
      check_value(*type.part, type.at(value, i), type.is_optional ? rule : item_info(rule, i),
                  problems);
}

void list_value(const ValueType& type, const void* value, const std::string& name,
                Dimension dimension, std::vector<ParamValue>& values) {
  switch (type.kind) {
    case ParamKind::custom:
      if (type.list)
        type.list(value, name, values);
      return;
    case ParamKind::number:
    case ParamKind::integer:
      values.push_back({name, value_text(type, value, dimension), number_in(type, value)});
      return;
    case ParamKind::boolean:
    case ParamKind::text:
    case ParamKind::choice:
      values.push_back({name, value_text(type, value, dimension)});
      return;
    case ParamKind::group:
      list_values(*type.group, value, name + ".", values);
      return;
    case ParamKind::table1:
    case ParamKind::table2:
      return;
    case ParamKind::list:
      break;
  }
  if (type.is_optional) {
    if (type.size(value))
      list_value(*type.part, type.at(value, 0), name, dimension, values);
  } else if (type.part->load) {
    values.push_back({name, value_text(type, value, dimension)});
  }
}

}  // namespace

ParamInfo brief_info(const ParamLine& line, std::string_view path) {
  ParamInfo info;
  info.name = path.empty() ? std::string(line.name) : fmt::format("{}.{}", path, line.name);
  info.unit = line.unit;
  info.limits = line.limits;
  info.help = line.help;
  info.required = line.is_required;
  info.min_items = line.min_items;
  info.max_items = line.max_items;
  for (const TableAxis& axis : line.axes)
    if (!axis.name.empty())
      info.axes.push_back(axis);
  return info;
}

std::string limits_text(const Range& limits, Dimension dimension) {
  const auto show = [&](double x) { return with_degree_signs(exact_quantity(x, dimension)); };
  if (!std::isfinite(limits.min))
    return fmt::format("more than {}", show(limits.max));
  if (!std::isfinite(limits.max))
    return limits.exclusive_min ? limits.min == 0
                                      ? std::string("not positive")
                                      : fmt::format("not more than {}", show(limits.min))
                                : fmt::format("less than {}", show(limits.min));
  return fmt::format("outside {}{}, {}]", limits.exclusive_min ? '(' : '[', show(limits.min),
                     show(limits.max));
}

std::vector<ParamInfo> parameters(const Description& type, const void* defaults) {
  std::vector<ParamInfo> all;
  for (const Parameter& p : type.parameters) {
    ParamInfo& info = all.emplace_back(brief_info(p));
    if (!p.is_required)
      info.default_text = value_text(*p.type, p.of(defaults), info.unit.dimension);
    describe(info, *p.type, p.of(defaults));
  }
  return all;
}

void check_values(const Description& type, const void* object, std::string_view path,
                  std::vector<std::string>& problems, bool defaults) {
  for (const Parameter& p : type.parameters) {
    if (defaults && p.is_required)
      continue;
    ParamInfo rule = brief_info(p);
    rule.name.insert(0, path);
    check_value(*p.type, p.of(object), rule, problems);
  }
}

void list_values(const Description& type, const void* object, std::string_view path,
                 std::vector<ParamValue>& values) {
  for (const Parameter& p : type.parameters)
    list_value(*p.type, p.of(object), std::string(path).append(p.name), p.unit.dimension, values);
}

void append_bits(const ValueType& type, const void* value, std::string& out) {
  if (type.load) {
    append_word(out, type.load(value));
  } else if (type.kind == ParamKind::list) {
    append_word(out, type.size(value));
    for (std::size_t i = 0; i < type.size(value); ++i)
      append_bits(*type.part, type.at(value, i), out);
  } else if (type.kind == ParamKind::table1) {
    const auto& table = *static_cast<const Table1*>(value);
    append_numbers(out, table.breakpoints());
    append_numbers(out, table.values());
  } else if (type.kind == ParamKind::table2) {
    const auto& table = *static_cast<const Table2*>(value);
    append_numbers(out, table.rows().breakpoints());
    append_numbers(out, table.columns().breakpoints());
    append_numbers(out, table.values());
  } else if (type.kind == ParamKind::group) {
    for (const Parameter& p : type.group->parameters)
      append_bits(*p.type, p.of(value), out);
  } else {
    EYRIE_DEMAND(type.kind == ParamKind::text, "what is this parameter as bytes?");
  }
}

}  // namespace detail
}  // namespace eyrie
