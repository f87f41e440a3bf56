// SPDX-License-Identifier: MIT
#pragma once
/// \file  Candidate commands: `{heading: {from: 0 deg, to: 360 deg, steps: 36, reach: 60 deg}}`.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "core/angle.hpp"
#include "core/bind.hpp"
#include "core/check_values.hpp"
#include "core/math.hpp"
#include "ubf/action_traits.hpp"

namespace eyrie::ubf {

namespace detail {

/// The axis of field number I, as a file writes it.
template <class Action, std::size_t I>
struct FieldAxis {
  static constexpr std::string_view type_name = "axis";
  [[nodiscard]] static constexpr auto params() {
    constexpr Unit kUnit = std::get<I>(ActionTraits<Action>::fields).unit;
    return std::tuple{
        param("from", &FieldAxis::from, kUnit, range(-1e9, 1e9), "the first candidate").required(),
        param("to", &FieldAxis::to, kUnit, range(-1e9, 1e9),
              "the last one; of a whole circle the first again")
            .required(),
        param("steps", &FieldAxis::steps, range(2, 360), "how many candidates").required(),
        param("reach", &FieldAxis::reach, kUnit, positive(1e9),
              "what a child asks for is worth 1, and so far from it -1")
            .required(),
        param("spread", &FieldAxis::spread, kUnit, range(0, 1e9),
              "standard deviation of what comes of a command (for utility)")};
  }
  double from = 0, to = 0, reach = 1, spread = 0;
  std::uint32_t steps = 2;
};

}  // namespace detail

/// A grid over one to three fields of an action that are numbers; its points are the candidates.
template <class Action>
class Grid {
 public:
  static constexpr std::size_t kMostAxes = 3, kMostCandidates = 1024, kMostSteps = 360;

  struct Axis {
    std::size_t field = 0;  ///< of the action
    double from = 0, to = 0, step = 0, reach = 1;
    double deviation = 0;  ///< of what comes of a command
    std::size_t steps = 0;
    bool is_direction = false, is_circle = false;
    /// The probability that the outcome lies k steps off the command, k = 0, 1 ...; the same to
    /// both sides. Only {1} without a spread.
    std::vector<double> spread{1};

    [[nodiscard]] double at(std::size_t i) const {
      const double x = from + static_cast<double>(i) * step;
      return is_direction ? wrap_tau(x) : x;
    }
    /// 1 at what is asked for, falling to -1 at `reach` and beyond.
    [[nodiscard]] double worth(double candidate, double asked) const {
      const double away =
          is_direction ? std::fabs(wrap_pi(candidate - asked)) : std::fabs(candidate - asked);
      return 1 - 2 * std::fmin(1, away / reach);
    }
  };

  [[nodiscard]] const std::vector<Axis>& axes() const { return axes_; }
  [[nodiscard]] std::size_t size() const {
    std::size_t n = axes_.empty() ? 0 : 1;
    for (const Axis& axis : axes_)
      n *= axis.steps;
    return n;
  }
  [[nodiscard]] bool has(std::size_t field) const {
    for (const Axis& axis : axes_)
      if (axis.field == field)
        return true;
    return false;
  }

  /// Adds an axis; says in words what is wrong with it, or nothing.
  std::string add(std::string_view name, double from, double to, std::size_t steps, double reach,
                  double spread = 0) {
    std::string problem = fmt::format("an action has no field {}{}", quote(name),
                                      did_you_mean(name, field_names<Action>()));
    for_each_field<Action>([&](const auto& f, auto i) {
      if (f.name != name)
        return;
      const detail::FieldAxis<Action, i> said{from, to, reach, spread,
                                              static_cast<std::uint32_t>(steps)};
      std::vector<std::string> wrong;
      check_values(said, fmt::format("{}.", name), wrong);
      problem = wrong.empty() ? add_field<std::remove_cvref_t<decltype(f)>>(
                                    name, i, {from, to, reach, spread, said.steps})
                              : wrong.front();
    });
    return problem;
  }
  /// Reads one axis and adds it.
  void read(const Value::Entry& entry, Diagnostics& diagnostics) {
    const std::size_t before = diagnostics.count();
    detail::FieldAxis<Action, 0> said;
    for_each_field<Action>([&](const auto& f, auto i) {
      if (f.name != entry.key)
        return;
      detail::FieldAxis<Action, i> axis;
      bind(axis, entry.value, diagnostics);
      said.from = axis.from, said.to = axis.to, said.steps = axis.steps;
      said.reach = axis.reach, said.spread = axis.spread;
    });
    if (diagnostics.count() != before)
      return;
    const std::string problem =
        add(entry.key, said.from, said.to, said.steps, said.reach, said.spread);
    if (!problem.empty())
      diagnostics.error(entry.where, problem);
  }

  /// Sets the fields of the grid to those of a candidate.
  void set(std::size_t candidate, Action& action) const {
    for (const Axis& axis : axes_) {
      set_number(action, axis.field, axis.at(candidate % axis.steps));
      candidate /= axis.steps;
    }
  }

 private:
  template <class Field>
  std::string add_field(std::string_view name, std::size_t field,
                        const detail::FieldAxis<Action, 0>& said) {
    constexpr bool kDirection = Field::is_direction;
    if (!Field::is_real)
      return fmt::format("{} is not a number and has no candidates", quote(name));
    if (has(field))
      return fmt::format("there are two axes {}", quote(name));
    if (axes_.size() == kMostAxes)
      return fmt::format("a grid has at most {} axes", kMostAxes);
    if (!(said.to > said.from))
      return fmt::format("{}: 'to' must be greater than 'from'", quote(name));
    Axis axis{.field = field,
              .from = said.from,
              .to = said.to,
              .reach = said.reach,
              .deviation = said.spread,
              .steps = said.steps};
    axis.is_direction = kDirection;
    const double width = said.to - said.from;
    if (kDirection && width > kTau * (1 + 1e-9))
      return fmt::format("{}: more than a whole circle", quote(name));
    axis.is_circle = kDirection && width > kTau * (1 - 1e-9);
    axis.step = width / static_cast<double>(axis.is_circle ? said.steps : said.steps - 1);
    set_spread(axis);
    axes_.push_back(std::move(axis));
    if (size() <= kMostCandidates)
      return {};
    const std::size_t candidates = size();
    axes_.pop_back();
    return fmt::format("the grid has {} candidates, the most is {}", candidates, kMostCandidates);
  }
  static void set_spread(Axis& axis) {
    if (!(axis.deviation > 0))
      return;
    const double in_steps = axis.deviation / axis.step;
    const auto farthest = static_cast<std::size_t>(
        std::fmin(std::ceil(3 * in_steps), static_cast<double>((axis.steps - 1) / 2)));
    double total = 1;
    for (std::size_t k = 1; k <= farthest; ++k) {
      const double x = static_cast<double>(k) / in_steps;
      axis.spread.push_back(math::exp(-0.5 * x * x));
      total += 2 * axis.spread.back();
    }
    for (double& p : axis.spread)
      p /= total;
  }

  std::vector<Axis> axes_;
};

/// Says in references what it is.
template <class Action>
void describe_value(ParamInfo& info, const Grid<Action>&) {
  info.type_name = "candidates by field";
}
/// Reads a map from fields to axes (core/bind.hpp).
template <class Action>
void bind_value(Grid<Action>& out, const Value& value, Diagnostics& diagnostics,
                const ParamInfo& info) {
  if (!value.is_map()) {
    diagnostics.error(value.where, fmt::format("{}: expected a map from fields to candidates, got "
                                               "{}",
                                               info.name, value.shown()));
    return;
  }
  for (const Value::Entry& entry : value.entries)
    out.read(entry, diagnostics);
}

/// Says the axes in their order (core/check_values.hpp): "grid.heading.from".
template <class Action>
void list_parts(const Grid<Action>& grid, const std::string& name,
                std::vector<ParamValue>& values) {
  for (const auto& axis : grid.axes()) {
    const auto put = [&](std::string_view part, double value) {
      values.push_back(
          {fmt::format("{}.{}.{}", name, field_names<Action>()[axis.field], part), value});
    };
    put("from", axis.from);
    put("to", axis.to);
    put("steps", static_cast<double>(axis.steps));
    put("reach", axis.reach);
    if (axis.deviation > 0)
      put("spread", axis.deviation);
  }
}

}  // namespace eyrie::ubf
