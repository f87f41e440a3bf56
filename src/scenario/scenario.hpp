// SPDX-License-Identifier: MIT
#pragma once
/// \file  A scenario that is ready to fly: const models, trees and systems, and the first world.
#include "driver/state.hpp"
#include "model/columns.hpp"
#include "model/library.hpp"
#include "model/remote.hpp"
#include "pilot/agent.hpp"
#include "pilot/state.hpp"
#include "pilot/trees.hpp"
#include "scenario/plugin_file.hpp"
#include "scenario/roster.hpp"
#include "scenario/source.hpp"
#include "scenario/spec.hpp"
#include "scenario/spread.hpp"
#include "sim/event.hpp"
#include "sim/simulation.hpp"
#include "sim/world.hpp"
#include "ubf/spec.hpp"

namespace eyrie::scenario {

/// Everything about a run that does not change, and the world it begins with. Shared by any number
/// of runs and threads.
struct Scenario {
  std::string file;  ///< as the user named it
  ScenarioSpec spec;
  Roster roster;
  std::shared_ptr<const model::Library> library;
  std::shared_ptr<const pilot::Trees> trees;
  model::AircraftColumns aircraft;
  model::MissileColumns missiles;
  pilot::PilotColumns pilots;
  std::optional<model::RemoteColumns> remote;  ///< if another program flies somebody
  std::vector<pilot::Formation> formations;    ///< by Fit::flight
  std::shared_ptr<const driver::Trees> driver_trees;
  std::vector<driver::Spacing> convoys;              ///< by Fit::flight
  std::optional<model::VehicleColumns> vehicles;     ///< if there are any
  driver::DriverColumns drivers;                     ///< of them
  std::vector<std::shared_ptr<const Fleet>> fleets;  ///< aircraft first
  std::shared_ptr<const sim::Simulation> simulation;
  std::optional<sim::World> start;  ///< with the scenario's own seed, unspread; use world()
  std::vector<Spread> spreads;      ///< of who begins elsewhere with every seed
  std::vector<sim::Order> orders;
  std::map<std::string, std::string> files;  ///< every text it was made from
  std::vector<std::string> sets;             ///< overrides, as given
  std::vector<PluginFile> plugins;           ///< whose nodes its trees may hold
  bool has_foreign_nodes = false;            ///< of plug-ins, or of the program that loaded it

  /// Of a player of the roster.
  [[nodiscard]] const Fleet& fleet_of(PlayerId who) const {
    return *fleets[roster.find(who)->fleet];
  }
  /// Of all fleets; one that serves pilots and drivers twice.
  [[nodiscard]] std::vector<const ubf::AnyTree*> all_trees() const {
    std::vector<const ubf::AnyTree*> all;
    for (const auto& fleet : fleets)
      all.insert(all.end(), fleet->trees.begin(), fleet->trees.end());
    return all;
  }
  /// A player's fleet and row in a world; nothing if it is not there.
  struct Found {
    const Fleet& fleet;
    std::uint32_t row;
  };
  [[nodiscard]] std::optional<Found> find(const sim::World& world, PlayerId who) const {
    const auto row = roster.find(who) ? fleet_of(who).row(world, who) : std::nullopt;
    return row ? std::optional<Found>({fleet_of(who), *row}) : std::nullopt;
  }
  /// Who led a player's last decision, as its row keeps it; kNone for nobody.
  [[nodiscard]] ubf::NodeIndex leader(const sim::World& world, PlayerId who) const {
    const auto found = find(world, who);
    return found ? found->fleet.agents->last_decision(world, found->row).node : ubf::kNone;
  }
  /// Calls `use(fleet, id, row)` for every player that is there and has appeared.
  template <class Use>
  void each_player(const sim::World& world, Use use) const {
    for (const auto& fleet : fleets)
      for (std::size_t row = 0; row < fleet->rows(world); ++row)
        if (!model::is_nowhere(fleet->motion(world, row)))
          use(*fleet, fleet->id(world, row), row);
  }
  /// The world at step 0 for a seed.
  [[nodiscard]] sim::World world(std::uint64_t seed) const;
  /// Makes it of any world of this scenario. Allocates nothing.
  void begin(sim::World& world, std::uint64_t seed) const;
};

/// A change of one node of the tree of that name, beside what files say.
struct TreeChange {
  std::string tree;
  ubf::NodeChange change;
};

class Registrar;  // scenario/plugin.hpp
/// Adds nodes of the program that loads a scenario, as a plug-in would.
using AddNodes = std::function<void(Registrar&)>;

/// What to load: a file, `path=value` overrides, and plug-ins that are opened whatever they are.
struct LoadRequest {
  std::string file;
  std::vector<std::string> sets = {};
  std::vector<std::string> plugins = {};
  std::vector<TreeChange> changes = {};  ///< of trees; a run file does not keep them
  /// Of the plug-ins that the file names besides: opening one runs its code. None without it.
  PluginPermission may_open = {};
  AddNodes add = {};
};

/// Reads, checks and builds. Throws ConfigError with every mistake that was found.
[[nodiscard]] std::shared_ptr<const Scenario> load(const LoadRequest& request, Source source);

/// Checks a file of trees and data for others to include: every tree is read for whom it can serve.
/// Gives how many there are, or nothing if it is a scenario; throws as load() does.
[[nodiscard]] std::optional<std::size_t> check_package(const LoadRequest& request, Source source);

}  // namespace eyrie::scenario
