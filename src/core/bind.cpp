// SPDX-License-Identifier: MIT
#include "core/bind.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <vector>

#include "core/check_values.hpp"
#include "core/text.hpp"

namespace eyrie::detail {
namespace {

void report(const Value& value, const ParamInfo& info, std::string_view message,
            Diagnostics& diagnostics) {
  diagnostics.error(value.where, fmt::format("{}: {}", info.name, message));
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  return first == text.npos ? "" : text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// A quantity that only rounding keeps from a limit is at the limit: 90 deg is half of pi.
double snapped(double x, const ParamInfo& info) {
  if (info.unit.dimension == Dimension::none)
    return x;
  for (const double limit : {info.limits.min, info.limits.max})
    if (std::fabs(x - limit) <= 2 * std::numeric_limits<double>::epsilon() * std::fabs(limit) &&
        std::isfinite(limit))
      return limit;
  return x;
}

/// A number as written, without the quotes but cut like quote() if it is absurdly long.
std::string as_written(const Value& value) {
  const std::string quoted = quote(trimmed(value.text));
  return quoted.substr(1, quoted.size() - 2);
}

bool check_range(double x, const Value& value, const ParamInfo& info, Diagnostics& diagnostics) {
  if (info.limits.contains(x))
    return true;
  report(value, info,
         fmt::format("{} is {}", as_written(value), limits_text(info.limits, info.unit.dimension)),
         diagnostics);
  return false;
}

/// A plain number in quotes is a text; a quantity is a text for YAML anyway.
std::string shown(const Value& value) {
  return value.is_scalar() && value.quoted ? value.shown() + " in quotes" : value.shown();
}

std::string prefix(std::string_view path) {
  return path.empty() ? "" : fmt::format("{}: ", path);
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
  const auto show = [&](double x) { return exact_quantity(x, dimension); };
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

bool check_keys(const Value& map, std::string_view type_name, std::string_view path,
                std::span<const std::string_view> names,
                std::span<const std::string_view> also_allowed, Diagnostics& diagnostics) {
  if (map.is_null())
    return true;
  if (!map.is_map()) {
    diagnostics.error(map.where, fmt::format("{}: expected a map, got {}",
                                             path.empty() ? type_name : path, map.shown()));
    return false;
  }
  std::vector<std::string_view> allowed(names.begin(), names.end());
  allowed.insert(allowed.end(), also_allowed.begin(), also_allowed.end());
  for (const Value::Entry& entry : map.entries)
    if (std::find(allowed.begin(), allowed.end(), entry.key) == allowed.end())
      diagnostics.error(entry.where,
                        fmt::format("{}{} has no parameter {}{}", prefix(path), type_name,
                                    quote(entry.key), did_you_mean(entry.key, allowed)));
  return true;
}

void report_missing(const Value& map, std::string_view type_name, std::string_view path,
                    std::string_view name, Diagnostics& diagnostics) {
  diagnostics.error(map.where,
                    fmt::format("{}{} needs the parameter '{}'", prefix(path), type_name, name));
}

bool read_number(double& out, const Value& value, const ParamInfo& info, Diagnostics& diagnostics) {
  const Dimension dimension = info.unit.dimension;
  if (!value.is_scalar() || (value.quoted && dimension == Dimension::none)) {
    report(value, info,
           fmt::format("expected {} such as '{}', got {}", dimension_noun(dimension),
                       dimension_example(dimension), shown(value)),
           diagnostics);
    return false;
  }
  const Parsed parsed = parse_quantity(value.text, dimension);
  if (!parsed) {
    report(value, info, parsed.error, diagnostics);
    return false;
  }
  const double x = snapped(parsed.value, info);
  if (!check_range(x, value, info, diagnostics))
    return false;
  out = x;
  return true;
}

bool read_float(float& out, const Value& value, const ParamInfo& info, Diagnostics& diagnostics) {
  double wide = 0;
  if (!read_number(wide, value, info, diagnostics))
    return false;
  if (std::fabs(wide) > double(std::numeric_limits<float>::max())) {
    report(value, info, fmt::format("{} is too large for this parameter", as_written(value)),
           diagnostics);
    return false;
  }
  out = static_cast<float>(wide);
  return true;
}

bool read_boolean(bool& out, const Value& value, const ParamInfo& info, Diagnostics& diagnostics) {
  const bool plain = value.is_scalar() && !value.quoted;
  if (!plain || (value.text != "true" && value.text != "false")) {
    report(value, info, "expected true or false, got " + shown(value), diagnostics);
    return false;
  }
  out = value.text == "true";
  return true;
}

bool read_integer(bool& negative, std::uint64_t& magnitude, const Value& value, WholeLimits type,
                  const ParamInfo& info, Diagnostics& diagnostics) {
  std::string_view digits = trimmed(value.text);
  negative = digits.starts_with('-');
  if (negative || digits.starts_with('+'))
    digits.remove_prefix(1);
  const auto [end, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), magnitude);
  const bool whole = value.is_scalar() && !value.quoted && !digits.empty() &&
                     end == digits.data() + digits.size() && error != std::errc::invalid_argument;
  if (!whole) {
    report(value, info, "expected a whole number, got " + shown(value), diagnostics);
    return false;
  }
  const std::uint64_t lowest = 0 - static_cast<std::uint64_t>(type.min);
  if (error != std::errc{} || magnitude > (negative ? lowest : type.max)) {
    report(value, info,
           fmt::format("{} is outside [{}, {}]", as_written(value), type.min, type.max),
           diagnostics);
    return false;
  }
  const double x = negative ? -static_cast<double>(magnitude) : static_cast<double>(magnitude);
  return check_range(x, value, info, diagnostics);
}

bool read_text(std::string& out, const Value& value, const ParamInfo& info,
               Diagnostics& diagnostics) {
  if (!value.is_scalar()) {
    report(value, info, "expected a text, got " + value.shown(), diagnostics);
    return false;
  }
  // a block of YAML ends in a line break
  const std::string_view text =
      std::string_view(value.text).substr(0, value.text.size() - value.text.ends_with('\n'));
  const std::size_t longest = std::min(info.max_items, kLongestText), size = characters(text);
  std::string problem;
  if (const auto held = text_problem(text))
    problem = fmt::format("{} holds {}", quote(text), *held);
  else if (size < info.min_items ||
           (info.min_items > 0 && text.find_first_not_of(' ') == text.npos))
    problem = "expected a text, got " + quote(text);
  else if (size > longest)
    problem = fmt::format("{} has {} characters, at most {} fit", quote(text), size, longest);
  if (problem.empty())
    out = text;
  else
    report(value, info, problem, diagnostics);
  return problem.empty();
}

bool read_choice(std::size_t& out, const Value& value, std::span<const std::string_view> names,
                 const ParamInfo& info, Diagnostics& diagnostics) {
  const auto found =
      value.is_scalar() ? std::find(names.begin(), names.end(), value.text) : names.end();
  if (found == names.end()) {
    const std::string hint = value.is_scalar() ? did_you_mean(value.text, names) : "";
    report(value, info,
           fmt::format("expected {}{}, got {}{}", names.size() > 1 ? "one of " : "",
                       fmt::join(names, ", "), value.shown(), hint),
           diagnostics);
    return false;
  }
  out = static_cast<std::size_t>(found - names.begin());
  return true;
}

bool check_list(const Value& value, std::size_t least, std::size_t most, const ParamInfo& info,
                Diagnostics& diagnostics) {
  if (!value.is_list()) {
    report(value, info, "expected a list, got " + value.shown(), diagnostics);
    return false;
  }
  const std::size_t size = value.items.size();
  if (size >= least && size <= most)
    return true;
  const bool exact = least == most;
  const std::size_t bound = size < least ? least : most;
  report(value, info,
         fmt::format("expected {} {} {}, got {}",
                     exact          ? "exactly"
                     : size < least ? "at least"
                                    : "at most",
                     bound, bound == 1 ? "item" : "items", size),
         diagnostics);
  return false;
}

ParamInfo item_info(const ParamInfo& list, std::size_t index) {
  ParamInfo item;
  item.name = fmt::format("{}[{}]", list.name, index);
  item.unit = list.unit;
  item.limits = list.limits;
  return item;
}

}  // namespace eyrie::detail
