// SPDX-License-Identifier: MIT
#pragma once
/// \file  What a kind of player besides aircraft and vehicles brings along: a ship, an air defense.
/// A plug-in adds it (Registrar::add_kind); the loader, recordings and debriefs ask it.
#include <set>

#include "core/describe.hpp"
#include "core/diagnostics.hpp"
#include "core/value.hpp"
#include "model/weapon/systems.hpp"
#include "scenario/plugin.hpp"
#include "scenario/roster.hpp"
#include "scenario/scenario.hpp"
#include "sim/simulation.hpp"
#include "sim/system.hpp"
#include "team/agent_system.hpp"

namespace eyrie::scenario {

/// Part of a scenario file.
struct FilePart {
  std::string name;  ///< "flight"
  std::string path;  ///< where it stands: "blue.flights.<name>"; "" for the top level
  std::string help;
  /// What is read by hand has the kind custom and its shape in words as type_name.
  std::vector<ParamInfo> parameters;
};

/// What a registry has besides the standard nodes.
template <class Registry>
[[nodiscard]] std::vector<ubf::NodeInfo> own_nodes(const Registry& registry) {
  std::vector<ubf::NodeInfo> own;
  for (const ubf::NodeInfo& node : registry.catalog())
    if (!node.standard)
      own.push_back(node);
  return own;
}

/// Enters a group with its members, by rank, into the roster and the library; their ids are the
/// next ones.
inline model::Flight& enter(Scenario& scenario, model::Library& library, std::uint8_t fleet,
                            model::Flight group, std::span<const Roster::Player> members) {
  for (Roster::Player player : members) {
    group.members.push_back(
        PlayerId{static_cast<std::uint32_t>(scenario.roster.players.size() + 1)});
    player.fleet = fleet;
    player.flight = static_cast<std::uint16_t>(library.flights.size());
    player.side = group.side;
    scenario.roster.players.push_back(std::move(player));
  }
  scenario.roster.flights.push_back({group.name, group.side, group.members});
  return library.flights.emplace_back(std::move(group));
}

/// Made once per scenario; asked in the order of its functions.
class PlayerKind {
 public:
  virtual ~PlayerKind() = default;

  /// What one of its groups says in a file, and what its trees may name besides the standard
  /// nodes: for the catalog and the schema of files.
  [[nodiscard]] virtual FilePart group() const = 0;
  [[nodiscard]] virtual std::vector<ubf::NodeInfo> nodes() const = 0;
  [[nodiscard]] virtual std::vector<ubf::StateFieldInfo> state_fields() const = 0;

  /// The key of a side under which its groups stand, such as "task_groups".
  [[nodiscard]] virtual std::string_view key() const = 0;
  /// Reads one of them, and says what is wrong with it. The document outlives the loading.
  virtual void read(const Value::Entry& group, model::Side side, Diagnostics& diagnostics) = 0;
  /// Whether a player is of this kind, by its name.
  [[nodiscard]] virtual bool has(std::string_view player) const = 0;
  /// Whether somebody begins with the tree of that name.
  [[nodiscard]] virtual bool uses(std::string_view tree) const = 0;
  /// Builds such a tree; false after mistakes.
  virtual bool add_tree(const ubf::NamedSpec& tree, std::span<const ubf::NamedSpec> all,
                        const std::vector<ubf::NodeChange>& changes, Diagnostics& diagnostics) = 0;
  /// Enters its players and groups into the roster and the library, as number `fleet`.
  virtual void enter(Scenario& scenario, model::Library& library, std::uint8_t fleet,
                     Diagnostics& diagnostics) = 0;
  /// Nothing if there is no such tree.
  [[nodiscard]] virtual std::optional<sim::Order> order_tree(std::uint64_t step, PlayerId who,
                                                             std::string_view tree) const = 0;
  /// Whether it has no players: then nothing below is asked but fleet().
  [[nodiscard]] virtual bool is_empty() const = 0;
  /// Adds its table and its order.
  virtual model::weapon::MovingTable define(sim::SchemaBuilder& schema) = 0;
  /// Adds what perceives and decides, and what moves.
  virtual void add_systems(sim::SimulationBuilder& builder, const Scenario& scenario, double dt,
                           std::uint32_t decision_period) = 0;
  /// Lets its players be born, in the order of the roster.
  virtual void populate(const Scenario& scenario, sim::World& world) const = 0;
  [[nodiscard]] virtual std::shared_ptr<const Fleet> fleet() const = 0;
};

/// The part of it that is the same for all whose agents use trees. `Platform` is what
/// team::AgentSystem needs to know.
template <class Platform>
class AgentKind : public PlayerKind {
 public:
  using Agents = team::AgentSystem<Platform>;
  using Registry = ubf::Registry<typename Platform::State, typename Platform::Action>;

  [[nodiscard]] std::vector<ubf::NodeInfo> nodes() const override { return own_nodes(registry_); }
  [[nodiscard]] std::vector<ubf::StateFieldInfo> state_fields() const override {
    return ubf::state_field_infos<typename Platform::State>();
  }
  [[nodiscard]] bool has(std::string_view player) const override { return names_.contains(player); }
  [[nodiscard]] bool uses(std::string_view tree) const override { return used_.contains(tree); }
  bool add_tree(const ubf::NamedSpec& spec, std::span<const ubf::NamedSpec> all,
                const std::vector<ubf::NodeChange>& changes, Diagnostics& diagnostics) override {
    auto tree = registry_.build_tree(spec.name, *spec.value, diagnostics, all, changes);
    if (tree)
      trees_->add(std::move(*tree));
    return tree.has_value();
  }
  [[nodiscard]] std::optional<sim::Order> order_tree(std::uint64_t step, PlayerId who,
                                                     std::string_view name) const override {
    const auto tree = trees_->find(name);
    return tree ? std::optional(Agents::swap_tree_order(step, who, *tree)) : std::nullopt;
  }
  [[nodiscard]] bool is_empty() const override { return players_ == 0; }
  model::weapon::MovingTable define(sim::SchemaBuilder& schema) override {
    columns_ = Platform::Columns::define(schema, players_);
    brains_ = team::AgentColumns<typename Platform::Agent>::define(
        schema, columns_.table, static_cast<std::uint32_t>(trees_->max_memory()));
    return {columns_.table, columns_.kinematics};
  }

 protected:
  explicit AgentKind(Registry registry) : registry_(std::move(registry)) {}

  /// group() of what `Spec` describes.
  template <Described Spec>
  [[nodiscard]] FilePart group_of() const {
    return {std::string(Spec::type_name), "blue." + std::string(this->key()) + ".<name>",
            std::string(Spec::help), parameters<Spec>()};
  }

  /// Adds the system that decides; to be called in add_systems.
  void add_agents(sim::SimulationBuilder& builder, const Scenario& scenario, double dt,
                  std::uint32_t decision_period) {
    plans_.resize(scenario.library->flights.size());
    agents_ = &builder.add<Agents>(typename Agents::Setup{.columns = columns_,
                                                          .agents = brains_,
                                                          .library = scenario.library,
                                                          .trees = trees_,
                                                          .plans = plans_,
                                                          .dt = dt,
                                                          .period = decision_period});
  }
  /// Enters one group with its members, by rank; their ids are the next ones.
  void enter_group(Scenario& scenario, model::Library& library, std::uint8_t fleet,
                   model::Flight group, std::span<const Roster::Player> members) {
    scenario::enter(scenario, library, fleet, std::move(group), members);
    players_ += static_cast<std::uint32_t>(members.size());
    plans_.resize(library.flights.size());
  }
  /// What fleet() gives; `Mine` is a Fleet, or one that shows more.
  template <class Mine, class... Arguments>
  [[nodiscard]] std::shared_ptr<const Fleet> fleet_of(Arguments&&... arguments) const {
    auto made = std::make_shared<Mine>(std::forward<Arguments>(arguments)...);
    made->trees = trees_->all();
    made->agents = agents_;
    made->fit = columns_.fit;
    made->kinematics = columns_.kinematics;
    return made;
  }

  Registry registry_;
  std::set<std::string, std::less<>> names_, used_;  ///< of players and trees, for read() to fill
  std::shared_ptr<ubf::Trees<typename Platform::State, typename Platform::Action>> trees_ =
      std::make_shared<ubf::Trees<typename Platform::State, typename Platform::Action>>();
  std::vector<typename Platform::Plan> plans_;  ///< by Fit::flight
  typename Platform::Columns columns_;
  team::AgentColumns<typename Platform::Agent> brains_;
  const Agents* agents_ = nullptr;
  std::uint32_t players_ = 0;
};

}  // namespace eyrie::scenario
