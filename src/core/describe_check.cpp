// SPDX-License-Identifier: MIT
#include "core/describe_check.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace eyrie::detail {
namespace {

bool is_snake_case(std::string_view name) {
  const auto allowed = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
  };
  return !name.empty() && name.front() >= 'a' && name.front() <= 'z' &&
         std::all_of(name.begin(), name.end(), allowed);
}

}  // namespace

std::string info_mistakes(std::string_view type_name, std::span<const ParamInfo> infos) {
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
      mistakes += info_mistakes(group->type_name, group->children);
  }
  return mistakes;
}

Value default_map(std::span<const ParamInfo> infos) {
  std::vector<Value::Entry> entries;
  for (const ParamInfo& info : infos) {
    const bool scalar = info.kind == ParamKind::number || info.kind == ParamKind::integer ||
                        info.kind == ParamKind::boolean || info.kind == ParamKind::choice;
    const bool absent = info.required || (info.optional && info.default_text == "null");
    if (scalar && !absent)
      entries.push_back(entry(info.name, info.default_text));
  }
  return Value::map(std::move(entries));
}

}  // namespace eyrie::detail
