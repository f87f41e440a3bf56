// SPDX-License-Identifier: MIT
/// \file  Writes what the arbiters make of random proposals, for the tests of the page's own
/// arbitration (viewer/test): one JSON object to the file that is named.
#include <cstdio>
#include <fstream>

#include "core/draw.hpp"
#include "page/decisions.hpp"
#include "page/tree_json.hpp"
#include "ubf/standard_nodes.hpp"

namespace {

using namespace eyrie;
using page::Json;

struct Action {
  std::optional<double> heading{};         ///< rad
  std::optional<double> altitude{};        ///< m
  std::optional<double> speed{};           ///< m/s
  std::optional<std::uint32_t> route{};    ///< kept if all agree
  std::optional<std::uint32_t> release{};  ///< the strongest
};

struct Cue {
  ubf::Status status = ubf::Status::failure;
  float vote = 0;
  Action action{};
};
struct State {
  std::vector<Cue> cues;
  double fuel = 0;   ///< kg
  double range = 0;  ///< m, NaN: there is no target
  bool alarm = false;
};

}  // namespace

template <>
struct eyrie::ubf::StateFields<State> {
  static std::span<const StateField<State>> all() {
    using F = FieldsOf<State>;
    static constexpr std::array kFields = {
        F::number("fuel", "kg", "on board", [](const State& s) { return s.fuel; }),
        F::number("range", "m", "of the target", [](const State& s) { return s.range; }),
        F::flag("alarm", "", [](const State& s) { return s.alarm ? 1.0 : 0.0; })};
    return kFields;
  }
};

template <>
struct eyrie::ubf::ActionTraits<Action> {
  static constexpr auto fields = std::tuple{
      field<blend::Angle>("heading", &Action::heading, "rad"),
      field<blend::Mean>("altitude", &Action::altitude, "m"),
      field<blend::Mean>("speed", &Action::speed, "m/s"),
      field<blend::Agreed>("route", &Action::route),
      field<blend::Strongest>("release", &Action::release),
  };
};

namespace {

using Node = ubf::Behavior<State, Action>;
using Child = std::unique_ptr<Node>;

/// Answers as its cue says.
class Probe final : public Node {
 public:
  static constexpr std::string_view type_name = "probe";
  explicit Probe(std::size_t cue) : cue_(cue) {}
  ubf::Status tick(const ubf::Tick<State>& t, ubf::Proposal<Action>& out) const override {
    out.action = t.state.cues[cue_].action;
    out.vote = t.state.cues[cue_].vote;
    return t.state.cues[cue_].status;
  }

 private:
  std::size_t cue_;
};

class Maker {
 public:
  explicit Maker(std::uint64_t seed) : draw_(seed, PlayerId{1}, Stream::test, 0) {}

  [[nodiscard]] Child tree() { return composite(0); }
  /// s, until the next tick.
  [[nodiscard]] double pause() { return 0.1 * (1 + pick(3)); }
  [[nodiscard]] State state() {
    State s;
    for (std::size_t i = 0; i < cues_; ++i)
      s.cues.push_back(cue());
    s.fuel = 500.0 * pick(4);
    s.range = pick(4) ? 1000.0 * pick(9) : ubf::kNoValue;
    s.alarm = pick(3) == 0;
    return s;
  }

 private:
  [[nodiscard]] std::uint32_t pick(std::uint32_t count) {
    return static_cast<std::uint32_t>(draw_.uniform() * count);
  }
  [[nodiscard]] Child node(std::size_t depth) {
    return depth < 3 && pick(3) == 0 ? composite(depth) : ubf::make<Probe>(cues_++);
  }
  template <class B>
  [[nodiscard]] std::unique_ptr<B> with_children(std::size_t depth) {
    return with_children<B>(depth, 1 + pick(4));
  }
  template <class B>
  [[nodiscard]] std::unique_ptr<B> with_children(std::size_t depth, std::uint32_t count) {
    std::vector<Child> children;
    for (std::uint32_t i = 0; i < count; ++i)
      children.push_back(node(depth + 1));
    auto made = ubf::make<B>(std::move(children));
    if constexpr (requires { made->vote_scale; }) {
      if (pick(4) == 0)
        made->vote_scale = 0.3F * static_cast<float>(pick(5));
      else if (pick(6) == 0)
        made->vote = static_cast<float>(pick(5));
    }
    return made;
  }
  [[nodiscard]] Child composite(std::size_t depth) {
    using S = State;
    using A = Action;
    switch (pick(16)) {
      case 0:
        return with_children<ubf::PerField<S, A>>(depth);
      case 1:
      case 2: {
        auto fusion = with_children<ubf::Fusion<S, A>>(depth);
        if (pick(2))
          fusion->top = 1 + pick(3);
        if (pick(3) == 0)
          fusion->conflicts = ubf::Conflicts::drop;
        return fusion;
      }
      case 3: {
        auto paper = with_children<ubf::PaperFusion<S, A>>(depth);
        paper->high_vote = static_cast<float>(pick(5));
        return paper;
      }
      case 4: {
        auto priority = with_children<ubf::Priority<S, A>>(depth);
        if (pick(2))
          for (std::size_t i = 0; i < priority->children().size(); ++i)
            priority->interruptible.push_back(pick(2) != 0);
        return priority;
      }
      case 5: {
        auto schema = with_children<ubf::MotorSchema<S, A>>(depth);
        schema->direction.choose("heading");
        schema->magnitude.choose("speed");
        schema->unit_vote = 2;
        return schema;
      }
      case 6:
        return with_children<ubf::Selector<S, A>>(depth);
      case 7:
        return with_children<ubf::Sequence<S, A>>(depth);
      case 8: {
        auto commitment = with_children<ubf::Commitment<S, A>>(depth);
        commitment->margin = 0.7F * static_cast<float>(pick(3));
        commitment->min_time = 0.2 * pick(4);
        commitment->hold = 0.1 + 0.2 * pick(4);
        return commitment;
      }
      case 9: {
        auto suppress = with_children<ubf::Suppress<S, A>>(depth, 2);
        suppress->hold = 0.2 * pick(4);
        return suppress;
      }
      case 10: {
        auto inhibit = with_children<ubf::Inhibit<S, A>>(depth, 2);
        inhibit->hold = 0.2 * pick(4);
        return inhibit;
      }
      case 11:
      case 12:
        return verify(depth);
      case 13:
        return over_grid<ubf::VoteGrid<S, A>>(depth);
      case 14:
        return over_grid<ubf::Utility<S, A>>(depth);
      default:
        return with_children<ubf::WinnerTakesAll<S, A>>(depth);
    }
  }
  [[nodiscard]] Child verify(std::size_t depth) {
    auto verify = with_children<ubf::Verify<State, Action>>(depth);
    verify->fallback = verify->children().size() > 1 && pick(2) != 0;
    if (pick(2))
      verify->bounds.set("heading", radians(90.0 * pick(4)), radians(90.0 * pick(4)));
    const std::optional<double> least = 1000.0 * pick(2);
    if (pick(2))
      verify->bounds.set("altitude", least, pick(2) ? std::optional(3000.0) : std::nullopt);
    if (pick(2))
      verify->bounds.set("route", std::nullopt, 0.0);
    static constexpr std::array kRefusals = {
        "action.altitude < range and not alarm",
        "fuel <= 500 kg and (action.release > 0 or action.speed != 200 m/s)",
        "alarm or action.route == action.release",
        "not (action.heading >= 90 deg) or range > 5 km",
    };
    if (pick(2) || verify->bounds.empty())
      verify->add_refusal(refusal(kRefusals[pick(4)]));
    if (pick(3) == 0)
      verify->add_refusal(refusal(kRefusals[pick(4)]));
    return verify;
  }
  [[nodiscard]] static ubf::ActionExpression<State, Action> refusal(const char* words) {
    using Expression = ubf::ActionExpression<State, Action>;
    ubf::FieldNames names;
    Diagnostics diagnostics;
    auto program = ubf::parse_expression(eyrie::Value::scalar(words), Expression::fields(), names,
                                         diagnostics);
    EYRIE_ASSERT(program.has_value());
    return Expression(std::move(*program));
  }
  template <class Arbiter>
  [[nodiscard]] Child over_grid(std::size_t depth) {
    auto made = with_children<Arbiter>(depth);
    const bool spreads = std::is_same_v<Arbiter, ubf::Utility<State, Action>> && pick(3);
    const double from = radians(45.0 * pick(3));
    made->grid.add("heading", from, from + radians(pick(2) ? 360 : 180), 8 + pick(9),
                   radians(30.0 * (1 + pick(4))), spreads ? radians(20.0) : 0);
    if (pick(3) == 0)
      made->grid.add("speed", 50, 250, 5 + pick(3), 100, spreads ? 40 : 0);
    return made;
  }
  /// Few different votes and values, so that ties and agreement happen.
  [[nodiscard]] Cue cue() {
    Cue c;
    const auto status = pick(5);
    c.status = status == 0   ? ubf::Status::failure
               : status == 1 ? ubf::Status::success
                             : ubf::Status::running;
    c.vote = pick(4) == 0 ? 0 : static_cast<float>(pick(6)) * 0.7F;
    if (pick(3))
      c.action.heading = pick(2) ? radians(90.0 * pick(4)) : radians(draw_.uniform() * 360);
    if (pick(3))
      c.action.altitude = pick(2) ? 1000.0 * pick(3) : draw_.uniform() * 12'000;
    if (pick(3))
      c.action.speed = pick(2) ? 100.0 * pick(3) : draw_.uniform() * 300;
    if (pick(2))
      c.action.route = pick(2);
    if (pick(3) == 0)
      c.action.release = pick(3);
    return c;
  }

  Draw draw_;
  std::size_t cues_ = 0;
};

Json action_json(const Action& action) {
  Json values = Json::array();
  ubf::for_each_field<Action>([&](const auto& f, auto) {
    const auto& value = action.*f.member;
    values.push_back(value ? Json(*value) : Json());
  });
  return values;
}

Json index_or_nobody(ubf::NodeIndex node) {
  return node == ubf::kNone ? Json(-1) : Json(node);
}

/// What every node answered in one tick, and what the leaves had proposed.
Json answers_json(const ubf::Tree<State, Action>& tree, const ubf::Trace<Action>& trace) {
  Json leaves = Json::array(), expected = Json::array();
  for (std::size_t i = 0; i < tree.size(); ++i) {
    const auto node = static_cast<ubf::NodeIndex>(i);
    const auto& row = trace.row(node);
    if (!row.ticked) {
      expected.push_back(Json());
      continue;
    }
    Json supplier = Json::array();
    for (const ubf::NodeIndex from : row.supplier)
      supplier.push_back(index_or_nobody(from));
    const Json action = action_json(row.proposal.action);
    expected.push_back({{"status", ubf::to_text(row.status)},
                        {"vote", row.proposal.vote},
                        {"leader", index_or_nobody(row.proposal.leader)},
                        {"action", action},
                        {"supplier", supplier}});
    if (tree.node(node).children().empty())
      leaves.push_back({{"node", i},
                        {"status", ubf::to_text(row.status)},
                        {"vote", row.proposal.vote},
                        {"action", action}});
  }
  return {{"leaves", leaves}, {"expected", expected}};
}

/// One tree over some ticks, in which it remembers.
Json case_json(Maker& maker) {
  const ubf::Tree<State, Action> tree("vectors", maker.tree());
  std::vector<std::uint64_t> slab(tree.memory_bytes() / 8 + 1);
  ubf::Trace<Action> trace(tree.size());
  Json ticks = Json::array();
  double time = 0;
  for (int i = 0; i < 6; ++i) {
    const State state = maker.state();
    ubf::Proposal<Action> out;
    static_cast<void>(tree.tick({.state = state,
                                 .time = time,
                                 .memory = reinterpret_cast<std::byte*>(slab.data()),
                                 .trace = &trace},
                                out));
    ticks.push_back(answers_json(tree, trace));
    ticks.back()["t"] = time;
    for (const auto& field : ubf::StateFields<State>::all())
      ticks.back()["state"].push_back(page::number_or_null(field.read(state)));
    time += maker.pause();
  }
  return {{"tree", page::tree_json(tree, "aircraft")["nodes"]}, {"ticks", ticks}};
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: arbitration_vectors FILE\n");
    return 2;
  }
  Json cases = Json::array();
  for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
    Maker maker(seed);
    cases.push_back(case_json(maker));
  }
  std::ofstream out(argv[1]);
  out << Json{{"action", page::action_fields<Action>()}, {"cases", cases}}.dump();
  return out.flush() ? 0 : 1;
}
