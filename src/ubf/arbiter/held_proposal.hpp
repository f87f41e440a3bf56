// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "ubf/behavior.hpp"

namespace eyrie::ubf {

/// A proposal kept in the slab, to stand in for a child that fell silent.
template <class Action>
struct HeldProposal {
  PackedAction<Action> action;
  float vote = 0;
  NodeIndex leader = 0;
  std::uint16_t reserved = 0;

  void keep(const Proposal<Action>& proposal) {
    action.assign(proposal.action);
    vote = proposal.vote;
    leader = proposal.leader;
  }
  void get(Proposal<Action>& proposal) const {
    action.unpack(proposal.action);
    proposal.vote = vote;
    proposal.leader = leader;
  }
};

}  // namespace eyrie::ubf
