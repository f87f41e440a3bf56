// SPDX-License-Identifier: MIT
#include "core/bind.hpp"

#include <algorithm>
#include <charconv>

#include "core/text.hpp"

namespace eyrie::detail {
namespace {

/// False, as what is told of is wrong.
template <class... T>
bool report(Diagnostics& diagnostics, const Value& value, const ParamInfo& info,
            fmt::format_string<T...> words, T&&... values) {
  diagnostics.error(value.where, "{}: {}", info.name,
                    fmt::format(words, std::forward<T>(values)...));
  return false;
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
  return quoted.substr(1, quoted.rfind('\'') - 1);
}

/// What its help says of null, for who writes -1 to say "no limit".
std::string_view null_instead(const ParamInfo& info) {
  const std::size_t at = std::min(info.help.find("null: "), info.help.size());
  return std::string_view(info.help).substr(at);
}

bool check_range(double x, const Value& value, const ParamInfo& info, Diagnostics& diagnostics) {
  if (info.limits.contains(x))
    return true;
  const std::string_view instead = null_instead(info);
  return report(diagnostics, value, info, "{} is {}{}{}", as_written(value),
                limits_text(info.limits, info.unit.dimension), instead.empty() ? "" : "; ",
                instead);
}

/// A plain number in quotes is a text; a quantity is a text for YAML anyway.
std::string shown(const Value& value) {
  return value.is_scalar() && value.quoted ? value.shown() + " in quotes" : value.shown();
}

std::string prefix(std::string_view path) {
  return path.empty() ? "" : fmt::format("{}: ", path);
}

}  // namespace

bool check_keys(const Value& map, std::string_view type_name, std::string_view path,
                std::span<const std::string_view> names,
                std::span<const std::string_view> also_allowed, Diagnostics& diagnostics) {
  if (!map.is_map()) {
    diagnostics.error(map.where, "{}: expected a map, got {}", path.empty() ? type_name : path,
                      map.shown());
    return false;
  }
  std::vector<std::string_view> allowed(names.begin(), names.end());
  allowed.insert(allowed.end(), also_allowed.begin(), also_allowed.end());
  for (const Value::Entry& entry : map.entries)
    if (std::ranges::find(allowed, entry.key) == allowed.end())
      diagnostics.error(entry.where, "{}{} has no parameter {}{}", prefix(path), type_name,
                        quote(entry.key), nearest_or_all(entry.key, allowed));
  return true;
}

void report_missing(const Value& map, std::string_view type_name, std::string_view path,
                    std::string_view name, Diagnostics& diagnostics) {
  diagnostics.error(map.where, "{}{} needs the parameter '{}'", prefix(path), type_name, name);
}

bool read_number(double& out, const Value& value, const ParamInfo& info, Diagnostics& diagnostics) {
  const Dimension dimension = info.unit.dimension;
  if (!value.is_scalar() || (value.quoted && dimension == Dimension::none))
    return report(diagnostics, value, info, "expected {} such as '{}', got {}",
                  dimension_noun(dimension), dimension_example(dimension), shown(value));
  const Parsed parsed = parse_quantity(value.text, dimension);
  if (!parsed)
    return report(diagnostics, value, info, "{}", parsed.error);
  const double x = snapped(parsed.value, info);
  if (!check_range(x, value, info, diagnostics))
    return false;
  out = x + 0.0;  // -0 is 0
  return true;
}

bool check_list(const Value& value, std::size_t least, std::size_t most, const ParamInfo& info,
                Diagnostics& diagnostics) {
  if (!value.is_list())
    return report(diagnostics, value, info, "expected a list, got {}", value.shown());
  const std::size_t size = value.items.size();
  if (size >= least && size <= most)
    return true;
  const bool exact = least == most;
  const std::size_t bound = size < least ? least : most;
  return report(diagnostics, value, info, "expected {} {} {}, got {}",
                exact          ? "exactly"
                : size < least ? "at least"
                               : "at most",
                bound, bound == 1 ? "item" : "items", size);
}

ParamInfo item_info(const ParamInfo& list, std::size_t index) {
  ParamInfo item;
  item.name = fmt::format("{}[{}]", list.name, index);
  item.unit = list.unit;
  item.limits = list.limits;
  return item;
}

namespace {

bool read_boolean(std::uint64_t& out, const Value& value, const ParamInfo& info,
                  Diagnostics& diagnostics) {
  const bool plain = value.is_scalar() && !value.quoted;
  if (!plain || (value.text != "true" && value.text != "false"))
    return report(diagnostics, value, info, "expected true or false, got {}", shown(value));
  out = value.text == "true";
  return true;
}

bool read_integer(std::uint64_t& out, const ValueType& type, const Value& value,
                  const ParamInfo& info, Diagnostics& diagnostics) {
  std::string_view digits = trimmed(value.text);
  std::uint64_t magnitude = 0;
  const bool negative = digits.starts_with('-');
  if (negative || digits.starts_with('+'))
    digits.remove_prefix(1);
  const auto [end, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), magnitude);
  const bool whole = value.is_scalar() && !value.quoted && !digits.empty() &&
                     end == digits.data() + digits.size() && error != std::errc::invalid_argument;
  if (!whole)
    return report(diagnostics, value, info, "expected a whole number, got {}", shown(value));
  const double x = negative ? -static_cast<double>(magnitude) : static_cast<double>(magnitude);
  if (error == std::errc{} && !check_range(x, value, info, diagnostics))
    return false;
  const std::uint64_t lowest = 0 - static_cast<std::uint64_t>(type.least);
  if (error != std::errc{} || magnitude > (negative ? lowest : type.most)) {
    const auto [min, max, exclusive] = info.limits;
    const std::int64_t least = min > double(type.least) ? std::int64_t(min) : type.least;
    const std::uint64_t most = max < double(type.most) ? std::uint64_t(max) : type.most;
    return report(diagnostics, value, info, "{} is outside {}{}, {}]", as_written(value),
                  exclusive ? '(' : '[', least, most);
  }
  out = negative ? 0 - magnitude : magnitude;
  return true;
}

bool read_text(std::string& out, const Value& value, const ParamInfo& info,
               Diagnostics& diagnostics) {
  if (!value.is_scalar())
    return report(diagnostics, value, info, "expected a text, got {}", value.shown());
  // a block of YAML ends in a line break
  const std::string_view text =
      std::string_view(value.text).substr(0, value.text.size() - value.text.ends_with('\n'));
  const std::size_t longest = std::min(info.max_items, kLongestText), size = characters(text);
  std::string problem;
  if (size > longest)
    problem = fmt::format("{} has {} characters, at most {} fit", quote(text), size, longest);
  else if (const auto held = text_problem(text))
    problem = fmt::format("{} holds {}", quote(text), *held);
  else if (size < info.min_items ||
           (info.min_items > 0 && text.find_first_not_of(' ') == text.npos))
    problem = "expected a text, got " + quote(text);
  if (problem.empty())
    out = text;
  else
    report(diagnostics, value, info, "{}", problem);
  return problem.empty();
}

bool read_choice(std::uint64_t& out, const ValueType& type, const Value& value,
                 const ParamInfo& info, Diagnostics& diagnostics) {
  const std::span<const std::string_view> names = type.names;
  const auto found = value.is_scalar() ? std::ranges::find(names, value.text) : names.end();
  if (found == names.end()) {
    const std::string hint = value.is_scalar() ? did_you_mean(value.text, names) : "";
    return report(diagnostics, value, info, "expected {}{}, got {}{}",
                  names.size() > 1 ? "one of " : "", fmt::join(names, ", "), value.shown(), hint);
  }
  out = type.values[static_cast<std::size_t>(found - names.begin())];
  return true;
}

/// All parts, or none after a mistake in one of them.
bool read_parts(const ValueType& type, void* out, const Value& value, const ParamInfo& info,
                Diagnostics& diagnostics) {
  const std::size_t before = diagnostics.count();
  if (type.is_optional) {
    const auto fill = [&](void* part, std::size_t) {
      return read(*type.part, part, value, info, diagnostics);
    };
    // nothing at all is no null: a variable of a shell that is not set, a line that was forgotten
    type.build(out, value.is_null() && !value.text.empty() ? 0 : 1, fill);
    return diagnostics.count() == before;
  }
  const bool fixed = type.fixed != 0;
  if (!check_list(value, fixed ? type.fixed : info.min_items, fixed ? type.fixed : info.max_items,
                  info, diagnostics))
    return false;
  const std::size_t size = value.items.size();
  type.build(out, size, [&](void* part, std::size_t i) {
    read(*type.part, part, value.items[i], item_info(info, i), diagnostics);
    return i + 1 < size || diagnostics.count() == before;  // every mistake is told
  });
  return diagnostics.count() == before;
}

}  // namespace

bool read(const ValueType& type, void* out, const Value& value, const ParamInfo& info,
          Diagnostics& diagnostics) {
  const std::size_t before = diagnostics.count();
  if (!value.tag.empty())
    return report(diagnostics, value, info, "unexpected tag {}", quote(value.tag));
  std::uint64_t bits = 0;
  double number = 0;
  bool good = true;
  switch (type.kind) {
    case ParamKind::custom:
      type.bind(out, value, diagnostics, info);
      return diagnostics.count() == before;
    case ParamKind::text:
      return read_text(*static_cast<std::string*>(out), value, info, diagnostics);
    case ParamKind::table1:
      return read_table(*static_cast<Table1*>(out), value, info, diagnostics);
    case ParamKind::table2:
      return read_table(*static_cast<Table2*>(out), value, info, diagnostics);
    case ParamKind::list:
      return read_parts(type, out, value, info, diagnostics);
    case ParamKind::group:
      return bind(*type.group, out, value, info.name, diagnostics, {});
    case ParamKind::number:
      good = read_number(number, value, info, diagnostics);
      if (good && type.is_float && std::fabs(number) > double(std::numeric_limits<float>::max())) {
        report(diagnostics, value, info, "{} is too large for this parameter", as_written(value));
        good = false;
      }
      bits = std::bit_cast<std::uint64_t>(number);
      break;
    case ParamKind::integer:
      good = read_integer(bits, type, value, info, diagnostics);
      break;
    case ParamKind::boolean:
      good = read_boolean(bits, value, info, diagnostics);
      break;
    case ParamKind::choice:
      good = read_choice(bits, type, value, info, diagnostics);
      break;
  }
  if (good)
    type.store(out, bits);
  return good;
}

bool bind(const Description& type, void* out, const Value& map, std::string_view path,
          Diagnostics& diagnostics, std::span<const std::string_view> also_allowed) {
  const std::size_t before = diagnostics.count();
  std::vector<std::string_view> names;
  for (const Parameter& p : type.parameters)
    names.push_back(p.name);
  if (!check_keys(map, type.type_name, path, names, also_allowed, diagnostics))
    return false;
  for (const Parameter& p : type.parameters)
    if (const Value* value = map.find(p.name))
      read(*p.type, p.member(out), *value, brief_info(p, path), diagnostics);
    else if (p.is_required)
      report_missing(map, type.type_name, path, p.name, diagnostics);
  return diagnostics.count() == before;
}

}  // namespace eyrie::detail
