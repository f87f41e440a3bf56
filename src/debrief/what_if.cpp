// SPDX-License-Identifier: MIT
#include "debrief/what_if.hpp"

#include "core/yaml.hpp"

namespace eyrie::debrief {
namespace {

/// Asks the trees of two fleets about the same states; the second keeps a memory of its own.
class Twice {
 public:
  Twice(const scenario::Fleet& flown, const scenario::Fleet& other, WhatIf& result)
      : flown_(flown), other_(other), result_(result) {}

  void look(const team::AnyMoment& m) {
    if (m.tree != tree_) {
      tree_ = m.tree;
      slab_ = m.memory_for(*other_.agents);
    }
    team::Comparison found = m.compare(*other_.agents, reinterpret_cast<std::byte*>(slab_.data()));
    ++result_.decisions;
    result_.steps.push_back(m.info.step);
    result_.leaders.push_back(found.other);
    const bool same = found.fields.empty();
    if (!same) {
      ++result_.different;
      if (!result_.first)
        result_.first = {m.info.step, m.info.time(), flown_.trees[tree_]->label(found.flown),
                         other_.trees[tree_]->label(found.other), std::move(found.fields)};
      if (in_a_row_)
        result_.spans.back().second = m.info.time();
      else
        result_.spans.emplace_back(m.info.time(), m.info.time());
    }
    in_a_row_ = !same;
  }

 private:
  const scenario::Fleet& flown_;
  const scenario::Fleet& other_;
  WhatIf& result_;
  std::uint16_t tree_ = team::kNoTree;
  std::vector<std::uint64_t> slab_;
  bool in_a_row_ = false;
};

}  // namespace

Outcome outcome_of(const scenario::Mission& mission, const record::Tally& tally) {
  return {std::string(enum_name(mission.outcome())), mission.run().time(),
          tally.side(model::Side::blue), tally.side(model::Side::red)};
}

std::string outcome_text(const scenario::Mission& mission, const record::Tally& tally) {
  const auto blue = tally.side(model::Side::blue), red = tally.side(model::Side::red);
  using Ending = scenario::Outcome;
  std::string text;
  switch (mission.outcome()) {
    case Ending::blue_home:
      text = blue.players ? fmt::format("blue is home, {} of {}", blue.home, blue.players)
                          : "blue has arrived";
      break;
    case Ending::blue_lost:
      text = "no blue player is left";
      break;
    case Ending::red_lost:
      text = "no red player is left";
      break;
    case Ending::time:
      text = fmt::format("time is up at {}", record::clock_text(mission.run().time()));
      break;
    case Ending::fault:
      text = fmt::format("a fault ended it at {}", record::clock_text(mission.run().time()));
      break;
    default:
      text = fmt::format("stopped at {}", record::clock_text(mission.run().time()));
      break;
  }
  return fmt::format("{}; losses: blue {}, red {}", text, blue.losses, red.losses);
}

WhatIf what_if(const Recorded& recorded, const scenario::Scenario& other, PlayerId who,
               double from) {
  WhatIf result;
  const scenario::Scenario& flown = *recorded.scenario;
  const scenario::Fleet& fleet = flown.fleet_of(who);
  Twice twice(fleet, other.fleet_of(who), result);
  Reflight flight(recorded);
  std::optional<Decision> first;  // which has the names
  while (flight.step()) {
    if (flown.find(flight.after(), who))
      result.until = flight.time();
    if (flight.time() < from - 1e-9)
      continue;
    fleet.agents->look_again(flight.before(), flight.after(), who, flight.orders(),
                             [&](const team::AnyMoment& m) { twice.look(m); });
    if (!result.first || first)
      continue;
    first = explain(flown, flight.before(), flight.after(), who, flight.orders());
    for (Changed& field : result.first->fields)
      for (std::string* text : {&field.flown, &field.other})
        put_names(*text, *first, flown);
  }
  return result;
}

Outcome outcome_of(const Recorded& recorded) {
  return Branch(recorded, recorded.scenario, past_at(recorded, recorded.last_step()),
                recorded.until())
      .fly();
}

std::optional<double> limit_of(const Recorded& recorded, const Outcome& flown) {
  const bool out_of_time = flown.outcome == enum_name(scenario::Outcome::time);
  return out_of_time ? std::optional(recorded.until()) : std::nullopt;
}

Branch::Branch(const Recorded& recorded, std::shared_ptr<const scenario::Scenario> other,
               const Past& past, std::optional<double> until)
    : tally_(*recorded.scenario), before_(past.world) {
  for (const Happened& happened : past.events)
    tally_.observe(past.world, happened.info, happened.events);
  const double end = until.value_or(other->spec.until);
  mission_.emplace(std::move(other), past.world, end, tally_.side(model::Side::blue).home > 0);
  for (const sim::Order& order : recorded.run.orders)
    if (order.step >= before_.step())
      static_cast<void>(mission_->run().submit(order));
  mission_->run().attach(tally_);
}

std::unique_ptr<Branch> branch(const Recorded& recorded,
                               std::shared_ptr<const scenario::Scenario> other, const Past& past,
                               std::optional<double> until, std::string& problem) {
  std::optional<sim::World> world = past.world.moved_to(other->simulation->shared_schema());
  if (!world) {
    problem =
        "the change gives another world than the one flown: other columns, or too little room";
    return nullptr;
  }
  return std::make_unique<Branch>(recorded, std::move(other), Past{std::move(*world), past.events},
                                  until);
}

bool Branch::step() {
  before_ = mission_->run().world();
  if (mission_->step())
    return true;
  mission_->run().finish();
  return false;
}

Outcome Branch::fly() {
  while (step()) {
  }
  return outcome();
}

namespace {

/// The tree that a player begins with.
std::string tree_of(const scenario::Scenario& scenario, PlayerId who) {
  const auto found = scenario.find(*scenario.start, who);
  if (!found)
    return "";
  const auto tree = found->fleet.agents->last_decision(*scenario.start, found->row).tree;
  return tree < found->fleet.trees.size() ? std::string(found->fleet.trees[tree]->name()) : "";
}

/// The paths of the nodes of the tree of that name, whoever uses it, in pre-order.
std::vector<std::string> paths_of(const scenario::Scenario& scenario, const std::string& name) {
  std::vector<std::string> paths;
  for (const auto& fleet : scenario.fleets)
    for (const ubf::AnyTree* tree : fleet->trees)
      for (std::size_t i = 0; tree->name() == name && paths.size() < tree->size(); ++i)
        paths.push_back(tree->path(static_cast<ubf::NodeIndex>(i)));
  return paths;
}

/// False if the text is no override of a node.
bool read_change(const scenario::Scenario& scenario, PlayerId who, const std::string& text,
                 std::vector<scenario::TreeChange>& changes, Diagnostics& diagnostics) {
  const std::size_t equals = text.find('='), colon = text.substr(0, equals).find(':');
  const std::size_t begin = colon == text.npos ? 0 : colon + 1;
  std::string node = text.substr(begin, equals - begin), key;
  if (equals == text.npos ||
      !(node == "root" || node.starts_with("root/") || node.starts_with("root.")))
    return false;
  const auto at = [&](std::size_t offset) {
    return Location{"--set " + text, 1, static_cast<int>(offset) + 1};
  };
  const auto wrong = [&](std::size_t offset, std::string message) {
    diagnostics.error(at(offset), std::move(message));
    return true;
  };
  const std::string tree = begin > 1 ? text.substr(0, colon) : tree_of(scenario, who);
  const auto paths = paths_of(scenario, tree);
  if (paths.empty())
    return wrong(0, fmt::format("there is no tree {}", quote(tree)));
  auto found = std::find(paths.begin(), paths.end(), node);
  const std::size_t point = node.rfind('.');
  const bool names_key = found == paths.end() && point != node.npos;
  if (names_key) {
    key = node.substr(point + 1);
    node.resize(point);
    found = std::find(paths.begin(), paths.end(), node);
  }
  if (found == paths.end())
    return wrong(begin, fmt::format("tree {} has no node {}{}", quote(tree), quote(node),
                                    did_you_mean(node, paths)));
  if (names_key && key.empty())
    return wrong(equals, "a parameter is missing behind the point");
  Diagnostics in_value;
  eyrie::Value value = eyrie::parse_yaml(text.substr(equals + 1), "--set", in_value);
  if (!in_value.ok())
    return wrong(equals + 1, in_value.sorted().front().message);
  value.where = at(equals + 1);
  changes.push_back({tree,
                     {.node = static_cast<ubf::NodeIndex>(found - paths.begin()),
                      .key = key,
                      .value = std::move(value),
                      .where = at(begin + (names_key ? point + 1 : 0))}});
  return true;
}

}  // namespace

Overrides read_overrides(const scenario::Scenario& scenario, PlayerId who,
                         const std::vector<std::string>& texts, Diagnostics& diagnostics) {
  Overrides out;
  for (const std::string& text : texts)
    if (!read_change(scenario, who, text, out.changes, diagnostics))
      out.sets.push_back(text);
  return out;
}

}  // namespace eyrie::debrief
