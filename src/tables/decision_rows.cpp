// SPDX-License-Identifier: MIT
#include "tables/decision_rows.hpp"

namespace eyrie::tables {
namespace {

/// "speed_m_s", "load_factor", "release_order"
std::string column_of(const ubf::ActionFieldInfo& field) {
  std::string name(field.name);
  if (!field.is_real)
    return name + "_order";
  if (!field.unit.si_symbol.empty())
    name += "_" + std::string(field.unit.si_symbol);
  std::replace(name.begin(), name.end(), '/', '_');
  return name;
}

std::vector<Cell> cells_of(std::span<const debrief::Value> values,
                           std::span<const ActionColumn> columns) {
  std::vector<Cell> cells(columns.size());
  for (const debrief::Value& value : values) {
    const auto at = std::ranges::find(columns, value.name, &ActionColumn::name);
    if (at == columns.end())
      continue;
    Cell& cell = cells[static_cast<std::size_t>(at - columns.begin())];
    if (value.number)
      cell = *value.number;
    else if (at->is_words)
      cell = value.text;
  }
  return cells;
}

}  // namespace

void add_columns(std::span<const ubf::ActionFieldInfo> fields, std::vector<ActionColumn>& columns) {
  for (const ubf::ActionFieldInfo& field : fields)
    if (std::ranges::none_of(columns, [&](const ActionColumn& c) { return c.name == field.name; }))
      columns.push_back({std::string(field.name), column_of(field),
                         std::string(field.unit.si_symbol), field.is_words, field.is_real});
}

std::vector<ActionColumn> action_columns(const scenario::Scenario& scenario) {
  std::vector<ActionColumn> columns;
  for (const auto& fleet : scenario.fleets)
    if (fleet->agents)
      add_columns(fleet->agents->action_fields(), columns);
  return columns;
}

Answers answers_of(const debrief::Decision& d, std::span<const ActionColumn> columns,
                   const Answers* before) {
  Answers answers(d.nodes.size());
  for (std::size_t i = 0; i < d.nodes.size(); ++i) {
    const debrief::Answer& node = d.nodes[i];
    if (node.asked)
      answers[i] = {.status = std::string(ubf::to_text(node.status)),
                    .why = node.why,
                    .vote = node.vote,
                    .halts = node.halts,
                    .action = cells_of(node.action, columns)};
  }
  // what a composite hands on is what some leaf below it said
  for (std::size_t i = 0; i < d.nodes.size(); ++i) {
    if (!answers[i] || d.nodes[i].is_leaf || d.nodes[i].action.empty())
      continue;
    const auto same = [&](std::size_t leaf) {
      return answers[leaf] && d.nodes[leaf].is_leaf && answers[leaf]->action == answers[i]->action;
    };
    if (before && (*before)[i] && (*before)[i]->hands_on != ubf::kNone &&
        same((*before)[i]->hands_on))
      answers[i]->hands_on = (*before)[i]->hands_on;
    for (std::size_t leaf = i + 1; answers[i]->hands_on == ubf::kNone && leaf < d.nodes.size() &&
                                   d.nodes[leaf].depth > d.nodes[i].depth;
         ++leaf)
      if (same(leaf))
        answers[i]->hands_on = static_cast<ubf::NodeIndex>(leaf);
    if (answers[i]->hands_on != ubf::kNone)
      answers[i]->action.assign(columns.size(), Cell());
  }
  return answers;
}

std::vector<Cell> action_of(const debrief::Decision& d, std::span<const ActionColumn> columns) {
  return d.nodes.empty() ? std::vector<Cell>(columns.size())
                         : cells_of(d.nodes.front().action, columns);
}

std::vector<Cell> decision_row(const debrief::Decision& d, const scenario::Roster& roster,
                               std::span<const ActionColumn> columns) {
  const debrief::Answer* leader = d.leader < d.nodes.size() ? &d.nodes[d.leader] : nullptr;
  std::vector<Cell> row{d.time,
                        static_cast<double>(d.step),
                        roster.name(d.player),
                        d.tree,
                        std::string(ubf::to_text(d.status)),
                        static_cast<double>(d.vote),
                        leader ? leader->label : "",
                        leader ? leader->path : "",
                        roster.name(d.attacks)};
  for (Cell& cell : action_of(d, columns))
    row.push_back(std::move(cell));
  return row;
}

bool Chooser::wants(const debrief::Decision& d) {
  Last& last = last_[d.player];
  const bool first = last.time < 0;
  constexpr double kRounding = 1e-9;
  if (!first && selection_.every > 0 &&
      std::floor(d.time / selection_.every + kRounding) ==
          std::floor(last.time / selection_.every + kRounding))
    return false;
  if (selection_.changes_only) {
    std::vector<Cell> orders = action_of(d, columns_);
    for (std::size_t i = 0; i < orders.size(); ++i)
      if (columns_[i].is_real && orders[i] != Cell())
        orders[i] = 1.0;
    if (!first && d.tree == last.tree && d.leader == last.leader && orders == last.orders)
      return false;
    last.tree = d.tree;
    last.leader = d.leader;
    last.orders = std::move(orders);
  }
  last.time = d.time;
  return true;
}

bool each_decision(debrief::Reflight& flight, const scenario::Scenario& scenario, Chooser& chooser,
                   const std::function<bool()>& stop,
                   const std::function<void(const debrief::Decision&)>& use) {
  while (!stop()) {
    if (!flight.step())
      return true;
    for (std::uint32_t id = 1; id <= scenario.roster.players.size(); ++id)
      if (chooser.wants(PlayerId{id}))
        if (const auto decision = debrief::explain(scenario, flight.before(), flight.after(),
                                                   PlayerId{id}, flight.orders());
            decision && chooser.wants(*decision))
          use(*decision);
  }
  return false;
}

}  // namespace eyrie::tables
