// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>

#include "ubf/decorator.hpp"

namespace eyrie::ubf {

struct RepeatingMemory {
  std::uint32_t rounds = 0;  ///< how often the child ended as it should
};

/// The base of repeat and retry: a child that ended in one way begins anew in the next tick, at
/// most once per tick, so that a loop takes simulated time. A standing child that ended forgets.
template <class State, class Action>
class Repeating : public WithMemory<Decorator<State, Action>, RepeatingMemory> {
 public:
  using WithMemory<Decorator<State, Action>, RepeatingMemory>::WithMemory;

  [[nodiscard]] bool stands() const noexcept final { return false; }

 protected:
  /// Running until the child has answered `again` that often (null: for ever) or ended otherwise.
  Status loop(const Tick<State>& t, Proposal<Action>& out, Status again,
              std::optional<std::uint32_t> rounds) const {
    auto& m = this->memory(t);
    const Status answer = this->ask_child(t, out);
    if (answer == Status::running)
      return answer;
    this->close(this->child(), t);
    if (answer != again || (rounds && m.rounds + 1 >= *rounds)) {
      m = {};
      return answer;
    }
    if (rounds)
      ++m.rounds;
    if (answer == Status::failure)
      out.clear();
    return Status::running;
  }
};

}  // namespace eyrie::ubf
