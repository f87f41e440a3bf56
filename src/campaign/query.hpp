// SPDX-License-Identifier: MIT
#pragma once
/// \file  A question about the events or the decisions of a flight: which of them count, and what
/// is made of them.
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
  void decisions(const sim::World& world, double time);

  const MeasureSpec& spec_;
  const Flight& flight_;
  Players who_, whom_;
  model::EventKind kind_ = model::EventKind::none;
  std::size_t own_values_ = 0;  ///< of the kind
  std::vector<ubf::detail::Instruction> condition_;
  std::size_t value_ = 0;                    ///< field that is taken
  std::vector<std::vector<Players>> nodes_;  ///< by fleet and tree: whether a node is meant
  std::vector<std::uint32_t> ticks_;         ///< by player: decisions seen
  double count_ = 0, result_ = 0;
};

}  // namespace eyrie::campaign
