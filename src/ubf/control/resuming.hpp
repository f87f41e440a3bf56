// SPDX-License-Identifier: MIT
#pragma once
#include "ubf/composite.hpp"

namespace eyrie::ubf {

struct ResumingMemory {
  std::uint16_t running = 0;  ///< 1 + the child that was left running, 0 for none
};

/// The base of the control nodes with memory: children before the one left running are not asked
/// again until the node itself has ended. When it ends, nothing in it goes on.
template <class State, class Action>
class Resuming : public WithMemory<Voting<State, Action>, ResumingMemory> {
 public:
  using WithMemory<Voting<State, Action>, ResumingMemory>::WithMemory;

  [[nodiscard]] NodeIndex active_child(const std::byte* slab) const noexcept final {
    const auto& m = this->memory(slab);
    return m.running ? static_cast<NodeIndex>(m.running - 1) : kNone;
  }

 protected:
  /// Asks from the child that was left running, while children answer `go_on`; answers what the
  /// last one asked did.
  Status resume(const Tick<State>& t, Proposal<Action>& out, Status go_on) const {
    auto& m = this->memory(t);
    Status status = go_on;
    for (std::size_t i = m.running ? m.running - 1u : 0u;
         i < this->children_.size() && status == go_on; ++i) {
      const auto& child = *this->children_[i];
      status = this->ask_over(child, t, out);
      m.running = status == Status::running ? static_cast<std::uint16_t>(i + 1) : 0;
      if (status != Status::running)
        this->close(child, t);
    }
    this->rescale(out);
    return status;
  }
};

}  // namespace eyrie::ubf
