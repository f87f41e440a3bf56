// SPDX-License-Identifier: MIT
#pragma once
/// \file  Parameters of arbiters that speak of fields of an action: limits, candidates, a choice.
///
///   bounds: {altitude: {min: 1000 ft}, heading: {min: 350 deg, max: 20 deg}}
///   grid: {heading: {from: 0 deg, to: 360 deg, steps: 36, reach: 60 deg}}
///   direction: heading
#include "core/bind.hpp"
#include "ubf/action_traits.hpp"

namespace eyrie::ubf {

using ActionFields = std::span<const ActionFieldInfo>;

/// What an action must keep to. A field without limits, and one that is not set, passes. Limits
/// include their ends, in SI; those of a direction are an arc from `min` clockwise to `max`,
/// which is all of the circle if `max` is a turn or more above `min`.
class AnyBounds {
 public:
  explicit AnyBounds(ActionFields fields) : fields_(fields) {}

  [[nodiscard]] bool empty() const { return limits_.empty(); }
  /// Sets the limits of a field; says in words what is wrong with them, or nothing.
  std::string set(std::string_view name, std::optional<double> min, std::optional<double> max);

 protected:
  /// Which field that is set is not within its limits, as NaN is not: "refused: altitude ..."; null
  /// if there is none.
  [[nodiscard]] const char* why_not(const void* action) const;

 private:
  struct Limits {
    std::size_t field;
    std::optional<double> min, max;
    std::string refusal;
  };
  friend void bind_value(AnyBounds&, const Value&, Diagnostics&, const ParamInfo&);
  friend void list_parts(const AnyBounds&, const std::string& name, std::vector<ParamValue>&);

  ActionFields fields_;
  std::vector<Limits> limits_;
};
template <class Action>
class Bounds : public AnyBounds {
 public:
  Bounds() : AnyBounds(action_fields<Action>()) {}
  [[nodiscard]] bool hold(const Action& action) const { return !broken_by(action); }
  /// Why an action does not keep to them; null if it does.
  [[nodiscard]] const char* broken_by(const Action& action) const { return why_not(&action); }
};

/// A grid over one to three fields of an action that are numbers; its points are the candidates.
class AnyGrid {
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

  explicit AnyGrid(ActionFields fields) : fields_(fields) {}

  [[nodiscard]] const std::vector<Axis>& axes() const { return axes_; }
  [[nodiscard]] std::size_t size() const;
  [[nodiscard]] bool has(std::size_t field) const;
  /// Adds an axis; says in words what is wrong with it, or nothing.
  std::string add(std::string_view name, double from, double to, std::size_t steps, double reach,
                  double spread = 0);

 protected:
  ActionFields fields_;

 private:
  friend void bind_value(AnyGrid&, const Value&, Diagnostics&, const ParamInfo&);
  friend void list_parts(const AnyGrid&, const std::string& name, std::vector<ParamValue>&);
  std::string add_axis(std::size_t field, Axis axis);

  std::vector<Axis> axes_;
};
template <class Action>
class Grid : public AnyGrid {
 public:
  Grid() : AnyGrid(action_fields<Action>()) {}
  /// Puts the fields of a candidate into an action.
  void set(std::size_t candidate, Action& action) const {
    for (const Axis& axis : axes()) {
      fields_[axis.field].set(&action, axis.at(candidate % axis.steps));
      candidate /= axis.steps;
    }
  }
};

/// One of the fields of an action that are floating-point numbers and directions, or quantities on
/// a line, by its position; none at first.
class AnyFieldChoice {
 public:
  AnyFieldChoice(ActionFields fields, bool of_directions)
      : fields_(fields), of_directions_(of_directions) {}

  [[nodiscard]] std::optional<std::size_t> index() const { return index_; }
  /// False, and nothing changes, if there is no such field.
  bool choose(std::string_view name);
  [[nodiscard]] std::vector<std::string> names() const;
  [[nodiscard]] std::optional<double> get(const void* action) const {
    return index_ ? fields_[*index_].get(action) : std::nullopt;
  }
  void set(std::optional<double> value, void* action) const {
    if (index_)
      fields_[*index_].set(action, value);
  }

 private:
  friend void list_parts(const AnyFieldChoice&, const std::string&, std::vector<ParamValue>&);
  [[nodiscard]] bool fits(const ActionFieldInfo& field) const {
    return field.is_real && (of_directions_ ? field.is_direction : field.is_mean);
  }

  ActionFields fields_;
  bool of_directions_;
  std::optional<std::size_t> index_;
};
template <class Action, class Blend>
class FieldChoice : public AnyFieldChoice {
 public:
  FieldChoice() : AnyFieldChoice(action_fields<Action>(), std::is_same_v<Blend, blend::Angle>) {}
};

// How each is read (core/bind.hpp), what references say of it, and its parts (core/describe.hpp),
// such as "bounds.altitude.min".
void bind_value(AnyBounds& out, const Value&, Diagnostics&, const ParamInfo&);
void bind_value(AnyGrid& out, const Value&, Diagnostics&, const ParamInfo&);
void bind_value(AnyFieldChoice& out, const Value&, Diagnostics&, const ParamInfo&);
void describe_value(ParamInfo& info, const AnyBounds&);
void describe_value(ParamInfo& info, const AnyGrid&);
void describe_value(ParamInfo& info, const AnyFieldChoice& choice);
void list_parts(const AnyBounds&, const std::string& name, std::vector<ParamValue>& values);
void list_parts(const AnyGrid&, const std::string& name, std::vector<ParamValue>& values);
void list_parts(const AnyFieldChoice&, const std::string& name, std::vector<ParamValue>& values);

}  // namespace eyrie::ubf
