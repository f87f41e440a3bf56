// SPDX-License-Identifier: MIT
#include "ubf/arbiter/field_values.hpp"

namespace eyrie::ubf {
namespace {

/// The limits of one field, as a file writes them.
struct LimitsSpec {
  static constexpr std::string_view type_name = "limits";
  [[nodiscard]] static constexpr auto params() {
    return Lines{param("min", &LimitsSpec::min, range(-1e9, 1e9), "least value that passes"),
                 param("max", &LimitsSpec::max, range(-1e9, 1e9), "greatest value that passes")};
  }
  std::optional<double> min, max;
};

/// The axis of one field, as a file writes it.
struct AxisSpec {
  static constexpr std::string_view type_name = "axis";
  [[nodiscard]] static constexpr auto params() {
    return Lines{param("from", &AxisSpec::from, range(-1e9, 1e9), "the first candidate").required(),
                 param("to", &AxisSpec::to, range(-1e9, 1e9),
                       "the last one; of a whole circle the first again")
                     .required(),
                 param("steps", &AxisSpec::steps, range(2, 360), "how many candidates").required(),
                 param("reach", &AxisSpec::reach, positive(1e9),
                       "what a child asks for is worth 1, and so far from it -1")
                     .required(),
                 param("spread", &AxisSpec::spread, range(0, 1e9),
                       "standard deviation of what comes of a command (for utility)")};
  }
  double from = 0, to = 0;
  std::uint32_t steps = 2;
  double reach = 1, spread = 0;
};

/// The description of a Spec whose quantities have the unit of a field.
template <class Spec>
class InUnit {
 public:
  explicit InUnit(Unit unit)
      : lines_(description_of<Spec>().parameters.begin(), description_of<Spec>().parameters.end()) {
    for (Parameter& line : lines_)
      if (line.type->kind != ParamKind::integer)
        line.unit = unit;
  }
  [[nodiscard]] Description description() const { return {Spec::type_name, lines_, nullptr}; }

 private:
  std::vector<Parameter> lines_;
};

template <class Spec>
void list_field(const Spec& spec, const std::string& name, const ActionFieldInfo& field,
                std::vector<ParamValue>& values) {
  eyrie::detail::list_values(InUnit<Spec>(field.unit).description(), &spec,
                             fmt::format("{}.{}.", name, field.name), values);
}

/// The index of a field, or their number.
std::size_t find(ActionFields fields, std::string_view name) {
  const auto found = std::ranges::find(fields, name, &ActionFieldInfo::name);
  return static_cast<std::size_t>(found - fields.begin());
}
std::string unknown(ActionFields fields, std::string_view name) {
  return fmt::format("an action has no field {}{}", quote(name),
                     did_you_mean(name, listed(fields, &ActionFieldInfo::name)));
}

std::string problem_with(const ActionFieldInfo& field, std::optional<double> min,
                         std::optional<double> max) {
  if (!field.is_number)
    return fmt::format("{} is not a number and has no limits", quote(field.name));
  if (!min && !max)
    return fmt::format("{} needs a 'min' or a 'max'", quote(field.name));
  if (field.is_direction && !(min && max))
    return fmt::format("{} is a direction and needs both 'min' and 'max'", quote(field.name));
  for (const auto& limit : {min, max})
    if (limit && !std::isfinite(*limit))
      return fmt::format("{}: a limit is {}", quote(field.name), *limit);
  if (!field.is_direction && min && max && *min > *max)
    return fmt::format("{}: 'min' is greater than 'max'", quote(field.name));
  return {};
}

/// Whether a direction is on an arc, its ends and what rounds to them included.
bool is_on_arc(double x, double min, double max) {
  constexpr double kRounding = 1e-9;
  const double past = wrap_tau(x - min);
  return max - min >= kTau - kRounding ||  // all of the circle, as from 0 to 360 deg
         past <= wrap_tau(max - min) + kRounding || past >= kTau - kRounding;
}

/// How probable it is that what comes of a command lies so many steps off it: normal, to three
/// standard deviations.
void set_spread(AnyGrid::Axis& axis) {
  if (!(axis.deviation > 0))
    return;
  const double in_steps = axis.deviation / axis.step;
  // on a circle no outcome is met from both sides; on an open axis all that lies beyond an end, for
  // every command, stands in the last place
  const std::size_t places = axis.is_circle ? (axis.steps - 1) / 2 : axis.steps - 1;
  const double reach = std::fmin(std::ceil(3 * in_steps), axis.is_circle ? double(places) : 1e5);
  double total = 1;
  for (std::size_t k = 1; k <= static_cast<std::size_t>(reach); ++k) {
    const double x = static_cast<double>(k) / in_steps, p = math::exp(-0.5 * x * x);
    total += 2 * p;
    if (k <= places)
      axis.spread.push_back(p);
    else
      axis.spread.back() += p;
  }
  for (double& p : axis.spread)
    p /= total;
}

/// A map from fields to `Spec`s; `add(spec, field)` gives what is wrong, or nothing.
template <class Spec, class Add>
void read_fields(ActionFields fields, const Value& value, Diagnostics& diagnostics,
                 const ParamInfo& info, std::string_view what, Add add) {
  if (!value.is_map()) {
    diagnostics.error(value.where, "{}: expected a map from fields to {}, got {}", info.name, what,
                      value.shown());
    return;
  }
  for (const Value::Entry& e : value.entries) {
    const std::size_t field = find(fields, e.key);
    std::string problem = unknown(fields, e.key);
    if (field < fields.size()) {
      Spec spec;
      const InUnit<Spec> lines(fields[field].unit);
      if (!eyrie::detail::bind(lines.description(), &spec, e.value, {}, diagnostics, {}))
        continue;
      problem = add(spec, e.key);
    }
    if (!problem.empty())
      diagnostics.error(e.where, std::move(problem));
  }
}

}  // namespace

std::string AnyBounds::set(std::string_view name, std::optional<double> min,
                           std::optional<double> max) {
  const std::size_t field = find(fields_, name);
  if (field == fields_.size())
    return unknown(fields_, name);
  std::string problem = problem_with(fields_[field], min, max);
  if (!problem.empty())
    return problem;
  std::erase_if(limits_, [&](const Limits& l) { return l.field == field; });
  limits_.push_back({field, min, max, fmt::format("refused: {} is out of bounds", name)});
  std::ranges::sort(limits_, [](const Limits& a, const Limits& b) { return a.field < b.field; });
  return {};
}

const char* AnyBounds::why_not(const void* action) const {
  for (const Limits& limits : limits_) {
    const ActionFieldInfo& field = fields_[limits.field];
    const std::optional<double> x = field.get(action);
    if (!x)
      continue;
    const auto& [_, min, max, refusal] = limits;
    const bool inside = field.is_direction ? is_on_arc(*x, *min, *max)
                                           : (!min || *x >= *min) && (!max || *x <= *max);
    if (!inside || *x != *x)
      return refusal.c_str();
  }
  return nullptr;
}

std::size_t AnyGrid::size() const {
  std::size_t n = axes_.empty() ? 0 : 1;
  for (const Axis& axis : axes_)
    n *= axis.steps;
  return n;
}

bool AnyGrid::has(std::size_t field) const {
  return std::ranges::any_of(axes_, [&](const Axis& a) { return a.field == field; });
}

std::string AnyGrid::add(std::string_view name, double from, double to, std::size_t steps,
                         double reach, double spread) {
  const std::size_t field = find(fields_, name);
  if (field == fields_.size())
    return unknown(fields_, name);
  const AxisSpec said{from, to, static_cast<std::uint32_t>(steps), reach, spread};
  std::vector<std::string> wrong;
  const InUnit<AxisSpec> lines(fields_[field].unit);
  eyrie::detail::check_values(lines.description(), &said, fmt::format("{}.", name), wrong);
  if (!wrong.empty())
    return wrong.front();
  return add_axis(field, {.field = field,
                          .from = from,
                          .to = to,
                          .reach = reach,
                          .deviation = spread,
                          .steps = steps});
}

std::string AnyGrid::add_axis(std::size_t field, Axis axis) {
  const std::string name = quote(fields_[field].name);
  if (!fields_[field].is_real)
    return fmt::format("{} is not a number and has no candidates", name);
  if (has(field))
    return fmt::format("there are two axes {}", name);
  if (axes_.size() == kMostAxes)
    return fmt::format("a grid has at most {} axes", kMostAxes);
  if (!(axis.to > axis.from))
    return fmt::format("{}: 'to' must be greater than 'from'", name);
  axis.is_direction = fields_[field].is_direction;
  const double width = axis.to - axis.from;
  if (axis.is_direction && width > kTau * (1 + 1e-9))
    return fmt::format("{}: more than a whole circle", name);
  axis.is_circle = axis.is_direction && width > kTau * (1 - 1e-9);
  axis.step = width / static_cast<double>(axis.is_circle ? axis.steps : axis.steps - 1);
  set_spread(axis);
  axes_.push_back(std::move(axis));
  if (size() <= kMostCandidates)
    return {};
  const std::size_t candidates = size();
  axes_.pop_back();
  return fmt::format("the grid has {} candidates, the most is {}", candidates, kMostCandidates);
}

bool AnyFieldChoice::choose(std::string_view name) {
  const std::size_t field = find(fields_, name);
  if (field == fields_.size() || !fits(fields_[field]))
    return false;
  index_ = field;
  return true;
}

std::vector<std::string> AnyFieldChoice::names() const {
  std::vector<std::string> names;
  for (const ActionFieldInfo& field : fields_)
    if (fits(field))
      names.emplace_back(field.name);
  return names;
}

void bind_value(AnyBounds& out, const Value& value, Diagnostics& diagnostics,
                const ParamInfo& info) {
  read_fields<LimitsSpec>(out.fields_, value, diagnostics, info, "limits",
                          [&](const LimitsSpec& said, std::string_view name) {
                            return out.set(name, said.min, said.max);
                          });
}
void bind_value(AnyGrid& out, const Value& value, Diagnostics& diagnostics, const ParamInfo& info) {
  read_fields<AxisSpec>(out.fields_, value, diagnostics, info, "candidates",
                        [&](const AxisSpec& said, std::string_view name) {
                          return out.add(name, said.from, said.to, said.steps, said.reach,
                                         said.spread);
                        });
}
void bind_value(AnyFieldChoice& out, const Value& value, Diagnostics& diagnostics,
                const ParamInfo& info) {
  if (value.is_scalar() && out.choose(value.text))
    return;
  diagnostics.error(value.where, "{}: {} is no field that can be chosen here{}", info.name,
                    value.shown(),
                    nearest_or_all(value.is_scalar() ? value.text : "", out.names()));
}

void describe_value(ParamInfo& info, const AnyBounds&) {
  info.type_name = "limits by field";
}
void describe_value(ParamInfo& info, const AnyGrid&) {
  info.type_name = "candidates by field";
}
void describe_value(ParamInfo& info, const AnyFieldChoice& choice) {
  info.kind = ParamKind::choice;
  info.choices = choice.names();
}

void list_parts(const AnyBounds& bounds, const std::string& name, std::vector<ParamValue>& values) {
  for (const auto& limits : bounds.limits_)
    list_field(LimitsSpec{limits.min, limits.max}, name, bounds.fields_[limits.field], values);
}
void list_parts(const AnyGrid& grid, const std::string& name, std::vector<ParamValue>& values) {
  for (const AnyGrid::Axis& axis : grid.axes())
    list_field(AxisSpec{axis.from, axis.to, static_cast<std::uint32_t>(axis.steps), axis.reach,
                        axis.deviation},
               name, grid.fields_[axis.field], values);
}
void list_parts(const AnyFieldChoice& choice, const std::string& name,
                std::vector<ParamValue>& values) {
  if (choice.index_)
    values.push_back({name, std::string(choice.fields_[*choice.index_].name)});
}

}  // namespace eyrie::ubf
