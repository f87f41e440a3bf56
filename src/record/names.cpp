// SPDX-License-Identifier: MIT
#include "record/names.hpp"

#include "pilot/outside.hpp"

namespace eyrie::record {
namespace {

std::string missile_name(const scenario::Scenario& scenario, const std::string& label, PlayerId id,
                         PlayerId shooter) {
  return fmt::format("{} #{} of {}", label, id.value, scenario.roster.name(shooter));
}

}  // namespace

const ubf::AnyTree* tree_of(const scenario::Scenario& scenario, const sim::Event& e) {
  if (!scenario.roster.find(e.who))
    return nullptr;
  const auto& trees = scenario.fleet_of(e.who).trees;
  return e.aux < trees.size() ? trees[e.aux] : nullptr;
}

bool is_outermost(const scenario::Scenario& scenario, const sim::Event& phase) {
  if (const ubf::AnyTree* tree = tree_of(scenario, phase))
    for (std::size_t i = 0; i < tree->size(); ++i)
      if (tree->node(static_cast<ubf::NodeIndex>(i)).is_sequencer())
        return static_cast<std::size_t>(phase.values[2]) == i;
  return false;
}

std::string node_label(const scenario::Scenario& scenario, const sim::Event& e, float node) {
  const ubf::AnyTree* tree = tree_of(scenario, e);
  return tree && node >= 0 && static_cast<std::size_t>(node) < tree->size()
             ? std::string(tree->node(static_cast<ubf::NodeIndex>(node)).label())
             : "";
}

std::string child_label(const scenario::Scenario& scenario, const sim::Event& phase, float child) {
  const ubf::AnyTree* tree = tree_of(scenario, phase);
  const auto node = static_cast<std::size_t>(phase.values[2]);
  if (!tree || node >= tree->size() || child < 0)
    return "";
  const auto children = tree->node(static_cast<ubf::NodeIndex>(node)).children();
  const auto i = static_cast<std::size_t>(child);
  return i < children.size() ? std::string(children[i]->label()) : "";
}

std::string phase_name(const scenario::Scenario& scenario, const sim::Event& phase) {
  const std::string name = child_label(scenario, phase, phase.values[1]);
  return name.empty() ? "?" : name;
}

std::string_view order_word(const sim::Event& order) {
  const bool on = order.values[1] == 1;
  switch (static_cast<pilot::OrderKind>(static_cast<std::uint16_t>(order.values[0]))) {
    case pilot::OrderKind::manual:
      return on ? "take_over" : "hand_back";
    case pilot::OrderKind::vote:
      return "vote";
    case pilot::OrderKind::weapons:
      return on ? "weapons_tight" : "weapons_free";
    case pilot::OrderKind::point:
      return "point";
    default:
      return order.values[0] == 3 ? "lose" : "swap_tree";
  }
}

std::string order_sentence(const scenario::Scenario& scenario, const sim::Event& order) {
  const std::string_view word = order_word(order);
  const ubf::AnyTree* tree = tree_of(scenario, order);
  const std::string by = tree ? std::string(tree->name()) : "?";
  if (word == "take_over")
    return "is taken over by a person";
  if (word == "hand_back")
    return fmt::format("is handed back to tree {}", by);
  if (word == "vote")
    return fmt::format("is told another vote of {}", node_label(scenario, order, order.values[1]));
  if (word == "weapons_tight" || word == "weapons_free")
    return word == "weapons_tight" ? "is told: weapons tight" : "is told: weapons free";
  if (word == "point")
    return order.values[1] == 2 ? "is told to fly its route again" : "is told to fly to a point";
  return fmt::format("is told to go by tree {}", by);
}

std::string name_in(const scenario::Scenario& scenario, const sim::World& world, PlayerId id) {
  const auto row = world.row(scenario.missiles.table, id);
  if (!row)
    return scenario.roster.find(id) ? scenario.roster.name(id)
                                    : fmt::format("missile {}", id.value);
  const model::MissileState& missile = world.rows(scenario.missiles.state)[*row];
  return missile_name(scenario, scenario.library->missiles[missile.type].label, id,
                      missile.shooter);
}

void Missiles::note(const sim::Event& e) {
  if (kind_of(e) == model::EventKind::launch)
    all_[e.who] = {PlayerId{e.detail}, e.whom, store_label(*scenario_, e.values[1])};
}

const Missiles::Missile* Missiles::find(PlayerId id) const {
  const auto at = all_.find(id);
  return at == all_.end() ? nullptr : &at->second;
}

std::string Missiles::name(PlayerId id) const {
  const Missile* missile = find(id);
  return missile ? missile_name(*scenario_, missile->label, id, missile->shooter)
                 : scenario_->roster.name(id);
}

std::string store_label(const scenario::Scenario& scenario, float index) {
  const auto& missiles = scenario.library->missiles;
  const auto i = static_cast<std::size_t>(index);
  return index >= 0 && i < missiles.size() ? missiles[i].label : "?";
}

}  // namespace eyrie::record
