// SPDX-License-Identifier: MIT
#pragma once
/// \file  A layer over another one: Brooks' suppression and inhibition.
#include "ubf/arbiter/held_proposal.hpp"
#include "ubf/composite.hpp"
#include "ubf/simulated_time.hpp"

namespace eyrie::ubf {

template <class Action>
struct SuppressMemory {
  double last = 0;  ///< s, when the higher layer last proposed
  HeldProposal<Action> proposal;
  std::uint8_t holding = 0;  ///< 1: `proposal` and `last` count
  std::uint8_t reserved[7] = {};
};

/// Two layers: what the higher one (`by`) proposes replaces what the lower one (`child`) proposes,
/// and its last proposal stands in for it for `hold` after it has fallen silent, with the status
/// running. Both layers are asked in every tick. A layer that fails or abstains is silent; if both
/// are and nothing is held, it fails. The suppression node of Brooks, "A Robust Layered Control
/// System for a Mobile Robot" (IEEE Journal of Robotics and Automation, 1986).
template <class State, class Action>
class Suppress final : public WithMemory<Voting<State, Action>, SuppressMemory<Action>> {
  using Base = WithMemory<Voting<State, Action>, SuppressMemory<Action>>;

 public:
  static constexpr std::string_view type_name = "suppress";
  static constexpr std::string_view help =
      "a higher layer's proposal replaces a lower one's, for a while";
  static constexpr Kind kind = Kind::arbiter;
  static constexpr std::array<std::string_view, 2> slots{"by", "child"};
  [[nodiscard]] static constexpr auto params() {
    return std::tuple_cat(
        std::tuple{param("hold", &Suppress::hold, "s", range(0, 1e6),
                         "how long the higher layer's last proposal goes on to replace")},
        Voting<State, Action>::template vote_params<Suppress>());
  }
  using Base::Base;

  double hold = 0;  ///< s

  [[nodiscard]] bool stands() const noexcept override { return true; }
  [[nodiscard]] std::string problem() const override {
    return this->children_.size() == 2 ? Base::problem() : "suppress has two layers";
  }

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    const auto &higher = *this->children_[0], &lower = *this->children_[1];
    auto& m = this->memory(t);
    Scratch<Action> scratch;
    Proposal<Action>& below = scratch.get();
    const Status above = this->ask(higher, t, out);
    const Status answer = this->ask(lower, t, below);

    if (above != Status::failure && out.vote > 0) {
      this->took(t, higher);
      remember(m, t.time, out);
      this->rescale(out);
      return above;
    }
    if (m.holding && !passed(t.time, m.last, hold)) {
      m.proposal.get(out);
      if (t.trace) [[unlikely]]
        Trace<Action>::of(*t.trace).supplied(this->index(), higher.index(), out.action);
      this->rescale(out);
      return Status::running;
    }
    m = {};
    if (answer == Status::failure || below.vote == 0)
      return Status::failure;
    out.copy(below);
    this->took(t, lower);
    this->rescale(out);
    return answer;
  }

 private:
  void remember(SuppressMemory<Action>& m, double now, const Proposal<Action>& proposal) const {
    if (hold == 0)
      return;
    m.proposal.keep(proposal);
    m.last = now;
    m.holding = 1;
  }
};

struct InhibitMemory {
  double last = 0;           ///< s, when `by` last did not fail
  std::uint8_t blocked = 0;  ///< 1: `last` counts
  std::uint8_t reserved[7] = {};
};

/// Two layers: while the higher one (`by`) does not fail, and for `hold` after that, what the lower
/// one (`child`) proposes is lost, and it fails. What `by` proposes is ignored, so a condition will
/// do. Both are asked in every tick. A lower layer that fails or abstains is a failure. The
/// inhibition node of Brooks, "A Robust Layered Control System for a Mobile Robot" (IEEE Journal of
/// Robotics and Automation, 1986).
template <class State, class Action>
class Inhibit final : public WithMemory<Voting<State, Action>, InhibitMemory> {
  using Base = WithMemory<Voting<State, Action>, InhibitMemory>;

 public:
  static constexpr std::string_view type_name = "inhibit";
  static constexpr std::string_view help = "a higher layer blocks a lower one, for a while";
  static constexpr Kind kind = Kind::arbiter;
  static constexpr std::array<std::string_view, 2> slots{"by", "child"};
  [[nodiscard]] static constexpr auto params() {
    return std::tuple_cat(std::tuple{param("hold", &Inhibit::hold, "s", range(0, 1e6),
                                           "how long the lower layer stays blocked afterwards")},
                          Voting<State, Action>::template vote_params<Inhibit>());
  }
  using Base::Base;

  double hold = 0;  ///< s

  [[nodiscard]] bool stands() const noexcept override { return true; }
  [[nodiscard]] std::string problem() const override {
    return this->children_.size() == 2 ? Base::problem() : "inhibit has two layers";
  }

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    const auto &higher = *this->children_[0], &lower = *this->children_[1];
    auto& m = this->memory(t);
    const Status above = this->ask(higher, t, out);
    const Status answer = this->ask(lower, t, out);
    if (above != Status::failure) {
      m = {.last = t.time, .blocked = 1};
      return Status::failure;
    }
    if (m.blocked && !passed(t.time, m.last, hold))
      return Status::failure;
    m = {};
    if (answer == Status::failure || out.vote == 0)
      return Status::failure;
    this->took(t, lower);
    this->rescale(out);
    return answer;
  }
};

}  // namespace eyrie::ubf
