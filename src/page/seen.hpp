// SPDX-License-Identifier: MIT
#pragma once
/// \file  How players and missiles moved, what became of them, and what agents perceived, in
/// columns.
#include "driver/state.hpp"
#include "model/frames.hpp"
#include "page/decisions.hpp"
#include "pilot/state.hpp"
#include "record/names.hpp"
#include "scenario/scenario.hpp"
#include "sim/system.hpp"

namespace eyrie::page {

/// A player's place in the roster; -1: it is none.
[[nodiscard]] inline int index_of(const scenario::Roster& roster, PlayerId who) {
  return roster.find(who) ? static_cast<int>(who.value) - 1 : -1;
}

/// A place in the scenario's local frame as one on the map.
struct OnMap {
  double east = 0, north = 0, up = 0, turn = 0;
};
[[nodiscard]] OnMap on_map(const Reference& reference, const Vec3& position);

/// What one agent perceived: its state by fields, tracks, warnings, radar and the zone of the
/// missile in hand.
class Sights {
 public:
  Sights(const scenario::Scenario& scenario, TextBook& texts);

  /// `world` is the one after the step in which `who` had that state.
  void add(const pilot::State& state, const sim::World& world, PlayerId who);
  void add(const driver::State& state);
  /// Whether its tracks are others, or of others, than those of the last one.
  [[nodiscard]] bool names_others(const pilot::State& state) const;
  /// s, of the last one; before the run if there is none.
  [[nodiscard]] double last_time() const { return last_time_; }
  [[nodiscard]] Json json(ColumnBytes& bytes) const;
  [[nodiscard]] bool empty() const { return t_.values().empty(); }
  void forget();

 private:
  template <class State>
  void add_state(const State& state);
  void add_track(std::uint32_t id, PlayerId truth, model::Identity identity, bool target,
                 const Vec3& position, double age);
  void add_warning(const sim::World& world, const std::string& kind, double bearing, double range,
                   PlayerId truth);
  void add_zone(const pilot::State& state);

  const scenario::Scenario& scenario_;
  TextBook& texts_;
  double last_time_ = -1e9;
  std::vector<std::pair<TrackId, PlayerId>> named_;  ///< the last tracks, and whose they are
  Column t_{1e-3};
  std::vector<Column> state_;
  // of tracks and warnings, how many there were each time, and all of them
  Column track_counts_, warning_counts_;
  Columns tracks_{{"id"},   {"truth"}, {"identity"}, {"target"},
                  {"east"}, {"north"}, {"up"},       {"age", 0.1}};
  Columns warnings_{{"kind"}, {"bearing", 1e-3}, {"range", 10}, {"name"}};
  // of pilots only
  Columns scan_{{"mode"}, {"azimuth", 1e-3}, {"elevation", 1e-3}};
  Columns zone_{{"min", 10}, {"no_escape", 10}, {"max", 10}};
};

/// Samples of one motion.
class Motion {
 public:
  /// False if there is one of that time (s) already.
  bool add(double time, const Reference& reference, const model::Kinematics& k);
  /// There was none yet.
  [[nodiscard]] bool empty() const { return last_time_ < 0; }
  [[nodiscard]] Json json(ColumnBytes& bytes) const { return columns_.json(bytes); }
  void forget() { columns_.forget(); }

 private:
  double last_time_ = -1;
  Columns columns_{{"t", 1e-3},       {"east", 0.5},   {"north", 0.5}, {"up", 0.5},
                   {"heading", 1e-3}, {"pitch", 1e-3}, {"roll", 1e-3}};
};

/// Watches a run: aircraft and vehicles every `period` seconds, missiles five times as often, all
/// of them also when they appear and when they are seen for the last time.
class Motions final : public sim::Observer {
 public:
  explicit Motions(const scenario::Scenario& scenario, double period = 0.5);

  void begin(const sim::World& world, double dt) override;
  void observe(const sim::World& world, const sim::StepInfo& info,
               std::span<const sim::Event> events) override;
  void finish(const sim::World& world) override;
  /// What happened in a step before begin(); `world` is the one that it will be given.
  void remember(const sim::World& world, const sim::StepInfo& info,
                std::span<const sim::Event> events);

  /// Of a player, by its place in the roster: born, gone, end, motion, gauges.
  [[nodiscard]] Json player(std::size_t index, ColumnBytes& bytes) const;
  [[nodiscard]] Json missiles(ColumnBytes& bytes) const;
  /// Where everybody is: players in order, null for who is not there, and missiles by id; times,
  /// places and attitudes as the columns of motion have them, then the gauges.
  [[nodiscard]] Json now() const;
  /// What was packed is packed no more.
  void forget();

 private:
  struct Mover {
    std::optional<double> born, gone;  ///< s
    std::string_view end;
    Motion motion;
    model::Kinematics last;  ///< as last seen, in case it is not there at the next look
    bool told = false;       ///< to its end
  };
  struct Flown : Mover {
    Columns gauges{{"speed", 0.1}, {"mach", 1e-3}, {"load_factor", 0.01}, {"fuel", 1}};
    double last_fuel = 0;
    double heard = 0;  ///< s, when it was last there: another program may fall silent
  };
  struct Missile : Mover {
    std::string type;
    model::Side side = model::Side::none;
    PlayerId shooter, target;
    double active = ubf::kNoValue;
  };

  void look(const sim::World& world, bool players, bool missiles);
  void sample(Flown& player) const;
  void happened(const sim::Event& event, const sim::World& world);
  void launched(const sim::Event& event, const sim::World& world);
  void left(const record::Fate& fate);

  const scenario::Scenario& scenario_;
  double period_, time_ = 0;
  std::uint64_t players_every_ = 25, missiles_every_ = 5;
  std::vector<Flown> players_;
  std::map<std::uint32_t, Missile> missiles_;
};

}  // namespace eyrie::page
