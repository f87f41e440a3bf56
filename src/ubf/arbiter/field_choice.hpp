// SPDX-License-Identifier: MIT
#pragma once
/// \file  A field of an action named in a file: `direction: heading`.
#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <type_traits>
#include <vector>

#include "core/bind.hpp"
#include "core/check_values.hpp"
#include "ubf/action_traits.hpp"

namespace eyrie::ubf {

/// One of the fields of an action that are floating-point numbers and blended as `Blend` says, by
/// its position; none at first.
template <class Action, class Blend>
class FieldChoice {
 public:
  [[nodiscard]] std::optional<std::size_t> index() const { return index_; }
  /// False, and nothing changes, if there is no such field.
  bool choose(std::string_view name) {
    bool found = false;
    for_each_field<Action>([&](const auto& f, auto i) {
      if (!fits<std::remove_cvref_t<decltype(f)>>() || f.name != name)
        return;
      index_ = i;
      found = true;
    });
    return found;
  }
  [[nodiscard]] static std::vector<std::string_view> names() {
    std::vector<std::string_view> all;
    for_each_field<Action>([&](const auto& f, auto) {
      if (fits<std::remove_cvref_t<decltype(f)>>())
        all.push_back(f.name);
    });
    return all;
  }
  [[nodiscard]] std::optional<double> get(const Action& action) const {
    return index_ ? number_of(action, *index_) : std::nullopt;
  }
  void set(std::optional<double> value, Action& action) const {
    if (index_)
      set_number(action, *index_, value);
  }

 private:
  template <class Field>
  [[nodiscard]] static constexpr bool fits() {
    return std::is_same_v<typename Field::BlendTag, Blend> && Field::is_real;
  }
  std::optional<std::size_t> index_;
};

/// Reads the name of a field (core/bind.hpp).
template <class Action, class Blend>
void bind_value(FieldChoice<Action, Blend>& out, const Value& value, Diagnostics& diagnostics,
                const ParamInfo& info) {
  if (value.is_scalar() && out.choose(value.text))
    return;
  const auto names = FieldChoice<Action, Blend>::names();
  diagnostics.error(
      value.where,
      fmt::format("{}: {} is no field that can be chosen here{}", info.name, value.shown(),
                  did_you_mean(value.is_scalar() ? value.text : "", names)));
}
/// Says in references which fields there are.
template <class Action, class Blend>
void describe_value(ParamInfo& info, const FieldChoice<Action, Blend>&) {
  info.kind = ParamKind::choice;
  for (const std::string_view name : FieldChoice<Action, Blend>::names())
    info.choices.emplace_back(name);
}

/// Says which field it is (core/check_values.hpp).
template <class Action, class Blend>
void list_parts(const FieldChoice<Action, Blend>& choice, const std::string& name,
                std::vector<ParamValue>& values) {
  if (choice.index())
    values.push_back({name, std::string(field_names<Action>()[*choice.index()])});
}

}  // namespace eyrie::ubf
