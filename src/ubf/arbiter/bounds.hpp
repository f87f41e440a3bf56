// SPDX-License-Identifier: MIT
#pragma once
/// \file  Limits on the fields of an action, written `{altitude: {min: 1000 ft}, speed: {...}}`.
#include <fmt/format.h>

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

#include "core/angle.hpp"
#include "core/bind.hpp"
#include "core/check_values.hpp"
#include "ubf/action_traits.hpp"

namespace eyrie::ubf {

namespace detail {

/// The limits of field number I, as a file writes them.
template <class Action, std::size_t I>
struct FieldLimits {
  static constexpr std::string_view type_name = "limits";
  [[nodiscard]] static constexpr auto params() {
    constexpr Unit kUnit = std::get<I>(ActionTraits<Action>::fields).unit;
    return std::tuple{
        param("min", &FieldLimits::min, kUnit, range(-1e9, 1e9), "least value that passes"),
        param("max", &FieldLimits::max, kUnit, range(-1e9, 1e9), "greatest value that passes")};
  }
  std::optional<double> min, max;
};

}  // namespace detail

/// What an action must keep to. A field without limits, and one that is not set, passes. Limits
/// include their ends, in SI; those of a direction are an arc from `min` clockwise to `max`,
/// which is all of the circle if `max` is a turn or more above `min`.
template <class Action>
class Bounds {
 public:
  /// Of one field.
  struct Limits {
    std::optional<double> min, max;

    [[nodiscard]] bool given() const { return min || max; }
    /// Of a direction: as from 0 to 360 degrees.
    [[nodiscard]] bool is_circle() const { return *max - *min >= kTau - 1e-9; }
    template <class Field>
    [[nodiscard]] bool contain(double x) const {
      if constexpr (Field::is_direction)
        return x == x && (is_circle() || wrap_tau(x - *min) <= wrap_tau(*max - *min));
      else
        return (!min || x >= *min) && (!max || x <= *max) && x == x;
    }
  };

  /// Whether every field that is set is within its limits. NaN is not.
  [[nodiscard]] bool hold(const Action& action) const {
    bool good = true;
    for_each_field<Action>([&](const auto& f, auto i) {
      using Field = std::remove_cvref_t<decltype(f)>;
      if constexpr (Field::is_number) {
        if (const auto& value = action.*f.member; value && limits_[i].given())
          good &= limits_[i].template contain<Field>(static_cast<double>(*value));
      }
    });
    return good;
  }
  [[nodiscard]] bool empty() const {
    for (const Limits& limits : limits_)
      if (limits.given())
        return false;
    return true;
  }
  [[nodiscard]] const Limits& limits(std::size_t field) const { return limits_[field]; }
  /// Sets the limits of a field; says in words what is wrong with them, or nothing.
  std::string set(std::string_view name, std::optional<double> min, std::optional<double> max) {
    std::string problem = fmt::format("an action has no field {}{}", quote(name),
                                      did_you_mean(name, field_names<Action>()));
    for_each_field<Action>([&](const auto& f, auto i) {
      if (f.name != name)
        return;
      problem = problem_with<std::remove_cvref_t<decltype(f)>>(name, min, max);
      if (problem.empty())
        limits_[i] = {min, max};
    });
    return problem;
  }
  /// Reads the limits of one field and sets them.
  void read(const Value::Entry& entry, Diagnostics& diagnostics) {
    const std::size_t before = diagnostics.count();
    std::optional<double> min, max;
    for_each_field<Action>([&](const auto& f, auto i) {
      if (f.name != entry.key)
        return;
      detail::FieldLimits<Action, i> limits;
      bind(limits, entry.value, diagnostics);
      min = limits.min;
      max = limits.max;
    });
    if (diagnostics.count() != before)
      return;
    if (std::string problem = set(entry.key, min, max); !problem.empty())
      diagnostics.error(entry.where, std::move(problem));
  }

 private:
  template <class Field>
  [[nodiscard]] static std::string problem_with(std::string_view name, std::optional<double> min,
                                                std::optional<double> max) {
    if (!Field::is_number)
      return fmt::format("{} is not a number and has no limits", quote(name));
    if (!min && !max)
      return fmt::format("{} needs a 'min' or a 'max'", quote(name));
    if (Field::is_direction && !(min && max))
      return fmt::format("{} is a direction and needs both 'min' and 'max'", quote(name));
    for (const auto& limit : {min, max})
      if (limit && !(*limit - *limit == 0))
        return fmt::format("{}: a limit is {}", quote(name), *limit);
    if (!Field::is_direction && min && max && *min > *max)
      return fmt::format("{}: 'min' is greater than 'max'", quote(name));
    return {};
  }

  std::array<Limits, kFields<Action>> limits_;
};

/// Says in references what it is.
template <class Action>
void describe_value(ParamInfo& info, const Bounds<Action>&) {
  info.type_name = "limits by field";
}
/// Reads a map from fields to limits (core/bind.hpp).
template <class Action>
void bind_value(Bounds<Action>& out, const Value& value, Diagnostics& diagnostics,
                const ParamInfo& info) {
  if (!value.is_map()) {
    diagnostics.error(value.where, fmt::format("{}: expected a map from fields to limits, got {}",
                                               info.name, value.shown()));
    return;
  }
  for (const Value::Entry& entry : value.entries)
    out.read(entry, diagnostics);
}

/// Says the limits (core/check_values.hpp): "bounds.altitude.min".
template <class Action>
void list_parts(const Bounds<Action>& bounds, const std::string& name,
                std::vector<ParamValue>& values) {
  for_each_field<Action>([&](const auto& f, auto i) {
    const auto& limits = bounds.limits(i);
    for (const auto& [end, limit] : {std::pair("min", limits.min), {"max", limits.max}})
      if (limit)
        values.push_back({fmt::format("{}.{}.{}", name, f.name, end), *limit});
  });
}

}  // namespace eyrie::ubf
