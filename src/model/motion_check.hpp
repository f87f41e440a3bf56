// SPDX-License-Identifier: MIT
#pragma once
/// \file  After everybody has moved: where a player is, how fast and how it lies are numbers that
/// mean something, or the step is not finished.
#include "model/kinematics.hpp"
#include "sim/system.hpp"

namespace eyrie::model {

/// The first value of a motion that is NaN, infinite or absurd, as "kinematics.speed is 1e+300
/// m/s"; empty if there is none. Absurd is what nobody reaches who is not computed wrongly:
/// 100,000 km from the reference point, 100 km/s, 100 radians of attitude, 10,000 g.
[[nodiscard]] std::string motion_problem(const Kinematics& motion);

/// Added behind the system that moves the players of a table.
class MotionCheck final : public sim::System {
 public:
  MotionCheck(TableId table, sim::Column<Kinematics> kinematics)
      : table_(table), kinematics_(kinematics) {}

  [[nodiscard]] std::string_view name() const override { return "motion"; }
  [[nodiscard]] TableId table() const override { return table_; }
  void move(sim::World&, const sim::StepInfo&, sim::Chunk, sim::Outbox&) const override;

 private:
  TableId table_;
  sim::Column<Kinematics> kinematics_;
};

}  // namespace eyrie::model
