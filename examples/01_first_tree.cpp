// SPDX-License-Identifier: MIT
/// Behaviors recommend, an arbiter decides: the Unified Behavior Framework without any aircraft.
#include <fmt/format.h>

#include "ubf/standard_nodes.hpp"

struct State {
  double battery = 1;   // 0 .. 1
  double obstacle = 9;  // m, straight ahead
};
struct Action {
  std::optional<double> turn;   // rad
  std::optional<double> speed;  // m/s
};

template <>
struct eyrie::ubf::ActionTraits<Action> {
  static constexpr auto fields = std::tuple{field<blend::Angle>("turn", &Action::turn, "rad"),
                                            field<blend::Mean>("speed", &Action::speed, "m/s")};
};

using namespace eyrie::ubf;
using Node = Behavior<State, Action>;

struct Wander : Node {
  static constexpr std::string_view type_name = "wander", help = "drives on";
  Status tick(const Tick<State>&, Proposal<Action>& out) const override {
    out = {{.turn = 0.1, .speed = 1.0}, 10};
    return Status::running;
  }
};
struct Avoid : Node {
  static constexpr std::string_view type_name = "avoid", help = "turns away from what is near";
  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    if (t.state.obstacle > 2)
      return Status::failure;  // nothing to avoid: ignored by the arbiter
    out = {{.turn = 1.5, .speed = 0.2}, 50};
    return Status::running;
  }
};
struct Recharge : Node {
  static constexpr std::string_view type_name = "recharge", help = "stops when the battery is low";
  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    out.action.speed = 0.0;
    out.vote = static_cast<float>(60 * (1 - t.state.battery));  // the emptier, the louder
    return Status::running;
  }
};

int main() {
  const Tree<State, Action> tree("robot", make<WinnerTakesAll<State, Action>>(
                                              make<Wander>(), make<Avoid>(), make<Recharge>()));
  for (const State state :
       {State{.battery = 0.9, .obstacle = 8}, State{.battery = 0.8, .obstacle = 1},
        State{.battery = 0.1, .obstacle = 1}}) {
    Proposal<Action> decided;
    tree.tick({.state = state}, decided);
    fmt::print("battery {:.1f}, obstacle at {:.0f} m: {} wins with {:.0f}, speed {:.1f} m/s\n",
               state.battery, state.obstacle, tree.path(decided.leader), decided.vote,
               decided.action.speed.value());
  }
}
