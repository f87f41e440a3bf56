// SPDX-License-Identifier: MIT
#pragma once
/// \file  The parameter `vote` of a type of node, if it has one.
#include <optional>
#include <tuple>
#include <type_traits>

#include "core/describe.hpp"

namespace eyrie::ubf {

/// The parameter `vote` of a node: a float, an optional one, or none.
template <class B>
[[nodiscard]] std::optional<float> vote_of(const B& node) {
  std::optional<float> vote;
  const auto look = [&](const auto& param) {
    using Member = typename std::remove_cvref_t<decltype(param)>::member_type;
    if constexpr (std::is_same_v<Member, float> || std::is_same_v<Member, std::optional<float>>)
      if (param.name == "vote")
        vote = node.*param.member;
  };
  std::apply([&](const auto&... param) { (look(param), ...); }, B::params());
  return vote;
}
template <class B>
[[nodiscard]] bool has_vote() {
  return std::apply([](const auto&... param) { return (false || ... || (param.name == "vote")); },
                    B::params());
}

}  // namespace eyrie::ubf
