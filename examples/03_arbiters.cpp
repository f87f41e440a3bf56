// SPDX-License-Identifier: MIT
/// The same recommendations under four arbiters: exchange one word and the agent acts differently.
#include <fmt/format.h>

#include "core/angle.hpp"
#include "ubf/standard_nodes.hpp"

struct State {};
struct Action {
  std::optional<double> heading;   // rad
  std::optional<double> altitude;  // m
  std::optional<bool> release;
};

template <>
struct eyrie::ubf::ActionTraits<Action> {
  static constexpr auto fields = std::tuple{field<blend::Angle>("heading", &Action::heading, "rad"),
                                            field<blend::Mean>("altitude", &Action::altitude, "m"),
                                            field<blend::Strongest>("release", &Action::release)};
};

using namespace eyrie;
using namespace eyrie::ubf;

/// Recommends always the same.
struct Fixed : Behavior<State, Action> {
  static constexpr std::string_view type_name = "fixed", help = "says what it was told";
  explicit Fixed(Proposal<Action> p) : proposal(p) {}
  Proposal<Action> proposal;
  Status tick(const Tick<State>&, Proposal<Action>& out) const override {
    out.action = proposal.action;
    out.vote = proposal.vote;
    return Status::running;
  }
};

template <template <class, class> class Arbiter>
void ask() {
  const Tree<State, Action> tree(
      "demo",
      make<Arbiter<State, Action>>(make<Fixed>(Proposal<Action>{{radians(350), 6000, {}}, 30}),
                                   make<Fixed>(Proposal<Action>{{radians(20), 3000, {}}, 10}),
                                   make<Fixed>(Proposal<Action>{{{}, {}, true}, 40})));
  const State state;
  Proposal<Action> out;
  tree.tick({.state = state}, out);
  const auto& a = out.action;
  fmt::print("{:<17} heading {:>5}  altitude {:>4}  release {:<3}  vote {:.0f}\n",
             Arbiter<State, Action>::type_name,
             a.heading ? fmt::format("{:.1f}", degrees(wrap_tau(*a.heading))) : "-",
             a.altitude ? fmt::format("{:.0f}", *a.altitude) : "-", a.release ? "yes" : "-",
             out.vote);
}

int main() {
  ask<WinnerTakesAll>();
  ask<PerField>();
  ask<Fusion>();
  ask<PaperFusion>();  // averages headings as plain numbers, as the paper does: 350 and 20 give 185
}
