// SPDX-License-Identifier: MIT
#include "campaign/factor.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <map>

#include "core/bind.hpp"
#include "core/math.hpp"
#include "core/text.hpp"
#include "scenario/path.hpp"

namespace eyrie::campaign {
namespace {

struct Between {
  static constexpr std::string_view type_name = "distribution";
  static constexpr auto params() {
    return Lines{param("low", &Between::low, "least value").required(),
                 param("high", &Between::high, "greatest value").required()};
  }
  std::string low, high;
};
struct Around {
  static constexpr std::string_view type_name = "distribution";
  static constexpr auto params() {
    return Lines{param("mean", &Around::mean, "mean value").required(),
                 param("deviation", &Around::deviation, "standard deviation").required()};
  }
  std::string mean, deviation;
};
struct Steps {
  static constexpr std::string_view type_name = "range";
  static constexpr auto params() {
    return Lines{
        param("from", &Steps::from, "first value").required(),
        param("to", &Steps::to, "last value").required(),
        param("count", &Steps::count, range(2, 1000), "how many, equally far apart").required()};
  }
  std::string from, to;
  std::uint32_t count = 2;
};

/// "2.5 nmi"
struct Number {
  double value = 0;
  std::string unit;
};
std::optional<Number> number_in(std::string_view text) {
  Number number;
  const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), number.value);
  if (failed != std::errc{} || !std::isfinite(number.value))
    return std::nullopt;
  number.unit = std::string_view(end, text.data() + text.size());
  number.unit.erase(0, number.unit.find_first_not_of(' '));
  if (!number.unit.empty() && !find_unit(number.unit))
    return std::nullopt;
  return number;
}
/// In six digits, or more where those would tell no 10,000 values of such a `width` apart.
std::string text_of(double value, const std::string& unit, double width) {
  const double times = std::abs(value / width);
  int digits = 6;
  for (double least = 100; times >= least && digits < 17; least *= 10)
    ++digits;
  return fmt::format("{:.{}g}{}{}", value, digits, unit.empty() ? "" : " ", unit);
}

/// The same for "1 nmi" and "1852 m", and for "3 s" and "3.0 s".
std::string meaning_of(const std::string& text) {
  const std::optional<Number> number = number_in(text);
  if (!number)
    return text;
  const UnitInfo* const unit = find_unit(number->unit);
  return fmt::format("{:.12g} {}", unit ? to_si(number->value, *unit) : number->value,
                     dimension_noun(unit ? unit->dimension : Dimension::none));
}

std::string in_quotes(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text)
    if (c == '"' || c == '\\')
      quoted += {'\\', c};
    else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
      quoted += fmt::format("\\x{:02x}", c);
    else
      quoted += c;
  return quoted + '"';
}

std::vector<std::string> sets_to(const std::string& value, const std::vector<std::string>& paths) {
  return listed(paths, [&](const std::string& path) { return path + "=" + value; });
}

class Reader {
 public:
  Reader(const Value::Entry& entry, Diagnostics& diagnostics)
      : value_(entry.value), diagnostics_(diagnostics) {
    factor_.name = entry.key;
    factor_.where = entry.where;
  }

  Factor read() {
    static constexpr std::array<std::string_view, 3> kKeys{"path", "values", "levels"};
    if (!detail::check_keys(value_, "factor", factor_.name, kKeys, {}, diagnostics_))
      return std::move(factor_);
    const Value* const path = value_.find("path");
    const Value* const values = value_.find("values");
    const Value* const levels = value_.find("levels");
    if (levels ? path || values : !path || !values)
      error(value_.where, "a factor has 'path' and 'values', or 'levels' alone");
    else if (levels)
      named(*levels, [&](const Value& v) { return texts(v, "path=value"); });
    else if ((factor_.paths = texts(*path, "a path")).empty())
      return std::move(factor_);
    else if (values->is_map() && values->tag.empty())
      named(*values, [&](const Value& v) { return sets_to(yaml_text(v), factor_.paths); });
    else if (values->tag.empty() || values->tag == "!choice")
      listed(*values);
    else
      tagged(*values);
    return std::move(factor_);
  }

 private:
  template <class... T>
  void error(const Location& where, fmt::format_string<T...> words, T&&... values) {
    diagnostics_.error(where, "{}: {}", factor_.name,
                       fmt::format(words, std::forward<T>(values)...));
  }
  /// One text or several.
  std::vector<std::string> texts(const Value& v, std::string_view what) {
    std::vector<std::string> all;
    for (const Value& item : v.is_list() ? std::span(v.items) : std::span(&v, 1)) {
      const bool set = scenario::path_size(item.text) < item.text.size();
      if (item.is_scalar() && !item.text.empty() && set == (what == "path=value"))
        all.push_back(item.text);
      else
        error(item.where, "expected {}, got {}", what, item.shown());
    }
    if (v.is_list() && v.items.empty())
      error(v.where, "expected {}, got an empty list", what);
    return all;
  }
  template <class Sets>
  void named(const Value& map, Sets sets_of) {
    if (!map.is_map() || map.entries.size() < 2)
      return error(map.where, "expected a map of two levels or more, got {}",
                   map.is_map() ? "a smaller one" : map.shown());
    for (const Value::Entry& e : map.entries)
      factor_.levels.push_back({e.key, sets_of(e.value), e.where});
  }
  void level(const std::string& text, const Location& where) {
    const auto [same, is_new] = known_.emplace(meaning_of(text), text);
    if (!is_new)
      error(where, "{} is there twice{}", quote(text),
            same->second == text ? "" : ", first as " + quote(same->second));
    else
      factor_.levels.push_back({text, sets_to(text, factor_.paths), where});
  }
  void listed(const Value& list) {
    if (!list.is_list() || list.items.size() < 2)
      return error(list.where, "expected a list of two values or more, got {}",
                   list.is_list() ? "a shorter one" : list.shown());
    for (const Value& item : list.items)
      level(yaml_text(item), item.where);
  }
  /// Two numbers of one unit.
  std::optional<std::pair<Number, Number>> numbers(const Value& map, std::string_view a,
                                                   std::string_view b) {
    std::array<Number, 2> both;
    for (const auto& [number, key] : {std::pair{&both[0], a}, std::pair{&both[1], b}}) {
      const Value& v = *map.find(key);
      const auto read = number_in(v.text);
      if (!read)
        error(v.where, "{}: expected a number and its unit such as '2.5 nmi', got {}", key,
              v.shown());
      if (!read)
        return std::nullopt;
      *number = *read;
    }
    if (both[0].unit != both[1].unit) {
      error(map.find(b)->where, "{} and {} must be in one unit", a, b);
      return std::nullopt;
    }
    return std::pair{both[0], both[1]};
  }
  void tagged(const Value& map) {
    using Kind = Distribution::Kind;
    if (map.tag == "!range") {
      Steps steps;
      const auto ends = bind(steps, map, diagnostics_) ? numbers(map, "from", "to") : std::nullopt;
      for (std::uint32_t i = 0; ends && i < steps.count; ++i) {
        const double share = static_cast<double>(i) / (steps.count - 1);
        const double width = ends->second.value - ends->first.value;
        level(text_of(ends->first.value + share * width, ends->first.unit, width), map.where);
      }
    } else if (map.tag == "!uniform" || map.tag == "!log_uniform") {
      Between ends;
      const bool log = map.tag == "!log_uniform";
      if (const auto both =
              bind(ends, map, diagnostics_) ? numbers(map, "low", "high") : std::nullopt) {
        const auto& [low, high] = *both;
        if (low.value >= high.value)
          error(map.find("high")->where, "high must be more than low");
        else if (log && low.value <= 0)
          error(map.find("low")->where, "low must be more than 0");
        factor_.distribution = {log ? Kind::log_uniform : Kind::uniform, low.value, high.value,
                                low.unit};
      }
    } else if (map.tag == "!normal") {
      Around around;
      if (const auto both =
              bind(around, map, diagnostics_) ? numbers(map, "mean", "deviation") : std::nullopt) {
        const auto& [mean, deviation] = *both;
        if (deviation.value <= 0)
          error(map.find("deviation")->where, "deviation must be more than 0");
        factor_.distribution = {Kind::normal, mean.value, deviation.value, mean.unit};
      }
    } else {
      static constexpr std::array<std::string_view, 5> kTags{"!choice", "!range", "!uniform",
                                                             "!log_uniform", "!normal"};
      error(map.where, "there is no {}, only {}", quote(map.tag), fmt::join(kTags, ", "));
    }
  }

  const Value& value_;
  Diagnostics& diagnostics_;
  Factor factor_;
  std::map<std::string, std::string> known_;  ///< levels without names, by what they mean
};

}  // namespace

double Distribution::quantile(double u) const {
  switch (kind) {
    case Kind::uniform:
      return first + u * (second - first);
    case Kind::log_uniform:
      return first * math::exp(u * math::log(second / first));
    case Kind::normal:
      break;
  }
  return first + second * normal_quantile(u);
}

std::string Factor::value_at(double u) const {
  if (distribution)
    return text_of(distribution->quantile(u), distribution->unit, distribution->width());
  const auto level = static_cast<std::size_t>(u * static_cast<double>(levels.size()));
  return levels[std::min(level, levels.size() - 1)].name;
}

std::vector<std::string> Factor::sets_of(const std::string& value) const {
  for (const Level& level : levels)
    if (level.name == value)
      return level.sets;
  return sets_to(value, paths);
}

std::set<std::string> Factor::all_paths() const {
  std::set<std::string> all(paths.begin(), paths.end());
  for (const Level& level : levels)
    for (const std::string& set : level.sets)
      all.insert(set.substr(0, scenario::path_size(set)));
  return all;
}

std::vector<Factor> read_factors(const Value& map, Diagnostics& diagnostics) {
  if (!map.is_map()) {
    diagnostics.error(map.where, "factors: expected a map, got " + map.shown());
    return {};
  }
  std::vector<Factor> factors;
  for (const Value::Entry& e : map.entries)
    if (const auto problem = identifier_problem(e.key))
      diagnostics.error(e.where, *problem);
    else
      factors.push_back(Reader(e, diagnostics).read());
  return factors;
}

std::string yaml_text(const Value& value) {
  std::vector<std::string> parts;
  for (const Value& item : value.items)
    parts.push_back(yaml_text(item));
  for (const Value::Entry& e : value.entries)
    parts.push_back(
        fmt::format("{}: {}", is_identifier(e.key) ? e.key : in_quotes(e.key), yaml_text(e.value)));
  const std::string tag = value.tag.empty() ? "" : value.tag + " ";
  switch (value.kind) {
    case Value::Kind::null:
      return tag + "null";
    case Value::Kind::list:
      return fmt::format("{}[{}]", tag, fmt::join(parts, ", "));
    case Value::Kind::map:
      return fmt::format("{}{{{}}}", tag, fmt::join(parts, ", "));
    case Value::Kind::scalar:
      break;
  }
  // in a list or map these characters would be taken for its own
  const bool plain = !value.quoted && value.text.find_first_of(",[]{}") == value.text.npos;
  return tag + (plain ? value.text : in_quotes(value.text));
}

double normal_quantile(double u) {
  const auto over = [](double x, const std::array<double, 8>& p, const std::array<double, 8>& q) {
    double above = p[7], below = q[7];
    for (int i = 6; i >= 0; --i) {
      above = above * x + p[static_cast<std::size_t>(i)];
      below = below * x + q[static_cast<std::size_t>(i)];
    }
    return above / below;
  };
  const double q = u - 0.5;
  if (std::abs(q) <= 0.425)
    return q * over(0.180625 - q * q,
                    {3.3871328727963666080e0, 1.3314166789178437745e+2, 1.9715909503065514427e+3,
                     1.3731693765509461125e+4, 4.5921953931549871457e+4, 6.7265770927008700853e+4,
                     3.3430575583588128105e+4, 2.5090809287301226727e+3},
                    {1, 4.2313330701600911252e+1, 6.8718700749205790830e+2,
                     5.3941960214247511077e+3, 2.1213794301586595867e+4, 3.9307895800092710610e+4,
                     2.8729085735721942674e+4, 5.2264952788528545610e+3});
  const double r = std::sqrt(-math::log(q < 0 ? u : 1 - u));
  const double x =
      r <= 5
          ? over(r - 1.6,
                 {1.42343711074968357734e0, 4.63033784615654529590e0, 5.76949722146069140550e0,
                  3.64784832476320460504e0, 1.27045825245236838258e0, 2.41780725177450611770e-1,
                  2.27238449892691845833e-2, 7.74545014278341407640e-4},
                 {1, 2.05319162663775882187e0, 1.67638483018380384940e0, 6.89767334985100004550e-1,
                  1.48103976427480074590e-1, 1.51986665636164571966e-2, 5.47593808499534494600e-4,
                  1.05075007164441684324e-9})
          : over(r - 5,
                 {6.65790464350110377720e0, 5.46378491116411436990e0, 1.78482653991729133580e0,
                  2.96560571828504891230e-1, 2.65321895265761230930e-2, 1.24266094738807843860e-3,
                  2.71155556874348757815e-5, 2.01033439929228813265e-7},
                 {1, 5.99832206555887937690e-1, 1.36929880922735805310e-1,
                  1.48753612908506148525e-2, 7.86869131145613259100e-4, 1.84631831751005468180e-5,
                  1.42151175831644588870e-7, 2.04426310338993978564e-15});
  return q < 0 ? -x : x;
}

}  // namespace eyrie::campaign
