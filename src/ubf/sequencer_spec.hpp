// SPDX-License-Identifier: MIT
#pragma once
/// \file  How a file writes a sequencer.
///
///   sequencer:
///     start: ingress
///     trees:
///       ingress: {winner_takes_all: [navigate, follow_lead]}
///       bvr: {tree: bvr}
///     transitions:                           # asked in this order, at most one per tick
///       - {from: ingress, to: bvr, when: has_target}
///       - {from: any, to: egress, when: {bingo: {fuel: 900 kg}}}
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/diagnostics.hpp"
#include "core/value.hpp"
#include "ubf/spec.hpp"

namespace eyrie::ubf {

inline constexpr std::array<std::string_view, 3> kSequencerKeys{"start", "trees", "transitions"};

/// Trees and transitions with their names resolved to positions.
struct SequencerSpec {
  struct Transition {
    std::uint16_t from, to;  ///< positions in `trees`; `from` is kNone for any
    const Value* when;
  };
  std::vector<std::pair<std::string, const Value*>> trees;
  std::vector<Transition> transitions;
  std::uint16_t start = 0;
};

/// Which trees the transitions can enter, that have `from` and `to`.
template <class Transitions>
[[nodiscard]] std::vector<bool> entered(std::size_t trees, const Transitions& transitions,
                                        std::uint16_t start) {
  std::vector<bool> reached(trees);
  std::vector<std::uint16_t> open{start};
  while (!open.empty()) {
    const std::uint16_t tree = open.back();
    open.pop_back();
    if (reached[tree])
      continue;
    reached[tree] = true;
    for (const auto& transition : transitions)
      if (transition.from == tree || transition.from == kNone)
        open.push_back(transition.to);
  }
  return reached;
}

/// Reads everything but the nodes. Reports unknown, duplicate and missing names, a transition from
/// a tree to itself, and a tree that can never be entered.
[[nodiscard]] SequencerSpec read_sequencer(const NodeSpec& spec, Diagnostics& diagnostics);

}  // namespace eyrie::ubf
