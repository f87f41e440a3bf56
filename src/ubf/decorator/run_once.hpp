// SPDX-License-Identifier: MIT
#pragma once
#include "core/enum_names.hpp"
#include "ubf/decorator.hpp"

namespace eyrie::ubf {

/// What run_once answers when its child has ended.
enum class Afterwards : std::uint8_t { same, failure, success };

}  // namespace eyrie::ubf

template <>
struct eyrie::EnumNames<eyrie::ubf::Afterwards> {
  using Afterwards = ubf::Afterwards;
  static constexpr std::array names{
      std::pair<std::string_view, Afterwards>{"same", Afterwards::same},
      std::pair<std::string_view, Afterwards>{"failure", Afterwards::failure},
      std::pair<std::string_view, Afterwards>{"success", Afterwards::success}};
};

namespace eyrie::ubf {

struct RunOnceMemory {
  std::uint8_t ended = 0;  ///< 1 + the status with which the child ended, 0 before that
};

/// Asks the child until it has ended, success or failure, and then never again; from then on it
/// proposes nothing and answers what `then` says. It begins anew when a subtree around it loses
/// control and forgets.
template <class State, class Action>
class RunOnce final : public WithMemory<Decorator<State, Action>, RunOnceMemory> {
 public:
  static constexpr std::string_view type_name = "run_once";
  static constexpr std::string_view help = "does not ask a child again that has ended";
  [[nodiscard]] static constexpr auto params() {
    return std::tuple{
        param("then", &RunOnce::then,
              "what it answers from then on: what the child last did, or always that")};
  }
  using WithMemory<Decorator<State, Action>, RunOnceMemory>::WithMemory;

  Afterwards then = Afterwards::same;

  [[nodiscard]] bool stands() const noexcept override { return false; }

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    auto& m = this->memory(t);
    if (m.ended)
      return afterwards(static_cast<Status>(m.ended - 1));
    const Status answer = this->ask_child(t, out);
    if (answer == Status::running)
      return answer;
    this->close(this->child(), t);
    m.ended = static_cast<std::uint8_t>(static_cast<std::uint8_t>(answer) + 1);
    return answer;
  }

 private:
  [[nodiscard]] Status afterwards(Status ended) const {
    if (then == Afterwards::same)
      return ended;
    return then == Afterwards::success ? Status::success : Status::failure;
  }
};

}  // namespace eyrie::ubf
