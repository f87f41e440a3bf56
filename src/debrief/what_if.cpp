// SPDX-License-Identifier: MIT
#include "debrief/what_if.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "core/angle.hpp"
#include "debrief/explainer.hpp"
#include "debrief/values.hpp"
#include "record/tally.hpp"
#include "sim/snapshot.hpp"

namespace eyrie::debrief {
namespace {

template <class Field, class T>
Changed changed(const Field& field, const std::optional<T>& flown, const std::optional<T>& other) {
  const auto value = [&](const std::optional<T>& v) {
    return v ? action_value(field.name, field.unit, *v) : Value{.text = "-"};
  };
  const Value a = value(flown), b = value(other);
  Changed change{std::string(field.name), std::string(field.unit.si_symbol), a.text, b.text, {}};
  if (a.number && b.number && Field::is_number)
    change.difference =
        Field::is_direction ? angle_between(*a.number, *b.number) : *b.number - *a.number;
  return change;
}

/// Whether two arbiters mean the same: the last bits of a sum are not another decision.
template <class Field, class T>
bool same(const Field&, const std::optional<T>& a, const std::optional<T>& b) {
  if constexpr (Field::is_real) {
    constexpr double kRounding = 1e-11;
    if (a && b) {
      const double x = static_cast<double>(*a), y = static_cast<double>(*b);
      return std::fabs(x - y) <= kRounding * std::max({1.0, std::fabs(x), std::fabs(y)});
    }
  }
  return a == b;
}

template <class Action>
std::vector<Changed> changes(const Action& flown, const Action& other) {
  std::vector<Changed> all;
  ubf::for_each_field<Action>([&](const auto& f, auto) {
    if (!same(f, flown.*f.member, other.*f.member))
      all.push_back(changed(f, flown.*f.member, other.*f.member));
  });
  return all;
}

/// Asks two trees about the same states; the second keeps a memory of its own.
template <class State, class Action>
class Comparison {
 public:
  using Trees = ubf::Trees<State, Action>;
  Comparison(const Trees& flown, const Trees& other, WhatIf& result)
      : flown_(flown), other_(other), result_(result) {}

  void look(const team::Moment<State>& m) {
    const std::uint16_t index = m.state.agent.tree;
    const auto& flown = flown_[index];
    const auto& other = other_[index];
    if (index != tree_) {
      tree_ = index;
      slab_ = team::memory_for(other, flown, m);
    }
    const auto was = team::ask_again(flown, m);
    const auto would = team::ask_again(other, m, reinterpret_cast<std::byte*>(slab_.data()));
    compare(flown, other, m, was, would);
  }

 private:
  static std::string label(const ubf::Tree<State, Action>& tree, ubf::NodeIndex node) {
    return node == ubf::kNone ? "nobody" : std::string(tree.node(node).label());
  }
  void compare(const ubf::Tree<State, Action>& flown, const ubf::Tree<State, Action>& other,
               const team::Moment<State>& m, const ubf::Proposal<Action>& was,
               const ubf::Proposal<Action>& would) {
    ++result_.decisions;
    result_.steps.push_back(m.info.step);
    result_.leaders.push_back(would.leader);
    std::vector<Changed> fields = changes(was.action, would.action);
    const bool same = fields.empty();
    if (!same) {
      ++result_.different;
      if (!result_.first)
        result_.first = {m.info.step, m.info.time(), label(flown, was.leader),
                         label(other, would.leader), std::move(fields)};
      if (in_a_row_)
        result_.spans.back().second = m.info.time();
      else
        result_.spans.emplace_back(m.info.time(), m.info.time());
    }
    in_a_row_ = !same;
  }

  const Trees& flown_;
  const Trees& other_;
  WhatIf& result_;
  std::uint16_t tree_ = team::kNoTree;
  std::vector<std::uint64_t> slab_;
  bool in_a_row_ = false;
};

Outcome outcome_of(const scenario::Mission& mission, const record::Tally& tally) {
  const auto side = [&](model::Side s) {
    const auto sum = tally.side(s);
    return Outcome::Side{sum.losses, sum.shots, sum.kills, sum.home};
  };
  return {std::string(scenario::outcome_name(mission.outcome())), mission.run().time(),
          side(model::Side::blue), side(model::Side::red)};
}

}  // namespace

WhatIf what_if(const Recorded& recorded, const scenario::Scenario& other, PlayerId who,
               double from) {
  WhatIf result;
  const scenario::Scenario& flown = *recorded.scenario;
  const auto* pilots = find_system<pilot::PilotSystem>(*flown.simulation);
  const auto* drivers = find_system<driver::DriverSystem>(*flown.simulation);
  Comparison<pilot::State, pilot::Action> in_air(*flown.trees, *other.trees, result);
  Comparison<driver::State, driver::Action> on_ground(*flown.driver_trees, *other.driver_trees,
                                                      result);
  const bool drives = flown.roster.find(who)->platform == scenario::Platform::vehicle;
  Reflight flight(recorded);
  while (flight.step()) {
    if (flight.time() < from - 1e-9)
      continue;
    if (drives)
      drivers->revisit(flight.before(), flight.after(), who, flight.orders(),
                       [&](const auto& m) { on_ground.look(m); });
    else
      pilots->revisit(flight.before(), flight.after(), who, flight.orders(),
                      [&](const auto& m) { in_air.look(m); });
  }
  return result;
}

Outcome outcome_of(std::shared_ptr<const scenario::Scenario> scenario, std::uint64_t seed,
                   std::optional<double> until) {
  record::Tally tally(*scenario);
  scenario::Mission mission(scenario, seed, until);
  mission.run().attach(tally);
  mission.fly();
  return outcome_of(mission, tally);
}

Outcome outcome_of(const Recorded& recorded) {
  std::string problem;
  return branch(recorded, recorded.scenario, recorded.last_step(), recorded.until(), problem)
      .value();
}

std::optional<double> limit_of(const Recorded& recorded, const Outcome& flown) {
  const bool out_of_time = flown.outcome == scenario::outcome_name(scenario::Outcome::time);
  return out_of_time ? std::optional(recorded.until()) : std::nullopt;
}

std::optional<Outcome> branch(const Recorded& recorded,
                              std::shared_ptr<const scenario::Scenario> other, std::uint64_t step,
                              std::optional<double> until, std::string& problem) {
  record::Tally tally(*recorded.scenario);
  Reflight flight(recorded);
  flight.attach(tally);
  bool any_home = false;
  while (flight.after().step() < step && flight.step())
    for (const sim::Event& e : flight.events())
      any_home |= e.kind == sim::EventKind(model::EventKind::home);
  std::stringstream bytes;
  EYRIE_DEMAND(sim::save(flight.after(), bytes), "a stream in memory does not fail");
  sim::Loaded loaded = sim::load(other->simulation->shared_schema(), bytes);
  if (!loaded.world) {
    problem = "the change gives another world than the one flown: " + loaded.error;
    return std::nullopt;
  }
  scenario::Mission mission(other, std::move(*loaded.world), until.value_or(other->spec.until),
                            any_home);
  for (const sim::Order& order : recorded.run.orders)
    if (order.step >= step)
      static_cast<void>(mission.run().submit(order));
  mission.run().attach(tally);
  mission.fly();
  return outcome_of(mission, tally);
}

}  // namespace eyrie::debrief
