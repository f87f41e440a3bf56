// SPDX-License-Identifier: MIT
#pragma once
/// \file  Where everybody is while a mission is flown, straight from the world.
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "scenario/scenario.hpp"

namespace eyrie::test {

/// Everybody's samples: players every 10 steps, missiles every 5.
class Truth final : public sim::Observer {
 public:
  struct At {
    double time = 0;
    model::Kinematics k;
  };
  explicit Truth(const scenario::Scenario& scenario) : scenario_(scenario) {}

  void observe(const sim::World& world, const sim::StepInfo& info,
               std::span<const sim::Event>) override {
    const double time = info.time_after();
    if (world.step() % 10 == 0) {
      look(world, time, scenario_.aircraft.table, scenario_.aircraft.kinematics);
      if (scenario_.vehicles)
        look(world, time, scenario_.vehicles->table, scenario_.vehicles->kinematics);
    }
    if (world.step() % 5 == 0)
      look(world, time, scenario_.missiles.table, scenario_.missiles.kinematics);
  }
  [[nodiscard]] const std::map<std::uint32_t, std::vector<At>>& all() const { return all_; }

 private:
  template <class Column>
  void look(const sim::World& world, double time, TableId table, Column column) {
    for (std::size_t i = 0; i < world.rows(table); ++i)
      all_[world.ids(table)[i].value].push_back({time, world.rows(column)[i]});
  }
  const scenario::Scenario& scenario_;
  std::map<std::uint32_t, std::vector<At>> all_;
};

}  // namespace eyrie::test
