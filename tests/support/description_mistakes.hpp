// SPDX-License-Identifier: MIT
#pragma once
/// \file  For tests only: mistakes of whoever wrote a description.
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "core/bind.hpp"
#include "core/describe.hpp"

namespace eyrie {
namespace detail {

inline bool is_snake_case(std::string_view name) {
  const auto allowed = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
  };
  return !name.empty() && name.front() >= 'a' && name.front() <= 'z' &&
         std::all_of(name.begin(), name.end(), allowed);
}

inline std::string mistakes_in(std::string_view type_name, std::span<const ParamInfo> infos) {
  std::string mistakes;
  const auto report = [&](const ParamInfo& info, std::string_view what) {
    mistakes += fmt::format("{}: {} {}\n", type_name, info.name, what);
  };
  for (std::size_t i = 0; i < infos.size(); ++i) {
    const ParamInfo& info = infos[i];
    if (!is_snake_case(info.name))
      report(info, "is not a name in snake_case");
    if (info.help.empty())
      report(info, "has no help");
    if (info.limits.min > info.limits.max)
      report(info, "has a range without a value");
    for (std::size_t k = 0; k < i; ++k)
      if (infos[k].name == info.name)
        report(info, "is described twice");
    const ParamInfo* group = &info;
    while (group->kind == ParamKind::list)
      group = &group->children[0];
    if (group->kind == ParamKind::group)
      mistakes += mistakes_in(group->type_name, group->children);
  }
  return mistakes;
}

inline std::string description_mistakes(const Description& type) {
  const std::shared_ptr<void> object = type.fresh();
  const std::vector<ParamInfo> infos = parameters(type, object.get());
  std::string mistakes = mistakes_in(type.type_name, infos);
  Diagnostics diagnostics;
  for (std::size_t i = 0; i < infos.size(); ++i) {
    const ParamInfo& info = infos[i];
    const bool scalar = info.kind == ParamKind::number || info.kind == ParamKind::integer ||
                        info.kind == ParamKind::boolean || info.kind == ParamKind::choice;
    const bool absent = info.required || (info.optional && info.default_text == "null");
    if (scalar && !absent)
      read(*type.parameters[i].type, type.parameters[i].member(object.get()),
           Value::scalar(info.default_text, {}), info, diagnostics);
  }
  for (const Diagnostic& d : diagnostics.sorted())
    mistakes += fmt::format("{}: the default of {}\n", type.type_name, d.message);
  return mistakes;
}

}  // namespace detail

/// Mistakes of the person who wrote a description, one per line, for the tests of described types:
/// `EXPECT_EQ(description_mistakes<Radar>(), "");`. Names that are not snake_case or stand twice,
/// missing help, ranges without a value, and defaults that a file could not give because the
/// parameter's own range, unit or choices refuse them.
template <Described T>
requires std::default_initializable<T>
[[nodiscard]] std::string description_mistakes() {
  return detail::description_mistakes(description_of<T>());
}

}  // namespace eyrie
