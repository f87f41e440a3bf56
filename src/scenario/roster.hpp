// SPDX-License-Identifier: MIT
#pragma once
/// \file  Who is who in a scenario: names for reports, tables and recordings.
#include "core/diagnostics.hpp"
#include "core/id.hpp"
#include "core/value.hpp"
#include "model/fit.hpp"
#include "model/kinematics.hpp"
#include "model/library.hpp"
#include "sim/world.hpp"
#include "team/agents.hpp"
#include "ubf/node.hpp"

namespace eyrie::scenario {

/// Names that never enter a step. Player ids are 1 + index: players are born in this order, fleet
/// by fleet.
struct Roster {
  struct Player {
    std::string name;   ///< "eagle1"
    std::string type;   ///< name of its type, "f15c"
    std::string label;  ///< what people call the type, "F-15C"
    model::Side side = model::Side::none;
    std::uint16_t flight = 0;  ///< index into flights
    std::uint16_t rank = 1;    ///< from the name
    std::uint8_t fleet = 0;    ///< index into Scenario::fleets
    std::string entity_type;   ///< as its type has it (model::EntityType); "": other
    bool remote = false;       ///< another program flies it
  };
  struct Flight {
    std::string name;
    model::Side side = model::Side::none;
    std::vector<PlayerId> members;  ///< in order of rank
  };

  std::vector<Player> players;
  std::vector<Flight> flights;

  [[nodiscard]] const Player* find(PlayerId id) const {
    return id && id.value <= players.size() ? &players[id.value - 1] : nullptr;
  }
  /// The name of a player in it; for anybody else "player 12", for nobody "".
  [[nodiscard]] std::string name(PlayerId id) const {
    if (const Player* p = find(id))
      return p->name;
    return id ? "player " + std::to_string(id.value) : "";
  }
  [[nodiscard]] std::optional<PlayerId> find(std::string_view name) const {
    for (std::size_t i = 0; i < players.size(); ++i)
      if (players[i].name == name)
        return PlayerId{static_cast<std::uint32_t>(i + 1)};
    return std::nullopt;
  }
  /// By which some of the players can be meant: sides, flights, themselves.
  [[nodiscard]] std::vector<std::string> names() const {
    std::vector<std::string> all = listed(flights, &Flight::name);
    all.insert(all.begin(), {"blue", "red"});
    for (const Player& player : players)
      all.push_back(player.name);
    return all;
  }
  /// "there is no player 'eagel1'; did you mean 'eagle1'?"
  [[nodiscard]] std::string unknown(std::string_view name) const {
    return fmt::format("there is no player {}{}", quote(name),
                       nearest_or_all(name, listed(players, &Player::name)));
  }
};

[[nodiscard]] constexpr std::string_view side_name(model::Side side) {
  return side == model::Side::blue ? "blue" : side == model::Side::red ? "red" : "none";
}

/// What a player shows besides its motion.
struct Gauges {
  std::optional<double> mach, load_factor;
  std::optional<double> fuel;  ///< kg
  PlayerId locked{};           ///< whom it attacks
};

/// How a flight or convoy stands: it has arrived when everybody stands and somebody is past the
/// last point of the route.
struct Standing {
  std::uint32_t players = 0;
  bool moving = false, at_the_end = false;
};

/// The players of one kind in a scenario, for who does not know the kind.
class Fleet {
 public:
  struct Words {
    std::string_view name;    ///< "vehicle": of the kind
    std::string_view plural;  ///< "vehicles"
    std::string_view group;   ///< "convoy"
    std::string_view there;   ///< "on the ground": of who is still there at the end
    std::string_view acmi;    ///< type in Tacview's files
    bool comes_home = false;  ///< counted by who has come home at the end
  };

  explicit Fleet(const Words& its_words) : words(its_words) {}
  virtual ~Fleet() = default;
  Fleet(const Fleet&) = delete;
  Fleet& operator=(const Fleet&) = delete;

  const Words words;
  std::vector<const ubf::AnyTree*> trees;  ///< as its agents number them
  const team::Agents* agents = nullptr;    ///< null if there are no such players
  sim::Column<model::Fit> fit;
  sim::Column<model::Kinematics> kinematics;

  /// Live rows.
  [[nodiscard]] std::uint32_t rows(const sim::World& world) const {
    return agents ? world.rows(agents->table()) : 0;
  }
  [[nodiscard]] PlayerId id(const sim::World& world, std::size_t row) const {
    return world.ids(agents->table())[row];
  }
  [[nodiscard]] std::optional<std::uint32_t> row(const sim::World& world, PlayerId who) const {
    return agents ? world.row(agents->table(), who) : std::nullopt;
  }
  [[nodiscard]] const model::Kinematics& motion(const sim::World& world, std::size_t row) const {
    return world.rows(kinematics)[row];
  }
  /// The label of who led the last decision; "nobody".
  [[nodiscard]] std::string leader(const sim::World& world, std::size_t row) const {
    const team::LastDecision last = agents->last_decision(world, row);
    return last.tree < trees.size() ? trees[last.tree]->label(last.node) : "nobody";
  }
  [[nodiscard]] virtual Gauges gauges(const sim::World&, std::size_t /*row*/) const { return {}; }
  /// Adds who is there to how the flights stand; by flight.
  virtual void count(const sim::World& world, const model::Library& /*library*/,
                     std::span<Standing> standings) const {
    for (std::size_t i = 0; i < rows(world); ++i)
      ++standings[world.rows(fit)[i].flight].players;
  }
};

/// Everybody is remote whom `ours` names neither itself nor by his flight or side; nobody if it
/// names nobody. `list` is what it was read from. Refused: names of nobody, and a remote player who
/// is no aircraft.
void share_out(const std::vector<std::string>& ours, const Value& list, Roster& roster,
               Diagnostics& diagnostics);

}  // namespace eyrie::scenario
