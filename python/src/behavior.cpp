// SPDX-License-Identifier: MIT
#include "action_values.hpp"
#include "core/bind.hpp"

namespace eyrie::python {
namespace {

constexpr std::size_t kMostParameters = 16;

/// A parameter of a node is one of these.
using Value = std::variant<double, bool, std::string>;
/// Those of one node, by place; each is of its type from the start.
using Values = std::array<Value, kMostParameters>;

template <class T, std::size_t I>
void* place(void* values) {
  return &std::get<T>((*static_cast<Values*>(values))[I]);
}
/// By its number where a parameter of that type is.
template <class T>
constexpr auto kPlaces = []<std::size_t... I>(std::index_sequence<I...>) {
  return std::array<void* (*)(void*), kMostParameters>{place<T, I>...};
}
(std::make_index_sequence<kMostParameters>{});

/// eyrie._core.State
struct State {
  std::function<nb::object(std::string_view)> read;  ///< empty when the tick is over
  std::function<double()> random;
  std::uint32_t player = 0;
};

}  // namespace

/// A type of node whose tick calls a function of Python.
class BehaviorType : public ubf::NodeType, public std::enable_shared_from_this<BehaviorType> {
 public:
  std::string its_name, its_help;
  nb::object function;
  bool for_drivers = false;
  std::vector<std::string> words;  ///< names and helps of parameters, which stay where they are
  std::vector<Parameter> lines;
  Description described;
  Values defaults;

  ~BehaviorType() {
    if (!Py_IsInitialized()) {  // nobody may be told any more
      static_cast<void>(function.release());
      return;
    }
    const GilHeld held;
    function.reset();
  }
  BehaviorType() = default;
  BehaviorType(const BehaviorType&) = delete;
  BehaviorType& operator=(const BehaviorType&) = delete;
};

namespace {

void demand_asked(const State& state) {
  if (!state.read)
    raise("Error", "a state is gone when the behavior has answered");
}

/// The tick is over: whoever has kept the state is told so.
struct Over {
  State& state;
  ~Over() { state.read = nullptr; }
};

/// As Python tells it, from the behavior on.
std::string traceback_of(const nb::python_error& e) {
  const nb::object lines = nb::module_::import_("traceback")
                               .attr("format_exception")(e.type(), e.value(), e.traceback());
  const nb::object whole = nb::str("").attr("join")(lines);
  const auto bytes = nb::cast<nb::bytes>(whole.attr("encode")("utf-8", "backslashreplace"));
  return {bytes.c_str(), bytes.size()};
}

/// A parameter as a function of Python gets it.
nb::object object_of(const Value& value) {
  if (const auto* words = std::get_if<std::string>(&value))
    return text(*words);
  if (const auto* is_on = std::get_if<bool>(&value))
    return nb::bool_(*is_on);
  return nb::float_(std::get<double>(value));
}

nb::object field_value(const ubf::StateFieldInfo& info, double value) {
  if (info.kind == ubf::FieldKind::flag)
    return nb::bool_(value == 1);
  if (info.kind == ubf::FieldKind::choice) {
    const auto index = static_cast<std::size_t>(value);
    return std::isnan(value) ? nb::object(nb::none()) : text(info.choices[index]);
  }
  return nb::float_(value);
}

template <class S, class Action>
class Node final : public ubf::Behavior<S, Action> {
 public:
  explicit Node(std::shared_ptr<const BehaviorType> type) : type_(std::move(type)) {
    values = type_->defaults;
  }
  Values values;

  ubf::Status tick(const ubf::Tick<S>& t, ubf::Proposal<Action>& out) const override {
    const GilHeld held;
    const auto state = std::make_shared<State>();
    state->player = t.player.value;
    state->read = [&t](std::string_view name) { return read(t.state, name); };
    state->random = [draw = this->draw(t)]() mutable { return draw.uniform(); };
    const Over over{*state};
    try {
      nb::list arguments;
      arguments.append(nb::cast(state));
      for (std::size_t i = 0; i < type_->lines.size(); ++i)
        arguments.append(object_of(values[i]));
      return take(type_->function(*nb::tuple(arguments)), out);
    } catch (nb::python_error& e) {
      const std::string words = traceback_of(e);
      if (e.matches(PyExc_KeyboardInterrupt))
        PyErr_SetInterrupt();  // without_gil() sees it when the step is over
      throw std::runtime_error(words);
    }
  }

 private:
  static nb::object read(const S& state, std::string_view name) {
    const auto fields = ubf::StateFields<S>::all();
    for (const auto& field : fields)
      if (field.info.name == name)
        return field_value(field.info, field.read(state));
    const auto names = listed(fields, [](const auto& field) { return field.info.name; });
    throw nb::attribute_error(
        fmt::format("there is no state field {}{}", quote(name), nearest_or_all(name, names))
            .c_str());
  }
  /// (status, vote, fields) -> the proposal.
  static ubf::Status take(const nb::object& answer, ubf::Proposal<Action>& out) {
    const auto [status, vote, fields] = nb::cast<std::tuple<int, double, nb::dict>>(answer);
    out.vote = static_cast<float>(vote);
    for (const auto [name, value] : fields) {
      std::string field;
      if (!nb::try_cast(name, field))
        throw nb::type_error(
            fmt::format("an action has no field {}", nb::cast<std::string>(nb::repr(name)))
                .c_str());
      set_action_field(out.action, field, value);
    }
    return static_cast<ubf::Status>(status);
  }

  std::shared_ptr<const BehaviorType> type_;
};

template <class N>
void make_for(BehaviorType& type) {
  type.make = [](const ubf::NodeType& self) -> std::unique_ptr<ubf::AnyNode> {
    return std::make_unique<N>(static_cast<const BehaviorType&>(self).shared_from_this());
  };
  type.object = [](ubf::AnyNode& node) -> void* { return &static_cast<N&>(node).values; };
}

using PilotNode = Node<pilot::State, pilot::Action>;
using DriverNode = Node<driver::State, driver::Action>;

/// (name, kind, unit, default, least, most, help); numbers in the unit.
using ParameterText = std::tuple<std::string, std::string, std::string, nb::object,
                                 std::optional<double>, std::optional<double>, std::string>;

double in_si(const std::string& parameter, double number, const std::string& unit) {
  if (unit.empty())
    return number;
  const UnitInfo* info = find_unit(unit);
  if (!info)
    refuse("{}: there is no unit {}{}", parameter, quote(unit),
           nearest_or_all(unit, listed(units(), &UnitInfo::symbol)));
  return to_si(number, *info);
}

/// Gives the next parameter of a behavior its type and default. Throws TypeError.
template <class T>
T& put(BehaviorType& type, Parameter& line, const nb::object& value) {
  const std::size_t i = type.lines.size();
  line.type = &eyrie::detail::TypeOf<T>::value;
  line.member = kPlaces<T>[i];
  T& got = type.defaults[i].emplace<T>();
  if (!nb::try_cast(value, got))
    throw nb::type_error(fmt::format("{}: its default cannot be {}", line.name,
                                     nb::cast<std::string>(nb::repr(value)))
                             .c_str());
  return got;
}

Behavior behavior(std::string name, std::string help, const std::string& platform,
                  nb::object function, const std::vector<ParameterText>& parameters) {
  if (const auto problem = identifier_problem(name))
    refuse("{}", *problem);
  if (parameters.size() > kMostParameters)
    refuse("{}: {} parameters; the most is {}", name, parameters.size(), kMostParameters);
  auto type = std::make_shared<BehaviorType>();
  type->its_name = std::move(name);
  type->its_help = std::move(help);
  type->name = type->its_name;
  type->help = type->its_help;
  type->function = std::move(function);
  type->for_drivers = platform == "driver";
  type->words.reserve(2 * parameters.size());
  for (const auto& [its_name, kind, unit, value, least, most, its_help] : parameters) {
    Parameter line;
    line.name = type->words.emplace_back(its_name);
    line.help = type->words.emplace_back(its_help);
    if (kind == "switch") {
      put<bool>(*type, line, value);
    } else if (kind == "text") {
      put<std::string>(*type, line, value);
    } else {
      double& number = put<double>(*type, line, value);
      number = in_si(its_name, number, unit);
      line.unit = Unit(unit.empty() ? Dimension::none : find_unit(unit)->dimension);
      if (least)
        line.limits.min = in_si(its_name, *least, unit);
      if (most)
        line.limits.max = in_si(its_name, *most, unit);
      if (!std::isfinite(number) || !line.limits.contains(number))
        refuse("{}: its default {}{}{} is outside its limits", its_name, nb::cast<double>(value),
               unit.empty() ? "" : " ", unit);
    }
    type->lines.push_back(line);
  }
  type->described.type_name = type->its_name;
  type->described.parameters = type->lines;
  type->parameters = &type->described;
  if (type->for_drivers)
    make_for<DriverNode>(*type);
  else
    make_for<PilotNode>(*type);
  return {std::move(type)};
}

}  // namespace

scenario::AddNodes adds(const std::vector<Behavior>& behaviors) {
  if (behaviors.empty())
    return {};
  return [behaviors](scenario::Registrar& registrar) {
    for (const Behavior& one : behaviors)
      if (one.type->for_drivers)
        registrar.add_driver_node(*one.type);
      else
        registrar.add_pilot_node(*one.type);
  };
}

void add_behavior(nb::module_& m) {
  nb::class_<State>(m, "State", "What a behavior sees of its agent, while it is asked.")
      .def_prop_ro(
          "player", [](const State& s) { return s.player; }, "The number of the agent.")
      .def(
          "random",
          [](const State& s) {
            demand_asked(s);
            return s.random();
          },
          "A number in [0, 1): of seed, player, step, node and how many were "
          "drawn before.")
      .def(
          "__getattr__",
          [](const State& s, const std::string& name) {
            if (name.starts_with("__"))
              throw nb::attribute_error(name.c_str());
            demand_asked(s);
            return s.read(name);
          },
          nb::arg("name"), nb::sig("def __getattr__(self, name: str) -> typing.Any"),
          "A field of the state, in SI: docs/reference.md has them.");
  nb::class_<Behavior>(m, "Behavior", "A type of node that calls a function of Python.")
      .def_prop_ro(
          "name", [](const Behavior& b) { return b.type->its_name; }, "What trees call it.")
      .def_prop_ro(
          "defaults",
          [](const Behavior& b) {
            std::vector<nb::object> all;
            for (std::size_t i = 0; i < b.type->lines.size(); ++i)
              all.push_back(object_of(b.type->defaults[i]));
            return all;
          },
          "Of its parameters, in their order, in SI.");
  m.def("behavior", &behavior, nb::arg("name"), nb::arg("help"), nb::arg("platform"),
        nb::arg("function"), nb::arg("parameters"),
        "Makes one; the function answers (status, vote, fields).");
}

}  // namespace eyrie::python
