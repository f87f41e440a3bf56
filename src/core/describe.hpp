// SPDX-License-Identifier: MIT
#pragma once
/// \file  Describe once: one table of parameters per type drives binding, errors and references.
///
///   struct BreakTurn {
///     static constexpr std::string_view type_name = "break_turn";
///     static constexpr std::string_view help = "turns hard away from a missile";
///     static constexpr auto params() {
///       return std::tuple{
///           param("danger_range", &BreakTurn::danger_range_, "m", range(0, 50e3), "break inside"),
///           param("mode", &BreakTurn::mode_, "how to turn").required()};
///     }
///    private:
///     double danger_range_ = si(2, "nmi");
///     Mode mode_ = Mode::level;
///   };
///
/// A member may be: double, float, bool, an integer, std::string, an enum with EnumNames, Vec3,
/// Table1, Table2, another described struct, std::optional, std::vector or std::array of these, or
/// a type with its own bind_value (see core/bind.hpp). The value of a default-constructed object is
/// the default of the parameter.
#include <concepts>
#include <tuple>
#include <vector>

#include "core/param.hpp"
#include "core/param_types.hpp"

namespace eyrie {

/// Every parameter of a type, with the values of `defaults` as defaults. A type must not contain
/// itself, not even in a list.
template <Described T>
[[nodiscard]] std::vector<ParamInfo> parameters(const T& defaults) {
  std::vector<ParamInfo> result;
  std::apply(
      [&](const auto&... param) {
        (result.push_back(detail::info(param, defaults.*param.member)), ...);
      },
      T::params());
  return result;
}

template <Described T>
requires std::default_initializable<T>
[[nodiscard]] std::vector<ParamInfo> parameters() {
  return parameters(T{});
}

}  // namespace eyrie
