// SPDX-License-Identifier: MIT
#pragma once
/// \file  How players and missiles moved, and what became of them, in columns.
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "page/json.hpp"
#include "page/sights.hpp"
#include "record/names.hpp"
#include "scenario/scenario.hpp"
#include "sim/system.hpp"

namespace eyrie::page {

/// Samples of one motion.
class Motion {
 public:
  void add(double time, const Reference& reference, const model::Kinematics& k);
  [[nodiscard]] bool empty() const { return t_.size() == 0; }
  [[nodiscard]] double last_time() const { return last_time_; }
  [[nodiscard]] Json json(ColumnBytes& bytes) const;

 private:
  double last_time_ = -1;
  Column t_{1e-3}, east_{0.5}, north_{0.5}, up_{0.5}, heading_{1e-3}, pitch_{1e-3}, roll_{1e-3};
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

 private:
  struct Flown {
    double gone = -1;
    std::string_view end;
    Motion motion;
    Column speed{0.1}, mach{1e-3}, load_factor{0.01}, fuel{1};
    model::Kinematics last;  ///< as last seen, in case it is not there at the next look
    double last_fuel = 0;
    bool born = false;
    double born_time = 0;
  };
  struct Missile {
    std::string type;
    model::Side side = model::Side::none;
    PlayerId shooter, target;
    double born = 0, gone = -1, active = ubf::kNoValue;
    std::string_view end = "flying";
    Motion motion;
    model::Kinematics last;
  };

  void look(const sim::World& world, bool players, bool missiles);
  void sample(Flown& player, double time, const model::Kinematics& k, double fuel);
  void happened(const sim::Event& event, const sim::World& world);
  void launched(const sim::Event& event, const sim::World& world);
  void left(const record::Fate& fate);
  /// Who is still there is gone at the end of what was seen.
  [[nodiscard]] double gone(double time) const { return time < 0 ? time_ : time; }

  const scenario::Scenario& scenario_;
  double period_, time_ = 0, dt_ = 0.02;
  std::uint64_t players_every_ = 25, missiles_every_ = 5;
  std::vector<Flown> players_;
  std::map<std::uint32_t, Missile> missiles_;
};

}  // namespace eyrie::page
