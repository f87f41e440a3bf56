// SPDX-License-Identifier: MIT
#pragma once
/// \file  A question about the events or the decisions of a flight: which of them count, and what
/// is made of them.
#include <utility>

#include "campaign/measure.hpp"
#include "ubf/expression.hpp"

namespace eyrie::campaign {

/// Whether a player of the roster is meant; index: id - 1.
using Players = std::vector<bool>;
/// Those of a side, a flight or of one name, which stands in a measure under a key; everybody for
/// "". Reports a name that nobody has.
[[nodiscard]] Players players_named(const scenario::Scenario& scenario, const MeasureSpec& spec,
                                    std::string_view key, const std::string& name,
                                    Diagnostics& diagnostics);
/// Those of all sides that none of these is of.
[[nodiscard]] Players enemies_of(const scenario::Scenario& scenario, const Players& who);

/// Who shot which missile.
class Flight {
 public:
  explicit Flight(const scenario::Scenario& its_scenario) : scenario(its_scenario) {}
  void observe(std::span<const sim::Event> events);
  /// The player that an event is about: itself, or of a missile its shooter; none if unknown.
  [[nodiscard]] PlayerId player(PlayerId id) const;

  const scenario::Scenario& scenario;

 private:
  std::vector<PlayerId> shooters_;  ///< by missile, from the id behind that of the last player
};

/// The decisions that were made since it was last asked.
class NewDecisions {
 public:
  explicit NewDecisions(const scenario::Scenario& scenario)
      : scenario_(scenario), ticks_(scenario.roster.players.size()) {}

  /// Calls `use(id, fleet, decision)` for each of those players; `fleet` is its index.
  template <class Use>
  void each(const sim::World& world, const Players& who, Use use) {
    for (std::size_t f = 0; f < scenario_.fleets.size(); ++f) {
      const scenario::Fleet& fleet = *scenario_.fleets[f];
      for (std::size_t row = 0; row < fleet.rows(world); ++row) {
        const PlayerId id = fleet.id(world, row);
        if (!who[id.value - 1])
          continue;
        const team::LastDecision last = fleet.agents->last_decision(world, row);
        if (std::exchange(ticks_[id.value - 1], last.ticks) != last.ticks)
          use(id, f, last);
      }
    }
  }

 private:
  const scenario::Scenario& scenario_;
  std::vector<std::uint32_t> ticks_;  ///< by player: decisions seen
};

/// How various the decisions of some players are: the entropy (bits, Shannon, Bell System Technical
/// Journal 27 (1948) 379) of the type of node that led them, or of how the aircraft moved then:
/// bank (beyond 45 deg, beyond 10 deg, less; left or right) and climb (beyond 5 deg, up or down). 0
/// if it was always the same.
class Variety {
 public:
  Variety(const Flight& flight, Players who, bool of_motion);
  void observe(const sim::World& world);
  /// NaN if none was led by anybody.
  [[nodiscard]] double value() const;

 private:
  const scenario::Scenario& scenario_;
  Players who_;
  NewDecisions decisions_;
  std::vector<std::vector<std::vector<std::size_t>>> types_;  ///< by fleet, tree and node
  bool of_motion_;
  std::vector<std::uint64_t> counts_;  ///< by type, or by way to move
};

/// Gathers over one flight what a measure asks for. Its condition and its value name
///   time (s), of the event or decision, and its values: of an event as model::event_values() calls
///     them, of a decision `vote`;
///   altitude (m), speed (m/s), mach and fuel (kg) of who does it, and how far the nearest missile
///     flies that was shot at it or sees it (missile_range, m) and its nearest enemy (enemy_range);
///   the same of whom it is done to, as whom.altitude.
/// All of them as they are after the step, so who has left the run in it has none of them. Of a
/// missile it is the shooter who does it.
class Query {
 public:
  /// Reports what is wrong with the text, whatever the scenario.
  static void check(const MeasureSpec& spec, Diagnostics& diagnostics);
  /// Of the column.
  [[nodiscard]] static std::string_view unit(const MeasureSpec& spec);

  /// `spec` must have been checked; reports what the scenario has not. Both must outlive it.
  Query(const MeasureSpec& spec, const Flight& flight, Diagnostics& diagnostics);

  void observe(const sim::World& world, const sim::StepInfo& info,
               std::span<const sim::Event> events);
  /// Of all so far; NaN if there was none to take a value of.
  [[nodiscard]] double value() const;

 private:
  /// One event or decision.
  struct Case {
    const sim::World& world;
    double time;
    PlayerId who, whom;
    std::span<const float> values;
  };
  [[nodiscard]] double field(const Case& c, std::size_t index) const;
  void take(const Case& c);

  const MeasureSpec& spec_;
  const Flight& flight_;
  Players who_, whom_;
  model::EventKind kind_ = model::EventKind::none;
  std::vector<std::uint8_t> own_values_;  ///< which of an event's can be read
  std::vector<ubf::detail::Instruction> condition_;
  std::size_t value_ = 0;                    ///< field that is taken
  std::vector<std::vector<Players>> nodes_;  ///< by fleet and tree: whether a node is meant
  NewDecisions decisions_;
  double count_ = 0, result_ = 0;
};

}  // namespace eyrie::campaign
