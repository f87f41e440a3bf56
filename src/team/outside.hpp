// SPDX-License-Identifier: MIT
#pragma once
/// \file  What is asked of agents from outside, besides another tree.
#include <array>
#include <span>

#include "sim/event.hpp"
#include "ubf/behavior.hpp"

namespace eyrie::team {

/// What an order to an agent came to.
enum class Obeyed : std::uint8_t { no, quietly, told };

/// The votes that are other ones than the tree's file says, at most N.
template <std::size_t N>
struct NodeVotes {
  std::array<ubf::NodeVote, N> votes;
  std::size_t size = 0;
  [[nodiscard]] std::span<const ubf::NodeVote> span() const { return {votes.data(), size}; }
};

/// The tree by which an agent goes now.
struct Flown {
  std::uint16_t tree = 0;  ///< index
  std::size_t nodes = 0;   ///< of it; 0: there is none
};

/// A platform of whose agents nothing else is asked; and what an Outside has to say.
struct NoOutside {
  /// What is kept of it: a row of Platform::Columns::*column, if there is one.
  struct Asked {};
  struct Rows {
    mutable Asked all;
    Asked& operator[](std::size_t) const { return all; }
  };
  static constexpr std::array<sim::OrderKind, 0> orders{};
  /// Carries out an order. One that makes no sense is ignored.
  static Obeyed obey(const sim::Order&, Asked&, const Flown&) { return Obeyed::no; }
  /// What is told of it beside its kind.
  static constexpr double detail(const sim::Order&) { return 0; }
  /// Whether nobody is to be asked at all.
  static constexpr bool sleeps(const Asked&) { return false; }
  static constexpr NodeVotes<1> votes(const Asked&) { return {}; }
  static constexpr void forget_votes(Asked&) {}
  /// Whether there is anything to overrule.
  static constexpr bool says(const Asked&) { return false; }
  /// Puts what is asked from outside in the place of what the tree recommends.
  static constexpr void overrule(const Asked&, const auto& /*state*/, auto& /*action*/) {}
  /// What is asked for once has been carried out.
  static constexpr void done(Asked&, const auto& /*state*/) {}
};

template <class Platform>
struct OutsideOf {
  using Type = NoOutside;
};
template <class Platform>
requires requires {
  typename Platform::Outside;
}
struct OutsideOf<Platform> {
  using Type = typename Platform::Outside;
};

}  // namespace eyrie::team
