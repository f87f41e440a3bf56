// SPDX-License-Identifier: MIT
/// A tree from YAML with the library of behaviors alone, and with a mistake in it.
#include <fmt/format.h>

#include "core/yaml.hpp"
#include "ubf/standard_nodes.hpp"

struct State {
  double obstacle = 9;  // m, straight ahead
};
struct Action {
  std::optional<double> turn;  // rad
};

template <>
struct eyrie::ubf::ActionTraits<Action> {
  static constexpr auto fields = std::tuple{field<blend::Angle>("turn", &Action::turn, "rad")};
};
template <>
struct eyrie::ubf::StateFields<State> {
  static std::span<const StateField<State>> all() {
    static constexpr std::array kFields{FieldsOf<State>::number(
        "obstacle", "m", "straight ahead", [](const State& s) { return s.obstacle; })};
    return kFields;
  }
};

using namespace eyrie::ubf;

struct Turn : Behavior<State, Action> {
  static constexpr std::string_view type_name = "turn", help = "turns";
  static constexpr auto params() {
    return std::tuple{eyrie::param("by", &Turn::by, "rad", eyrie::range(-3.2, 3.2), "how far"),
                      eyrie::param("vote", &Turn::vote, eyrie::range(0, 100), "how strongly")};
  }
  double by = 0;
  float vote = 10;
  Status tick(const Tick<State>&, Proposal<Action>& out) const override {
    out.action.turn = by;
    out.vote = vote;
    return Status::running;
  }
};

int main() {
  Registry<State, Action> registry;
  add_standard_nodes(registry);
  registry.add<Turn>();
  for (const std::string text :
       {"winner_takes_all:\n"
        "  - turn: {by: 5 deg}\n"
        "  - guard:\n"
        "      when: obstacle < 2 m\n"
        "      child: {turn: {by: 90 deg, name: avoid, vote: {most: 50, of: obstacle, "
        "from: 2 m, to: 0 m}}}\n",
        "turn: {buy: 5 deg}\n"}) {
    eyrie::Diagnostics mistakes;
    const auto tree =
        registry.build_tree("robot", eyrie::parse_yaml(text, "robot.yaml", mistakes), mistakes);
    if (!tree) {
      fmt::print("{}\n", mistakes.text());
      continue;
    }
    std::vector<std::byte> slab(tree->memory_bytes());
    for (const double obstacle : {9.0, 1.0}) {
      Proposal<Action> out;
      tree->tick({.state = {obstacle}, .memory = slab.data()}, out);
      fmt::print("{} m: {} with {}\n", obstacle, tree->path(out.leader), out.vote);
    }
  }
}
