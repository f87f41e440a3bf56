// SPDX-License-Identifier: MIT
#include "debrief/what_if.hpp"

#include "core/yaml.hpp"
#include "scenario/source.hpp"

namespace eyrie::debrief {
namespace {

/// A player's trees of another scenario, asked about every state from the start of a run on, with a
/// memory of their own.
class OtherTrees {
 public:
  OtherTrees(const scenario::Fleet& flown, const scenario::Fleet& other, PlayerId who)
      : flown_(flown), other_(other), who_(who) {}

  /// Looks at the next step: `use(moment, comparison)` if the player decided in it.
  template <class Use>
  void look(const Reflight& flight, Use use) {
    for (const sim::Order& order : flight.orders())
      if (order.player == who_ && swaps_tree(order))
        tree_ = team::kNoTree;
    flown_.agents->look_again(flight.before(), flight.after(), who_, flight.orders(),
                              [&](const team::AnyMoment& m) {
                                if (m.tree != tree_)  // with nothing remembered
                                  slab_.assign(other_.trees[m.tree]->memory_bytes() / 8 + 1, 0);
                                tree_ = m.tree;
                                use(m, m.compare(*other_.agents, bytes()));
                              });
  }
  /// Puts what they remember now into a row of a world of theirs.
  void remember(sim::World& world, std::size_t row) {
    const std::span<std::byte> memory = other_.agents->memory(world, row);
    std::ranges::fill(memory, std::byte{0});
    if (tree_ != team::kNoTree)
      std::copy_n(bytes(), other_.trees[tree_]->memory_bytes(), memory.begin());
  }

 private:
  [[nodiscard]] bool swaps_tree(const sim::Order& order) const {
    return order.kind == flown_.agents->order_tree(order.step, who_, 0).kind &&
           order.as<team::SwapTree>().tree < flown_.trees.size();
  }
  [[nodiscard]] std::byte* bytes() { return reinterpret_cast<std::byte*>(slab_.data()); }

  const scenario::Fleet& flown_;
  const scenario::Fleet& other_;
  PlayerId who_;
  std::uint16_t tree_ = team::kNoTree;
  std::vector<std::uint64_t> slab_;
};

/// One of whom all is asked, step by step.
class Asked {
 public:
  Asked(const scenario::Scenario& flown, const scenario::Scenario& other, PlayerId player,
        double from)
      : who(player),
        flown_(flown),
        other_(other),
        trees_(flown.fleet_of(player), other.fleet_of(player), player),
        from_(from) {}

  /// Looks at the next step.
  void look(const Reflight& flight) {
    if (flown_.find(flight.after(), who))
      result.until = flight.time();
    if (!result.fault.empty())
      return;
    const bool had_first = result.first.has_value();
    trees_.look(flight, [&](const team::AnyMoment& m, team::Comparison found) {
      note(m, std::move(found));
    });
    if (had_first || !result.first)
      return;
    const std::optional<Decision> names =
        explain(flown_, flight.before(), flight.after(), who, flight.orders());
    for (Changed& field : result.first->fields)
      for (std::string* text : {&field.flown, &field.other})
        put_names(*text, *names, flown_);
  }

  PlayerId who;
  WhatIf result{};

 private:
  void note(const team::AnyMoment& m, team::Comparison found) {
    const double time = m.info.time();
    if (found.fault) {
      result.fault = scenario::fault_text(*found.fault, other_.roster, m.info.dt);
      return;
    }
    if (time < from_ - 1e-9)
      return;
    ++result.decisions;
    result.steps.push_back(m.info.step);
    result.leaders.push_back(found.other);
    const bool same = found.fields.empty();
    if (!same) {
      ++result.different;
      if (!result.first)
        result.first = {m.info.step, time, flown_.fleet_of(who).trees[m.tree]->label(found.flown),
                        other_.fleet_of(who).trees[m.tree]->label(found.other),
                        std::move(found.fields)};
      if (in_a_row_)
        result.spans.back().second = time;
      else
        result.spans.emplace_back(time, time);
    }
    in_a_row_ = !same;
  }

  const scenario::Scenario& flown_;
  const scenario::Scenario& other_;
  OtherTrees trees_;
  double from_;
  bool in_a_row_ = false;
};

bool any_remembers(const scenario::Scenario& scenario) {
  return std::ranges::any_of(scenario.all_trees(),
                             [](const ubf::AnyTree* tree) { return tree->memory_bytes() > 0; });
}

/// Puts into a world of `other`, which was flown as recorded up to there, what its trees would
/// remember. Memory of the trees that were flown means nothing to them.
void remember(const Recorded& recorded, const scenario::Scenario& other, sim::World& world) {
  std::vector<std::pair<OtherTrees, std::size_t>> players;  // with their rows
  for (std::size_t f = 0; f < other.fleets.size(); ++f)
    for (std::size_t row = 0; row < other.fleets[f]->rows(world); ++row)
      players.emplace_back(OtherTrees(*recorded.scenario->fleets[f], *other.fleets[f],
                                      other.fleets[f]->id(world, row)),
                           row);
  if (any_remembers(other)) {
    Reflight flight(recorded, recorded.scenario->world(recorded.run.seed));
    while (flight.after().step() < world.step() && flight.step())
      for (auto& [trees, row] : players)
        trees.look(flight, [](const auto&, const auto&) {});
  }
  for (auto& [trees, row] : players)
    trees.remember(world, row);
}

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
  for (const ubf::AnyTree* tree : scenario.all_trees())
    if (tree->name() == name)
      return tree->paths();
  return {};
}

/// False if the text is no override of a node.
bool read_change(const scenario::Scenario& scenario, PlayerId who, const std::string& text,
                 std::vector<scenario::TreeChange>& changes, Diagnostics& diagnostics) {
  std::size_t equals = text.find('=');
  const std::size_t colon = text.substr(0, equals).find(':');
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
  if (tree.empty())
    return wrong(0, fmt::format("{} begins with no tree", scenario.roster.name(who)));
  if (paths.empty())
    return wrong(
        0, fmt::format("there is no tree {}{}", quote(tree),
                       did_you_mean(tree, listed(scenario.all_trees(), &ubf::AnyTree::name))));
  for (const std::string& path : paths)  // one with a '=' in a label
    if (path.starts_with(node) && text.compare(begin, path.size(), path) == 0)
      equals = std::max(equals, std::min(text.find('=', begin + path.size()), text.size()));
  node = text.substr(begin, equals - begin);
  auto found = std::ranges::find(paths, node);
  const std::size_t point = node.rfind('.');
  const bool names_key = found == paths.end() && point != node.npos;
  if (names_key) {
    key = node.substr(point + 1);
    node.resize(point);
    found = std::ranges::find(paths, node);
  }
  for (std::size_t p = node.rfind('.'); found == paths.end() && p != node.npos && p > 0;
       p = node.rfind('.', p - 1))
    if (std::ranges::find(paths, node.substr(0, p)) != paths.end())
      return wrong(begin + p + 1,
                   fmt::format("{} is inside a parameter; behind a node stands a whole one, as in "
                               "{}={{...}}, and the path of a file (trees. ...) goes on into it",
                               quote(text.substr(begin + p + 1, equals - begin - p - 1)),
                               node.substr(p + 1, node.find('.', p + 1) - p - 1)));
  if (found == paths.end())
    return wrong(begin, fmt::format("tree {} has no node {}{}", quote(tree), quote(node),
                                    nearest_or_all(node, paths)));
  if (names_key && key.empty())
    return wrong(equals, "a parameter is missing behind the point");
  if (text.find_first_not_of(' ', equals + 1) == text.npos)
    return wrong(equals, "a value is missing behind '='");
  Diagnostics in_value;
  eyrie::Value value = eyrie::parse_yaml(text.substr(equals + 1), "--set", in_value);
  if (!in_value.ok())
    return wrong(equals + 1, in_value.sorted().front().message);
  scenario::place_in_override(value, text, equals + 1);
  changes.push_back({tree,
                     {.node = static_cast<ubf::NodeIndex>(found - paths.begin()),
                      .key = key,
                      .value = std::move(value),
                      .where = at(begin + (names_key ? point + 1 : 0))}});
  return true;
}

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
    case Ending::both_lost:
      text = "no player is left";
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
  Asked asked(*recorded.scenario, other, who, from);
  Reflight flight(recorded);
  while (flight.step())
    asked.look(flight);
  return std::move(asked.result);
}

std::optional<First> first_otherwise(const Recorded& recorded, const scenario::Scenario& other,
                                     PlayerId asked, double from) {
  std::vector<Asked> all;
  all.emplace_back(*recorded.scenario, other, asked, from);
  for (PlayerId who{1}; recorded.scenario->roster.find(who); ++who.value)
    if (who != asked)
      all.emplace_back(*recorded.scenario, other, who, from);
  Reflight flight(recorded);
  while (flight.step())
    for (Asked& one : all) {
      one.look(flight);
      if (one.result.first)
        return First{one.who, std::move(*one.result.first)};
    }
  return std::nullopt;
}

Outcome outcome_of(const Recorded& recorded) {
  return outcome_of(recorded, past_at(recorded, recorded.last_step()));
}

Outcome outcome_of(const Recorded& recorded, const Past& end) {
  Outcome flown = Branch(recorded, recorded.scenario, end, recorded.until()).fly();
  // no side has ended it: what did, the recording alone knows, by a name or in outcome_text()
  using enum scenario::Outcome;
  using Said = std::pair<std::string_view, scenario::Outcome>;
  for (const auto& [begin, other] :
       {Said{"running", running}, {"stopped", stopped}, {"fault", fault}, {"a fault", fault}})
    if (flown.outcome == enum_name(time) && recorded.run.outcome.starts_with(begin))
      flown.outcome = enum_name(other);
  return flown;
}

std::optional<double> limit_of(const Recorded& recorded, const Outcome& flown) {
  using enum scenario::Outcome;
  for (const scenario::Outcome of_sides : {blue_home, blue_lost, red_lost, both_lost})
    if (flown.outcome == enum_name(of_sides))
      return std::nullopt;
  return recorded.until();
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
      static_cast<void>(
          mission_->run().submit(moved_vote(*recorded.scenario, mission_->scenario(), order)));
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
  remember(recorded, *other, *world);
  move_votes(*recorded.scenario, *other, *world);
  return std::make_unique<Branch>(recorded, std::move(other), Past{std::move(*world), past.events},
                                  until);
}

bool Branch::step() {
  before_.become(mission_->run().world());
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

Overrides read_overrides(const scenario::Scenario& scenario, PlayerId who,
                         const std::vector<std::string>& texts, Diagnostics& diagnostics) {
  Overrides out;
  for (const std::string& text : texts)
    if (!read_change(scenario, who, text, out.changes, diagnostics))
      out.sets.push_back(text);
  return out;
}

}  // namespace eyrie::debrief
