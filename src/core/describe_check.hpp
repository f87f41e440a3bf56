// SPDX-License-Identifier: MIT
#pragma once
/// \file  Mistakes of the person who wrote a description, for the tests of described types:
/// `EXPECT_EQ(description_mistakes<Radar>(), "");`
#include <fmt/format.h>

#include <concepts>
#include <span>
#include <string>

#include "core/bind.hpp"

namespace eyrie {

namespace detail {
/// Names that are not snake_case or stand twice, missing help, ranges without a value.
[[nodiscard]] std::string info_mistakes(std::string_view type_name,
                                        std::span<const ParamInfo> infos);
/// A map that gives every scalar parameter its default, as a file would.
[[nodiscard]] Value default_map(std::span<const ParamInfo> infos);
}  // namespace detail

/// One line per mistake, "" if there is none. Also reports defaults that a file could not give
/// because the parameter's own range, unit or choices refuse them.
template <Described T>
requires std::default_initializable<T>
[[nodiscard]] std::string description_mistakes() {
  T object{};
  const std::vector<ParamInfo> infos = parameters(object);
  std::string mistakes = detail::info_mistakes(T::type_name, infos);
  Diagnostics diagnostics;
  const auto bind_one = [&](const auto& param) {
    const ParamInfo info = detail::info(param, object.*param.member);
    const Value map = detail::default_map(std::span(&info, 1));
    for (const Value::Entry& entry : map.entries)
      detail::read(object.*param.member, entry.value, info, diagnostics);
  };
  std::apply([&](const auto&... param) { (bind_one(param), ...); }, T::params());
  for (const Diagnostic& d : diagnostics.sorted())
    mistakes += fmt::format("{}: the default of {}\n", T::type_name, d.message);
  return mistakes;
}

}  // namespace eyrie
