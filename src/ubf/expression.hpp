// SPDX-License-Identifier: MIT
#pragma once
/// \file  Small conditions in words: `range < 10 nmi and not inbound_missile`.
///
///   expression  = term { "or" term }
///   term        = factor { "and" factor }
///   factor      = "not" factor | "(" expression ")" | comparison | flag
///   comparison  = operand ("<" | "<=" | ">" | ">=" | "==" | "!=") operand
///   operand     = field | quantity | the name of a choice
///
/// A comparison with a field that has no value is false, whichever it is, "!=" too. What is needed
/// of the state is found when the file is read: a tick compares numbers and nothing else.
#include "core/value.hpp"
#include "ubf/action_traits.hpp"
#include "ubf/state_fields.hpp"

namespace eyrie::ubf {

namespace detail {

/// A step of an expression. There is one truth value: comparisons set it, the others turn it over
/// or skip what cannot change it any more.
enum class Op : std::uint8_t {
  less,
  less_equal,
  greater,
  greater_equal,
  equal,
  not_equal,
  flag,           ///< the left field is not 0
  negate,         ///< turn it over
  skip_if_false,  ///< go to `target` if it is false
  skip_if_true,   ///< go to `target` if it is true
};

/// A field of the platform, or a number in SI.
struct Operand {
  static constexpr std::uint32_t kNumber = ~0u;
  std::uint32_t field = kNumber;
  double number = 0;
};

struct Instruction {
  Op op = Op::flag;
  Operand left, right;
  std::uint32_t target = 0;
};

[[nodiscard]] constexpr bool compare(Op op, double a, double b) {
  switch (op) {
    case Op::less:
      return a < b;
    case Op::less_equal:
      return a <= b;
    case Op::greater:
      return a > b;
    case Op::greater_equal:
      return a >= b;
    case Op::equal:
      return a == b;
    case Op::not_equal:
      return a < b || a > b;  // not true of what has no value
    default:
      return false;
  }
}

}  // namespace detail

/// The steps of an expression, or nothing after reporting what is wrong with it.
[[nodiscard]] std::optional<std::vector<detail::Instruction>> parse_expression(
    const Value& text, std::span<const StateFieldInfo> fields, FieldNames& names,
    Diagnostics& diagnostics);

/// Whether a text in the place of a node is meant as an expression.
[[nodiscard]] bool looks_like_expression(std::string_view text);

namespace detail {

/// Runs the steps; `value(index)` reads a field.
template <class Value>
[[nodiscard]] bool run(const std::vector<Instruction>& program, Value value) {
  const auto number = [&](const Operand& o) {
    return o.field == Operand::kNumber ? o.number : value(o.field);
  };
  bool truth = false;
  for (std::size_t at = 0; at < program.size(); ++at) {
    const Instruction& i = program[at];
    switch (i.op) {
      case Op::negate:
        truth = !truth;
        break;
      case Op::skip_if_false:
        at = truth ? at : i.target - 1;
        break;
      case Op::skip_if_true:
        at = truth ? i.target - 1 : at;
        break;
      case Op::flag:
        truth = number(i.left) > 0;
        break;
      default:
        truth = compare(i.op, number(i.left), number(i.right));
    }
  }
  return truth;
}

}  // namespace detail

/// An expression over the fields of one platform's state.
template <class State>
class Expression {
 public:
  Expression() = default;
  explicit Expression(std::vector<detail::Instruction> program) : program_(std::move(program)) {}
  [[nodiscard]] bool empty() const { return program_.empty(); }

  [[nodiscard]] bool holds(const State& state) const {
    const StateField<State>* fields = StateFields<State>::all().data();
    return detail::run(program_, [&](std::uint32_t i) { return fields[i].read(state); });
  }

 private:
  std::vector<detail::Instruction> program_;
};

/// An expression over a state and an action that is proposed in it. Its fields are those of the
/// state and, as `action.altitude`, those of the action: numbers, directions in (-180°, 180°] as
/// those of states, whether a flag is true, and of everything else whether it is set. A number that
/// is not set has no value.
template <class State, class Action>
class ActionExpression {
 public:
  ActionExpression() = default;
  explicit ActionExpression(std::vector<detail::Instruction> program)
      : program_(std::move(program)) {}

  [[nodiscard]] bool holds(const State& state, const Action& action) const {
    const auto fields = StateFields<State>::all();
    return detail::run(program_, [&](std::uint32_t i) {
      return i < fields.size() ? fields[i].read(state) : read(action, i - fields.size());
    });
  }
  /// The fields that it may name; made once.
  [[nodiscard]] static std::span<const StateFieldInfo> fields() {
    static const Names kNames;
    return kNames.infos;
  }

 private:
  struct Names {
    std::vector<std::string> texts;
    std::vector<StateFieldInfo> infos = state_field_infos<State>();

    Names() {
      texts.reserve(kFields<Action>);
      for (const ActionFieldInfo& f : action_fields<Action>()) {
        texts.push_back("action." + std::string(f.name));
        infos.push_back({.name = texts.back(),
                         .kind = f.is_number ? FieldKind::number : FieldKind::flag,
                         .unit = f.unit,
                         .help = "of the proposal",
                         .limits = f.is_direction ? Range{-kPi, kPi, true} : Range{}});
      }
    }
  };
  [[nodiscard]] static double read(const Action& action, std::size_t field) {
    const ActionFieldInfo& f = action_fields<Action>()[field];
    const double x = f.get(&action).value_or(f.is_number ? kNoValue : 0);
    return f.is_direction ? wrap_pi(x) : x;
  }

  std::vector<detail::Instruction> program_;
};

}  // namespace eyrie::ubf
